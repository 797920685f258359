// Whatever is commanded and whenever: plans stay continuous, the ZMP in the support polygon, the feet apart
// and above the ground, and every tail ends in the nominal stand.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"
#include "planned_walk.hpp"

namespace gaitway::trajectory {
namespace {

// Bounds of motion over one point of 10 ms.
constexpr double kMostFootSpeed_m_per_s = 2.6;
constexpr double kMostComAcceleration_m_per_s2 = 4.0;
constexpr double kMostTurnRate_rad_per_s = 7.0;
constexpr double kMostHipSpeed_m_per_s = 0.12;
// The preview follows the leg in the air, which moves the reference ZMP up and down by 40 mm in a step, so
// well. With steps of 0.32 s a command that changes in the middle of one, ahead, aside and around at once,
// leaves single points further outside (the worst of 60,000 batches: 4.3 mm): no more than one of ten
// thousand.
constexpr double kZmpTracking_m = 0.001;
constexpr double kZmpTrackingOfShortSteps_m = 0.005;
constexpr double kShortStep_s = 0.35;
constexpr double kHipOvershoot_m = 0.002;  // of a way that is aimed anew

struct Extremes {
  double least_zmp_depth_m = 1.0, least_gap_m = 1.0;
  int points = 0, points_outside = 0;  // with the ZMP more than kZmpTracking_m outside of the support polygon
};

void check_point(const MotionPlan& plan, std::size_t i, const GaitParameters& p, Extremes& seen) {
  const double depth = zmp_depth_m(plan, i, p.sole);
  const double gap = sole_gap_m(plan, i, p.sole);
  seen.least_zmp_depth_m = std::min(seen.least_zmp_depth_m, depth);
  seen.least_gap_m = std::min(seen.least_gap_m, gap);
  ++seen.points;
  seen.points_outside += depth < -kZmpTracking_m ? 1 : 0;
  ASSERT_GT(depth, p.step_time_s < kShortStep_s ? -kZmpTrackingOfShortSteps_m : -kZmpTracking_m)
      << "ZMP outside the support polygon at point " << i;
  ASSERT_GT(gap, 0.0) << "soles collide at point " << i;
  for (std::size_t side = 0; side < 2; ++side) {
    const double z = plan.foot_position[i][side][2];
    ASSERT_GE(z, 0.0);
    ASSERT_LE(z, p.lift_m + 1e-9);
    if (plan.support[i] == side || plan.support[i] == 2) {
      ASSERT_EQ(z, 0.0);
    }
  }
  ASSERT_LE(plan.hip_height[i], p.hip_height_m + kHipOvershoot_m);
  ASSERT_GE(plan.hip_height[i], p.fast_hip_height_m - kHipOvershoot_m);
}

void check_transition(const MotionPlan& plan, std::size_t i) {
  const double T = facts::kSlot_s;
  const Eigen::Vector2d moved = com_of(plan, i) - com_of(plan, i - 1);
  const Eigen::Vector2d mean = 0.5 * (com_velocity_of(plan, i) + com_velocity_of(plan, i - 1));
  ASSERT_LT((moved - T * mean).norm(), 1e-4) << "CoM position jumps at point " << i;
  ASSERT_LT((com_velocity_of(plan, i) - com_velocity_of(plan, i - 1)).norm(),
            kMostComAcceleration_m_per_s2 * T)
      << "CoM velocity jumps at point " << i;
  ASSERT_LT(std::abs(plan.hip_height[i] - plan.hip_height[i - 1]), kMostHipSpeed_m_per_s * T)
      << "hips jump at point " << i;
  for (std::size_t side = 0; side < 2; ++side) {
    ASSERT_LT((foot_of(plan, i, side) - foot_of(plan, i - 1, side)).norm(), kMostFootSpeed_m_per_s * T)
        << "foot " << side << " jumps at point " << i;
    ASSERT_LT(std::abs(plan.foot_yaw[i][side] - plan.foot_yaw[i - 1][side]), kMostTurnRate_rad_per_s * T);
  }
}

void check_final_stand(const MotionPlan& plan, const GaitParameters& p) {
  const std::size_t last = kBatchPoints + plan.tail_count - 1;
  ASSERT_EQ(com_velocity_of(plan, last), Eigen::Vector2d::Zero());
  ASSERT_EQ(plan.support[last], 2);
  ASSERT_NEAR(plan.hip_height[last], p.hip_height_m, 1e-12);
  ASSERT_NEAR(plan.foot_yaw[last][0], plan.foot_yaw[last][1], 1e-12);
  ASSERT_NEAR(plan.base_yaw[last], plan.foot_yaw[last][0], 1e-12);
  const Pose2 left{plan.foot_position[last][0][0], plan.foot_position[last][0][1], plan.foot_yaw[last][0]};
  const Pose2 right{plan.foot_position[last][1][0], plan.foot_position[last][1][1], plan.foot_yaw[last][1]};
  const Pose2 between = right.relative_of(left);
  ASSERT_NEAR(between.x_m, 0.0, 2e-6);
  ASSERT_NEAR(between.y_m, p.foot_spacing_m, 2e-6);
  const Pose2 com = right.relative_of({plan.com[last][0], plan.com[last][1], 0.0});
  ASSERT_NEAR(com.x_m, p.stand_com_forward_m, 2e-6);
  ASSERT_NEAR(com.y_m, 0.5 * p.foot_spacing_m, 2e-6);
  ASSERT_NEAR((zmp_of(plan, last) - com_of(plan, last)).norm(), 0.0, 1e-12);
}

// Point 0 of `scratch` is the last point before the plan; then the plan's points follow.
void check_plan(const MotionPlan& plan, const GaitParameters& p, MotionPlan& scratch, bool has_before,
                Extremes& seen) {
  ASSERT_LE(plan.tail_count, static_cast<unsigned>(p.longest_tail_points()) + kBatchPoints);
  ASSERT_EQ(plan.tail_count % kBatchPoints, 0U);
  const std::size_t count = kBatchPoints + plan.tail_count;
  for (std::size_t i = 0; i < count; ++i) copy_point(plan, i, scratch, i + 1);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_NO_FATAL_FAILURE(check_point(plan, i, p, seen));
    if (i > 0 || has_before) {
      ASSERT_NO_FATAL_FAILURE(check_transition(scratch, i + 1));
    }
  }
  ASSERT_NO_FATAL_FAILURE(check_final_stand(plan, p));
  copy_point(plan, kBatchPoints - 1, scratch, 0);
}

struct Case {
  unsigned seed;
  double step_time_s;
};

class RandomCommands : public ::testing::TestWithParam<Case> {};

TEST_P(RandomCommands, KeepEveryInvariantOfPlanAndTail) {
  SCOPED_TRACE(::testing::Message() << "seed " << GetParam().seed);
  GaitParameters p;
  p.step_time_s = GetParam().step_time_s;
  WalkingPattern pattern(p);
  std::mt19937 random(GetParam().seed);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto plan = std::make_unique<MotionPlan>();
  const auto scratch = std::make_unique<MotionPlan>();
  WalkCommand command{};
  Correction correction{};
  Extremes seen;
  for (std::uint32_t n = 1; n <= 1500; ++n) {
    if (uniform(0.0, 1.0) < 0.10) {
      command.walk = uniform(0.0, 1.0) < 0.75 ? 1 : 0;
      command.velocity[0] = uniform(-0.4, 0.5);
      command.velocity[1] = uniform(-0.17, 0.17);
      command.turn_rate = uniform(-1.6, 1.6);
      correction.turn_rate_offset = uniform(-0.1, 0.1);
      correction.step_offset[0] = uniform(-0.01, 0.01);
      correction.step_offset[1] = uniform(-0.005, 0.005);
    }
    pattern.plan(n, std::int64_t{n} * 80'000'000, command, correction, *plan);
    ASSERT_NO_FATAL_FAILURE(check_plan(*plan, p, *scratch, n > 1, seen)) << "batch " << n;
  }
  EXPECT_LE(10'000 * seen.points_outside, seen.points);
  RecordProperty("least_zmp_depth_mm", std::to_string(1e3 * seen.least_zmp_depth_m));
  std::cout << "least depth of the ZMP " << 1e3 * seen.least_zmp_depth_m << " mm, least gap of the soles "
            << 1e3 * seen.least_gap_m << " mm\n";
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCommands,
                         ::testing::Values(Case{1, 0.40}, Case{2, 0.40}, Case{3, 0.40}, Case{4, 0.32},
                                           Case{5, 0.48}));

}  // namespace
}  // namespace gaitway::trajectory
