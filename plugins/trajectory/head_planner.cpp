// Goals by mode, and one step of the way a point.
#include "gaitway/trajectory/head_planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::trajectory {
namespace {

// Of humanoid22; other robots' by their size. A head of 0.3 kg that is turned so moves the CoM by less than
// what balance feedback sees.
constexpr double kUsualLook_rad_per_s = 2.0;
constexpr double kAcceleration_rad_per_s2 = 12.0;
constexpr double kUsualScan_s = 4.0, kShortestScan_s = 0.1;
constexpr double kNeckSpeedShare = 0.8;  // of the joint's limit, so that no batch is refused for its head
constexpr double kNeckMargin_rad = 0.02;
// It brakes with less than its acceleration: below 1/1.125 of it, what is left keeps the last step, which
// ends at the goal, from passing it.
constexpr double kBrakingShare = 0.85;

}  // namespace

HeadPlanner::HeadPlanner(const urdf::RobotModel& robot) {
  command_.stamp_ns = -1;
  const urdf::ForwardKinematics home(robot);
  neck_ = urdf::neck_of(robot, home);
  const auto hip = [&](urdf::Side side) {
    const int joint = robot.legs[urdf::index_of(side)].joints[0];
    return home.link_position_m(robot.joints[static_cast<std::size_t>(joint)].child_link).z();
  };
  hip_above_base_m_ = 0.5 * (hip(urdf::Side::left) + hip(urdf::Side::right));
  const facts::BodyScale size = robot.body_scale();
  acceleration_rad_per_s2_ = kAcceleration_rad_per_s2 * size.factor("rad/s") / size.factor("s");
  usual_scan_s_ = kUsualScan_s * size.factor("s");
  const auto axis_of = [&](const std::optional<urdf::NeckJoint>& joint) -> Axis {
    if (!joint) return {};
    return {true, std::min(joint->lowest_rad + kNeckMargin_rad, 0.0),
            std::max(joint->highest_rad - kNeckMargin_rad, 0.0), kNeckSpeedShare * joint->most_rad_per_s};
  };
  axes_ = {axis_of(neck_.yaw), axis_of(neck_.pitch)};
}

void HeadPlanner::obey(const HeadCommand& command) noexcept {
  if (command.stamp_ns == command_.stamp_ns) return;
  command_ = command;
  scan_time_s_ = 0.0;
  if (command.mode != head_command::mode::hold) return;
  command_.mode = head_command::mode::direction;
  std::ranges::copy(rest_rad(angle_rad_, speed_rad_per_s_), command_.direction);
}

void HeadPlanner::begin_after_tail() noexcept {
  angle_rad_ = rest_rad_;
  speed_rad_per_s_ = {};
}

void HeadPlanner::leave_to_others(MotionPlan& plan) noexcept {
  angle_rad_ = speed_rad_per_s_ = rest_rad_ = {};
  for (auto& point : plan.head) std::ranges::fill(point, 0.0);
}

void HeadPlanner::plan(bool allowed, const Estimate* estimate, MotionPlan& plan) noexcept {
  Angles angle = angle_rad_, speed = speed_rad_per_s_;
  for (int point = 0; point < kBatchPoints; ++point) {
    scan_time_s_ += facts::kSlot_s;
    approach(goal_rad(allowed, estimate, plan.hip_height[point], scan_time_s_), angle, speed);
    std::ranges::copy(angle, plan.head[point]);
  }
  angle_rad_ = angle;
  speed_rad_per_s_ = speed;
  // In the tail it comes to rest where its speed lets it.
  const Angles rest = rest_rad(angle, speed);
  for (std::size_t point = kBatchPoints; point < kBatchPoints + plan.tail_count; ++point) {
    approach(rest, angle, speed);
    std::ranges::copy(angle, plan.head[point]);
  }
  rest_rad_ = angle;
}

HeadPlanner::Angles HeadPlanner::rest_rad(const Angles& angle_rad,
                                          const Angles& speed_rad_per_s) const noexcept {
  Angles rest = angle_rad;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double speed = std::abs(speed_rad_per_s[i]);
    const double way =
        speed * speed / (2.0 * kBrakingShare * acceleration_rad_per_s2_) - 0.5 * speed * facts::kSlot_s;
    rest[i] += std::copysign(std::max(way, 0.0), speed_rad_per_s[i]);
  }
  return rest;
}

HeadPlanner::Angles HeadPlanner::goal_rad(bool allowed, const Estimate* estimate, double hip_height_m,
                                          double scan_time_s) const noexcept {
  namespace modes = head_command::mode;
  if (!allowed || command_.mode == modes::ahead) return {};
  switch (command_.mode) {
    case modes::direction:
      return {command_.direction[0], command_.direction[1]};
    case modes::scan: {
      const double period_s =
          command_.period > 0.0 ? std::max(command_.period, kShortestScan_s) : usual_scan_s_;
      const double aside = std::sin(2.0 * std::numbers::pi * scan_time_s / period_s);
      return {command_.direction[0] + command_.extent * aside, command_.direction[1]};
    }
    case modes::point:
      return estimate != nullptr ? towards_rad(*estimate, hip_height_m) : angle_rad_;
    default:
      return angle_rad_;
  }
}

// The trunk is upright; the base's heading is that of the estimate.
HeadPlanner::Angles HeadPlanner::towards_rad(const Estimate& estimate, double hip_height_m) const noexcept {
  const double yaw_rad = estimate.odometry_base[2];
  const double x_m = command_.point[0] - estimate.odometry_base[0];
  const double y_m = command_.point[1] - estimate.odometry_base[1];
  const double neck_height_m = hip_height_m - hip_above_base_m_ + neck_.position_m.z();
  const Eigen::Vector3d to(std::cos(yaw_rad) * x_m + std::sin(yaw_rad) * y_m - neck_.position_m.x(),
                           -std::sin(yaw_rad) * x_m + std::cos(yaw_rad) * y_m - neck_.position_m.y(),
                           command_.point[2] - neck_height_m);
  if (!to.allFinite() || to.norm() < 1e-3) return angle_rad_;
  return {std::atan2(to.y(), to.x()), -std::atan2(to.z(), to.head<2>().norm())};
}

void HeadPlanner::approach(const Angles& goal_rad, Angles& angle_rad,
                           Angles& speed_rad_per_s) const noexcept {
  constexpr double dt = facts::kSlot_s;
  const double most_change = acceleration_rad_per_s2_ * dt;
  for (std::size_t i = 0; i < 2; ++i) {
    const Axis& axis = axes_[i];
    if (!axis.exists) {
      angle_rad[i] = speed_rad_per_s[i] = 0.0;
      continue;
    }
    const double usual = std::min(kUsualLook_rad_per_s, axis.most_rad_per_s);
    const double most = command_.speed > 0.0 ? std::min(command_.speed, axis.most_rad_per_s) : usual;
    const double way = std::clamp(goal_rad[i], axis.lowest_rad, axis.highest_rad) - angle_rad[i];
    // The largest speed from which it stops in steps of dt without passing the goal.
    const double braking = kBrakingShare * acceleration_rad_per_s2_, half = 0.5 * braking * dt;
    const double stopping = std::sqrt(half * half + 2.0 * braking * std::abs(way)) - half;
    const double within_a_point = std::abs(way) / dt;
    const double wanted = std::copysign(std::min({most, stopping, within_a_point}), way);
    speed_rad_per_s[i] =
        std::clamp(wanted, speed_rad_per_s[i] - most_change, speed_rad_per_s[i] + most_change);
    angle_rad[i] += speed_rad_per_s[i] * dt;
  }
}

}  // namespace gaitway::trajectory
