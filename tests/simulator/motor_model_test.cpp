// Motors, gears, supply and current sensors, each against its own specification.
#include "motor_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "home_servo.hpp"

namespace gaitway::simulator {
namespace {

constexpr int kMotorRobots = 40;  // of which distributions are made

struct Spread {
  double least = 1e9, most = -1e9, mean = 0.0, deviation = 0.0;
};

class MotorModelTest : public ::testing::Test {
 protected:
  [[nodiscard]] MotorModel motors(double mismatch, std::uint64_t seed = 1, bool noise = false) const {
    return {robot_, seed, mismatch, noise};
  }
  // One step in which one joint is asked for a torque at a speed and all others rest.
  double give(MotorModel& motors, std::size_t joint, double asked_Nm, double speed_rad_per_s,
              double torque_factor = 1.0) {
    asked_.assign(robot_.joints.size(), 0.0);
    speed_.assign(robot_.joints.size(), 0.0);
    asked_[joint] = asked_Nm;
    speed_[joint] = speed_rad_per_s;
    motors.step(asked_, speed_, torque_factor);
    return motors.torque_Nm()[joint];
  }
  // Of a value of every joint of many robots.
  [[nodiscard]] Spread spread(double mismatch,
                              const std::function<double(const MotorModel::Joint&)>& value) const {
    std::vector<double> all;
    for (std::uint64_t seed = 1; seed <= kMotorRobots; ++seed) {
      const MotorModel model = motors(mismatch, seed);
      for (std::size_t j = 0; j < robot_.joints.size(); ++j) all.push_back(value(model.joint(j)));
    }
    Spread spread;
    const auto count = static_cast<double>(all.size());
    for (const double one : all) {
      spread.least = std::min(spread.least, one);
      spread.most = std::max(spread.most, one);
      spread.mean += one / count;
    }
    for (const double one : all) spread.deviation += (one - spread.mean) * (one - spread.mean) / count;
    spread.deviation = std::sqrt(spread.deviation);
    return spread;
  }
  // Every motor of the legs bears as much at standstill as needs the reference power.
  void load_supply(MotorModel& motors) {
    asked_.assign(robot_.joints.size(), 0.0);
    speed_.assign(robot_.joints.size(), 0.0);
    for (const urdf::Leg& leg : robot_.legs) {
      for (const int joint : leg.joints) asked_[static_cast<std::size_t>(joint)] = limit_Nm_ * std::sqrt(0.5);
    }
    motors.step(asked_, speed_, 1.0);
  }

