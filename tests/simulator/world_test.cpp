// A robot in a world: it stands on its ground, pushes its things, and tells what of its body touches what.
#include "world_fixture.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "gaitway/input/complaint.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

// The place of the world's first thing.
Eigen::Vector3d thing_place(const Plant& robot) {
  return robot.solids()[robot.world()->solids.size()].pose.translation();
}

TEST_F(WorldTest, StandsOnASlopeAndLeansWithIt) {
  Plant robot =
      plant("slopes: [{position_m: [-0.5, 0], length_m: 1, rise_m: 0.0524, width_m: 2}]\n");  // 3 deg
  hold(robot, 1500);
  EXPECT_FALSE(robot.fallen());
  EXPECT_NEAR(robot.sensors().inclination_rad.y(), -3.0 * kRadPerDeg, 0.01);
  EXPECT_NEAR(robot.ground_contact().sole[0].translation().z(), 0.0262, 0.002);
  EXPECT_NEAR(robot.ground_contact().normal_force_N[0] + robot.ground_contact().normal_force_N[1],
              model_.total_mass_kg() * 9.81 * std::cos(3.0 * kRadPerDeg), 0.5);
  EXPECT_TRUE(robot.body_contacts().empty()) << "soles on a slope stand";
}

TEST_F(WorldTest, StandsOnTilesWhereTheyAreHighest) {
  Plant robot =
      plant("tiles: [{position_m: [0, 0], size_m: [1, 1], tile_m: 0.05, height_m: 0.004, seed: 2}]\n");
  hold(robot, 1500);
  EXPECT_FALSE(robot.fallen());
  EXPECT_GT(robot.ground_contact().sole[0].translation().z(), 0.001);
  EXPECT_LT(robot.ground_contact().sole[0].translation().z(), 0.005);
  EXPECT_TRUE(robot.body_contacts().empty());
}

TEST_F(WorldTest, BeginsWhereTheWorldSaysOnTheGroundThatIsThere) {
  Plant robot = plant(
      "start: {position_m: [3, -2], yaw_deg: 120}\n"
      "slopes: [{position_m: [3, -3], yaw_deg: 90, length_m: 0.5, rise_m: 0.2, width_m: 1, top_m: 1}]\n");
  const PlantTruth truth = robot.truth();
  EXPECT_NEAR(truth.base.translation().x(), 3.0, 1e-9);
  EXPECT_NEAR(truth.base.translation().y(), -2.0, 1e-9);
  EXPECT_NEAR(std::atan2(truth.base.linear()(1, 0), truth.base.linear()(0, 0)), 120.0 * kRadPerDeg, 1e-9);
  for (const Eigen::Isometry3d& sole : robot.ground_contact().sole) {
    EXPECT_NEAR(sole.translation().z(), 0.2, 1e-9);
  }
  hold(robot, 1000);
  EXPECT_FALSE(robot.fallen());
  EXPECT_LT(robot.truth().trunk_tilt_rad, 0.01);
}

TEST_F(WorldTest, AFallIsToldOnAPlatform) {
  Plant robot = plant("slopes: [{position_m: [-3, 0], length_m: 1, rise_m: 0.6, width_m: 4, top_m: 4}]\n");
  const std::vector<double> no_torque(model_.joints.size(), 0.0);
  for (int ms = 0; ms < 3000 && !robot.fallen(); ++ms) robot.step(no_torque);
  EXPECT_TRUE(robot.fallen());
  EXPECT_GT(robot.truth().base.translation().z(), 0.6);
}

TEST_F(WorldTest, ABoxThatIsDroppedComesToRest) {
  Plant robot = plant(
      "things: [{size_m: [0.2, 0.1, 0.3], mass_kg: 0.8, position_m: [1, 1], yaw_deg: 20, bottom_m: 0.2}]\n");
  EXPECT_NEAR(thing_place(robot).z(), 0.35, 1e-9);
  hold(robot, 2000);
  const Eigen::Vector3d rests = thing_place(robot);
  EXPECT_NEAR(rests.z(), 0.15, 0.001);
  hold(robot, 500);
  EXPECT_LT((thing_place(robot) - rests).norm(), 1e-4);
  EXPECT_FALSE(robot.fallen());
}

