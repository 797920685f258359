// The convex hull, against its definition: for random points, and for those that a quick algorithm stumbles
// over.
#include "gaitway/geometry/convex_hull.hpp"

#include <gmock/gmock.h>

#include <random>
#include <vector>

namespace gaitway::geometry {
namespace {

using Hull = ConvexHull<>;
using Points = std::vector<Eigen::Vector2d>;
using testing::ElementsAre;
using testing::IsEmpty;

Points corners_of(const Points& points) {
  const Hull hull{points};
  return {hull.corners().begin(), hull.corners().end()};
}

// By the definition: an edge is a line between two of the points with all others on its left.
double margin_by_definition_m(const Points& points, const Eigen::Vector2d& point) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const auto& a : points) {
    for (const auto& b : points) {
      if (a == b) continue;
      const Eigen::Vector2d inward = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
      const bool edge = std::all_of(points.begin(), points.end(),
                                    [&](const auto& c) { return inward.dot(c - a) >= -1e-12; });
      if (edge) least_m = std::min(least_m, inward.dot(point - a));
    }
  }
  return least_m;
}

TEST(ConvexHull, GoesCounterClockwiseAroundTheOutermostPoints) {
  const Eigen::Vector2d a{0, 0}, b{2, 0}, c{2, 1}, d{0, 1};
  EXPECT_THAT(corners_of({c, {1, 0.5}, a, d, {0.2, 0.9}, b}), ElementsAre(a, b, c, d));
}

TEST(ConvexHull, LeavesOutPointsBetweenCornersAndRepeatedOnes) {
  const Eigen::Vector2d a{0, 0}, b{2, 0}, c{2, 1}, d{0, 1};
  EXPECT_THAT(corners_of({a, {1, 0}, b, b, c, {1, 1}, d, {0, 0.5}}), ElementsAre(a, b, c, d));
}

TEST(ConvexHull, OfFewPointsIsTheseAlone) {
  const Eigen::Vector2d a{0, 0}, b{2, 1};
  EXPECT_THAT(corners_of({}), IsEmpty());
  EXPECT_THAT(corners_of({a}), ElementsAre(a));
  EXPECT_THAT(corners_of({b, a}), ElementsAre(a, b));
}

TEST(ConvexHull, LeavesOutWhatIsMoreThanItHolds) {
  EXPECT_EQ(corners_of(Points(9, Eigen::Vector2d(1, 1))).size(), 1U);
}

TEST(ConvexHull, KeepsTheHeightOfACorner) {
  const std::vector<Eigen::Vector3d> points{{0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {0.2, 0.2, 9}};
  const ConvexHull<Eigen::Vector3d> hull{points};
  EXPECT_THAT(std::vector(hull.corners().begin(), hull.corners().end()),
              ElementsAre(points[0], points[1], points[2]));
}

TEST(ConvexHull, MarginIsTheDistanceToTheNearestEdge) {
  const Points square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_DOUBLE_EQ(Hull{square}.margin_m({1.5, 1.0}), 0.5);
  EXPECT_DOUBLE_EQ(Hull{square}.margin_m({2.25, 1.0}), -0.25);
  EXPECT_EQ(Hull{}.margin_m({0, 0}), std::numeric_limits<double>::infinity());
}

TEST(ConvexHull, MarginAgreesWithTheDefinitionForRandomPoints) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  for (int trial = 0; trial < 1000; ++trial) {
    Points points(3 + random() % 6);
    for (auto& point : points) point = {anywhere(random), anywhere(random)};
    const Eigen::Vector2d point{anywhere(random), anywhere(random)};
    EXPECT_NEAR(Hull{points}.margin_m(point), margin_by_definition_m(points, point), 1e-9) << trial;
  }
}

}  // namespace
}  // namespace gaitway::geometry
