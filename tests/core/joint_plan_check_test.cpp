// Each rule alone, at its edge, in batch and tail.
#include "gaitway/core/joint_plan_check.hpp"

#include <gmock/gmock.h>

#include <array>
#include <limits>
#include <memory>

namespace gaitway::core {
namespace {

constexpr int kKnee = 3;

class JointPlanCheckTest : public testing::Test {
 protected:
  void SetUp() override {
    plan->sequence = 1;
    plan->joint_count = static_cast<std::uint32_t>(robot.joints.size());
    plan->tail_count = 100;
    for (std::size_t point = 0; point < kMaxPoints; ++point) {
      plan->support[point] = 2;
      for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
        plan->position[point][joint] = static_cast<float>(robot.joints[joint].home_rad);
      }
    }
    for (const urdf::Joint& joint : robot.joints) {
      start.push_back(joint.home_rad);
    }
  }
  // From `point` on, the knee is `offset` further.
  void shift_knee(int point, double offset_rad) {
    for (int p = point; p < kMaxPoints; ++p) {
      plan->position[p][kKnee] = static_cast<float>(robot.joints[kKnee].home_rad + offset_rad);
    }
  }
  JointPlanVerdict verdict() const { return check.check(*plan, start); }
  std::string text() const {
    std::array<char, 256> buffer{};
    return std::string(check.describe(verdict(), buffer));
  }

  urdf::RobotModel robot = urdf::load_robot(GAITWAY_TEST_ROBOT);
  JointPlanCheck check{robot};
  std::unique_ptr<JointPlan> plan = std::make_unique<JointPlan>();
  std::vector<double> start;
  double largest_step_rad = robot.joints[kKnee].velocity_limit_rad_per_s * 0.01;
};

TEST_F(JointPlanCheckTest, StandingIsAccepted) {
  EXPECT_TRUE(verdict().accepted()) << text();
}

TEST_F(JointPlanCheckTest, WrongCounts) {
  plan->joint_count = 12;
  EXPECT_EQ(verdict().rule, JointPlanRule::joint_count);
  plan->joint_count = 22;
  plan->tail_count = kMaxTailPoints + 1;
  EXPECT_EQ(verdict().rule, JointPlanRule::tail_count);
  EXPECT_THAT(text(), testing::HasSubstr("201: points of the safe tail must fit the plan (at most 200)"));
}

TEST_F(JointPlanCheckTest, NotANumber) {
  plan->position[7][kKnee] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(verdict().rule, JointPlanRule::finite);
  EXPECT_EQ(verdict().joint, kKnee);
  EXPECT_EQ(verdict().point, 7);
  EXPECT_EQ(verdict().refused_points, 1U);
}

TEST_F(JointPlanCheckTest, InfiniteInTheTailButNotBehindIt) {
  plan->position[108][kKnee] = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(verdict().accepted());
  plan->position[107][kKnee] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(verdict().point, 107);
}

TEST_F(JointPlanCheckTest, FirstPointMustGoOnFromTheReference) {
  shift_knee(0, 0.9 * largest_step_rad);
  EXPECT_TRUE(verdict().accepted()) << text();
  shift_knee(0, 1.1 * largest_step_rad);
  EXPECT_EQ(verdict().rule, JointPlanRule::continuity);
  EXPECT_EQ(verdict().point, 0);
  EXPECT_THAT(text(), testing::HasSubstr("joint 'left_knee', point 0 (batch): 8.8 rad/s"));
  start.clear();  // not known
  EXPECT_TRUE(verdict().accepted());
}

TEST_F(JointPlanCheckTest, ChangeWithinAVelocityLimitInBatchAndTail) {
  for (const int point : {4, 8, 107}) {
    shift_knee(0, 0.0);
    shift_knee(point, 0.99 * largest_step_rad);
    EXPECT_TRUE(verdict().accepted()) << text();
    shift_knee(point, -1.1 * largest_step_rad);
    EXPECT_EQ(verdict().rule, JointPlanRule::velocity_limit);
    EXPECT_EQ(verdict().point, point);
    EXPECT_NEAR(verdict().value, -1.1 * robot.joints[kKnee].velocity_limit_rad_per_s, 1e-3);
  }
}

TEST_F(JointPlanCheckTest, ChangeThatATrajectoryFrameCannotHold) {
  urdf::RobotModel fast = robot;
  fast.joints[kKnee].velocity_limit_rad_per_s = 100.0;
  const JointPlanCheck fast_check(fast);
  const double count_rad = fast.joints[kKnee].count_rad;
  shift_knee(5, 127.0 * count_rad);
  EXPECT_TRUE(fast_check.check(*plan, start).accepted());
  shift_knee(5, 128.0 * count_rad);
  EXPECT_EQ(fast_check.check(*plan, start).rule, JointPlanRule::count_range);
  EXPECT_EQ(fast_check.check(*plan, start).value, 128.0);
}

TEST_F(JointPlanCheckTest, PositionLimits) {
  const double upper = robot.joints[kKnee].upper_rad - robot.joints[kKnee].home_rad;
  const double step = 0.9 * largest_step_rad;
  for (int point = 0; point < kMaxPoints; ++point) {
    plan->position[point][kKnee] =
        static_cast<float>(robot.joints[kKnee].home_rad + std::min(upper, (point + 1) * step));
  }
  EXPECT_TRUE(verdict().accepted()) << text();
  plan->position[107][kKnee] += 0.001F;
  EXPECT_EQ(verdict().rule, JointPlanRule::position_limit);
  EXPECT_THAT(text(), testing::AllOf(testing::HasSubstr("joint 'left_knee', point 107 (safe tail)"),
                                     testing::HasSubstr("within the joint's limits")));
}

TEST_F(JointPlanCheckTest, UnknownSupport) {
  plan->support[20] = 3;
  EXPECT_EQ(verdict().rule, JointPlanRule::support);
  EXPECT_EQ(verdict().point, 20);
}

TEST_F(JointPlanCheckTest, CountsEveryBadPointAndNamesTheFirst) {
  plan->position[2][kKnee] += 0.5F;  // there and back: two changes
  plan->position[50][0] += 0.5F;
  EXPECT_EQ(verdict().refused_points, 4U);
  EXPECT_EQ(verdict().point, 2);
}

TEST_F(JointPlanCheckTest, DescriptionFitsASmallBuffer) {
  plan->position[2][kKnee] += 0.5F;
  std::array<char, 20> buffer{};
  EXPECT_EQ(check.describe(verdict(), buffer).size(), 20U);
}

}  // namespace
}  // namespace gaitway::core
