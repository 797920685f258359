// The closed form against forward kinematics, over geometries, reach and limits.
#include "gaitway/kinematics/leg_solver.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "leg_sampler.hpp"
#include "repeats.hpp"
#include "robots/robot_variants.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics {
namespace {

using test::home_posture;
using test::sole_pose;

using test::closed_form_variants;
using test::LegSampler;
using test::make_robot;

ClosedFormLeg leg_of(const urdf::RobotModel& model, urdf::Side side) {
  LegRecognition recognition = recognise_leg(model, side);
  EXPECT_TRUE(recognition.geometry) << recognition.reason;
  return ClosedFormLeg(recognition.geometry.value());
}

Eigen::Isometry3d home_sole(const urdf::RobotModel& model, urdf::Side side) {
  return sole_pose(model, side, home_posture(model));
}

void expect_the_angles_that_made_the_pose(const urdf::RobotModel& model) {
  for (const urdf::Side side : urdf::kSides) {
    const ClosedFormLeg leg = leg_of(model, side);
    LegSampler sampler(model, side, 1.2, 7);
    for (int i = 0; i < gaitway::test::repeats(5000); ++i) {
      const auto expected = sampler.angles();
      const LegSolution solution = leg.solve(sampler.sole(expected));
      ASSERT_TRUE(solution.reached()) << describe(solution, model, side);
      ASSERT_LT(test::largest_difference(solution.angle_rad, expected), 1e-9);
    }
  }
}

TEST(ClosedFormLeg, ReturnsTheAnglesThatMadeThePose) {
  std::size_t variant_index = 0;
  for (const test::LegVariant& variant : closed_form_variants()) {
    SCOPED_TRACE(testing::Message() << "variant " << variant_index++);
    expect_the_angles_that_made_the_pose(make_robot(variant));
  }
}

TEST(ClosedFormLeg, ReturnsThemForEveryOrderOfTheHip) {
  for (const auto& order : gaitway::test::kHipOrders) {
    SCOPED_TRACE(testing::PrintToString(order));
    gaitway::test::RobotVariant variant;
    variant.reorder(gaitway::test::kHip, order);
    expect_the_angles_that_made_the_pose(urdf::load_robot(variant.folder()));
  }
}

TEST(ClosedFormLeg, ReachesPosesOfADeepSquat) {
  for (const test::LegVariant& variant : closed_form_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    const ClosedFormLeg leg = leg_of(model, urdf::Side::left);
    LegSampler sampler(model, urdf::Side::left, 2.4, 9);
    for (int i = 0; i < gaitway::test::repeats(5000); ++i) {
      const Eigen::Isometry3d sole = sampler.sole(sampler.any_angles());
      const LegSolution solution = leg.solve(sole);
      ASSERT_TRUE(solution.reached()) << describe(solution, model, urdf::Side::left);
      ASSERT_LT((sampler.sole(solution.angle_rad).matrix() - sole.matrix()).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

TEST(ClosedFormLeg, SaysByHowMuchTheLegIsOverStretched) {
  const urdf::RobotModel model = make_robot();
  const ClosedFormLeg leg = leg_of(model, urdf::Side::left);
  Eigen::Isometry3d sole = home_sole(model, urdf::Side::left);
  // Ankle straight below the hip: 0.34 m of leg, hip at z = -0.02, sole 0.04 below the ankle.
  sole.translation() = Eigen::Vector3d(0.0, 0.05, -0.02 - 0.34 - 0.04 - 0.0123);
  const LegSolution solution = leg.solve(sole);
  EXPECT_EQ(solution.status, LegStatus::over_stretched);
  EXPECT_NEAR(solution.excess, 0.0123, 1e-12);
  EXPECT_TRUE(std::isnan(solution.angle_rad[3]));
  EXPECT_EQ(describe(solution, model, urdf::Side::left), "the leg is over-stretched by 12.3 mm");
}

TEST(ClosedFormLeg, SaysByHowMuchTheFootIsTooClose) {
  test::LegVariant variant;
  urdf::RobotModel model = make_robot(variant);
  model.joints[static_cast<std::size_t>(model.legs[0].joints[4])].origin.translation().z() =
      -0.12;  // short shin
  const ClosedFormLeg leg = leg_of(model, urdf::Side::left);
  Eigen::Isometry3d sole = Eigen::Isometry3d::Identity();
  sole.translation() = Eigen::Vector3d(0.0, 0.05, -0.02 - 0.05 + 0.02 - 0.04);  // ankle 30 mm below the hip
  const LegSolution solution = leg.solve(sole);
  EXPECT_EQ(solution.status, LegStatus::over_folded);
  EXPECT_NEAR(solution.excess, 0.02, 1e-12);
}

TEST(ClosedFormLeg, NamesTheJointThatIsFarthestBeyondItsLimit) {
  const urdf::RobotModel model = make_robot();
  const ClosedFormLeg leg = leg_of(model, urdf::Side::right);
  Eigen::Isometry3d sole = home_sole(model, urdf::Side::right);
  sole.rotate(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));  // hip yaw 1.0, limit 0.8
  const LegSolution solution = leg.solve(sole);
  EXPECT_EQ(solution.status, LegStatus::joint_limit);
  EXPECT_EQ(solution.joint, 0);
  EXPECT_NEAR(solution.excess, 0.2, 1e-9);
  EXPECT_NEAR(solution.angle_rad[0], 1.0, 1e-9) << "angles are not clamped";
  EXPECT_EQ(describe(solution, model, urdf::Side::right),
            "joint 'right_hip_yaw' would be at 1.0000 rad, 0.2000 rad beyond its limits [-0.8000, 0.8000]");
}

TEST(ClosedFormLeg, RefusesAPoseThatIsNotANumber) {
  const urdf::RobotModel model = make_robot();
  const ClosedFormLeg leg = leg_of(model, urdf::Side::left);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      Eigen::Isometry3d sole = home_sole(model, urdf::Side::left);
      sole(row, column) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_FALSE(leg.solve(sole).reached()) << row << ", " << column;
    }
  }
}

TEST(ClosedFormLeg, ReachesTheLastMicrometreBeforeTheLegIsStraight) {
  const urdf::RobotModel model = make_robot();
  const ClosedFormLeg leg = leg_of(model, urdf::Side::left);
  Eigen::Isometry3d sole = Eigen::Isometry3d::Identity();
  sole.translation() = Eigen::Vector3d(0.0, 0.05, -0.02 - 0.34 - 0.04 + 1e-6);
  const LegSolution solution = leg.solve(sole);
  ASSERT_TRUE(solution.reached()) << describe(solution, model, urdf::Side::left);
  LegSampler sampler(model, urdf::Side::left, 1.0, 1);
  EXPECT_TRUE(sampler.sole(solution.angle_rad).isApprox(sole, 1e-9));
}

}  // namespace
}  // namespace gaitway::kinematics
