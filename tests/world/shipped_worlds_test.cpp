// The worlds that are shipped.
#include <set>

#include "gaitway/world/height_grid.hpp"
#include "written_world.hpp"

namespace gaitway::world {
namespace {

World shipped(const std::string& name) {
  return read_world(std::filesystem::path(GAITWAY_WORLDS) / (name + ".yaml"));
}

TEST(ShippedWorlds, AreTheseAndCanBeRead) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(GAITWAY_WORLDS)) {
    names.insert(entry.path().stem().string());
    EXPECT_NO_THROW((void)read_world(entry.path())) << entry.path();
  }
  EXPECT_EQ(names, (std::set<std::string>{"boxes", "course", "doorway", "empty", "rough", "slalom", "stairs"}));
}

TEST(ShippedWorlds, BoxesIsARoomOfSixMetresWithFortyFive) {
  const World world = shipped("boxes");
  EXPECT_EQ(std::ranges::count(world.solids, Kind::box, &Solid::kind), 45);
  EXPECT_EQ(std::ranges::count(world.solids, Kind::wall, &Solid::kind), 4);
  for (const double x_m : {-3.0, 3.0}) EXPECT_GT(height_at(world.solids, x_m, 0.0).surface_m, 0.1);
  for (const Solid& box : world.solids) {
    if (box.kind != Kind::box) continue;
    EXPECT_LE(box.pose.translation().head<2>().cwiseAbs().maxCoeff(), 3.0);
    EXPECT_GE(box.pose.translation().head<2>().norm(), 0.8) << "off the start";
  }
}

TEST(ShippedWorlds, TheDoorwayCanBeWalkedThrough) {
  const World world = shipped("doorway");
  constexpr double kRobot_m = 0.85;
  bool has_lintel = false;
  for (double x_m = -0.5; x_m < 3.0; x_m += 0.02) {
    const Height height = height_at(world.solids, x_m, 0.0, kRobot_m);
    EXPECT_EQ(height.surface_m, 0.0) << x_m;
    has_lintel = has_lintel || height.underside_m;
  }
  EXPECT_TRUE(has_lintel);
}

TEST(ShippedWorlds, TheStairsAreLow) {
  const World world = shipped("stairs");
  double before_m = 0.0, highest_m = 0.0;
  for (double x_m = 0.0; x_m < 8.0; x_m += 0.01) {
    const double top_m = height_at(world.solids, x_m, 0.0).surface_m;
    EXPECT_LE(std::abs(top_m - before_m), 0.0101) << x_m;
    before_m = top_m;
    highest_m = std::max(highest_m, top_m);
  }
  EXPECT_GT(highest_m, 0.029);
  EXPECT_EQ(before_m, 0.0) << "down again";
}

TEST(ShippedWorlds, TheRoughGroundIsRough) {
  const World world = shipped("rough");
  std::set<double> heights;
  for (double x_m = 0.0; x_m < 4.0; x_m += 0.05) heights.insert(height_at(world.solids, x_m, 0.0).surface_m);
  EXPECT_GT(heights.size(), 10U);
  EXPECT_EQ(height_at(world.solids, 0.0, 0.0).surface_m, 0.0) << "level where it begins";
}

}  // namespace
}  // namespace gaitway::world
