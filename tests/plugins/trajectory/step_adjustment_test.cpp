// A body off its plan: what the step in flight does about it.
#include "gaitway/trajectory/step_adjustment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"
#include "planned_walk.hpp"

namespace gaitway::trajectory {
namespace {

constexpr std::int64_t kPoint_ns = facts::kSlot_ns;

double omega_of(const GaitParameters& parameters) {
  return std::sqrt(facts::kGravity_m_per_s2 / parameters.com_height_m);
}

class AdjustedWalk : public PlannedWalk {
 protected:
  // In the middle of the walk, before the next batch begins a swing early enough to be adjusted.
  void run_into_a_swing(Side swing) {
    command_walk(0.15, 0.0, 0.0);
    run(40);
    const auto early = [this, swing] {
      const PatternState& now = pattern.state();
      return now.step.swing == swing && now.elapsed_points > now.step.double_support_points &&
             now.elapsed_points < now.step.points() / 2;
    };
    while (!early()) run(1);
  }
  [[nodiscard]] Eigen::Vector2d next_footstep() const { return {plan->footstep[0][0], plan->footstep[0][1]}; }
};

TEST_F(AdjustedWalk, StaysAsItIsWithinTheThresholds) {
  run_into_a_swing(Side::left);
  WalkingPattern undisturbed = pattern;
  run(1, {0.9 * parameters.adjust_threshold_m, -0.9 * parameters.adjust_side_threshold_m});
  auto expected = std::make_unique<MotionPlan>();
  undisturbed.plan(sequence, sequence * kCycle_ns, command, Correction{}, *expected);
  for (std::size_t i = 0; i < kBatchPoints; ++i) EXPECT_EQ(com_of(*plan, i), com_of(*expected, i));
  EXPECT_EQ(plan->footstep[0][1], expected->footstep[0][1]);
}

TEST_F(AdjustedWalk, StepsToWhereTheBodyFalls) {
  run_into_a_swing(Side::left);
  WalkingPattern undisturbed = pattern;
  auto expected = std::make_unique<MotionPlan>();
  run(1, {0.0, parameters.adjust_side_threshold_m + 0.020});
  undisturbed.plan(sequence, sequence * kCycle_ns, command, Correction{}, *expected);
  EXPECT_GT(plan->footstep[0][1], expected->footstep[0][1] + 0.01);
  // The steps after it follow from where it lands.
  EXPECT_NEAR(plan->footstep[1][1] - plan->footstep[0][1],
              expected->footstep[1][1] - expected->footstep[0][1], 1e-9);
}

// To the side of the swing foot sooner; to the other, where the DCM comes to the landing place later, later.
TEST_F(AdjustedWalk, LandsWhenTheBodyGetsThere) {
  for (const double towards : {1.0, -1.0}) {
    run_into_a_swing(Side::left);
    WalkingPattern undisturbed = pattern;
    auto expected = std::make_unique<MotionPlan>();
    const int planned = pattern.state().step.points();
    run(1, {0.0, towards * (parameters.adjust_side_threshold_m + 0.012)});
    undisturbed.plan(sequence, sequence * kCycle_ns, command, Correction{}, *expected);
    const std::int64_t change_ns = plan->footstep_landing_ns[0] - expected->footstep_landing_ns[0];
    EXPECT_LE(towards * static_cast<double>(change_ns), -10e6);
    const std::int64_t landing = (plan->footstep_landing_ns[0] - plan->start_ns) / kPoint_ns;
    if (landing <= kBatchPoints) continue;
    EXPECT_EQ(pattern.state().step.points() - planned, change_ns / kPoint_ns);
    run(1);
    const std::int64_t rest = landing - kBatchPoints;
    EXPECT_EQ(plan->support[rest - 2], 1) << "in the air up to the point before";
    EXPECT_EQ(plan->support[rest - 1], 2);
    EXPECT_EQ(plan->foot_position[rest - 1][0][2], 0.0);
  }
}

// Its height, too, goes on without a jump when there is more or less time for it.
TEST_F(AdjustedWalk, MovesTheFootSmoothlyWhateverTheDeviation) {
  for (const double y : {0.06, -0.06, 0.2, -0.2}) {
    run_into_a_swing(Side::left);
    double height_m = pattern.state().foot_height_m[0];
    Eigen::Vector2d foot = pattern.state().feet[0].position();
    for (int i = 0; i < 3; ++i) {
      run(1, {0.01, y});
      for (std::size_t k = 0; k < kBatchPoints; ++k) {
        EXPECT_LT(std::abs(plan->foot_position[k][0][2] - height_m), 0.006);
        EXPECT_LE(plan->foot_position[k][0][2], parameters.lift_m + 1e-9);
        const Eigen::Vector2d now(plan->foot_position[k][0][0], plan->foot_position[k][0][1]);
        EXPECT_LT((now - foot).norm(), 0.015);
        height_m = plan->foot_position[k][0][2];
        foot = now;
      }
    }
    run(60);
  }
}

// The step that brings the robot to a stop is adjusted like any other, and it stands in the end.
TEST_F(AdjustedWalk, StepsAfterTheBodyWhileItStops) {
  run_into_a_swing(Side::left);
  WalkingPattern undisturbed = pattern;
  auto expected = std::make_unique<MotionPlan>();
  command.walk = 0;
  run(1, {0.0, parameters.adjust_side_threshold_m + 0.020});
  undisturbed.plan(sequence, sequence * kCycle_ns, command, Correction{}, *expected);
  EXPECT_GT(plan->footstep[0][1], expected->footstep[0][1] + 0.01);
  EXPECT_EQ(plan->footstep_count, 2U) << "the other foot comes beside it";
  run(25);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
  const Pose2 left = pattern.state().feet[1].relative_of(pattern.state().feet[0]);
  EXPECT_NEAR(left.y_m, parameters.foot_spacing_m, 1e-9);
}

// Only the velocity changes, by so much that the plan's DCM goes to the body's as far as the step answers it.
TEST_F(AdjustedWalk, TakesOverTheDivergenceWithoutAJumpOfTheCentreOfMass) {
  run_into_a_swing(Side::right);
  WalkingPattern undisturbed = pattern;
  const Eigen::RowVector2d com_before = pattern.state().cart.motion.row(0);
  auto expected = std::make_unique<MotionPlan>();
  constexpr double kExcess_m = 0.008;
  run(1, {parameters.adjust_threshold_m + kExcess_m, 0.0});
  undisturbed.plan(sequence, sequence * kCycle_ns, command, Correction{}, *expected);
  EXPECT_LT((com_of(*plan, 0) - com_before.transpose()).norm(), 0.005);
  const Eigen::Vector2d faster = com_velocity_of(*plan, 0) - com_velocity_of(*expected, 0);
  const double taken_over = omega_of(parameters) * parameters.adjust_share * kExcess_m;
  EXPECT_NEAR(faster.x(), taken_over, 0.15 * taken_over);
  EXPECT_NEAR(faster.y(), 0.0, 0.15 * taken_over);
}

// A command that comes after a push moves the footstep again: not further than the push may.
TEST_F(AdjustedWalk, ACommandBringsTheFeetOfAnAdjustedStepNoFurtherApart) {
  parameters.freeze_share = 0.9;
  pattern = WalkingPattern(parameters);
  run_into_a_swing(Side::left);
  run(1, {0.0, 0.2});
  ASSERT_GT(pattern.state().step.adjustment_m.y(), 0.01);
  const auto spacing_m = [this] {
    const Step& step = pattern.state().step;
    return step.stance.relative_of(step.landing).y_m;
  };
  ASSERT_LE(spacing_m(), parameters.adjust_spacing_m + 1e-9);
  ASSERT_GT(spacing_m(), parameters.adjust_spacing_m - 0.005);
  command_walk(0.15, 0.1, 0.0);
  const Side swing = pattern.state().step.swing;
  run(1);
  ASSERT_EQ(pattern.state().step.swing, swing) << "the same step";
  EXPECT_LE(spacing_m(), parameters.adjust_spacing_m + 1e-9);
}

TEST_F(AdjustedWalk, KeepsTheFootstepsLimitsWhateverTheDeviation) {
  for (const Eigen::Vector2d& deviation : {Eigen::Vector2d(0.5, 0.0), Eigen::Vector2d(-0.5, 0.0),
                                           Eigen::Vector2d(0.0, 0.5), Eigen::Vector2d(0.3, -0.5)}) {
    for (const Side swing : {Side::left, Side::right}) {
      run_into_a_swing(swing);
      for (int i = 0; i < 12; ++i) {
        run(1, deviation);
        EXPECT_EQ(pattern.applied_limits(), StepLimit::none) << "nobody commanded it";
        for (std::size_t k = 0; k < kBatchPoints + plan->tail_count; ++k) {
          ASSERT_GT(sole_gap_m(*plan, k, parameters.sole), 0.0);
          ASSERT_TRUE(com_of(*plan, k).allFinite());
        }
        const Pose2 foot = pattern.state().step.stance.relative_of(pattern.state().step.landing);
        EXPECT_LE(std::abs(foot.y_m), parameters.adjust_spacing_m + 1e-9);
        EXPECT_LE(foot.x_m, parameters.max_step_forward_m + 1e-9);
        EXPECT_GE(foot.x_m, -parameters.max_step_backward_m - 1e-9);
      }
      run(60);
    }
  }
}

TEST_F(AdjustedWalk, LeavesAFootAloneThatIsAboutToLand) {
  run_into_a_swing(Side::left);
  while (pattern.state().elapsed_points - pattern.state().step.double_support_points <
         parameters.adjust_until_share * pattern.state().step.swing_points)
    run(1);
  ASSERT_EQ(pattern.state().step.swing, Side::left);
  const Pose2 before = pattern.state().step.landing;
  run(1, {0.0, 0.1});
  EXPECT_EQ(plan->footstep[0][1], before.y_m);
}

// A trunk that has bowed catches no more: the step comes sooner.
TEST_F(AdjustedWalk, StepsSoonerWhereTheTrunkHasBowedAlready) {
  pattern.reset_to_stand({});
  command = WalkCommand{};
  run(3);
  const double edge_m = 0.0775 - parameters.stand_com_forward_m;
  run(1, {edge_m + 0.015, 0.0});
  EXPECT_EQ(plan->footstep_count, 0U);
  correction.bow[1] = 0.5;
  run(1, {edge_m + 0.015, 0.0});
  EXPECT_GT(plan->footstep_count, 0U);
}

TEST_F(AdjustedWalk, ABowThatIsNotANumberIsNone) {
  pattern.reset_to_stand({});
  command = WalkCommand{};
  run(3);
  correction.bow[1] = std::numeric_limits<double>::quiet_NaN();
  run(1, {0.2, 0.0});
  EXPECT_GT(plan->footstep_count, 0U);
}

// Until it stands again; the deviation is gone once the step is planned.
TEST_F(AdjustedWalk, StepsAfterABodyThatIsPushedOffItsFeetAndStandsAgain) {
  for (const Eigen::Vector2d& towards : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(-1.0, 0.0),
                                         Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(0.0, -1.0)}) {
    pattern.reset_to_stand({});
    command = WalkCommand{};
    run(3);
    const double edge_m =
        towards.x() > 0.0   ? 0.0775 - parameters.stand_com_forward_m + parameters.recover_ahead_m
        : towards.x() < 0.0 ? 0.0575 + parameters.stand_com_forward_m + parameters.recover_behind_m
                            : 0.0925;
    run(1, (edge_m - 0.002) * towards);
    EXPECT_EQ(plan->footstep_count, 0U) << "its feet still hold it";
    run(1, (edge_m + 0.002) * towards);
    ASSERT_GT(plan->footstep_count, 0U);
    const double quick_s = parameters.recover_lead_in_s + parameters.recover_swing_s;
    EXPECT_NEAR(static_cast<double>(plan->footstep_landing_ns[0] - plan->start_ns) * 1e-9, quick_s, 1e-9);
    if (towards.y() != 0.0) {
      EXPECT_EQ(plan->footstep_side[0], towards.y() > 0.0 ? 0U : 1U);
      EXPECT_GT(std::abs(next_footstep().y()), 0.5 * parameters.foot_spacing_m + 0.02);
    } else {
      const double longest_m = towards.x() > 0.0
                                   ? parameters.recover_step_m
                                   : std::min(parameters.recover_step_m, parameters.max_step_backward_m);
      EXPECT_NEAR(next_footstep().x(), towards.x() * longest_m, 1e-9);
    }
    run(40);
    EXPECT_EQ(pattern.state().phase, Phase::stand);
    EXPECT_EQ(plan->footstep_count, 0U);
  }
}

// The leg that steps would be all but straight when it lands, and the more so the further the bow has brought
// the hips back.
TEST_F(AdjustedWalk, CrouchesForALongStepAfterTheBodyAndMoreSoOutOfABow) {
  const auto hips_at_landing_m = [this](double bow_rad) {
    pattern.reset_to_stand({});
    command = WalkCommand{};
    run(3);
    correction.bow[1] = bow_rad;
    run(1, {0.12, 0.0});
    const std::int64_t landing_ns = plan->footstep_landing_ns[0] - plan->start_ns;
    const double hips_m = plan->hip_height[landing_ns / kPoint_ns - 1];
    run(45);
    EXPECT_EQ(plan->hip_height[0], parameters.hip_height_m) << "it stands as before";
    return hips_m;
  };
  const double upright_m = hips_at_landing_m(0.0);
  EXPECT_LT(upright_m, parameters.hip_height_m - 0.01);
  EXPECT_LT(hips_at_landing_m(0.5), upright_m - 0.01);
  EXPECT_NEAR(hips_at_landing_m(-0.5), upright_m, 1e-9);
}

// More than the first step may be asks too much of the joints; what is left is for the steps that follow.
TEST_F(AdjustedWalk, KeepsTheFirstStepAfterTheBodyShortHoweverFastItGoesOnFalling) {
  pattern.reset_to_stand({});
  command = WalkCommand{};
  run(3);
  run(1, {0.12, 0.0});
  run(1, {0.10, 0.0});
  ASSERT_GT(plan->footstep_count, 1U);
  EXPECT_NEAR(next_footstep().x(), parameters.recover_step_m, 1e-9);
  while (next_footstep().x() < parameters.recover_step_m + 1e-6 && sequence < 20) run(1, {0.10, 0.0});
  EXPECT_GT(next_footstep().x(), parameters.recover_step_m + 0.02) << "the second one goes further";
}

// A step in the middle of a walk, in the left foot's swing: the DCM goes from 20 mm beside the stance foot's
// ZMP to where the next foot is to land.
class AnswerOfAStep : public ::testing::Test {
 protected:
  AnswerOfAStep() {
    step.points = step.swing_points = 20;
    step.fewest_points = 15;
    step.most_points = 28;
    step.landing_dcm = Eigen::Vector2d(0.06, 0.02 * std::exp(omega * 0.20));
    step.lowest_shift = {-0.25, -0.05};
    step.highest_shift = {0.08, 0.06};
  }
  // What is left of the excess when the next foot takes over, as the DCM runs off the ZMP.
  [[nodiscard]] Eigen::Vector2d left_at_landing(const Eigen::Vector2d& excess,
                                                const StepAnswer& answer) const {
    const double landing_s = answer.points * 0.010;
    const Eigen::Vector2d planned_now = std::exp(-omega * step.points * 0.010) * step.landing_dcm;
    const Eigen::Vector2d dcm = std::exp(omega * landing_s) * (planned_now + excess) - step.landing_dcm;
    return std::exp(0.5 * omega * parameters.double_support_points() * 0.010) * dcm - answer.shift;
  }

