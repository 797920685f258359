// The whole balance feedback: support from plan or contacts, and when there is nothing to balance.
#include "gaitway/stability/balance_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using test::channel_of;
using test::humanoid;
using test::kLeftAnklePitch;

constexpr std::int64_t kTick_ns = facts::kSlot_ns;
const std::size_t kRightAnklePitch = channel_of(humanoid(), 1, 4);

class BalanceControllerTest : public ::testing::Test {
 protected:
  BalanceControllerTest() {
    estimate_.contact[0] = estimate_.contact[1] = 1;
    estimate_.attitude[1] = 0.04;
    plan_->tail_count = 200;
  }
  void tick(int count = 1) {
    for (int i = 0; i < count; ++i) {
      now_ns_ += kTick_ns;
      if (estimate_is_fresh_) estimate_.stamp_ns = now_ns_ - 3'000'000;
      network_.stamp_ns = now_ns_ - 3'000'000;
      controller_.update(now_ns_,
                         {has_estimate_ ? &estimate_ : nullptr, has_plan_ ? plan_.get() : nullptr,
                          has_network_ ? &network_ : nullptr},
                         trim_, correction_);
    }
  }
  // Publishes a plan that starts with the next tick.
  void plan(std::uint8_t support, double yaw_rad = 0.0) {
    ++plan_->sequence;
    plan_->start_ns = now_ns_ + kTick_ns;
    plan_->footstep_count = 2;
    for (std::size_t i = 0; i < kMaxPoints; ++i) {
      plan_->support[i] = support;
      plan_->commanded_yaw[i] = yaw_rad;
    }
    has_plan_ = true;
  }
  void expect_zero_trims() const {
    for (const double angle : trim_.angle) EXPECT_NEAR(angle, 0.0, 1e-12);
  }

  BalanceParameters parameters_;
  BalanceController controller_{humanoid(), parameters_};
  Estimate estimate_{};
  std::unique_ptr<MotionPlan> plan_ = std::make_unique<MotionPlan>();
  NetworkState network_{};
  TrimCommand trim_{};
  Correction correction_{};
  std::int64_t now_ns_ = 0;
  bool has_estimate_ = true, has_plan_ = false, has_network_ = false, estimate_is_fresh_ = true;
};

TEST_F(BalanceControllerTest, ThePlanSaysWhichLegStands) {
  plan(0);
  tick(20);
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
  EXPECT_EQ(trim_.angle[kRightAnklePitch], 0.0);
  plan(1);
  tick(1);
  EXPECT_EQ(trim_.angle[kLeftAnklePitch], 0.0);
  EXPECT_NEAR(trim_.angle[kRightAnklePitch], 0.01, 1e-7);
  EXPECT_EQ(trim_.stamp_ns, now_ns_);
  EXPECT_EQ(correction_.stamp_ns, now_ns_);
}

TEST_F(BalanceControllerTest, ContactsSayItWithoutAPlan) {
  estimate_.contact[0] = 0;
  tick(20);
  EXPECT_EQ(trim_.angle[kLeftAnklePitch], 0.0);
  EXPECT_NEAR(trim_.angle[kRightAnklePitch], 0.01, 1e-7);
  estimate_.contact[0] = 1;
  tick(1);
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
}

TEST_F(BalanceControllerTest, APlanThatTheNetworkRefusedDoesNotCount) {
  has_network_ = true;
  network_.accepted_sequence = 1;
  plan(0);
  tick(20);
  plan(1);
  tick(2);
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
  EXPECT_EQ(trim_.angle[kRightAnklePitch], 0.0);
  network_.accepted_sequence = 2;
  tick(1);
  EXPECT_NEAR(trim_.angle[kRightAnklePitch], 0.01, 1e-7);
}

// A robot that holds leans as it leans: what no batch takes out is not learned again and again, or the first
// batch would throw it over.
TEST_F(BalanceControllerTest, ALeanIsLearnedFromBatchesAlone) {
  has_network_ = true;
  network_.accepted_sequence = 1;
  plan(2);
  tick(20);
  const double learned_rad = correction_.base_attitude_offset[1];
  EXPECT_NE(learned_rad, 0.0);
  for (const std::uint32_t mode : {network_state::mode::safe_tail, network_state::mode::holding}) {
    network_.mode = mode;
    tick(500);
    EXPECT_NEAR(correction_.base_attitude_offset[1], learned_rad, 0.5 * std::abs(learned_rad)) << mode;
  }
  network_.mode = network_state::mode::batches;
  const double held_rad = correction_.base_attitude_offset[1];
  tick(20);
  EXPECT_GT(std::abs(correction_.base_attitude_offset[1]), 1.5 * std::abs(held_rad));
}