// What has begun to slide at v comes to rest after v² / (2 µ g).
TEST_F(WorldTest, ThingsSlideAsFarAsTheFrictionLetsThem) {
  const auto slides_m = [this](const std::string& floor, const std::string& thing) {
    Plant robot =
        plant("floor: {" + floor + "}\nthings: [{name: puck, size_m: [0.3, 0.3, 0.04], mass_kg: 2, " + thing +
              "position_m: [1, 1]}]\n");
    hold(robot, 300);
    const Eigen::Vector3d from = thing_place(robot);
    robot.push("puck", Eigen::Vector3d::UnitX(), 2.0, 0.001);  // 1 m/s
    hold(robot, 1500);
    return (thing_place(robot) - from).norm();
  };
  EXPECT_NEAR(slides_m("friction: 0.2", ""), 1.0 / (2.0 * 0.2 * 9.81), 0.02) << "the floor's";
  EXPECT_NEAR(slides_m("friction: 0.6", ""), 1.0 / (2.0 * 0.6 * 9.81), 0.01);
  EXPECT_NEAR(slides_m("friction: 0.6", "friction: 0.2, "), 1.0 / (2.0 * 0.2 * 9.81), 0.02) << "its own";
}

TEST_F(WorldTest, OnASlipperyFloorTheRobotSlides) {
  const auto slid_m = [this](const std::string& friction) {
    Plant robot = plant("floor: {friction: " + friction + "}\n");
    hold(robot, 500);
    const Eigen::Vector3d from = robot.ground_contact().sole[0].translation();
    robot.push("pelvis", Eigen::Vector3d::UnitX(), 2.0, 0.2);
    hold(robot, 1000);
    EXPECT_FALSE(robot.fallen());
    return (robot.ground_contact().sole[0].translation() - from).norm();
  };
  EXPECT_GT(slid_m("0.03"), 0.05);
  EXPECT_LT(slid_m("1.0"), 0.01);
}

TEST_F(WorldTest, APushIntoAWallTellsLinkAndForce) {
  Plant robot = plant("walls: [{name: north, from_m: [0.2, -1], to_m: [0.2, 1], height_m: 1}]\n");
  hold(robot, 500);
  EXPECT_TRUE(robot.body_contacts().empty()) << "it stands beside the wall";
  robot.push("trunk", Eigen::Vector3d::UnitX(), 6.0, 0.1);
  double hardest_N = 0.0, impulse_Ns = 0.0;
  int feet = 0;
  for (int ms = 0; ms < 400; ++ms) {
    hold(robot, 1);
    for (const BodyContact& contact : robot.body_contacts()) {
      EXPECT_EQ(robot.world()->all_solids(true)[static_cast<std::size_t>(contact.solid)].name, "north");
      feet += contact.link == link("left_foot") || contact.link == link("right_foot") ? 1 : 0;
      hardest_N = std::max(hardest_N, contact.force_N);
      impulse_Ns += 0.001 * contact.force_N;
    }
  }
  EXPECT_GT(hardest_N, 10.0);
  EXPECT_GT(impulse_Ns, 0.5);
  EXPECT_LT(impulse_Ns, 12.0) << "no more than was given, and thrown back";
  EXPECT_EQ(feet, 0) << "the trunk or the arms hit it, the feet stay behind";
}

// What a toe meets does not load its sole.
TEST_F(WorldTest, AFootAgainstAWallIsAContactAndNoLoad) {
  Plant robot =
      plant("floor: {friction: 0.02}\nboxes: [{name: kerb, position_m: [0.6, 0], size_m: [0.9, 2, 0.1]}]\n");
  hold(robot, 300);
  robot.push("pelvis", Eigen::Vector3d::UnitX(), 3.0, 0.2);
  double kerb_N = 0.0, sole_N = 0.0;
  for (int ms = 0; ms < 500; ++ms) {
    hold(robot, 1);
    for (const BodyContact& contact : robot.body_contacts()) {
      if (contact.link == link("left_foot") || contact.link == link("right_foot")) {
        kerb_N = std::max(kerb_N, contact.force_N);
      }
    }
    if (kerb_N > 0.0 && sole_N == 0.0) {
      sole_N = robot.ground_contact().normal_force_N[0] + robot.ground_contact().normal_force_N[1];
      for (const Eigen::Vector2d& cop : robot.ground_contact().foot_cop_m) {
        EXPECT_LT(cop.norm(), 0.09) << "within the sole";
      }
    }
  }
  EXPECT_GT(kerb_N, 1.0);
  EXPECT_LT(sole_N, 1.5 * model_.total_mass_kg() * 9.81);
}

