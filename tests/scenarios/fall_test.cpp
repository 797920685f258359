// A fall through the whole chain: told, into a posture, soft on every joint once it lies, and lying still
// until somebody asks for more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/event_log.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;

// Torque constants are 10 % off, and a gear of 0.9 adds what it loses to a motor that brakes.
constexpr double kStrongestMotor = 1.1 / 0.9;
constexpr std::uint32_t kFalls = estimate::fall::falls, kLies = estimate::fall::lies;

// The robot walks at 0.2 m/s and is pushed so hard to the left that no step could save it.
struct Fall {
  explicit Fall(const core::Configuration& plugins) : run_(3, plugins) {}
  Fall() = default;

  void fell_the_robot() {
    run_.apply(walk_at(0.0, 0.2));
    advance_to(3.0);
    run_.apply(
        {0.0, simulator::PushEvent{
                  .body = "trunk", .direction = {0.0, 1.0, 0.0}, .impulse_Ns = 7.0, .duration_s = 0.1}});
    while (fall() == 0 && run_.time_s() < 5.0) run_.cosimulation.advance_millisecond();
    told_s_ = run_.time_s();
  }
  void advance_to(double time_s) {
    while (run_.time_s() < time_s - 1e-9) run_.cosimulation.advance_millisecond();
  }
  std::uint32_t fall() {
    Estimate estimate{};
    estimate_.read(estimate);
    return estimate.fall;
  }
  double reference_rad(const std::string& name) {
    JointStates states{};
    joints_.read(states);
    const auto& joints = humanoid22().joints;
    const auto joint = std::find_if(joints.begin(), joints.end(),
                                    [&name](const urdf::Joint& candidate) { return candidate.name == name; });
    return states.reference_position[joint - joints.begin()];
  }
  void expect_soft(double from_s, double to_s) {
    advance_to(from_s);
    while (run_.time_s() < to_s) {
      ASSERT_EQ(largest_torque_Nm(), 0.0) << run_.time_s() - told_s_ << " s after it was told";
      run_.cosimulation.advance_millisecond();
    }
  }
  double largest_torque_Nm() {
    double largest = 0.0;
    for (const double torque : run_.cosimulation.plant().sensors().motor_torque_Nm) {
      largest = std::max(largest, std::abs(torque));
    }
    return largest;
  }
  // Of the speed of any joint's reference, from one time slot to the next, while it falls.
  double largest_change_rad_per_s(double until_s) {
    std::array<JointStates, 3> slots{};  // the newest last
    double largest = 0.0;
    for (int heard = 0; fall() == kFalls && run_.time_s() < until_s;
         run_.cosimulation.advance_millisecond()) {
      JointStates now{};
      joints_.read(now);
      if (now.stamp_ns == slots[2].stamp_ns) continue;
      slots = {slots[1], slots[2], now};
      if (++heard < 3) continue;
      for (std::size_t j = 0; j < now.joint_count; ++j) {
        const double change_rad = slots[2].reference_position[j] - 2.0 * slots[1].reference_position[j] +
                                  slots[0].reference_position[j];
        largest = std::max(largest, std::abs(change_rad) / facts::kSlot_s);
      }
    }
    return largest;
  }
  std::string events() {
    std::string all;
    const core::EventLog& log = run_.cosimulation.main_controller().events();
    for (std::uint64_t i = log.first(); i < log.total(); ++i) all += std::string(log[i].text()) + "\n";
    return all;
  }

  SimulatedRun run_{3};
  msgclient::Reader<Estimate> estimate_ = run_.cosimulation.client().read<Estimate>("estimate");
  msgclient::Reader<JointStates> joints_ = run_.cosimulation.client().read<JointStates>("joint_states");
  double told_s_ = 0.0;
};

class FallTest : public ::testing::Test, protected Fall {};

TEST_F(FallTest, MeetsTheGroundInAPostureAndIsSoftOnceItLies) {
  fell_the_robot();
  ASSERT_EQ(fall(), kFalls);
  EXPECT_LT(told_s_, 3.5);
  EXPECT_FALSE(run_.cosimulation.plant().fallen()) << "told before";
  const double waist_rad = reference_rad("waist_yaw");
  advance_to(told_s_ + 0.02);
  while (fall() == kFalls && run_.time_s() < told_s_ + 2.0) {
    ASSERT_LE(largest_torque_Nm(), 0.58 * 8.0 * kStrongestMotor) << "4/7 of it, within two time slots";
    run_.cosimulation.advance_millisecond();
  }
  ASSERT_EQ(fall(), kLies);
  EXPECT_GT(reference_rad("waist_yaw") - waist_rad, 0.8) << "the chest turns to the ground";
  expect_soft(run_.time_s() + 0.02, told_s_ + 4.0);
  EXPECT_TRUE(run_.cosimulation.plant().fallen());
  EXPECT_NEAR(reference_rad("waist_yaw"), 0.0, 0.01) << "back in the stand's angles, for who gets up next";
  EXPECT_THAT(events(), HasSubstr("the robot falls to the left"));
  EXPECT_THAT(events(), HasSubstr("the robot lies"));
  EXPECT_EQ(run_.cosimulation.main_controller().statistics().refused_locally, 0U) << events();
}