  urdf::RobotModel robot_ = humanoid22();
  std::size_t knee_ = static_cast<std::size_t>(robot_.joint_index("left_knee"));
  double limit_Nm_ = robot_.joints[knee_].motor.torque_limit_Nm;
  double fastest_ = robot_.joints[knee_].motor.speed_limit_rad_per_s;
  std::vector<double> asked_, speed_;
};

TEST_F(MotorModelTest, WithoutMismatchItGivesAndTellsWhatIsAskedUpToItsLimits) {
  MotorModel ideal = motors(0.0);
  for (int i = 0; i < 20'000; ++i) {  // hot, and the supply loaded
    load_supply(ideal);
  }
  EXPECT_EQ(ideal.voltage(), 1.0);
  EXPECT_EQ(give(ideal, knee_, 3.0, 2.0), 3.0);
  EXPECT_EQ(ideal.sensed_Nm()[knee_], 3.0);
  EXPECT_EQ(give(ideal, knee_, 100.0, 2.0), limit_Nm_ * (1.0 - 2.0 / fastest_));
  EXPECT_EQ(give(ideal, knee_, -100.0, 2.0), -limit_Nm_);
  EXPECT_EQ(give(ideal, knee_, -100.0, 2.0, 0.5), -0.5 * limit_Nm_);
  EXPECT_EQ(give(ideal, knee_, 100.0, 2.0 * fastest_), 0.0);
  EXPECT_EQ(ideal.joint(knee_).friction_factor, 1.0);
}

TEST_F(MotorModelTest, TorqueConstantsAreOffByUpToATenth) {
  const auto factor = [](const MotorModel::Joint& joint) { return joint.torque_constant_factor; };
  const Spread usual = spread(1.0, factor);
  EXPECT_GE(usual.least, 0.9);
  EXPECT_LE(usual.most, 1.1);
  EXPECT_NEAR(usual.mean, 1.0, 0.005);
  EXPECT_NEAR(usual.deviation, 0.1 / std::sqrt(3.0), 0.003) << "uniform";
  EXPECT_NEAR(spread(2.0, factor).deviation, 2.0 * usual.deviation, 1e-9);
  MotorModel model = motors(1.0);
  EXPECT_NEAR(give(model, knee_, 3.0, 0.0), 3.0 * model.joint(knee_).torque_constant_factor, 1e-12);
  EXPECT_NE(model.joint(knee_).torque_constant_factor, motors(1.0, 2).joint(knee_).torque_constant_factor);
}

TEST_F(MotorModelTest, GearsLoseATenthOfTheTorqueAgainstTheMotion) {
  MotorModel model = motors(1.0);
  const double constant = model.joint(knee_).torque_constant_factor;
  EXPECT_NEAR(give(model, knee_, 2.0, 3.0) / (2.0 * constant), 0.9, 0.001) << "drives";
  EXPECT_NEAR(give(model, knee_, -2.0, -3.0) / (-2.0 * constant), 0.9, 0.001);
  EXPECT_NEAR(give(model, knee_, -2.0, 3.0) / (-2.0 * constant), 1.1, 0.001) << "is driven";
  EXPECT_NEAR(give(model, knee_, 2.0, -3.0) / (2.0 * constant), 1.1, 0.001);
  EXPECT_EQ(give(model, knee_, 0.0, 3.0), 0.0);
}

TEST_F(MotorModelTest, GearsNeverGiveEnergyAndDoNotJumpWhereTheMotionTurns) {
  MotorModel model = motors(1.0);
  const MotorModel::Joint& joint = model.joint(knee_);
  EXPECT_GT(joint.gear_speed_rad_per_s, 0.05);
  EXPECT_LT(joint.gear_speed_rad_per_s, 0.25);
  for (const double asked_Nm : {-4.0, -0.3, 0.3, 4.0}) {
    double before = give(model, knee_, asked_Nm, -2.0);
    for (double speed = -2.0; speed <= 2.0; speed += 0.01) {
      const double given_Nm = give(model, knee_, asked_Nm, speed);
      const double into_gear_W = joint.torque_constant_factor * asked_Nm * speed;
      EXPECT_LE(given_Nm * speed, into_gear_W + 1e-12) << asked_Nm << " at " << speed;
      EXPECT_LE(std::abs(given_Nm - before), 0.01 * std::abs(asked_Nm)) << asked_Nm << " at " << speed;
      before = given_Nm;
    }
  }
}

// The loss is reckoned with the speed of the step before: on a bare rotor it must still come to rest.
TEST_F(MotorModelTest, ABareRotorComesToRestUnderItsGearsLoss) {
  MotorModel model = motors(1.0);
  const double rotor_kg_m2 = robot_.joints[knee_].motor.armature_kg_m2;
  double speed = 0.3;
  for (int i = 0; i < 200; ++i) {
    const double driven_Nm = give(model, knee_, limit_Nm_, speed);
    const double loss_Nm = driven_Nm - give(model, knee_, limit_Nm_, 0.0);
    const double next = speed + loss_Nm / rotor_kg_m2 * robot_.physics_step_s;
    ASSERT_LE(std::abs(next), std::abs(speed));
    ASSERT_GE(next * speed, 0.0) << "it swings";
    speed = next;
  }
  EXPECT_LT(speed, 1e-6);
}

TEST_F(MotorModelTest, HeatFollowsTheSquareOfTheTorqueInAMinute) {
  MotorModel model = motors(1.0);
  for (int ms = 0; ms < 60'000; ++ms) give(model, knee_, 0.5 * limit_Nm_, 0.0);
  EXPECT_NEAR(model.heat(knee_), 1.0 - std::exp(-1.0), 1e-4) << "on its way to 1";
  EXPECT_EQ(model.heat(knee_ + 1), 0.0);
  const double hot = model.heat(knee_);
  for (int ms = 0; ms < 60'000; ++ms) give(model, knee_, 0.0, 0.0);
  EXPECT_NEAR(model.heat(knee_), hot * std::exp(-1.0), 1e-4);
  for (int ms = 0; ms < 300'000; ++ms) give(model, knee_, 2.4, 0.0);
  EXPECT_NEAR(model.heat(knee_), 0.36, 0.01) << "what a walking knee settles at";
}

TEST_F(MotorModelTest, AHotMotorGivesLess) {
  MotorModel model = motors(1.0);
  const double most_Nm = limit_Nm_ * model.joint(knee_).torque_constant_factor;
  double begins_s = 0.0;
  for (int ms = 0; ms < 300'000; ++ms) {
    const double before = model.heat(knee_);
    const double share = give(model, knee_, 100.0, 0.0) / most_Nm;
    ASSERT_NEAR(share, 1.0 - 0.4 * std::clamp((before - 1.0) / 0.3, 0.0, 1.0), 1e-9) << ms << " ms";
    if (begins_s == 0.0 && share < 1.0) begins_s = 0.001 * ms;
  }
  EXPECT_NEAR(begins_s, 60.0 * std::log(4.0 / 3.0), 0.02);
  EXPECT_NEAR(give(model, knee_, 100.0, 0.0), 0.6 * most_Nm, 1e-9);
  EXPECT_NEAR(model.heat(knee_), 1.44, 0.01) << "of (0.6 / 0.5)²";
}

TEST_F(MotorModelTest, TheSupplySagsByATenthAtItsReferencePowerWithinMilliseconds) {
  MotorModel model = motors(1.0);
  // Half the torque at half the speed: a quarter is mechanical, a quarter is lost in copper.
  EXPECT_NEAR(model.reference_power_W(), 12 * 0.5 * limit_Nm_ * fastest_, 1e-9);
  for (int ms = 1; ms <= 60; ++ms) {
    load_supply(model);
    EXPECT_NEAR(model.voltage(), 1.0 - 0.1 * (1.0 - std::exp(-ms / 5.0)), 1e-9);
  }
  const double voltage = model.voltage();
  const double constant = model.joint(knee_).torque_constant_factor;
  EXPECT_NEAR(give(model, knee_, 100.0, 4.0) / constant, limit_Nm_ * (1.0 - 4.0 / (voltage * fastest_)) * 0.9,
              0.01)
      << "the speed limit falls with the voltage";
}

TEST_F(MotorModelTest, WhatBrakesDoesNotRaiseTheSupply) {
  MotorModel model = motors(1.0);
  for (int ms = 0; ms < 50; ++ms) give(model, knee_, -1.0, 6.0);
  EXPECT_EQ(model.voltage(), 1.0);
}

TEST_F(MotorModelTest, CurrentSensorsHaveAGainAndAnOffset) {
  const Spread gain = spread(1.0, [](const MotorModel::Joint& joint) { return joint.current_gain; });
  EXPECT_GE(gain.least, 0.95);
  EXPECT_LE(gain.most, 1.05);
  EXPECT_NEAR(gain.deviation, 0.05 / std::sqrt(3.0), 0.002);
  const Spread offset = spread(1.0, [](const MotorModel::Joint& joint) { return joint.current_offset_Nm; });
  EXPECT_NEAR(offset.mean, 0.0, 0.01);
  EXPECT_NEAR(offset.deviation, 0.1, 0.007);
  MotorModel model = motors(1.0);
  const MotorModel::Joint& joint = model.joint(knee_);
  EXPECT_EQ(model.sensed_Nm()[knee_], joint.current_offset_Nm) << "at rest";
  for (const double asked_Nm : {-3.0, 5.0}) {
    give(model, knee_, asked_Nm, asked_Nm > 0.0 ? 1.0 : -1.0);
    EXPECT_NEAR(model.sensed_Nm()[knee_], joint.current_gain * asked_Nm + joint.current_offset_Nm, 1e-12)
        << "neither torque constant nor gear are in it";
  }
  give(model, knee_, 100.0, 0.0);
  EXPECT_NEAR(model.sensed_Nm()[knee_], joint.current_gain * limit_Nm_ + joint.current_offset_Nm, 1e-12)
      << "what the motor takes, not what was asked for";
}

TEST_F(MotorModelTest, CurrentSensorsScatterWhereSensorsDoAndNothingElseDoes) {
  MotorModel noisy = motors(0.0, 1, true), exact = motors(0.0, 1, false);
  double sum = 0.0, squares = 0.0;
  constexpr int kCount = 20'000;
  for (int i = 0; i < kCount; ++i) {
    EXPECT_EQ(give(noisy, knee_, 3.0, 1.0), give(exact, knee_, 3.0, 1.0));
    ASSERT_EQ(exact.sensed_Nm()[knee_], 3.0);
    const double error = noisy.sensed_Nm()[knee_] - 3.0;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.1, 0.002);
}

TEST_F(MotorModelTest, FrictionIsFromHalfToTwice) {
  for (const auto part : {&MotorModel::Joint::friction_factor, &MotorModel::Joint::damping_factor}) {
    const Spread octaves =
        spread(1.0, [part](const MotorModel::Joint& joint) { return std::log2(joint.*part); });
    EXPECT_GE(octaves.least, -1.0);
    EXPECT_LE(octaves.most, 1.0);
    EXPECT_NEAR(octaves.mean, 0.0, 0.05);
    EXPECT_NEAR(octaves.deviation, 1.0 / std::sqrt(3.0), 0.03) << "uniform in its logarithm";
  }
}

TEST_F(MotorModelTest, ServosHaveACommonErrorAndOneOfTheirOwn) {
  double least_common = 2.0, most_common = 0.0;
  for (std::uint64_t seed = 1; seed <= kMotorRobots; ++seed) {
    const ServoFactors factors = draw_servo_factors(robot_, seed, 1.0);
    for (const std::vector<double>* gains : {&factors.stiffness, &factors.damping}) {
      const auto [least, most] = std::ranges::minmax(*gains);
      EXPECT_GE(least, 0.85 * 0.95);
      EXPECT_LE(most, 1.15 * 1.05);
      EXPECT_LE(most / least, 1.05 / 0.95);
      EXPECT_GT(most / least, 1.03);
      least_common = std::min(least_common, (least + most) / 2.0);
      most_common = std::max(most_common, (least + most) / 2.0);
    }
    EXPECT_NE(factors.stiffness, factors.damping);
  }
  EXPECT_LT(least_common, 0.88);
  EXPECT_GT(most_common, 1.12);
  const ServoFactors described = draw_servo_factors(robot_, 3, 0.0);
  EXPECT_EQ(described.stiffness, std::vector<double>(robot_.joints.size(), 1.0));
  EXPECT_EQ(described.damping, described.stiffness);
}

TEST_F(MotorModelTest, NoServoDampsMoreThanABareRotorBears) {
  for (const double mismatch : {1.0, 10.0}) {
    for (std::uint64_t seed = 1; seed <= kMotorRobots; ++seed) {
      const ServoFactors factors = draw_servo_factors(robot_, seed, mismatch);
      for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
        const double damping = factors.damping[j] * robot_.joints[j].servo.damping_Nms_per_rad;
        EXPECT_LT(damping * 0.001 / robot_.joints[j].motor.armature_kg_m2, 0.5);
        EXPECT_GT(factors.stiffness[j], 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace gaitway::simulator