TEST_F(WorldTest, OneSeedGivesTheSameMotionToTheBitThingsIncluded) {
  const std::string text =
      "things:\n"
      "  - {name: ball, shape: sphere, diameter_m: 0.12, mass_kg: 0.3, position_m: [0.25, 0.05], bottom_m: "
      "0.4}\n"
      "  - {shape: cylinder, diameter_m: 0.1, height_m: 0.3, mass_kg: 0.5, position_m: [0.2, -0.1], "
      "bottom_m: 0.01}\n"
      "  - {size_m: [0.2, 0.2, 0.2], mass_kg: 1, position_m: [0.25, 0.05]}\n";
  const auto end_of = [&](std::uint64_t seed) {
    PlantOptions chosen = options(text);
    chosen.seed = seed;
    chosen.mismatch = 1.0;
    chosen.sensor_noise = true;
    Plant robot(model_, chosen);
    std::vector<float> torques;
    HomeServo servo(model_);
    for (int ms = 0; ms < 1500; ++ms) {
      robot.step(servo(robot));
      for (const double torque : robot.sensors().motor_torque_Nm)
        torques.push_back(static_cast<float>(torque));
    }
    std::vector<double> end(robot.positions().begin(), robot.positions().end());
    EXPECT_EQ(robot.replay(torques).positions, end);
    return end;
  };
  const std::vector<double> end = end_of(3);
  EXPECT_EQ(end.size(), 7U + model_.joints.size() + 3U * 7U);
  EXPECT_EQ(end, end_of(3));
  EXPECT_NE(end, end_of(4));
}

class StartTest : public WorldTest {
 protected:
  void expect_refused(const std::string& text, const std::vector<std::string>& parts) const {
    try {
      (void)plant(text);
      ADD_FAILURE() << "has room:\n" << text;
    } catch (const input::InputError& error) {
      for (const std::string& part : parts) EXPECT_THAT(error.what(), testing::HasSubstr(part));
      EXPECT_THAT(error.what(), testing::HasSubstr(file_.string()));
    }
  }
};

TEST_F(StartTest, InsideAnObstacleIsRefusedByLinkAndName) {
  expect_refused(
      "start: {position_m: [2, 0]}\nboxes: [{name: crate, position_m: [2, 0.05], size_m: [0.1, 0.1, 0.2]}]\n",
      {".yaml:1: start: the robot's left_", "inside of box 'crate'", "Begin elsewhere"});
  expect_refused("walls: [{name: north, from_m: [0.02, -1], to_m: [0.02, 1], height_m: 1}]\n",
                 {"inside of wall 'north'"});
  expect_refused("things: [{name: ball, shape: sphere, diameter_m: 0.3, mass_kg: 1, position_m: [0.1, 0]}]\n",
                 {"inside of thing 'ball'"});
}

TEST_F(StartTest, OnUnevenGroundIsRefused) {
  expect_refused("steps: [{position_m: [0, 0], count: 1, rise_m: 0.1, run_m: 1, width_m: 2}]\n",
                 {"start: the ground under the soles differs by 100 mm"});
}

TEST_F(StartTest, AThingInsideOfABoxIsRefusedInItsLine) {
  expect_refused(
      "boxes: [{name: crate, position_m: [2, 0], size_m: [0.5, 0.5, 0.5]}]\n"
      "things: [{name: ball, shape: sphere, diameter_m: 0.1, mass_kg: 1, position_m: [2.2, 0]}]\n",
      {".yaml:2: ball: the thing begins", "inside of box 'crate'"});
}

TEST_F(WorldTest, ConditionsOfAnotherGroundAreRefused) {
  PlantOptions chosen = options("{}\n");
  chosen.conditions.ground.friction = 0.5;
  EXPECT_NO_THROW((void)Plant(model_, chosen));
  chosen.conditions.ground.tile_height_m = 0.005;
  EXPECT_THROW((void)Plant(model_, chosen), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::simulator