TEST_F(FallTest, MeetsTheGroundInThePostureOutOfASafeTail) {
  run_.apply(walk_at(0.0, 0.2));
  advance_to(2.9);
  run_.cosimulation.apply({0.0, simulator::MainControllerSilentFault{0.15}});
  fell_the_robot();
  ASSERT_EQ(fall(), kFalls);
  NetworkState network{};
  run_.cosimulation.client().read<NetworkState>("network_state").read(network);
  ASSERT_EQ(network.mode, 1U) << "the tail of 1.4 s plays";
  while (fall() == kFalls && run_.time_s() < told_s_ + 2.0) run_.cosimulation.advance_millisecond();
  EXPECT_LT(reference_rad("left_shoulder_pitch"), -1.2)
      << "whatever way it falls in mid-step, the arm is ahead";
  EXPECT_EQ(run_.cosimulation.main_controller().statistics().refused_locally, 0U) << events();
}

TEST_F(FallTest, BeginsThePostureAgainWhenItsFirstBatchFails) {
  fell_the_robot();
  ASSERT_EQ(fall(), kFalls);
  const double waist_rad = reference_rad("waist_yaw");
  run_.cosimulation.apply({0.0, simulator::PluginFault{.plugin = "kinematics", .duration_s = 0.08}});
  while (fall() == kFalls && run_.time_s() < told_s_ + 2.0) run_.cosimulation.advance_millisecond();
  ASSERT_EQ(fall(), kLies);
  EXPECT_THAT(events(), HasSubstr("kinematics")) << "the batch failed";
  EXPECT_GT(reference_rad("waist_yaw") - waist_rad, 0.5) << "the chest turns to the ground all the same";
}

// In the middle of a swing a tail moves its joints at some 7 rad/s. The posture goes on from there: begun
// from references that are a time slot old, as if they rested, joints would be thrown back.
TEST(FallOutOfAFastTail, ThePostureGoesOnAsTheTailMovesAndIsNotRefused) {
  constexpr double kLargestChange_rad_per_s = 7.0;  // of a joint's speed in a time slot
  for (int instant = 0; instant < 6; ++instant) {
    Fall fall;
    fall.run_.apply(walk_at(0.0, 0.35));
    fall.advance_to(3.0 + 0.05 * instant);
    fall.run_.apply(
        {0.0, simulator::PushEvent{
                  .body = "trunk", .direction = {0.0, 1.0, 0.0}, .impulse_Ns = 9.0, .duration_s = 0.1}});
    fall.advance_to(fall.run_.time_s() + 0.10);
    fall.run_.cosimulation.apply({0.0, simulator::MainControllerSilentFault{0.09}});
    while (fall.fall() != kFalls && fall.run_.time_s() < 5.0) fall.run_.cosimulation.advance_millisecond();
    ASSERT_EQ(fall.fall(), kFalls) << instant;
    EXPECT_LT(fall.largest_change_rad_per_s(6.0), kLargestChange_rad_per_s) << instant;
    EXPECT_EQ(fall.run_.cosimulation.main_controller().statistics().refused_locally, 0U)
        << instant << ": " << fall.events();
  }
}

TEST(FallWithoutPosture, EveryJointIsSoftWithinTwoTimeSlotsAndStaysSo) {
  core::Configuration plugins =
      core::read_configuration(std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml");
  for (core::PluginEntry& plugin : plugins.plugins) {
    if (plugin.name == "trajectory") plugin.parameters.push_back({.name = "fall_posture", .text = "false"});
    if (plugin.name == "stability") plugin.parameters.push_back({.name = "fall_posture_wait", .text = "0 s"});
  }
  Fall fall(plugins);
  fall.fell_the_robot();
  ASSERT_EQ(fall.fall(), kFalls);
  EXPECT_GT(fall.largest_torque_Nm(), 1.0);
  fall.expect_soft(fall.told_s_ + 0.02, fall.told_s_ + 3.0);
}

TEST_F(FallTest, NobodyWalksOnWhileTheRobotLies) {
  fell_the_robot();
  advance_to(told_s_ + 3.0);
  MotionPlan plan{};
  ASSERT_EQ(run_.cosimulation.client().read<MotionPlan>("motion_plan").read(plan).status,
            msgclient::ReadStatus::value);
  EXPECT_EQ(plan.footstep_count, 0U) << "the walk command from before the fall is void";
}

TEST_F(FallTest, LostFramesDoNotKeepAJointStiff) {
  run_.cosimulation.apply(
      {0.0, simulator::DisturbBusFault{
                .corruption = 0.02, .omission = 0.02, .duplicate = 0.0, .duration_s = 60.0}});
  fell_the_robot();
  ASSERT_EQ(fall(), kFalls);
  while (fall() == kFalls && run_.time_s() < told_s_ + 2.0) run_.cosimulation.advance_millisecond();
  ASSERT_EQ(fall(), kLies);
  expect_soft(run_.time_s() + 0.06, told_s_ + 2.0);
}

}  // namespace
}  // namespace gaitway::scenarios
