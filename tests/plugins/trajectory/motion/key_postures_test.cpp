// From wishes to postures: feet in their places, the centre of mass where it was wanted, or a complaint.
#include "gaitway/motion/motion_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/kinematics/leg_geometry.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "motion_fixture.hpp"

namespace gaitway::motion {
namespace {

using ::testing::HasSubstr;

// Seen from the left sole of the standing posture.
struct Seen {
  Eigen::Isometry3d right_sole, pelvis;
  Eigen::Vector3d com_m;
};

Seen look(const Eigen::VectorXd& joint_rad) {
  urdf::ForwardKinematics kinematics(humanoid22());
  kinematics.compute({joint_rad.data(), static_cast<std::size_t>(joint_rad.size())});
  const Eigen::Isometry3d ground = kinematics.sole_pose(urdf::Side::left).inverse();
  return {ground * kinematics.sole_pose(urdf::Side::right), ground, ground * kinematics.com_m()};
}

std::vector<KeyPosture> postures_of(const std::string& keys) {
  return key_postures(humanoid22(), of_keys(keys), {});
}

std::string posture_complaint(const std::string& keys) {
  try {
    postures_of(keys);
  } catch (const MotionError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(KeyPostures, BothSolesStayWhereTheyAreWhateverThePelvisDoes) {
  const auto postures = postures_of(
      "  - {name: a, pelvis: {hip_height_m: 0.3, pitch_deg: 20, roll_deg: 4, yaw_deg: -8, left_m: 0.01}}\n");
  const Seen home = look(postures.at(0).joint_rad), now = look(postures.at(1).joint_rad);
  EXPECT_LT((home.right_sole.matrix() - now.right_sole.matrix()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((now.pelvis.linear() - rotation_of(Eigen::Vector3d(4, 20, -8) * kDegree)).norm(), 1e-9);
  const Eigen::Vector3d hips = 0.5 * (kinematics::hip_centre(humanoid22(), urdf::Side::left) +
                                      kinematics::hip_centre(humanoid22(), urdf::Side::right));
  EXPECT_NEAR((now.pelvis * hips).z(), 0.3, 1e-9);
}

TEST(KeyPostures, TheCentreOfMassIsWhereItWasWantedAndStaysThereWhenArmsMove) {
  const auto postures = postures_of(
      "  - {name: over, pelvis: {hip_height_m: 0.345, over: left, forward_m: 0.01}}\n"
      "  - {name: arms, joints: {right_shoulder_roll: -90}}\n");
  const Eigen::Vector2d centre = humanoid22().feet[0].centre_m;
  for (std::size_t i = 1; i < 3; ++i) {
    const Eigen::Vector3d com = look(postures.at(i).joint_rad).com_m;
    EXPECT_NEAR(com.x(), centre.x() + 0.01, 2e-6);
    EXPECT_NEAR(com.y(), centre.y(), 2e-6);
  }
}

TEST(KeyPostures, ALiftedFootIsMovedFromItsStandingPlace) {
  const auto postures = postures_of(
      "  - {name: over, pelvis: {hip_height_m: 0.345, over: left}}\n"
      "  - {name: up, contact: left, right_foot: {forward_m: 0.05, up_m: 0.06, pitch_deg: -10}}\n");
  const Eigen::Isometry3d home = look(postures.at(0).joint_rad).right_sole;
  const Eigen::Isometry3d now = look(postures.at(2).joint_rad).right_sole;
  EXPECT_LT((now.translation() - home.translation() - Eigen::Vector3d(0.05, 0.0, 0.06)).norm(), 1e-9);
  EXPECT_NEAR(attitude_of(now.linear()).y(), -10.0 * kDegree, 1e-9);
}

TEST(KeyPostures, LegAnglesAreTakenWhenTheyLeaveBothSolesFlat) {
  const auto postures =
      postures_of("  - {name: a, symmetric: {hip_pitch: -30, knee: 60, ankle_pitch: -30}}\n");
  EXPECT_NEAR(postures.at(1).joint_rad[humanoid22().joint_index("right_knee")], 60.0 * kDegree, 1e-12);
  EXPECT_THAT(
      posture_complaint("  - {name: a, joints: {left_knee: 60}}\n"),
      ::testing::AllOf(HasSubstr("test.yaml:4: key 'a'"), HasSubstr("right sole"), HasSubstr("pelvis")));
}

TEST(KeyPostures, NameTheKeyThatCannotBe) {
  EXPECT_THAT(
      posture_complaint("  - {name: tall, pelvis: {hip_height_m: 0.6}}\n"),
      ::testing::AllOf(HasSubstr("key 'tall'"), HasSubstr("out of reach"), HasSubstr("lower hip_height_m")));
  EXPECT_THAT(posture_complaint("  - {name: far, pelvis: {hip_height_m: 0.3, forward_m: 0.07}}\n"),
              ::testing::AllOf(HasSubstr("key 'far'"), HasSubstr("edge of the support")));
  EXPECT_THAT(posture_complaint("  - {name: one leg, contact: left}\n"),
              HasSubstr("standing on the left foot"));
  EXPECT_THAT(
      posture_complaint("  - {name: over, pelvis: {hip_height_m: 0.345, over: left}}\n"
                        "  - {name: up, contact: left, right_foot: {up_m: 0.05}}\n"
                        "  - {name: home, from: home}\n"),
      ::testing::AllOf(HasSubstr("key 'home'"), HasSubstr("not flat on the ground"), HasSubstr("50.0 mm")));
  EXPECT_THAT(posture_complaint("  - {name: elbow, joints: {left_elbow: 0}}\n"), HasSubstr("left_elbow"));
}

}  // namespace
}  // namespace gaitway::motion
