// What is put into the world while the robot is in it, moved there and taken away.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "world_fixture.hpp"

namespace gaitway::simulator {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr world::Colour kRed{0.8, 0.1, 0.1};
constexpr const char* kEmpty = "start: {position_m: [0, 0]}\n";
constexpr const char* kOneThing =
    "things: [{name: crate, size_m: [0.2, 0.2, 0.2], mass_kg: 0.8, position_m: [1, 1]}]\n"
    "boxes: [{name: pillar, position_m: [2, 0], size_m: [0.2, 0.2, 1]}]\n";

world::Solid solid(const std::string& name, double x_m, double y_m, double z_m,
                   world::Solid::Shape shape = world::Solid::Shape::box, double size_m = 0.2) {
  world::Solid one;
  one.name = name;
  one.shape = shape;
  one.size_m.setConstant(size_m);
  one.pose.translation() = Eigen::Vector3d(x_m, y_m, z_m);
  return one;
}

Eigen::Isometry3d at(double x_m, double y_m, double z_m) {
  return Eigen::Isometry3d(Eigen::Translation3d(x_m, y_m, z_m));
}

std::string refusal_of(const std::function<void()>& change) {
  try {
    change();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

class WorldChangeTest : public WorldTest {
 protected:
  [[nodiscard]] static Eigen::Vector3d place_of(const Plant& robot, const std::string& name) {
    for (const world::Solid& one : robot.solids()) {
      if (one.name == name) return one.pose.translation();
    }
    ADD_FAILURE() << "there is no " << name;
    return Eigen::Vector3d::Zero();
  }
};

TEST_F(WorldChangeTest, ABallThatIsPutInTheAirFallsAndRolls) {
  Plant robot = plant(kEmpty);
  hold(robot, 300);
  robot.put(solid("ball", 1.0, 0.5, 0.6, world::Solid::Shape::sphere), kRed, 0.4);
  hold(robot, 100);
  EXPECT_NEAR(place_of(robot, "ball").z(), 0.6 - 0.5 * 9.81 * 0.1 * 0.1, 0.01);
  hold(robot, 2000);
  EXPECT_NEAR(place_of(robot, "ball").z(), 0.1, 0.003);
  EXPECT_FALSE(robot.fallen());
  robot.push("ball", {1.0, 0.0, 0.0}, 0.2, 0.1);
  hold(robot, 500);
  EXPECT_GT(place_of(robot, "ball").x(), 1.1);
}

TEST_F(WorldChangeTest, WhatStandsFastStandsFast) {
  Plant robot = plant(kEmpty);
  robot.put(solid("block", 1.0, 0.0, 0.5), kRed, std::nullopt);
  hold(robot, 500);
  EXPECT_TRUE(place_of(robot, "block").isApprox(Eigen::Vector3d(1.0, 0.0, 0.5)));
}

// All that moves goes on as it did: the robot to the bit in this instant, a thing with its speed.
TEST_F(WorldChangeTest, WhatIsThereGoesOn) {
  Plant robot = plant(kOneThing);
  hold(robot, 200);
  robot.push("crate", {1.0, 0.0, 0.0}, 1.6, 0.01);  // 2 m/s
  hold(robot, 20);
  const std::vector<double> positions(robot.positions().begin(), robot.positions().end());
  const std::vector<double> velocities(robot.velocities().begin(), robot.velocities().end());
  const GroundContact contact = robot.ground_contact();
  robot.put(solid("far", 5.0, 5.0, 0.1), kRed, 1.0);
  ASSERT_EQ(robot.positions().size(), positions.size() + 7);
  EXPECT_TRUE(std::equal(positions.begin(), positions.end(), robot.positions().begin()));
  EXPECT_TRUE(std::equal(velocities.begin(), velocities.end(), robot.velocities().begin()));
  EXPECT_EQ(robot.ground_contact().normal_force_N, contact.normal_force_N);
  const double before_m = place_of(robot, "crate").x();
  hold(robot, 20);
  EXPECT_GT(place_of(robot, "crate").x(), before_m + 0.02);
}

// A force that acts goes on, on the body that it acts on and no other.
TEST_F(WorldChangeTest, APushGoesOn) {
  Plant pushed = plant(kOneThing), changed = plant(kOneThing);
  for (Plant* robot : {&pushed, &changed}) {
    hold(*robot, 100);
    robot->push("crate", {1.0, 0.0, 0.0}, 1.6, 0.2);
    hold(*robot, 100);
    if (robot == &changed) {
      robot->put(solid("before", 4.0, 0.0, 0.1), kRed, std::nullopt);
      robot->put(solid("behind", 4.0, 2.0, 0.1), kRed, 1.0);
    }
    hold(*robot, 150);
  }
  EXPECT_NEAR(place_of(changed, "crate").x(), place_of(pushed, "crate").x(), 1e-4);
  EXPECT_GT(place_of(pushed, "crate").x(), 1.05);
  EXPECT_NEAR(place_of(changed, "behind").x(), 4.0, 1e-6);
}

TEST_F(WorldChangeTest, ThingsMoveAndComeToRestThere) {
  Plant robot = plant(kOneThing);
  robot.push("crate", {1.0, 0.0, 0.0}, 1.6, 0.01);
  hold(robot, 50);
  robot.move("crate", at(-1.0, -1.0, 0.1));
  hold(robot, 300);
  EXPECT_TRUE(place_of(robot, "crate").isApprox(Eigen::Vector3d(-1.0, -1.0, 0.1), 1e-3));
  robot.put(solid("block", 1.0, 0.0, 0.5), kRed, std::nullopt);
  robot.move("block", at(1.5, 0.0, 0.5));
  EXPECT_TRUE(place_of(robot, "block").isApprox(Eigen::Vector3d(1.5, 0.0, 0.5)));
}

TEST_F(WorldChangeTest, TheRobotFeelsAndTellsWhatWasPutThere) {
  Plant robot = plant(kEmpty);
  hold(robot, 200);
  robot.put(solid("wall", 0.5, 0.0, 0.5, world::Solid::Shape::box, 0.6), kRed, std::nullopt);
  robot.push("trunk", {1.0, 0.0, 0.0}, 6.0, 0.1);
  bool touched = false;
  for (int ms = 0; ms < 1000 && !touched; ++ms) {
    hold(robot, 1);
    for (const BodyContact& contact : robot.body_contacts()) {
      touched = touched || (contact.solid >= 0 &&
                            robot.solids()[static_cast<std::size_t>(contact.solid)].name == "wall");
    }
  }
  EXPECT_TRUE(touched);
}

TEST_F(WorldChangeTest, WhatWasPutGoesAgain) {
  Plant robot = plant(kOneThing);
  const std::uint32_t first = robot.geometry();
  robot.put(solid("ball", 1.0, -1.0, 0.1, world::Solid::Shape::sphere), kRed, 0.4);
  robot.put(solid("block", 3.0, -1.0, 0.1), kRed, std::nullopt);
  std::vector<std::string> names;
  for (const world::Solid& one : robot.put_solids()) names.push_back(one.name);
  EXPECT_THAT(names, ElementsAre("block", "ball"));
  EXPECT_EQ(robot.geometry(), first + 2);
  robot.remove("ball");
  robot.remove("block");
  EXPECT_TRUE(robot.put_solids().empty());
  EXPECT_EQ(robot.solids().size(), 2U);
  hold(robot, 200);
  EXPECT_FALSE(robot.fallen());
}

TEST_F(WorldChangeTest, ColoursOfWhatIsGoneAreFree) {
  Plant robot = plant(kOneThing);
  const std::size_t own = robot.world()->surfaces.size();
  for (int i = 0; i < 100; ++i) {
    robot.put(solid("first", 3.0, 1.0, 0.1), {0.001 * i, 0.2, 0.3}, std::nullopt);
    robot.put(solid("second", 3.0, 2.0, 0.1), {0.001 * i, 0.7, 0.3}, 1.0);
    robot.remove("first");
    const world::World& world = *robot.world();
    EXPECT_EQ(world.surfaces[world.things.back().solid.surface].colours[0],
              (world::Colour{0.001 * i, 0.7, 0.3}));
    robot.remove("second");
  }
  EXPECT_EQ(robot.world()->surfaces.size(), own);
}

TEST_F(WorldChangeTest, RefusalsNameTheRuleAndChangeNothing) {
  Plant robot = plant(kOneThing);
  hold(robot, 100);
  const std::uint32_t geometry = robot.geometry();
  EXPECT_THAT(refusal_of([&] { robot.put(solid("crate", 3, 3, 0.1), kRed, 1.0); }),
              HasSubstr("has a 'crate' already"));
  EXPECT_THAT(refusal_of([&] { robot.put(solid("block", 0, 0, 0.1), kRed, 1.0); }),
              HasSubstr("inside the robot's"));
  EXPECT_THAT(refusal_of([&] { robot.move("crate", at(0, 0, 0.1)); }), HasSubstr("inside the robot's"));
  EXPECT_THAT(refusal_of([&] { robot.move("pillar", at(3, 3, 0.5)); }), HasSubstr("stands fast"));
  EXPECT_THAT(refusal_of([&] { robot.move("crat", at(3, 3, 0.5)); }), HasSubstr("Did you mean 'crate'?"));
  EXPECT_THAT(refusal_of([&] { robot.remove("crate"); }), HasSubstr("nothing that was put"));
  EXPECT_EQ(robot.geometry(), geometry);
  EXPECT_TRUE(place_of(robot, "crate").isApprox(Eigen::Vector3d(1.0, 1.0, 0.1), 1e-3));
  Plant in_no_world(model_, PlantOptions{});
  EXPECT_THAT(refusal_of([&] { in_no_world.put(solid("block", 3, 3, 0.1), kRed, 1.0); }),
              HasSubstr("--world empty"));
}

TEST_F(WorldChangeTest, TheSameChangesGiveTheSameMotionToTheBit) {
  const auto last = [this] {
    Plant robot = plant(kOneThing);
    hold(robot, 100);
    robot.put(solid("ball", 0.4, 0.1, 0.9, world::Solid::Shape::sphere), kRed, 0.3);
    hold(robot, 300);
    robot.move("crate", at(0.5, 0.0, 0.4));
    hold(robot, 300);
    return std::vector<double>(robot.positions().begin(), robot.positions().end());
  };
  EXPECT_EQ(last(), last());
}

}  // namespace
}  // namespace gaitway::simulator