TEST_F(BalanceControllerTest, LostEstimateFadesTheTrimsAndKeepsTheGains) {
  plan(2);
  tick(100);
  ASSERT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
  has_estimate_ = false;
  tick(5);
  EXPECT_GT(trim_.angle[kLeftAnklePitch], 0.003);
  EXPECT_LT(trim_.angle[kLeftAnklePitch], 0.007);
  tick(6);
  expect_zero_trims();
  EXPECT_NEAR(trim_.gain[kBothFeet][kLeftAnklePitch][1], 0.25, 1e-7);
}

TEST_F(BalanceControllerTest, OldEstimateCountsAsLost) {
  plan(2);
  tick(100);
  estimate_is_fresh_ = false;
  tick(4);
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
  tick(12);
  expect_zero_trims();
}

TEST_F(BalanceControllerTest, FallenAirborneOrUndefinedRobotIsNotTrimmed) {
  plan(2);
  for (int fault = 0; fault < 3; ++fault) {
    tick(100);
    ASSERT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
    const Estimate good = estimate_;
    if (fault == 0) estimate_.attitude[0] = 1.4;
    if (fault == 1) estimate_.contact[0] = estimate_.contact[1] = 0;
    if (fault == 2) estimate_.angular_velocity[1] = std::nan("");
    tick(20);
    expect_zero_trims();
    estimate_ = good;
  }
}

// A push of 1.9 N·s from the front: half a second of its lean, integrated, made the robot fall.
TEST_F(BalanceControllerTest, NothingIsLearnedFromAStandingBodyThatIsBeingCaught) {
  plan(2);
  plan_->footstep_count = 0;  // it stands
  estimate_.foot_force[0] = estimate_.foot_force[1] = 33.0;
  estimate_.foot_zmp[0][1] = 0.02;
  estimate_.angular_velocity[1] = 0.3;
  tick(50);
  EXPECT_EQ(correction_.base_attitude_offset[1], 0.0);
  EXPECT_EQ(controller_.soles().roll_rad(0), 0.0);
  estimate_.angular_velocity[1] = 0.05;
  tick(50);
  EXPECT_LT(correction_.base_attitude_offset[1], -0.02);
  EXPECT_GT(controller_.soles().roll_rad(0), 0.02);
}

// What is asked of batches that nobody plans would come all at once, with the next one.
TEST_F(BalanceControllerTest, TheComIsCentredByBatchesThatComeAndNotInATail) {
  estimate_.attitude[1] = 0.0;
  estimate_.com[0] = estimate_.dcm[0] = 0.004;
  for (int batch = 0; batch < 10; ++batch) {
    plan(2);
    plan_->footstep_count = 0;
    tick(8);
  }
  const double centred_m = correction_.com_offset[0];
  EXPECT_LT(centred_m, -0.004);
  EXPECT_GT(centred_m, -0.0068) << "2 1/s for 0.8 s, of 4 mm";
  tick(100);
  EXPECT_NEAR(correction_.com_offset[0], centred_m, 4.1e-4) << "what the last batch learned until it was old";
}

TEST_F(BalanceControllerTest, AStandingRobotBowsWithItsDcmAndIsBalancedAboutTheBow) {
  estimate_.attitude[1] = 0.0;
  plan(2);
  plan_->footstep_count = 0;
  tick(40);
  EXPECT_EQ(correction_.bow[1], 0.0);
  estimate_.dcm[0] = 0.07;
  tick(7);
  plan(2);
  plan_->footstep_count = 0;
  tick();
  ASSERT_GT(correction_.bow[1], 0.05);
  EXPECT_GT(correction_.bow_rate[1], 1.0);
  EXPECT_EQ(correction_.bow[0], 0.0);
  EXPECT_EQ(trim_.gain[kBothFeet][kLeftAnklePitch][1], 0.0) << "the message controller knows of no bow";
  // The trunk is where the batch has it: nothing to correct.
  tick(4);
  const double next_s = 1e-9 * static_cast<double>(now_ns_ + kTick_ns - plan_->start_ns);
  const msgclient::Bow bow = controller_.hips().at(plan_->sequence, next_s);
  ASSERT_GT(bow.angle_rad, 0.01);
  estimate_.attitude[1] = bow.angle_rad;
  estimate_.angular_velocity[1] = bow.rate_rad_per_s;
  tick();
  expect_zero_trims();
}

