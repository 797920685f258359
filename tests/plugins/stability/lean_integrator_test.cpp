// The slow correction of a lasting lean.
#include "gaitway/stability/batch_feedback.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using test::kDefaults;

BalanceParameters with_gain(double gain_per_s) {
  BalanceParameters parameters;
  parameters.lean_gain_per_s = gain_per_s;
  return parameters;
}

constexpr double kComHeight_m = 0.36;

TEST(LeanIntegrator, IsOffWithoutGain) {
  const BalanceParameters parameters = with_gain(0.0);
  LeanIntegrator lean(parameters, kComHeight_m);
  for (int i = 0; i < 100; ++i) lean.update(0.1, -0.1, false);
  EXPECT_EQ(lean.offset_rad()[0], 0.0);
  EXPECT_EQ(lean.offset_rad()[1], 0.0);
}

TEST(LeanIntegrator, TakesOutALeanThatTheGroundCauses) {
  const BalanceParameters parameters = with_gain(0.5);
  LeanIntegrator lean(parameters, kComHeight_m);
  const double slope = 0.07;
  for (int i = 0; i < 1000; ++i) lean.update(0.0, slope + lean.offset_rad()[1], false);
  EXPECT_NEAR(lean.offset_rad()[1], -slope, 0.001);
  EXPECT_EQ(lean.offset_rad()[0], 0.0);
}

TEST(LeanIntegrator, BringsTheCentreOfMassAboveTheFeetOnASlope) {
  // Ground that turns the robot by roll and pitch: along its normal, the CoM is beside the feet by as much.
  const double roll = 0.06, pitch = -0.08;
  const BalanceParameters parameters = with_gain(1.0);
  LeanIntegrator lean(parameters, kComHeight_m);
  for (int i = 0; i < 1000; ++i)
    lean.update(roll + lean.offset_rad()[0], pitch + lean.offset_rad()[1], false);
  const Eigen::Matrix3d ground =
      (Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  const Eigen::Vector3d planned(lean.com_offset_m()[0], lean.com_offset_m()[1], kComHeight_m);
  const Eigen::Vector3d com = ground * planned;
  EXPECT_NEAR(com.x(), 0.0, 0.0005);
  EXPECT_NEAR(com.y(), 0.0, 0.0005);
}

TEST(LeanIntegrator, LearnsSlowlyFromAWalk) {
  LeanIntegrator standing{kDefaults, kComHeight_m}, walking{kDefaults, kComHeight_m};
  for (int i = 0; i < 10; ++i) {
    standing.update(0.05, 0.05, false);
    walking.update(0.05, 0.05, true);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_LT(walking.offset_rad()[axis], 0.0);
    EXPECT_GT(walking.offset_rad()[axis], 0.2 * standing.offset_rad()[axis]);
  }
}

TEST(LeanIntegrator, IsLimitedAndFades) {
  const BalanceParameters parameters = with_gain(0.5);
  LeanIntegrator lean(parameters, kComHeight_m);
  for (int i = 0; i < 2000; ++i) lean.update(-0.3, 0.3, false);
  EXPECT_DOUBLE_EQ(lean.offset_rad()[0], BalanceParameters{}.lean_limit_rad);
  EXPECT_DOUBLE_EQ(lean.offset_rad()[1], -BalanceParameters{}.lean_limit_rad);
  for (int i = 0; i < 1000; ++i) lean.fade();
  EXPECT_NEAR(lean.offset_rad()[0], 0.0, 0.01 * BalanceParameters{}.lean_limit_rad);
}

}  // namespace
}  // namespace gaitway::stability
