// A fall through the whole chain: told, soft on every joint at once, and lying still until somebody asks for
// more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "gaitway/core/event_log.hpp"
#include "gaitway/msgclient/cycle.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kFalls = 1, kLies = 2;  // Estimate::fall

// The robot walks at 0.2 m/s and is pushed so hard to the left that no step could save it.
class FallTest : public ::testing::Test {
 protected:
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
  double largest_torque_Nm() {
    double largest = 0.0;
    for (const double torque : run_.cosimulation.plant().sensors().motor_torque_Nm) {
      largest = std::max(largest, std::abs(torque));
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
  double told_s_ = 0.0;
};

TEST_F(FallTest, EveryJointIsSoftWithinTwoTimeSlotsAndStaysSo) {
  fell_the_robot();
  ASSERT_EQ(fall(), kFalls);
  EXPECT_LT(told_s_, 3.5);
  EXPECT_FALSE(run_.cosimulation.plant().fallen()) << "told before";
  EXPECT_GT(largest_torque_Nm(), 1.0);
  advance_to(told_s_ + 0.02);
  while (run_.time_s() < told_s_ + 3.0) {
    ASSERT_EQ(largest_torque_Nm(), 0.0) << run_.time_s() - told_s_ << " s after it was told";
    run_.cosimulation.advance_millisecond();
  }
  EXPECT_EQ(fall(), kLies);
  EXPECT_TRUE(run_.cosimulation.plant().fallen());
  EXPECT_THAT(events(), HasSubstr("the robot falls to the left"));
  EXPECT_THAT(events(), HasSubstr("the robot lies"));
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
  advance_to(told_s_ + 0.06);
  while (run_.time_s() < told_s_ + 1.0) {
    ASSERT_EQ(largest_torque_Nm(), 0.0) << run_.time_s() - told_s_ << " s after it was told";
    run_.cosimulation.advance_millisecond();
  }
}

}  // namespace
}  // namespace gaitway::scenarios
