// What is written is what stands there.
#include <cmath>
#include <numbers>

#include "gaitway/world/height_grid.hpp"
#include "written_world.hpp"

namespace gaitway::world {
namespace {

using test::WrittenWorld;

World read(const std::string& text) {
  return WrittenWorld(text).read();
}

double top_at(const World& world, double x_m, double y_m) {
  return height_at(world.solids, x_m, y_m).surface_m;
}

TEST(WorldFile, AnEmptyMapIsAnEmptyFloor) {
  const World world = read("{}\n");
  EXPECT_EQ(world.name, "course");
  EXPECT_TRUE(world.solids.empty());
  EXPECT_FALSE(world.floor_friction);
  EXPECT_EQ(world.start.position_m, Eigen::Vector2d::Zero());
  EXPECT_EQ(top_at(world, 3.0, 4.0), 0.0);
}

TEST(WorldFile, ABoxStandsTurnedOnItsPlace) {
  const World world = read(
      "boxes: [{position_m: [1, 2], yaw_deg: 90, size_m: [0.4, 0.2, 0.3], friction: 0.4, bottom_m: 0.1}]\n");
  ASSERT_EQ(world.solids.size(), 1U);
  const Solid& box = world.solids[0];
  EXPECT_EQ(box.kind, Kind::box);
  EXPECT_EQ(box.name, "box 1");
  EXPECT_EQ(box.friction, 0.4);
  const auto met = box.on_vertical(1.0, 2.19);  // its length lies along y
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->bottom_m, 0.1, 1e-12);
  EXPECT_NEAR(met->top_m, 0.4, 1e-12);
  EXPECT_FALSE(box.on_vertical(1.19, 2.0));
}

TEST(WorldFile, StepsGoUpAndDownAgain) {
  const World world = read(
      "steps: [{position_m: [1, 0], count: 3, rise_m: 0.02, run_m: 0.3, width_m: 1, top_m: 0.5, down: "
      "true}]\n");
  const std::vector<std::pair<double, double>> tops{{0.9, 0.0},   {1.15, 0.02}, {1.45, 0.04}, {1.65, 0.06},
                                                    {2.05, 0.06}, {2.25, 0.04}, {2.55, 0.02}, {2.75, 0.0}};
  for (const auto& [x_m, top_m] : tops) EXPECT_NEAR(top_at(world, x_m, 0.3), top_m, 1e-12) << x_m;
  EXPECT_EQ(top_at(world, 1.8, 0.51), 0.0);
  for (const Solid& solid : world.solids) EXPECT_EQ(solid.kind, Kind::step);
}

TEST(WorldFile, ASlopeRisesEvenlyToItsTop) {
  const World world = read(
      "slopes: [{position_m: [1, 1], yaw_deg: 90, length_m: 2, rise_m: 0.3, width_m: 1, top_m: 0.5, down: "
      "true}]\n");
  for (const auto& [along_m, top_m] : {std::pair{0.0, 0.0}, std::pair{0.5, 0.075}, std::pair{1.9, 0.285},
                                       std::pair{2.2, 0.3}, std::pair{2.6, 0.285}, std::pair{4.4, 0.015}}) {
    EXPECT_NEAR(top_at(world, 1.2, 1.0 + along_m), top_m, 1e-9) << along_m;
  }
  EXPECT_EQ(top_at(world, 1.6, 2.0), 0.0);
}

TEST(WorldFile, NothingIsHollowBelowASlope) {
  const World world = read("slopes: [{position_m: [0, 0], length_m: 1, rise_m: 0.5, width_m: 1}]\n");
  for (double x_m = 0.01; x_m < 1.0; x_m += 0.05) {
    const auto met = world.solids[0].on_vertical(x_m, 0.0);
    ASSERT_TRUE(met) << x_m;
    EXPECT_LE(met->bottom_m, 0.0) << x_m;
  }
}

TEST(WorldFile, TilesFillTheirFieldWithHeightsOfTheirSeed) {
  const std::string text =
      "tiles: [{position_m: [1, 0], size_m: [1, 0.6], tile_m: 0.2, height_m: 0.03, seed: ";
  const World world = read(text + "5}]\n"), again = read(text + "5}]\n"), other = read(text + "6}]\n");
  ASSERT_EQ(world.solids.size(), 15U);
  double largest_m = 0.0, differ_m = 0.0;
  for (double x_m = 0.55; x_m < 1.5; x_m += 0.1) {
    for (double y_m = -0.25; y_m < 0.3; y_m += 0.1) {
      const double top_m = top_at(world, x_m, y_m);
      EXPECT_GE(top_m, 0.0);
      EXPECT_LE(top_m, 0.03);
      EXPECT_EQ(top_m, top_at(again, x_m, y_m));
      largest_m = std::max(largest_m, top_m);
      differ_m = std::max(differ_m, std::abs(top_m - top_at(other, x_m, y_m)));
    }
  }
  EXPECT_GT(largest_m, 0.015);
  EXPECT_GT(differ_m, 0.005);
  EXPECT_EQ(top_at(world, 1.51, 0.0), 0.0);
}

TEST(WorldFile, AWallHasItsDoorsAndLintels) {
  const World world = read(
      "walls: [{name: north, from_m: [0, 0], to_m: [0, 4], height_m: 1.2, thickness_m: 0.1, doors: "
      "[{at_m: 1, width_m: 0.6, height_m: 0.9}, {at_m: 3, width_m: 0.6}]}]\n");
  std::vector<std::string> names;
  for (const Solid& solid : world.solids) names.push_back(solid.name);
  EXPECT_THAT(names, testing::ElementsAre("north part 1", "north lintel 1", "north part 2", "north part 3"));
  const auto at = [&](double y_m) { return height_at(world.solids, 0.0, y_m, 0.85); };
  EXPECT_NEAR(at(0.5).surface_m, 1.2, 1e-12);
  EXPECT_EQ(at(1.0).surface_m, 0.0);
  ASSERT_TRUE(at(1.0).underside_m);
  EXPECT_NEAR(*at(1.0).underside_m, 0.9, 1e-12);
  EXPECT_EQ(at(3.0).surface_m, 0.0);
  EXPECT_FALSE(at(3.0).underside_m);
  EXPECT_NEAR(at(3.5).surface_m, 1.2, 1e-12);
}

TEST(WorldFile, ThingsHaveTheirShapeAndMass) {
  const World world = read(
      "things:\n"
      "  - {name: ball, shape: sphere, diameter_m: 0.2, mass_kg: 0.1, position_m: [1, 0]}\n"
      "  - {shape: cylinder, diameter_m: 0.2, height_m: 0.3, mass_kg: 2, position_m: [2, 0], bottom_m: 0.5}\n"
      "  - {size_m: [0.1, 0.2, 0.3], mass_kg: 3, position_m: [3, 0], yaw_deg: 45}\n");
  ASSERT_EQ(world.things.size(), 3U);
  EXPECT_TRUE(world.solids.empty());
  EXPECT_EQ(world.things[0].solid.name, "ball");
  EXPECT_EQ(world.things[1].mass_kg, 2.0);
  EXPECT_NEAR(world.things[1].solid.pose.translation().z(), 0.65, 1e-12);
  const std::vector<Solid> all = world.all_solids(true);
  EXPECT_NEAR(height_at(all, 1.0, 0.0).surface_m, 0.2, 1e-12);
  EXPECT_NEAR(height_at(all, 1.06, 0.0).surface_m, 0.18, 1e-9);
  EXPECT_NEAR(height_at(all, 3.0, 0.0).surface_m, 0.3, 1e-12);
}

// z out of the picture, x to the right of who reads it, y up.
TEST(WorldFile, ATagLooksWhereItsAnglesSay) {
  const World world = read(
      "tags: [{id: 1, size_m: 0.2, position_m: [2, 0, 0.4], yaw_deg: 180}, "
      "{id: 2, size_m: 0.2, position_m: [0, 0, 0.001], pitch_deg: 90}]\n");
  ASSERT_EQ(world.tags.size(), 2U);
  const Eigen::Matrix3d facing = world.tags[0].pose.linear();
  EXPECT_NEAR((facing.col(2) - -Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((facing.col(1) - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((facing.col(0) - -Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-12)
      << "who looks ahead has right there";
  for (const Tag& tag : world.tags) EXPECT_NEAR(tag.pose.linear().determinant(), 1.0, 1e-12);
  EXPECT_NEAR(world.tags[1].pose.linear()(2, 2), 1.0, 1e-12) << "it lies on its back";
}

TEST(WorldFile, PartsLookAsTheySay) {
  const World world = read(
      "surfaces: {red: {plain: [1, 0, 0]}}\nfloor: {surface: red, friction: 0.3}\n"
      "boxes: [{position_m: [1, 0], size_m: [1, 1, 1]}, {position_m: [3, 0], size_m: [1, 1, 1], surface: "
      "red}]\n");
  EXPECT_EQ(world.floor_friction, 0.3);
  EXPECT_EQ(world.surfaces[world.floor_surface].colours[0], (Colour{1.0, 0.0, 0.0}));
  EXPECT_EQ(world.solids[1].surface, world.floor_surface);
  EXPECT_NE(world.solids[0].surface, world.floor_surface);
}

TEST(WorldFile, TheRobotBeginsWhereItSays) {
  const Start start = read("start: {position_m: [-1.5, 2], yaw_deg: -90}\n").start;
  EXPECT_EQ(start.position_m, Eigen::Vector2d(-1.5, 2.0));
  EXPECT_NEAR(start.yaw_rad, -std::numbers::pi / 2.0, 1e-12);
  EXPECT_EQ(start.line, 1);
}

}  // namespace
}  // namespace gaitway::world
