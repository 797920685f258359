// odom <- level frame of the support foot <- base.
#include "gaitway/api/robot_frames.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::api {
namespace {

constexpr double kVelocityFilter_s = 0.030;
constexpr double kYawJump_rad = 0.3;  // in one slot: the estimator began anew, the robot has not turned
constexpr std::int64_t kLongestGap_ns = 50'000'000;  // beyond it a difference of poses is no velocity

Eigen::Matrix3d about_z(double angle_rad) noexcept {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

double heading(const Eigen::Matrix3d& rotation) noexcept {
  return std::atan2(rotation(1, 0), rotation(0, 0));
}

Eigen::Isometry3d pose(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& position_m) noexcept {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = rotation;
  result.translation() = position_m;
  return result;
}

// Where the robot's own odometry has the foot; nothing: it has none, and both feet at one place.
std::optional<Eigen::Isometry3d> told_place(const Estimate& estimate, std::size_t side) noexcept {
  const auto& feet = estimate.odometry_foot;
  if (std::ranges::equal(feet[0], feet[1])) {
    return std::nullopt;
  }
  return pose(about_z(feet[side][2]), Eigen::Vector3d(feet[side][0], feet[side][1], 0.0));
}

// The support foot's place when nobody knows it: the middle of the feet is the origin.
Eigen::Isometry3d standing(const Eigen::Isometry3d& support_from_other) noexcept {
  const Eigen::Vector3d middle_m = 0.5 * support_from_other.translation();
  const Eigen::Matrix3d turn = about_z(-0.5 * heading(support_from_other.linear()));
  return pose(turn, -(turn * Eigen::Vector3d(middle_m.x(), middle_m.y(), 0.0)));
}

}  // namespace

RobotFrames::RobotFrames(const urdf::RobotModel& model) : kinematics_(model), trunk_(model.imu.link) {
  level_from_base_.fill(Eigen::Isometry3d::Identity());
  for (int link = trunk_; model.links[static_cast<std::size_t>(link)].parent_joint >= 0;) {
    const auto joint = static_cast<std::size_t>(model.links[static_cast<std::size_t>(link)].parent_joint);
    waist_.push_back({joint, link, model.joints[joint].axis});
    link = model.joints[joint].parent_link;
  }
}

void RobotFrames::reset() noexcept {
  support_.reset();
  instant_ns_ = 0;
  velocity_m_per_s_.setZero();
  odom_from_plan_.setIdentity();
}

void RobotFrames::update(std::int64_t instant_ns, std::span<const double> position_rad,
                         std::span<const double> velocity_rad_per_s, const Estimate& estimate,
                         const PlannedState* planned) noexcept {
  const std::array<Eigen::Isometry3d, 2> last = level_from_base_;
  const std::size_t side = estimate.support == 0 ? 0 : 1;
  kinematics_.compute(position_rad);
  update_levels(estimate);
  place_support(side, estimate);
  odom_from_base_ = odom_from_support_ * level_from_base_[side];
  if (planned != nullptr && planned->on_ground[side] != 0) {
    const Eigen::Vector3d place_m(planned->foot_position[side]);
    odom_from_plan_ = odom_from_support_ * pose(about_z(planned->foot_yaw[side]), place_m).inverse();
  }
  update_velocity(instant_ns, side, last);
  update_turn(velocity_rad_per_s, estimate);
  support_ = side;
  instant_ns_ = instant_ns;
  gyro_yaw_rad_ = estimate.attitude[2];
}

void RobotFrames::update_levels(const Estimate& estimate) noexcept {
  const Eigen::Matrix3d tilt = (Eigen::AngleAxisd(estimate.attitude[1], Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(estimate.attitude[0], Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Eigen::Matrix3d upright_from_base = tilt * kinematics_.link_rotation(trunk_).transpose();
  for (const urdf::Side side : urdf::kSides) {
    const auto i = static_cast<std::size_t>(side);
    const Eigen::Isometry3d sole = kinematics_.sole_pose(side);
    sole_heading_rad_[i] = heading(upright_from_base * sole.linear());
    const Eigen::Matrix3d turn = about_z(-sole_heading_rad_[i]) * upright_from_base;
    level_from_base_[i] = pose(turn, -(turn * sole.translation()));
  }
}

void RobotFrames::place_support(std::size_t side, const Estimate& estimate) noexcept {
  if (!support_) {
    odom_from_support_ =
        told_place(estimate, side)
            .value_or(standing(level_from_base_[side] * level_from_base_[1 - side].inverse()));
    trunk_heading_rad_ = heading(odom_from_support_.linear()) - sole_heading_rad_[side];
    return;
  }
  const double turned_rad = estimate.attitude[2] - gyro_yaw_rad_;
  if (std::abs(turned_rad) < kYawJump_rad) {
    trunk_heading_rad_ += turned_rad;
  } else {
    trunk_heading_rad_ = heading(odom_from_support_.linear()) - sole_heading_rad_[*support_];
  }
  Eigen::Vector3d place_m = odom_from_support_.translation();
  if (*support_ != side) {
    const Eigen::Vector3d other_m =
        (level_from_base_[*support_] * level_from_base_[side].inverse()).translation();
    place_m += about_z(trunk_heading_rad_ + sole_heading_rad_[*support_]) * other_m;
    place_m.z() = 0.0;
  }
  odom_from_support_ = pose(about_z(trunk_heading_rad_ + sole_heading_rad_[side]), place_m);
}

void RobotFrames::update_velocity(std::int64_t instant_ns, std::size_t side,
                                  const std::array<Eigen::Isometry3d, 2>& last) noexcept {
  const std::int64_t gap_ns = instant_ns - instant_ns_;
  if (!support_ || gap_ns <= 0 || gap_ns > kLongestGap_ns) {
    velocity_m_per_s_.setZero();
    return;
  }
  const double dt_s = static_cast<double>(gap_ns) * 1e-9;
  const Eigen::Vector3d way_m = level_from_base_[side].translation() - last[side].translation();
  const Eigen::Vector3d velocity = level_from_base_[side].linear().transpose() * way_m / dt_s;
  velocity_m_per_s_ += dt_s / (kVelocityFilter_s + dt_s) * (velocity - velocity_m_per_s_);
}

void RobotFrames::update_turn(std::span<const double> velocity_rad_per_s, const Estimate& estimate) noexcept {
  const Eigen::Map<const Eigen::Vector3d> trunk_rad_per_s(estimate.angular_velocity);
  turn_rad_per_s_ = kinematics_.link_rotation(trunk_) * trunk_rad_per_s;
  for (const WaistJoint& waist : waist_) {
    turn_rad_per_s_ -=
        velocity_rad_per_s[waist.joint] * (kinematics_.link_rotation(waist.child_link) * waist.axis);
  }
}

}  // namespace gaitway::api