  GaitParameters parameters = [] {
    GaitParameters all_of_it;
    all_of_it.adjust_share = 1.0;
    return all_of_it;
  }();
  double omega = omega_of(parameters);
  StepAdjustment adjustment{parameters, omega};
  StepInFlight step;
};

TEST_F(AnswerOfAStep, LeavesNothingOfADeviationThatTheFootCanFollow) {
  for (const Eigen::Vector2d& excess :
       {Eigen::Vector2d(0.01, 0.0), Eigen::Vector2d(-0.01, 0.005), Eigen::Vector2d(0.0, 0.02),
        Eigen::Vector2d(0.005, -0.008), Eigen::Vector2d(0.0, 0.0)}) {
    const StepAnswer answer = adjustment.answer(excess, step);
    EXPECT_LT(left_at_landing(excess, answer).norm(), 1e-9);
    EXPECT_LT((answer.answered - excess).norm(), 1e-12);
  }
}

TEST_F(AnswerOfAStep, IsThePlannedOneForABodyOnItsPlan) {
  const StepAnswer answer = adjustment.answer({0.0, 0.0}, step);
  EXPECT_EQ(answer.points, step.points);
  EXPECT_EQ(answer.shift, Eigen::Vector2d::Zero());
}

TEST_F(AnswerOfAStep, TakesItsTimeFromTheBody) {
  EXPECT_LT(adjustment.answer({0.0, 0.015}, step).points, step.points);
  EXPECT_GT(adjustment.answer({0.0, -0.008}, step).points, step.points);
  EXPECT_EQ(adjustment.answer({0.0, 0.2}, step).points, step.fewest_points);
}

TEST_F(AnswerOfAStep, KeepsItsTimeWhereTheBodyFallsAheadAlone) {
  EXPECT_EQ(adjustment.answer({0.05, 0.0}, step).points, step.points);
  EXPECT_EQ(adjustment.answer({-0.05, 0.0}, step).points, step.points);
}

// The feet cannot cross: what falls over the stance foot is for the next step, which must come soon.
TEST_F(AnswerOfAStep, LandsAsSoonAsItCanWhereTheBodyFallsOverTheStanceFoot) {
  const Eigen::Vector2d over(0.0, -0.08);
  const StepAnswer answer = adjustment.answer(over, step);
  EXPECT_EQ(answer.points, step.fewest_points);
  EXPECT_LT(left_at_landing(over, answer).y(), -0.05);
}

TEST_F(AnswerOfAStep, ChangesThePlaceAloneWhereTimeIsDear) {
  parameters.adjust_time_cost_m_per_s = 1000.0;
  const StepAnswer answer = StepAdjustment(parameters, omega).answer({0.0, 0.010}, step);
  EXPECT_EQ(answer.points, step.points);
  const double transfer_s = 0.20 + 0.5 * parameters.double_support_points() * 0.010;
  EXPECT_NEAR(answer.shift.y(), 0.010 * std::exp(omega * transfer_s), 1e-12);
}

TEST_F(AnswerOfAStep, KeepsTheLimits) {
  for (const Eigen::Vector2d& excess : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(-0.5, -0.5)}) {
    const StepAnswer answer = adjustment.answer(excess, step);
    EXPECT_GE(answer.points, step.fewest_points);
    EXPECT_LE(answer.points, step.most_points);
    EXPECT_TRUE((answer.shift.array() <= step.highest_shift.array()).all());
    EXPECT_TRUE((answer.shift.array() >= step.lowest_shift.array()).all());
    EXPECT_LE(std::abs(answer.shift.x()), parameters.adjust_speed_m_per_s * answer.points * 0.010 + 1e-12);
  }
}

}  // namespace
}  // namespace gaitway::trajectory
