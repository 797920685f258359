// Links that no joint connects must not overlap in the postures that the robot takes, or the simulated robot
// would push itself apart.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::urdf {
namespace {

// Separating-axis test of two oriented boxes (Gottschalk, Lin, Manocha 1996).
bool overlap(const Eigen::Isometry3d& pose_a, const Eigen::Vector3d& size_a, const Eigen::Isometry3d& pose_b,
             const Eigen::Vector3d& size_b) {
  const Eigen::Matrix3d a = pose_a.linear(), b = pose_b.linear();
  const Eigen::Vector3d between = pose_b.translation() - pose_a.translation();
  const auto separates = [&](const Eigen::Vector3d& axis) {
    const double reach =
        0.5 * ((a.transpose() * axis).cwiseAbs().dot(size_a) + (b.transpose() * axis).cwiseAbs().dot(size_b));
    return axis.norm() > 1e-9 && std::abs(between.dot(axis)) > reach;
  };
  for (int i = 0; i < 3; ++i) {
    if (separates(a.col(i)) || separates(b.col(i))) return false;
    for (int j = 0; j < 3; ++j) {
      if (separates(a.col(i).cross(b.col(j)))) return false;
    }
  }
  return true;
}

void expect_clear(const RobotModel& robot, const std::vector<double>& posture) {
  ForwardKinematics kinematics(robot);
  kinematics.compute(posture);
  const auto parent_of = [&robot](int link) {
    const int joint = robot.links[static_cast<std::size_t>(link)].parent_joint;
    return joint < 0 ? -1 : robot.joints[static_cast<std::size_t>(joint)].parent_link;
  };
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(robot.links.size()); ++j) {
      if (parent_of(j) == i) continue;
      const Link& first = robot.links[static_cast<std::size_t>(i)];
      const Link& second = robot.links[static_cast<std::size_t>(j)];
      for (const Shape& box : first.collision) {
        for (const Shape& other : second.collision) {
          EXPECT_FALSE(overlap(kinematics.link_pose(i) * box.pose, box.size_m,
                               kinematics.link_pose(j) * other.pose, other.size_m))
              << first.name << " touches " << second.name;
        }
      }
    }
  }
}

RobotModel shipped_robot() {
  return load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
}

// Hips this high, feet below them, everything else at home.
std::vector<double> squat(const RobotModel& robot, double hip_height_m) {
  std::vector<double> posture;
  for (const Joint& joint : robot.joints) {
    posture.push_back(joint.home_rad);
  }
  const double half_knee_rad = std::acos((hip_height_m - 0.04) / 0.34);
  for (const Leg& leg : robot.legs) {
    posture[static_cast<std::size_t>(leg.joints[2])] = -half_knee_rad;
    posture[static_cast<std::size_t>(leg.joints[3])] = 2.0 * half_knee_rad;
    posture[static_cast<std::size_t>(leg.joints[4])] = -half_knee_rad;
  }
  return posture;
}

TEST(SelfCollision, LimbsAreClearWithAllJointsAtZero) {
  const RobotModel robot = shipped_robot();
  expect_clear(robot, std::vector<double>(robot.joints.size(), 0.0));
}

TEST(SelfCollision, LimbsAreClearFromStandingToADeepSquat) {
  const RobotModel robot = shipped_robot();
  for (const double hip_height_m : {0.375, 0.36, 0.345, 0.30, 0.25, 0.20}) {
    SCOPED_TRACE(hip_height_m);
    expect_clear(robot, squat(robot, hip_height_m));
  }
}

TEST(SelfCollision, LegsAreClearWhenSwayingAndTurning) {
  const RobotModel robot = shipped_robot();
  for (const double roll_rad : {-0.2, 0.2}) {
    for (const double yaw_rad : {0.0, 0.1}) {
      std::vector<double> posture = squat(robot, 0.36);
      for (std::size_t side = 0; side < 2; ++side) {
        const auto& joints = robot.legs[side].joints;
        posture[static_cast<std::size_t>(joints[0])] = side == 0 ? yaw_rad : -yaw_rad;
        posture[static_cast<std::size_t>(joints[1])] = roll_rad;
        posture[static_cast<std::size_t>(joints[5])] = -roll_rad;
      }
      expect_clear(robot, posture);
    }
  }
}

TEST(SelfCollision, TheTestSeesAnArmInTheTrunk) {
  RobotModel robot = shipped_robot();
  robot.links[static_cast<std::size_t>(robot.link_index("left_forearm"))].collision[0].size_m.setConstant(
      0.4);
  const auto check = [&robot] { expect_clear(robot, squat(robot, 0.36)); };
  testing::TestPartResultArray failures;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &failures);
    check();
  }
  EXPECT_GT(failures.size(), 0);
}

}  // namespace
}  // namespace gaitway::urdf
