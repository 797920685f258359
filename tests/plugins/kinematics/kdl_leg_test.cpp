// The general solver against the closed form, and alone on legs that have none.
#include "gaitway/kinematics/leg_solver.hpp"

#include <gtest/gtest.h>

#include "leg_sampler.hpp"
#include "repeats.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics {
namespace {

using test::home_posture;
using test::sole_pose;

using test::LegSampler;
using test::make_robot;

// Both solvers on random poses; the general one starts up to 0.05 rad away, several samples' worth of
// walking.
void expect_agreement(double spread_rad, int samples) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> nearby(-0.05, 0.05);
  for (const test::LegVariant& variant : test::closed_form_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    for (const urdf::Side side : urdf::kSides) {
      const ClosedFormLeg closed_form(recognise_leg(model, side).geometry.value());
      KdlLeg general(model, side);
      LegSampler sampler(model, side, spread_rad, 11);
      for (int i = 0; i < samples; ++i) {
        const auto angles = sampler.angles();
        auto start = angles;
        for (double& angle : start) angle += nearby(random);
        start[3] = angles[3] + (start[3] - angles[3]) * 0.5;  // not through the straight knee
        general.start_from(start);
        const Eigen::Isometry3d sole = sampler.sole(angles);
        const LegSolution expected = closed_form.solve(sole);
        const LegSolution solution = general.solve(sole);
        ASSERT_TRUE(expected.reached() && solution.reached()) << describe(solution, model, side);
        ASSERT_LT(test::largest_difference(solution.angle_rad, expected.angle_rad), 1e-6);
      }
    }
  }
}

TEST(KdlLeg, AgreesWithTheClosedFormNearWalking) {
  expect_agreement(0.35, gaitway::test::repeats(1000));
}

TEST(KdlLeg, AgreesWithTheClosedFormFarFromWalking) {
  expect_agreement(1.0, gaitway::test::repeats(1000));
}

TEST(KdlLeg, SolvesALegWhoseAxesDoNotMeet) {
  test::LegVariant variant;
  variant.hip_pitch_shift_m = {0.01, 0.0, -0.03};
  variant.ankle_roll_shift_m = {0.0, 0.0, -0.02};
  const urdf::RobotModel model = make_robot(variant);
  KdlLeg leg(model, urdf::Side::right);
  LegSampler sampler(model, urdf::Side::right, 0.4, 5);
  for (int i = 0; i < gaitway::test::repeats(1000); ++i) {
    const auto expected = sampler.angles();
    leg.start_from(sampler.home());
    const LegSolution solution = leg.solve(sampler.sole(expected));
    ASSERT_TRUE(solution.reached()) << i << ": " << describe(solution, model, urdf::Side::right);
    ASSERT_LT(test::largest_difference(solution.angle_rad, expected), 1e-6);
  }
}

TEST(KdlLeg, SaysThatAnUnreachablePoseIsNotReached) {
  const urdf::RobotModel model = make_robot();
  KdlLeg leg(model, urdf::Side::left);
  Eigen::Isometry3d sole = Eigen::Isometry3d::Identity();
  sole.translation() = Eigen::Vector3d(0.0, 0.05, -0.02 - 0.34 - 0.04 - 0.03);
  const LegSolution solution = leg.solve(sole);
  EXPECT_EQ(solution.status, LegStatus::not_converged);
  EXPECT_NEAR(solution.excess, 0.03, 0.006) << "the nearest posture in position and orientation";
  // And it recovers at the next pose.
  LegSampler sampler(model, urdf::Side::left, 0.3, 1);
  EXPECT_TRUE(leg.solve(sampler.sole(sampler.home())).reached());
}

TEST(KdlLeg, ReportsAJointBeyondItsLimit) {
  const urdf::RobotModel model = make_robot();
  KdlLeg leg(model, urdf::Side::left);
  Eigen::Isometry3d sole = sole_pose(model, urdf::Side::left, home_posture(model));
  sole.rotate(Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitZ()));
  const LegSolution solution = leg.solve(sole);
  EXPECT_EQ(solution.status, LegStatus::joint_limit);
  EXPECT_EQ(solution.joint, 0);
  EXPECT_NEAR(solution.excess, 0.1, 1e-6);
}

TEST(KdlLeg, RefusesALegWhoseJointsAreNotTheChain) {
  urdf::RobotModel model = make_robot();
  std::swap(model.legs[0].joints[1], model.legs[0].joints[2]);
  try {
    KdlLeg leg(model, urdf::Side::left);
    FAIL() << "a leg with swapped joints was accepted";
  } catch (const urdf::RobotError& error) {
    EXPECT_NE(std::string(error.what()).find("left_hip_roll"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitway::kinematics
