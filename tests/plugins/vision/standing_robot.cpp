// The home posture, moved over the ground as a whole.
#include "standing_robot.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace gaitway::vision::testing {
namespace {

std::vector<double> posture(const urdf::RobotModel& model, double head_pitch_rad) {
  std::vector<double> position_rad;
  for (const urdf::Joint& joint : model.joints) position_rad.push_back(joint.home_rad);
  position_rad[static_cast<std::size_t>(model.joint_index("neck_pitch"))] = head_pitch_rad;
  return position_rad;
}

}  // namespace

StandingRobot::StandingRobot(Pictures pictures)
    : model_(urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22", urdf::CalibrationUse::left_out)),
      camera_(urdf::stereo_camera_of(model_).value()) {
  if (pictures == Pictures::small) return;
  camera_.width_px *= 2;
  camera_.height_px *= 2;
  for (urdf::LensParameters& lens : camera_.lens) {
    lens.fx_px *= 2.0;
    lens.fy_px *= 2.0;
    lens.cx_px = 2.0 * (lens.cx_px + 0.5) - 0.5;
    lens.cy_px = 2.0 * (lens.cy_px + 0.5) - 0.5;
  }
}

Eigen::Isometry3d StandingRobot::ground_pose(std::int64_t now_ns) const {
  const double t = 1e-9 * static_cast<double>(now_ns);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(speed.z() * t, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(
      speed.x() * t, speed.y() * t + sway_m * std::sin(2.0 * std::numbers::pi * sway_Hz * t), 0.0);
  return pose;
}

JointStates StandingRobot::joints(std::int64_t now_ns) const {
  JointStates joints{};
  joints.stamp_ns = now_ns + 3'000'000;  // its frames come some milliseconds after the edge
  const std::vector<double> position_rad = posture(model_, head_pitch_rad);
  joints.joint_count = static_cast<std::uint32_t>(position_rad.size());
  std::copy(position_rad.begin(), position_rad.end(), joints.position);
  return joints;
}

Estimate StandingRobot::estimate(std::int64_t now_ns) const {
  urdf::ForwardKinematics kinematics(model_);
  kinematics.compute(posture(model_, head_pitch_rad));
  const Eigen::Isometry3d left = kinematics.sole_pose(urdf::Side::left),
                          right = kinematics.sole_pose(urdf::Side::right);
  const Eigen::Vector3d middle_m = 0.5 * (left.translation() + right.translation());
  const Eigen::Isometry3d ground = ground_pose(now_ns);
  const double yaw_rad = speed.z() * 1e-9 * static_cast<double>(now_ns);
  Estimate estimate{};
  estimate.stamp_ns = now_ns + 3'000'000;
  const auto write = [&](const Eigen::Vector3d& in_base_m, double(&pose)[3]) {
    const Eigen::Vector3d at = ground * (in_base_m - middle_m);
    pose[0] = at.x();
    pose[1] = at.y();
    pose[2] = yaw_rad;
  };
  write(left.translation(), estimate.odometry_foot[0]);
  write(right.translation(), estimate.odometry_foot[1]);
  write(Eigen::Vector3d::Zero(), estimate.odometry_base);
  estimate.attitude[2] = yaw_rad;
  estimate.fall = fallen ? estimate::fall::lies : estimate::fall::upright;
  return estimate;
}

Eigen::Isometry3d StandingRobot::camera_pose(std::int64_t now_ns) const {
  urdf::ForwardKinematics kinematics(model_);
  kinematics.compute(posture(model_, head_pitch_rad));
  const Eigen::Vector3d middle_m = 0.5 * (kinematics.sole_pose(urdf::Side::left).translation() +
                                          kinematics.sole_pose(urdf::Side::right).translation());
  return ground_pose(now_ns) * Eigen::Translation3d(-middle_m) *
         kinematics.link_pose(model_.link_index(camera_.link)) * camera_.left_in_link;
}

}  // namespace gaitway::vision::testing
