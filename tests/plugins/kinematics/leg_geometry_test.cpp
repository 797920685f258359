// Which legs are recognised as having a closed form, and what is said of the others.
#include "gaitway/kinematics/leg_geometry.hpp"

#include <gtest/gtest.h>

#include "gaitway/kinematics/leg_solver.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics {
namespace {

using test::LegVariant;
using test::make_robot;

std::string reason_for(const LegVariant& variant) {
  const LegRecognition recognition = recognise_leg(make_robot(variant), urdf::Side::left);
  EXPECT_FALSE(recognition.geometry);
  return recognition.reason;
}

TEST(LegGeometry, MeasuresTheLegInItsOwnAxes) {
  const LegRecognition left = recognise_leg(make_robot(), urdf::Side::left);
  ASSERT_TRUE(left.geometry) << left.reason;
  EXPECT_TRUE(left.geometry->hip_m.isApprox(Eigen::Vector3d(0.0, 0.05, -0.02)));
  EXPECT_TRUE(left.geometry->thigh_m.isApprox(Eigen::Vector2d(0.0, -0.17)));
  EXPECT_TRUE(left.geometry->shin_m.isApprox(Eigen::Vector2d(0.0, -0.17)));
  EXPECT_TRUE(left.geometry->ankle_m.isApprox(Eigen::Vector3d(0.0, 0.0, 0.04)));
  EXPECT_NEAR(left.geometry->lateral_m, 0.0, 1e-15);
  EXPECT_EQ(left.geometry->knee_sign, 1.0);
}

TEST(LegGeometry, RecognisesLegsWithOffsetsSignsAndABentZeroPosture) {
  for (const LegVariant& variant : test::closed_form_variants()) {
    for (const urdf::Side side : urdf::kSides) {
      const LegRecognition recognition = recognise_leg(make_robot(variant), side);
      EXPECT_TRUE(recognition.geometry) << recognition.reason;
    }
  }
}

TEST(LegGeometry, SaysWhichAxisMissesTheHipAndByHowMuch) {
  LegVariant variant;
  variant.hip_pitch_shift_m = {0.0, 0.0, -0.02};
  EXPECT_EQ(reason_for(variant),
            "the hip pitch axis misses the point where the hip axes should meet by 20.000 mm");
}

TEST(LegGeometry, SaysThatTheAnkleAxesDoNotMeet) {
  LegVariant variant;
  variant.ankle_roll_shift_m = {0.0, 0.0, -0.015};
  EXPECT_EQ(reason_for(variant), "the ankle roll axis misses the ankle pitch axis by 15.000 mm");
}

TEST(LegGeometry, SaysThatTheKneeIsNotParallel) {
  LegVariant variant;
  variant.knee_tilt_rad = 0.01;
  EXPECT_EQ(reason_for(variant), "the knee axis is not parallel to the hip pitch axis");
}

TEST(LegGeometry, SaysThatTheHipAxesAreNotAtRightAngles) {
  LegVariant variant;
  variant.hip_roll_tilt_rad = 0.1;
  EXPECT_EQ(reason_for(variant), "the hip roll and hip pitch axes are not at right angles");
}

TEST(LegGeometry, SaysThatTheJointsAreNoChain) {
  urdf::RobotModel model = make_robot();
  std::swap(model.legs[0].joints[2], model.legs[0].joints[3]);
  const LegRecognition recognition = recognise_leg(model, urdf::Side::left);
  EXPECT_EQ(recognition.reason, "joint 'left_knee' (hip pitch) does not follow the one before it in the leg");
}

TEST(LegSolver, ChoosesTheClosedFormWhereThereIsOneAndSaysWhyNotElsewhere) {
  EXPECT_TRUE(LegSolver(make_robot(), urdf::Side::left, SolverChoice::automatic).closed_form());
  EXPECT_FALSE(LegSolver(make_robot(), urdf::Side::left, SolverChoice::kdl).closed_form());
  LegVariant shifted;
  shifted.ankle_roll_shift_m = {0.0, 0.0, -0.015};
  const LegSolver general(make_robot(shifted), urdf::Side::left, SolverChoice::automatic);
  EXPECT_FALSE(general.closed_form());
  EXPECT_EQ(general.reason(), "the ankle roll axis misses the ankle pitch axis by 15.000 mm");
  EXPECT_THROW(LegSolver(make_robot(shifted), urdf::Side::left, SolverChoice::closed_form), urdf::RobotError);
}

TEST(LegSolver, TakesAStartWhereItIterates) {
  const urdf::RobotModel usual = make_robot(), offset = make_robot(test::offset_hip());
  EXPECT_FALSE(LegSolver(usual, urdf::Side::left, SolverChoice::automatic).wants_start());
  EXPECT_TRUE(LegSolver(offset, urdf::Side::left, SolverChoice::automatic).wants_start());
  EXPECT_FALSE(LegSolver(offset, urdf::Side::left, SolverChoice::kdl).wants_start()) << "it has its own";
}

TEST(LegGeometry, FindsTheNearestLegWithAClosedForm) {
  const LegGeometry usual = recognise_leg(make_robot(), urdf::Side::left).geometry.value();
  const auto nearest = nearest_closed_form(make_robot(test::offset_hip()), urdf::Side::left);
  ASSERT_TRUE(nearest);
  EXPECT_NEAR((nearest->hip_m - Eigen::Vector3d(0.03, 0.05, 0.0)).norm(), 0.0, 1e-12)
      << "on the pitch axis, where the roll axis is nearest";
  EXPECT_NEAR((nearest->thigh_m - usual.thigh_m).norm(), 0.0, 1e-12);
  EXPECT_NEAR((nearest->shin_m - usual.shin_m).norm(), 0.0, 1e-12);
  for (const LegVariant& variant : test::general_variants()) {
    for (const urdf::Side side : urdf::kSides) EXPECT_TRUE(nearest_closed_form(make_robot(variant), side));
  }
}

TEST(LegSolver, RefusesAnUnknownChoiceByName) {
  EXPECT_EQ(solver_choice("auto"), SolverChoice::automatic);
  EXPECT_EQ(solver_choice("closed_form"), SolverChoice::closed_form);
  EXPECT_EQ(solver_choice("kdl"), SolverChoice::kdl);
  EXPECT_THROW((void)solver_choice("pinocchio"), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::kinematics
