// The way into the posture of a fall: from any references, in any direction, within every limit.
#include "gaitway/trajectory/fall_posture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace gaitway::trajectory {
namespace {

constexpr double kPoint_s = 0.010, kPi = std::numbers::pi;
constexpr std::size_t kBatch = kBatchPoints;

class FallPostureTest : public ::testing::Test {
 protected:
  FallPostureTest() {
    for (const urdf::Joint& joint : robot_.joints) at_rad_.push_back(joint.home_rad);
    before_rad_ = at_rad_;
  }
  [[nodiscard]] FallPosture::References references() const { return {before_rad_, at_rad_}; }
  std::size_t joint(const std::string& name) const {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      if (robot_.joints[j].name == name) return j;
    }
    throw std::out_of_range(name);
  }
  void batch() { posture_.plan(++sequence_, 0, {{}, 0.01, 0.36, 0.1}, *plan_, *offsets_); }
  [[nodiscard]] double angle_rad(std::size_t point, std::size_t j) const {
    return robot_.joints[j].home_rad + static_cast<double>(offsets_->offset[point][j]);
  }
  double last_deg(const std::string& name) const {
    return angle_rad(kBatch + plan_->tail_count - 1, joint(name)) * 180.0 / kPi;
  }
  // Every point of the batch and its tail; goes on from the batch's last one.
  void expect_within_limits() {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const urdf::Joint& limits = robot_.joints[j];
      double from_rad = at_rad_[j];
      for (std::size_t i = 0; i < kBatch + plan_->tail_count; ++i) {
        const double to_rad = angle_rad(i, j);
        ASSERT_GE(to_rad, limits.lower_rad - 1e-6) << limits.name;
        ASSERT_LE(to_rad, limits.upper_rad + 1e-6) << limits.name;
        ASSERT_LE(std::abs(to_rad - from_rad), limits.velocity_limit_rad_per_s * kPoint_s + 1e-6)
            << limits.name << " at point " << i;
        from_rad = to_rad;
      }
      before_rad_[j] = angle_rad(kBatch - 2, j);
      at_rad_[j] = angle_rad(kBatch - 1, j);
    }
  }

  urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_ROBOTS "/humanoid22");
  FallPosture posture_{robot_};
  std::vector<double> before_rad_, at_rad_;
  std::uint32_t sequence_ = 0;
  std::unique_ptr<MotionPlan> plan_ = std::make_unique<MotionPlan>();
  std::unique_ptr<PosturePlan> offsets_ = std::make_unique<PosturePlan>();
};

TEST_F(FallPostureTest, ArmsGoToWhereItFalls) {
  posture_.fall(0.1, references());
  batch();
  EXPECT_LT(last_deg("left_shoulder_pitch"), -60.0) << "ahead";
  EXPECT_LT(last_deg("right_shoulder_pitch"), -60.0);
  EXPECT_NEAR(last_deg("left_shoulder_roll"), -last_deg("right_shoulder_roll"), 1e-3);
  posture_.fall(-kPi, references());
  batch();
  EXPECT_GT(last_deg("left_shoulder_pitch"), 30.0) << "back";
  EXPECT_GT(last_deg("right_shoulder_pitch"), 30.0);
  EXPECT_EQ(plan_->motion, kFallPostureMotion);
  EXPECT_EQ(offsets_->from_home, 1U);
}

TEST_F(FallPostureTest, FallsToBothSidesAreEachOthersMirrorImage) {
  posture_.fall(0.5 * kPi, references());
  batch();
  const double left_knee = last_deg("left_knee"), left_elbow = last_deg("left_elbow");
  const double right_hip_roll = last_deg("right_hip_roll"), waist_yaw = last_deg("waist_yaw");
  EXPECT_GT(waist_yaw, 30.0) << "the chest turns to the ground";
  posture_.fall(-0.5 * kPi, references());
  batch();
  EXPECT_NEAR(last_deg("right_knee"), left_knee, 1e-3);
  EXPECT_NEAR(last_deg("right_elbow"), left_elbow, 1e-3);
  EXPECT_NEAR(last_deg("left_hip_roll"), -right_hip_roll, 1e-3);
  EXPECT_NEAR(last_deg("waist_yaw"), -waist_yaw, 1e-3);
}

TEST_F(FallPostureTest, TakesHalfASecondAtMost) {
  for (const double direction : {0.0, 0.5 * kPi, kPi}) {
    posture_.fall(direction, references());
    batch();
    EXPECT_LE(kBatch + plan_->tail_count, 50U) << "points of 10 ms";
  }
}

TEST_F(FallPostureTest, GoesOnFromAnyReferencesWithinEveryLimit) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const urdf::Joint& limits = robot_.joints[j];
      at_rad_[j] = std::uniform_real_distribution(limits.lower_rad, limits.upper_rad)(random);
      const double most_rad = limits.velocity_limit_rad_per_s * kPoint_s;
      before_rad_[j] = std::clamp(at_rad_[j] + std::uniform_real_distribution(-most_rad, most_rad)(random),
                                  limits.lower_rad, limits.upper_rad);
    }
    posture_.fall(std::uniform_real_distribution(-kPi, kPi)(random), references());
    batch();
    ASSERT_NO_FATAL_FAILURE(expect_within_limits()) << "trial " << trial;
    posture_.go_home(references());
    for (int i = 0; posture_.plays(); ++i) {
      ASSERT_LT(i, 30);
      batch();
      ASSERT_NO_FATAL_FAILURE(expect_within_limits()) << "trial " << trial;
    }
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      ASSERT_NEAR(at_rad_[j], robot_.joints[j].home_rad, 1e-5) << "home, where a stand goes on";
    }
  }
}

TEST_F(FallPostureTest, TheTailEndsTheWayAndTheNextBatchIsItsBeginning) {
  posture_.fall(0.0, references());
  batch();
  const std::size_t arm = joint("left_shoulder_pitch");
  const double promised_rad = angle_rad(kBatch, arm), end_deg = last_deg("left_shoulder_pitch");
  batch();
  EXPECT_EQ(angle_rad(0, arm), promised_rad);
  EXPECT_NEAR(last_deg("left_shoulder_pitch"), end_deg, 1e-3);
  for (int i = 0; i < 20; ++i) batch();
  EXPECT_TRUE(posture_.falls()) << "it is held until somebody says otherwise";
  EXPECT_NEAR(angle_rad(0, arm) * 180.0 / kPi, end_deg, 1e-3);
  EXPECT_EQ(plan_->tail_count, kBatch);
}

TEST_F(FallPostureTest, NonsenseBeginsNothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  posture_.fall(kNan, references());
  EXPECT_FALSE(posture_.plays());
  at_rad_[3] = kNan;
  posture_.fall(0.0, references());
  EXPECT_FALSE(posture_.plays());
  posture_.fall(0.0, {});
  EXPECT_FALSE(posture_.plays());
}

}  // namespace
}  // namespace gaitway::trajectory
