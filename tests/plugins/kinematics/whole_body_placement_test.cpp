// Whole-body CoM, and placing the base so that it is where it was planned, against plain sums over all links.
#include "gaitway/kinematics/whole_body_placement.hpp"

#include <gtest/gtest.h>

#include "leg_sampler.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics {
namespace {

using test::home_posture;
using test::link_poses;
using test::sole_pose;

using test::make_robot;

std::vector<double> posture(const urdf::RobotModel& model, const std::array<double, 6>& left_rad,
                            const std::array<double, 6>& right_rad) {
  std::vector<double> all = home_posture(model);
  for (std::size_t i = 0; i < 6; ++i) {
    all[static_cast<std::size_t>(model.legs[0].joints[i])] = left_rad[i];
    all[static_cast<std::size_t>(model.legs[1].joints[i])] = right_rad[i];
  }
  return all;
}

Eigen::Vector3d com_by_sum(const urdf::RobotModel& model, const std::vector<double>& angle_rad) {
  const std::vector<Eigen::Isometry3d> poses = link_poses(model, angle_rad);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double mass_kg = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    moment += model.links[i].mass_kg * (poses[i] * model.links[i].com_m);
    mass_kg += model.links[i].mass_kg;
  }
  return moment / mass_kg;
}

TEST(BodyMass, EqualsTheSumOverAllLinks) {
  for (const test::LegVariant& variant : test::closed_form_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    const BodyMass mass(model);
    EXPECT_NEAR(mass.total_mass_kg(), 6.84, 1e-9);
    test::LegSampler left(model, urdf::Side::left, 1.0, 1);
    test::LegSampler right(model, urdf::Side::right, 1.0, 2);
    for (int i = 0; i < 200; ++i) {
      const auto left_rad = left.any_angles();
      const auto right_rad = right.any_angles();
      const Eigen::Vector3d expected = com_by_sum(model, posture(model, left_rad, right_rad));
      ASSERT_LT((mass.com_m(left_rad, right_rad) - expected).norm(), 1e-12);
    }
  }
}

TEST(BodyMass, RefusesALinkThatHangsOnALeg) {
  urdf::RobotModel model = make_robot();
  model.joints.back().parent_link = model.feet[0].link;
  EXPECT_THROW(BodyMass{model}, urdf::RobotError);
}

// Plan points of a walk in mid-step, with everything turned on.
PlanPoint busy_point(double phase) {
  PlanPoint point;
  point.com_m = {1.0 + 0.03 * phase, -2.0 + 0.02 * phase};
  point.com_offset_m = {0.004, -0.006};
  point.hip_height_m = 0.345;
  point.base_yaw_rad = 0.7 + 0.2 * phase;
  point.base_attitude_rad = {0.03 * phase, 0.05};
  const Eigen::Rotation2Dd heading(0.7);
  const Eigen::Vector2d left = Eigen::Vector2d(1.0, -2.0) + heading * Eigen::Vector2d(0.04 * phase, 0.05);
  const Eigen::Vector2d right = Eigen::Vector2d(1.0, -2.0) + heading * Eigen::Vector2d(-0.05 * phase, -0.055);
  point.foot_m = {Eigen::Vector3d(left.x(), left.y(), 0.02 * std::abs(phase)),
                  Eigen::Vector3d(right.x(), right.y(), 0.0)};
  point.foot_yaw_rad = {0.75, 0.65 + 0.1 * phase};
  return point;
}

