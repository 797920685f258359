// Convex hulls hold all points, face outwards and have as few points as asked for.
#include <numbers>
#include <random>

#include "maker_folder.hpp"
#include "surface_measures.hpp"

namespace gaitway::importer {
namespace {

Surface cloud(std::size_t points, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> spread;
  Surface surface;
  surface.source = "cloud";
  for (std::size_t i = 0; i < points; ++i) {
    surface.point_m.emplace_back(spread(engine) + 5.0, 0.1 * spread(engine), spread(engine));
  }
  return surface;
}

double farthest_outside_m(const Surface& hull, const Surface& surface) {
  double worst = 0.0;
  for (const auto& corners : hull.triangle) {
    const auto point = [&](std::size_t i) { return hull.point_m.at(static_cast<std::size_t>(corners[i])); };
    const Eigen::Vector3d normal = (point(1) - point(0)).cross(point(2) - point(0)).stableNormalized();
    for (const Eigen::Vector3d& inner : surface.point_m) {
      worst = std::max(worst, normal.dot(inner - point(0)));
    }
  }
  return worst;
}

TEST(ConvexHull, HoldsAllPoints) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Surface surface = cloud(200, seed);
    const Surface hull = convex_hull(surface, 1000);
    EXPECT_LT(farthest_outside_m(hull, surface), 1e-9) << "seed " << seed;
    EXPECT_TRUE(test::is_closed(hull));
    EXPECT_GT(test::volume_m3(hull), 0.0);
    EXPECT_LT(hull.point_m.size(), surface.point_m.size());
    EXPECT_EQ(hull.source, "cloud");
  }
}

TEST(ConvexHull, OfABoxIsTheBox) {
  const MakerRobot robot = test::MakerFolder().read_robot(
      test::link("a", "<collision><geometry><box size=\"0.5 1 1.5\"/></geometry></collision>"));
  const Surface hull = convex_hull(robot.links[0].collision.at(0), 8);
  EXPECT_EQ(hull.point_m.size(), 8U);
  EXPECT_EQ(hull.triangle.size(), 12U);
  EXPECT_NEAR(test::volume_m3(hull), 0.75, 1e-12);
}

TEST(ConvexHull, KeepsToAFewPointsAndNearlyTheVolume) {
  Surface ball;
  std::mt19937 engine(7);
  std::normal_distribution<double> spread;
  for (int i = 0; i < 20'000; ++i) {
    ball.point_m.push_back(Eigen::Vector3d(spread(engine), spread(engine), spread(engine)).normalized());
  }
  const Surface hull = convex_hull(ball, 100);
  EXPECT_LE(hull.point_m.size(), 100U);
  EXPECT_GT(hull.point_m.size(), 50U);
  EXPECT_TRUE(test::is_closed(hull));
  EXPECT_GT(test::volume_m3(hull), 0.85 * 4.0 / 3.0 * std::numbers::pi);
}

TEST(ConvexHull, PointsWithoutVolumeHaveNone) {
  Surface flat;
  flat.point_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}};
  EXPECT_THROW((void)convex_hull(flat, 10), std::invalid_argument);
  flat.point_m.resize(3);
  EXPECT_THROW((void)convex_hull(flat, 10), std::invalid_argument);
  flat.point_m.assign(10, Eigen::Vector3d::Ones());
  EXPECT_THROW((void)convex_hull(flat, 10), std::invalid_argument);
  Surface endless = cloud(10, 1);
  endless.point_m[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)convex_hull(endless, 10), std::invalid_argument);
  EXPECT_THROW((void)convex_hull(cloud(10, 1), 3), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::importer
