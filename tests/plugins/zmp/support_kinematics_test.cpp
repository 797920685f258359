// Level frames of the feet.
#include "gaitway/zmp/support_kinematics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::home_posture;
using test::humanoid;
using urdf::Side;

TEST(SupportKinematics, HomePostureHasTheOtherSoleBesideAndTheComAbove) {
  const SupportKinematics kinematics(humanoid());
  const Eigen::Vector3d right = kinematics.sole_point_m(Side::left, Side::right, {0.0, 0.0});
  EXPECT_NEAR((right - Eigen::Vector3d(0.0, -0.1, 0.0)).norm(), 0.0, 1e-9);
  const Eigen::Vector3d com = kinematics.com_m(Side::left);
  EXPECT_NEAR(com.y(), -0.05, 1e-3);
  EXPECT_GT(com.z(), 0.3);
}

TEST(SupportKinematics, PointOfTheSupportSoleIsItselfOnLevelGround) {
  const SupportKinematics kinematics(humanoid());
  const Eigen::Vector3d point = kinematics.sole_point_m(Side::right, Side::right, {0.04, -0.02});
  EXPECT_NEAR((point - Eigen::Vector3d(0.04, -0.02, 0.0)).norm(), 0.0, 1e-12);
}

// The robot somewhere in the world, in any posture: positions against the sole, in axes that are vertical and
// along the sole's heading, are the same however they are found.
TEST(SupportKinematics, AgreesWithPosesInTheWorldForAnyPosture) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> angle(-0.3, 0.3);
  SupportKinematics kinematics(humanoid());
  urdf::ForwardKinematics reference(humanoid());
  for (int run = 0; run < 300; ++run) {
    std::vector<double> posture = home_posture(humanoid());
    for (double& position : posture) position += angle(random);
    Attitude attitude{angle(random), angle(random), 5.0 * angle(random)};
    kinematics.update(posture, attitude);
    reference.compute(posture);
    const Eigen::Matrix3d world_from_trunk =
        Eigen::AngleAxisd(attitude.yaw_rad, Eigen::Vector3d::UnitZ()) * attitude.tilt();
    Eigen::Isometry3d world_from_base = Eigen::Isometry3d::Identity();
    world_from_base.linear() = world_from_trunk * reference.link_rotation(humanoid().imu.link).transpose();
    world_from_base.translation() = Eigen::Vector3d(1.0, -2.0, 0.4);
    for (const Side side : urdf::kSides) {
      const Side other = side == Side::left ? Side::right : Side::left;
      const Eigen::Isometry3d sole = world_from_base * reference.sole_pose(side);
      const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d left = up.cross(sole.linear().col(0)).normalized();
      Eigen::Matrix3d axes;
      axes << left.cross(up), left, up;
      const auto in_level = [&](const Eigen::Vector3d& base_point) -> Eigen::Vector3d {
        return axes.transpose() * (world_from_base * base_point - sole.translation());
      };
      EXPECT_NEAR((kinematics.com_m(side) - in_level(reference.com_m())).norm(), 0.0, 1e-12);
      const Eigen::Vector3d toe = reference.sole_pose(other) * Eigen::Vector3d(0.07, 0.01, 0.0);
      EXPECT_NEAR((kinematics.sole_point_m(side, other, {0.07, 0.01}) - in_level(toe)).norm(), 0.0, 1e-12);
      EXPECT_NEAR(
          (kinematics.turn(side, other) * kinematics.turn(other, side) - Eigen::Matrix3d::Identity()).norm(),
          0.0, 1e-12);
      EXPECT_NEAR((kinematics.turn(side, other) * up - up).norm(), 0.0, 1e-12);
    }
  }
}

// On a slope the sole is tilted, the frame is not: the CoM is where a plumb line says.
TEST(SupportKinematics, TiltedSoleKeepsALevelFrame) {
  SupportKinematics kinematics(humanoid());
  const Eigen::Vector3d flat = kinematics.com_m(Side::left);
  kinematics.update(home_posture(humanoid()),
                    Attitude{0.0, 0.1, 0.0});  // the whole robot, soles too, is nose down
  const Eigen::Vector3d expected = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()) * flat;
  EXPECT_NEAR((kinematics.com_m(Side::left) - expected).norm(), 0.0, 1e-12);
  EXPECT_LT(kinematics.sole_point_m(Side::left, Side::left, {0.05, 0.0}).z(), -0.004);
}

}  // namespace
}  // namespace gaitway::zmp
