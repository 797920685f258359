// Heights of solids at any angle, against a search along the line; and the grid against single points.
#include "gaitway/world/height_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gaitway/facts/random_stream.hpp"

namespace gaitway::world {
namespace {

bool contains(const Solid& solid, const Eigen::Vector3d& point_m) {
  const Eigen::Vector3d local = (solid.pose.inverse() * point_m).cwiseAbs();
  const Eigen::Vector3d half = solid.size_m / 2.0;
  switch (solid.shape) {
    case Solid::Shape::box:
      return (half - local).minCoeff() >= 0.0;
    case Solid::Shape::cylinder:
      return local.head<2>().norm() <= half.x() && local.z() <= half.z();
    case Solid::Shape::sphere:
      return local.norm() <= half.x();
  }
  return false;
}

Solid random_solid(facts::RandomStream& random) {
  Solid solid;
  solid.shape = static_cast<Solid::Shape>(random.next() % 3);
  solid.size_m = {0.05 + random.uniform(), 0.05 + random.uniform(), 0.05 + random.uniform()};
  if (solid.shape == Solid::Shape::cylinder) solid.size_m.y() = solid.size_m.x();
  if (solid.shape == Solid::Shape::sphere) solid.size_m.setConstant(solid.size_m.x());
  Eigen::Quaterniond turn(random.normal(), random.normal(), random.normal(), random.normal());
  if (random.next() % 4 == 0) turn = Eigen::Quaterniond(std::cos(random.uniform()), 0.0, 0.0, std::sin(1.0));
  if (random.next() % 8 == 0) turn.setIdentity();
  solid.pose.linear() = turn.normalized().toRotationMatrix();
  solid.pose.translation() = 2.0 * Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform());
  return solid;
}

TEST(OnVertical, IsWhatASearchAlongTheLineFinds) {
  facts::RandomStream random(11, 1);
  int met_count = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Solid solid = random_solid(random);
    const double x_m = solid.pose.translation().x() + 1.2 * (random.uniform() - 0.5);
    const double y_m = solid.pose.translation().y() + 1.2 * (random.uniform() - 0.5);
    const auto met = solid.on_vertical(x_m, y_m);
    constexpr double kStep_m = 0.002;
    double bottom_m = 0.0, top_m = 0.0;
    bool found = false;
    for (double z_m = -2.0; z_m < 5.0; z_m += kStep_m) {
      if (!contains(solid, {x_m, y_m, z_m})) continue;
      bottom_m = found ? bottom_m : z_m;
      top_m = z_m;
      found = true;
    }
    ASSERT_TRUE(met || !found) << "trial " << trial;
    if (!met) continue;
    ++met_count;
    if (!found) {
      EXPECT_LT(met->top_m - met->bottom_m, 2.0 * kStep_m) << "trial " << trial;
      continue;
    }
    EXPECT_NEAR(met->bottom_m, bottom_m, 1.01 * kStep_m) << "trial " << trial;
    EXPECT_NEAR(met->top_m, top_m, 1.01 * kStep_m) << "trial " << trial;
    const auto [least_m, greatest_m] = solid.bounds_m();
    EXPECT_GE(met->bottom_m, least_m.z() - 1e-9);
    EXPECT_LE(met->top_m, greatest_m.z() + 1e-9);
    EXPECT_TRUE(x_m >= least_m.x() && x_m <= greatest_m.x() && y_m >= least_m.y() && y_m <= greatest_m.y());
  }
  EXPECT_GT(met_count, 200);
}

TEST(HeightAt, AsksWhatIsBelowTheCeilingAndWhatHangsAboveIt) {
  Solid table, lamp;
  table.size_m = {1.0, 1.0, 0.1};
  table.pose.translation().z() = 0.45;  // from 0.4 to 0.5
  lamp.size_m = {0.2, 0.2, 0.2};
  lamp.pose.translation().z() = 1.6;  // from 1.5 to 1.7
  const std::vector<Solid> both{table, lamp};
  const auto expect = [&](double ceiling_m, double surface_m, std::optional<double> underside_m) {
    const Height height = height_at(both, 0.0, 0.0, ceiling_m);
    EXPECT_NEAR(height.surface_m, surface_m, 1e-12) << ceiling_m;
    ASSERT_EQ(height.underside_m.has_value(), underside_m.has_value()) << ceiling_m;
    EXPECT_NEAR(height.underside_m.value_or(0.0), underside_m.value_or(0.0), 1e-12) << ceiling_m;
  };
  expect(0.3, 0.0, 0.4);
  expect(1.0, 0.5, 1.5);
  expect(2.0, 1.7, std::nullopt);
}

TEST(HeightGridTest, HasInEachCellWhatItsMiddleHas) {
  facts::RandomStream random(5, 2);
  std::vector<Solid> solids;
  for (int i = 0; i < 40; ++i) solids.push_back(random_solid(random));
  const Grid grid{.origin_m = {-0.53, -0.31}, .cell_m = 0.07, .columns = 41, .rows = 37};
  for (const double ceiling_m : {0.6, 1.2, std::numeric_limits<double>::infinity()}) {
    const HeightGrid heights = height_grid(solids, grid, ceiling_m);
    ASSERT_EQ(heights.surface_m.size(), 41U * 37U);
    std::size_t cell = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column, ++cell) {
        const Height height = height_at(solids, grid.origin_m.x() + (column + 0.5) * grid.cell_m,
                                        grid.origin_m.y() + (row + 0.5) * grid.cell_m, ceiling_m);
        EXPECT_EQ(heights.surface_m[cell], static_cast<float>(height.surface_m));
        EXPECT_EQ(std::isnan(heights.underside_m[cell]), !height.underside_m.has_value());
        if (height.underside_m) {
          EXPECT_EQ(heights.underside_m[cell], static_cast<float>(*height.underside_m));
        }
      }
    }
  }
}

TEST(HeightGridTest, RefusesGridsThatAreNone) {
  EXPECT_THROW((void)height_grid({}, {.cell_m = 0.1, .columns = 0, .rows = 1}), std::invalid_argument);
  EXPECT_THROW((void)height_grid({}, {.cell_m = 0.0, .columns = 1, .rows = 1}), std::invalid_argument);
  EXPECT_THROW((void)height_grid({}, {.cell_m = 0.1, .columns = 4001, .rows = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::world
