// Batches that are planned anew from one of their points on: without news nothing changes, with a push the
// rest of the batch answers it, and what is not played is forgotten.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/divergence_feedback.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"
#include "planned_walk.hpp"

namespace gaitway::trajectory {
namespace {

constexpr int kFrom = 4;
constexpr double kSame = 1e-5;  // m; the reference is known some points further

class Revision : public PlannedWalk {
 protected:
  Revision() {
    pattern.revise_from(kFrom);
    command_walk(0.2, 0.0, 0.0);
  }
  bool revise(const Eigen::Vector2d& deviation_m = Eigen::Vector2d::Zero()) {
    return pattern.revise(command, correction, *plan, deviation_m);
  }
  static double difference_m(const MotionPlan& a, const MotionPlan& b, std::size_t i) {
    double most = (com_of(a, i) - com_of(b, i)).norm();
    for (std::size_t side = 0; side < 2; ++side) {
      most = std::max(most, (foot_of(a, i, side) - foot_of(b, i, side)).norm());
    }
    return most;
  }
};

TEST_F(Revision, WithoutNewsChangesNothing) {
  for (int i = 0; i < 60; ++i) {
    run(1);
    const auto before = std::make_unique<MotionPlan>(*plan);
    ASSERT_TRUE(revise());
    EXPECT_EQ(plan->sequence, before->sequence);
    EXPECT_EQ(plan->start_ns, before->start_ns);
    ASSERT_EQ(plan->footstep_count > 0, before->footstep_count > 0);
    for (std::size_t k = 0; k < kBatchPoints; ++k) {
      ASSERT_NEAR(difference_m(*plan, *before, k), 0.0, k < kFrom ? 0.0 : kSame)
          << "batch " << i << ", " << k;
      ASSERT_EQ(plan->support[k], before->support[k]);
    }
    if (plan->footstep_count > 1) {  // the step that has landed by then is no longer to come
      const std::int64_t landing_ns = plan->footstep_landing_ns[0];
      EXPECT_TRUE(landing_ns == before->footstep_landing_ns[0] ||
                  landing_ns == before->footstep_landing_ns[1]);
    }
  }
}

TEST_F(Revision, AnswersAPushByTheRestOfTheBatchAndTheNextGoesOnFromThere) {
  run(60);
  int answered = 0;  // where the step in flight can still be moved
  for (int i = 0; i < 10; ++i) {
    run(1);
    const auto before = std::make_unique<MotionPlan>(*plan);
    ASSERT_TRUE(revise({0.06, 0.0}));
    for (std::size_t k = 0; k < kFrom; ++k) {
      EXPECT_EQ(difference_m(*plan, *before, k), 0.0);
    }
    for (std::size_t k = kFrom; k < kBatchPoints; ++k) {
      EXPECT_LT((com_of(*plan, k) - com_of(*plan, k - 1)).norm(), 0.01) << "no jump";
    }
    const bool moved = plan->footstep[0][0] != before->footstep[0][0];
    EXPECT_EQ(difference_m(*plan, *before, kBatchPoints - 1) > 1e-5, moved);
    answered += moved ? 1 : 0;
    const Eigen::Vector2d last = com_of(*plan, kBatchPoints - 1);
    const Eigen::Vector2d velocity = com_velocity_of(*plan, kBatchPoints - 1);
    run(1);
    EXPECT_LT((com_of(*plan, 0) - last - 0.01 * velocity).norm(), 0.001);
  }
  EXPECT_GE(answered, 3);
}

TEST_F(Revision, ThatIsNotPlayedIsForgotten) {
  run(60);
  const auto twin = std::make_unique<WalkingPattern>(pattern);
  const auto plan_of_twin = std::make_unique<MotionPlan>(*plan);
  ASSERT_TRUE(revise({0.06, 0.04}));
  pattern.take_revision_back();
  run(1);
  twin->plan(sequence, sequence * kCycle_ns, command, correction, *plan_of_twin);
  for (std::size_t k = 0; k < kBatchPoints + plan->tail_count; ++k) {
    ASSERT_EQ(difference_m(*plan, *plan_of_twin, k), 0.0) << k;
  }
}

TEST_F(Revision, IsOfTheLastBatchAloneAndOnce) {
  EXPECT_FALSE(revise()) << "there is no batch";
  run(2);
  plan->sequence = 1;
  EXPECT_FALSE(revise());
  plan->sequence = 2;
  EXPECT_TRUE(revise());
  EXPECT_FALSE(revise()) << "its beginning is no longer known";
}

TEST_F(Revision, TakesThePlaceOfItsBatchInTheFeedback) {
  DivergenceFeedback feedback(parameters);
  run(60);
  feedback.take(*plan);
  ASSERT_TRUE(revise({0.06, 0.0}));
  feedback.take(*plan);
  // A body that is where the revised plan has it is not off it.
  constexpr std::size_t kPoint = 6;
  Estimate estimate{};
  estimate.stamp_ns = plan->start_ns + static_cast<std::int64_t>(kPoint + 1) * 10'000'000 +
                      static_cast<std::int64_t>(parameters.response_lag_s * 1e9);
  const double omega_per_s = std::sqrt(facts::kGravity_m_per_s2 / parameters.com_height_m);
  const Eigen::Rotation2Dd to_sole(-plan->foot_yaw[kPoint][0]);
  const Eigen::Vector2d foot(plan->foot_position[kPoint][0]);
  const Eigen::Vector2d dcm =
      to_sole * (com_of(*plan, kPoint) + com_velocity_of(*plan, kPoint) / omega_per_s - foot);
  const Eigen::Vector2d zmp = to_sole * (Eigen::Vector2d(plan->zmp[kPoint]) - foot);
  Eigen::Map<Eigen::Vector2d>(estimate.dcm) = dcm;
  Eigen::Map<Eigen::Vector2d>(estimate.zmp) = zmp;
  EXPECT_NEAR(feedback.deviation_m(estimate, estimate.stamp_ns + 10'000'000).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace gaitway::trajectory