// Checked through the feet alone: the base follows from the left sole, everything else from forward
// kinematics.
void expect_point_is_met(const urdf::RobotModel& model, const PlanPoint& point, const BothLegs& legs,
                         double tolerance_m) {
  const std::vector<double> all = posture(model, legs[0].angle_rad, legs[1].angle_rad);
  const auto plan_from_sole = [&](std::size_t i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate(point.foot_m[i])
        .rotate(Eigen::AngleAxisd(point.foot_yaw_rad[i], Eigen::Vector3d::UnitZ()));
    return pose;
  };
  const Eigen::Isometry3d plan_from_base =
      plan_from_sole(0) * sole_pose(model, urdf::Side::left, all).inverse();
  const Eigen::Isometry3d right = plan_from_base * sole_pose(model, urdf::Side::right, all);
  ASSERT_LT((right.matrix() - plan_from_sole(1).matrix()).cwiseAbs().maxCoeff(), 1e-8);

  const Eigen::Vector2d com = (plan_from_base * com_by_sum(model, all)).head<2>();
  const Eigen::Vector2d planned = point.com_m + Eigen::Rotation2Dd(point.base_yaw_rad) * point.com_offset_m;
  EXPECT_LT((com - planned).norm(), tolerance_m);

  const Eigen::Vector3d hips =
      0.5 * (hip_centre(model, urdf::Side::left) + hip_centre(model, urdf::Side::right));
  EXPECT_NEAR((plan_from_base * hips).z(), point.hip_height_m, 1e-8);
  const Eigen::Matrix3d attitude = (Eigen::AngleAxisd(point.base_yaw_rad, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(point.base_attitude_rad.y(), Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(point.base_attitude_rad.x(), Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  EXPECT_LT((plan_from_base.linear() - attitude).cwiseAbs().maxCoeff(), 1e-8);
}

class EverySolver : public ::testing::TestWithParam<SolverChoice> {};
INSTANTIATE_TEST_SUITE_P(WholeBodyPlacement, EverySolver,
                         ::testing::Values(SolverChoice::closed_form, SolverChoice::kdl));

TEST_P(EverySolver, PutsTheComWhereItIsPlannedAndTheFeetWhereTheyBelong) {
  for (const test::LegVariant& variant : test::closed_form_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    WholeBodyPlacement placement(model, GetParam());
    for (int i = -10; i <= 10; ++i) {
      const PlanPoint point = busy_point(0.1 * i);
      const auto result = placement.place_com(placement.frames(point), placement.standing_offset_m(), 1e-6);
      ASSERT_TRUE(result.converged) << describe(result.legs[0], model, urdf::Side::left) << "; "
                                    << describe(result.legs[1], model, urdf::Side::right);
      expect_point_is_met(model, point, result.legs, 1e-6);
    }
  }
}

TEST(WholeBodyPlacement, ConvergesFromACentimetreAwayInThreeSolutions) {
  const urdf::RobotModel model = make_robot();
  WholeBodyPlacement placement(model, SolverChoice::closed_form);
  const PointFrames frames = placement.frames(busy_point(0.5));
  Eigen::Vector2d offset = placement.standing_offset_m() + Eigen::Vector2d(0.01, -0.01);
  for (int i = 0; i < 2; ++i) offset = placement.place_com(frames, offset, 1.0).refined_m;  // one step a call
  const BothLegs legs = placement.place(frames, offset);
  EXPECT_LT(placement.com_error_m(frames, legs, offset).norm(), 0.05e-3);
}

TEST(WholeBodyPlacement, ReturnsTheStandingPostureForTheStandingPlan) {
  const urdf::RobotModel model = make_robot();
  WholeBodyPlacement placement(model, SolverChoice::automatic);
  const std::vector<double> home = home_posture(model);
  PlanPoint point;
  const Eigen::Vector3d com = com_by_sum(model, home);
  for (const urdf::Side side : urdf::kSides) {
    Eigen::Vector3d sole = sole_pose(model, side, home).translation();
    sole.z() = 0.0;
    point.foot_m[static_cast<std::size_t>(side)] = sole;
  }
  point.com_m = com.head<2>();
  point.hip_height_m = -0.02 - sole_pose(model, urdf::Side::left, home).translation().z();
  const auto result = placement.place_com(placement.frames(point), placement.standing_offset_m(), 1e-9);
  ASSERT_TRUE(result.converged);
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(result.legs[side].angle_rad[i], home[static_cast<std::size_t>(model.legs[side].joints[i])],
                  1e-6);
    }
  }
}

}  // namespace
}  // namespace gaitway::kinematics
