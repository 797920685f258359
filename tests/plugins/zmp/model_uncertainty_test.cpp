// What errors of the description do to CoM and feet.
#include "gaitway/zmp/support_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::humanoid;
using urdf::Side;

TEST(ModelUncertainty, ExactDescriptionHasNone) {
  EstimatorParameters exact;
  exact.joint_zero_deviation_rad = exact.tilt_zero_deviation_rad = 0.0;
  exact.link_mass_deviation = exact.trunk_com_deviation_m = 0.0;
  const ModelUncertainty uncertainty = model_uncertainty(humanoid(), exact);
  EXPECT_EQ(uncertainty.com_m, Eigen::Vector3d::Zero());
  EXPECT_EQ(uncertainty.foot_m, Eigen::Vector3d::Zero());
}

TEST(ModelUncertainty, IsWhatRandomJointZerosDo) {
  EstimatorParameters zeros;
  zeros.link_mass_deviation = zeros.trunk_com_deviation_m = zeros.tilt_zero_deviation_rad = 0.0;
  const ModelUncertainty uncertainty = model_uncertainty(humanoid(), zeros);
  std::mt19937 random(11);
  std::normal_distribution<double> zero(0.0, zeros.joint_zero_deviation_rad);
  SupportKinematics kinematics(humanoid());
  const std::vector<double> home = test::home_posture(humanoid());
  kinematics.update(home, Attitude{});
  const Eigen::Vector3d com = kinematics.com_m(Side::left);
  const Eigen::Vector3d foot = kinematics.sole_point_m(Side::left, Side::right, Eigen::Vector2d::Zero());
  Eigen::Vector3d com_squares = Eigen::Vector3d::Zero(), foot_squares = Eigen::Vector3d::Zero();
  constexpr int kRobots = 2000;
  for (int i = 0; i < kRobots; ++i) {
    std::vector<double> posture = home;
    for (double& angle : posture) angle += zero(random);
    kinematics.update(posture, Attitude{});
    com_squares += (kinematics.com_m(Side::left) - com).cwiseAbs2() / kRobots;
    foot_squares +=
        (kinematics.sole_point_m(Side::left, Side::right, Eigen::Vector2d::Zero()) - foot).cwiseAbs2() /
        kRobots;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(uncertainty.com_m[axis], std::sqrt(com_squares[axis]), 0.1 * uncertainty.com_m[axis] + 1e-5);
    EXPECT_NEAR(uncertainty.foot_m[axis], std::sqrt(foot_squares[axis]),
                0.1 * uncertainty.foot_m[axis] + 1e-4);
  }
}

// An IMU that is mounted askew turns the body about the sole.
TEST(ModelUncertainty, AnAskewImuLiftsNothingAndMovesTheComByItsHeight) {
  EstimatorParameters askew;
  askew.link_mass_deviation = askew.trunk_com_deviation_m = askew.joint_zero_deviation_rad = 0.0;
  askew.tilt_zero_deviation_rad = 0.02;
  SupportKinematics kinematics(humanoid());
  kinematics.update(test::home_posture(humanoid()), Attitude{});
  const Eigen::Vector3d com = kinematics.com_m(Side::left);
  kinematics.level({.roll_rad = 0.0, .pitch_rad = 0.02, .yaw_rad = 0.0});
  const double moved_m = kinematics.com_m(Side::left).x() - com.x();
  const ModelUncertainty uncertainty = model_uncertainty(humanoid(), askew);
  EXPECT_NEAR(uncertainty.com_m.x(), moved_m, 0.05 * moved_m);
  EXPECT_EQ(uncertainty.com_m.x(), uncertainty.com_m.y());
  EXPECT_EQ(uncertainty.com_m.z(), 0.0);
  EXPECT_EQ(uncertainty.foot_m, Eigen::Vector3d::Zero());
}

TEST(ModelUncertainty, MassesAndTrunkAddToIt) {
  EstimatorParameters zeros;
  zeros.link_mass_deviation = zeros.trunk_com_deviation_m = 0.0;
  const ModelUncertainty less = model_uncertainty(humanoid(), zeros);
  const ModelUncertainty all = model_uncertainty(humanoid(), EstimatorParameters{});
  for (Eigen::Index axis = 0; axis < 3; ++axis) EXPECT_GT(all.com_m[axis], less.com_m[axis]);
  EXPECT_EQ(all.foot_m, less.foot_m);
}

}  // namespace
}  // namespace gaitway::zmp