// All of the rate gain would have a standing robot tremble in the play of its joints.
TEST_F(BalanceControllerTest, ACalmStandTakesLessOfTheRateThanAPushedOneOrAWalk) {
  const auto trim_of_rate = [this](double pitch_rate_rad_per_s, std::uint32_t footsteps) {
    estimate_.attitude[1] = 0.0;
    estimate_.angular_velocity[1] = pitch_rate_rad_per_s;
    plan(2);
    plan_->footstep_count = footsteps;
    for (std::size_t i = 0; i < kMaxPoints; ++i) plan_->com_velocity[i][0] = footsteps > 0 ? 0.1 : 0.0;
    tick(8);
    plan(2);
    plan_->footstep_count = footsteps;
    tick(8);
    return trim_.angle[kLeftAnklePitch] / pitch_rate_rad_per_s;
  };
  tick(20);
  const BalanceParameters parameters;
  const double full_s = parameters.ankle_pitch.rate_rad_per_rad_per_s;
  EXPECT_NEAR(trim_of_rate(0.1, 0), parameters.calm_damping * full_s, 1e-7);
  EXPECT_NEAR(trim_of_rate(0.3, 0), full_s, 1e-7);
  EXPECT_NEAR(trim_of_rate(0.1, 2), full_s, 1e-7);
}

TEST_F(BalanceControllerTest, AWalkingRobotDoesNotBow) {
  plan(2);
  estimate_.dcm[0] = 0.07;
  tick(8);
  plan(2);
  tick(8);
  EXPECT_EQ(correction_.bow[1], 0.0);
}

TEST_F(BalanceControllerTest, AShortLossOfContactChangesNothing) {
  plan(2);
  tick(100);
  estimate_.contact[0] = estimate_.contact[1] = 0;
  tick(4);
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
}

TEST_F(BalanceControllerTest, HeadingErrorAsksForATurnAndNothingElse) {
  estimate_.attitude[0] = estimate_.attitude[1] = 0.0;
  plan(2);
  tick(10);
  for (int i = 0; i < 50; ++i) {
    estimate_.attitude[2] += 0.002;
    tick();
  }
  EXPECT_LT(correction_.turn_rate_offset, -0.02);
  EXPECT_GE(correction_.turn_rate_offset, -0.3);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(correction_.com_offset[axis], 0.0);
    EXPECT_EQ(correction_.base_attitude_offset[axis], 0.0);
    EXPECT_EQ(correction_.step_offset[axis], 0.0);
    EXPECT_EQ(correction_.velocity_offset[axis], 0.0);
  }
  has_estimate_ = false;
  tick();
  EXPECT_EQ(correction_.turn_rate_offset, 0.0);
}

TEST_F(BalanceControllerTest, AFallSoftensTheJointsAndEndsTheTrims) {
  plan(2);
  tick(30);
  EXPECT_EQ(trim_.softness, 0.0);
  EXPECT_NE(trim_.angle[kLeftAnklePitch], 0.0);
  estimate_.fall = 1;
  tick();
  EXPECT_EQ(trim_.softness, BalanceParameters{}.fall.posture) << "a posture may come";
  tick(15);
  EXPECT_EQ(trim_.softness, 1.0) << "none came";
  expect_zero_trims();
  estimate_is_fresh_ = false;
  tick(100);
  EXPECT_EQ(trim_.softness, 1.0) << "a robot that is not heard stays as it is";
}

TEST_F(BalanceControllerTest, ThePostureOfAFallKeepsTheJointsStiffUntilTheRobotLies) {
  plan(3);
  plan_->motion = 2;
  estimate_.fall = 1;
  tick(40);
  EXPECT_EQ(trim_.softness, BalanceParameters{}.fall.posture);
  expect_zero_trims();
  estimate_.fall = 2;
  tick();
  EXPECT_EQ(trim_.softness, 1.0);
}

TEST_F(BalanceControllerTest, AMotionOnTheGroundMakesTheJointsStiffAgain) {
  estimate_.fall = 2;
  plan(2);
  tick(5);
  EXPECT_EQ(trim_.softness, 1.0);
  plan(3);
  tick(5);
  EXPECT_EQ(trim_.softness, 0.0);
  expect_zero_trims();
}

TEST_F(BalanceControllerTest, AChangedParameterIsInForceAtTheNextUpdate) {
  plan(0);
  tick(40);
  const double before_rad = trim_.angle[kLeftAnklePitch];
  ASSERT_GT(before_rad, 0.009);
  parameters_.trim_limit_rad = 0.004;
  tick();
  EXPECT_DOUBLE_EQ(trim_.angle[kLeftAnklePitch], 0.004);
  parameters_.trim_limit_rad = 0.11;
  parameters_.ankle_pitch.angle_rad_per_rad *= 0.5;
  tick();
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.5 * before_rad, 1e-6);
}

// Seen from a foot that is turned against the base, the body moves another way than it does in the base's
// axes.
TEST_F(BalanceControllerTest, ABodyThatMovesAsPlannedOverATurnedFootIsNotTooSlow) {
  constexpr double kTurned_rad = 0.4, kSpeed_m_per_s = 0.2;
  for (std::size_t i = 0; i < kMaxPoints; ++i) {
    plan_->com_velocity[i][0] = kSpeed_m_per_s;
    plan_->foot_yaw[i][0] = kTurned_rad;
  }
  plan(0);
  estimate_.support = 0;
  estimate_.com_velocity[0] = kSpeed_m_per_s * std::cos(kTurned_rad);
  estimate_.com_velocity[1] = -kSpeed_m_per_s * std::sin(kTurned_rad);
  tick(100);
  EXPECT_NEAR(correction_.velocity_offset[0], 0.0, 1e-9);
  EXPECT_NEAR(correction_.velocity_offset[1], 0.0, 1e-9);
}

TEST(BalanceParametersTest, BadValuesAreRefusedByName) {
  BalanceParameters parameters;
  parameters.ankle_pitch.angle_rad_per_rad = -0.25;
  try {
    BalanceController controller(humanoid(), parameters);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("ankle_pitch is -0.25"), std::string::npos) << error.what();
  }
}

// The trunk is where the motion has it: nothing to correct; and 0.04 rad beyond: what is corrected in the
// stand.
TEST_F(BalanceControllerTest, BalancesAboutWhereAMotionHasTheTrunk) {
  plan(2);
  plan_->footstep_count = 0;
  plan_->motion = 1;
  for (auto& attitude : plan_->trunk_attitude) attitude[1] = 0.75;
  estimate_.attitude[1] = 0.75;
  tick(20);
  expect_zero_trims();
  estimate_.attitude[1] = 0.79;  // no fall, although it would be one in the stand at 0.8 and more
  tick(1);
  EXPECT_NEAR(trim_.angle[kLeftAnklePitch], 0.01, 1e-7);
  EXPECT_EQ(trim_.gain[2][kLeftAnklePitch][1], 0.0) << "the message controller knows of no leaning trunk";
}

TEST_F(BalanceControllerTest, ATrunkThatTurnsAsPlannedIsNotHeldBack) {
  plan(2);
  plan_->motion = 1;
  for (std::size_t i = 0; i < kMaxPoints; ++i) plan_->trunk_attitude[i][1] = 0.01 * static_cast<double>(i);
  for (int i = 0; i < 30; ++i) {
    // Point i is reached at the end of slot i.
    estimate_.attitude[1] = i < 2 ? 0.0 : 0.01 * (i - 2);
    estimate_.angular_velocity[1] = i < 3 ? 0.0 : 1.0;
    tick(1);
  }
  for (const double angle : trim_.angle) EXPECT_NEAR(angle, 0.0, 0.003);
}

TEST_F(BalanceControllerTest, NothingIsBalancedWhereNoFootStands) {
  plan(2);
  tick(20);
  EXPECT_NE(trim_.angle[kLeftAnklePitch], 0.0);
  plan(3);
  tick(200);
  expect_zero_trims();
}

// Beyond 90° pitch grows when the robot falls back: trims by it would push it over, as they once did on
// getting up.
TEST_F(BalanceControllerTest, ATrunkThatIsToHangDownIsNotBalanced) {
  plan(2);
  plan_->motion = 1;
  for (auto& attitude : plan_->trunk_attitude) {
    attitude[0] = 3.14;
    attitude[1] = 1.2;
  }
  estimate_.attitude[0] = 3.14;
  estimate_.attitude[1] = 1.3;
  tick(100);
  expect_zero_trims();
}

}  // namespace
}  // namespace gaitway::stability
