// Remembers the newest of each, and when it came.
#include "gaitway/api/view_source.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::api {
namespace {

double age_s(std::int64_t came_ns, std::int64_t wall_ns) {
  return came_ns == INT64_MIN ? page::kUnknown : static_cast<double>(wall_ns - came_ns) * 1e-9;
}

double yaw_of(const ros::Quaternion& turn) {
  return std::atan2(2.0 * (turn.w * turn.z + turn.x * turn.y),
                    1.0 - 2.0 * (turn.y * turn.y + turn.z * turn.z));
}

}  // namespace

ViewSource::ViewSource(msgclient::Client& client, const urdf::RobotModel& robot)
    : joint_count_(std::min(robot.joints.size(), page::kViewJoints)),
      network_(client.read<NetworkState>("network_state")),
      health_(client.read<NetworkHealth>("network_health")),
      estimate_(client.read<Estimate>("estimate")),
      motion_(client.read<MotionState>("motion_state")) {}

bool ViewSource::wants(Topic topic) noexcept {
  switch (topic) {
    case Topic::joint_states:
    case Topic::odometry:
    case Topic::com:
    case Topic::zmp:
    case Topic::reference_zmp:
    case Topic::footsteps:
      return true;
    default:
      return false;
  }
}

void ViewSource::note(Topic, const ros::JointState& message, std::int64_t wall_ns) {
  std::copy_n(message.position.begin(), std::min(joint_count_, message.position.size()), joints_rad_.begin());
  joints_ns_ = wall_ns;
}

void ViewSource::note(Topic, const ros::Odometry& message, std::int64_t wall_ns) {
  odometry_.pose = message.pose;
  odometry_.twist = message.twist;
  pose_ns_ = wall_ns;
}

void ViewSource::note(Topic topic, const ros::PointStamped& message, std::int64_t wall_ns) {
  if (topic == Topic::reference_zmp) {
    planned_zmp_ = message.point;
    plan_ns_ = wall_ns;
  } else if (topic == Topic::zmp) {
    zmp_ = message.point;
  } else {
    com_ = message.point;
    com_ns_ = wall_ns;
  }
}

void ViewSource::note(Topic, const ros::PoseArray& message, std::int64_t) {
  footsteps_.assign(message.poses.begin(),
                    message.poses.begin() +
                        static_cast<std::ptrdiff_t>(std::min(message.poses.size(), page::kViewFootsteps)));
}

page::ViewState ViewSource::state(std::int64_t robot_ns, std::int64_t beat_age_ns, std::string_view commander,
                                  std::int64_t wall_ns) {
  page::ViewState state;
  state.robot_time_s = static_cast<double>(robot_ns) * 1e-9;
  state.commander = commander;
  add_controller(state, wall_ns);
  state.age_s = {age_s(joints_ns_, wall_ns), age_s(pose_ns_, wall_ns), age_s(network_ns_, wall_ns),
                 age_s(plan_ns_, wall_ns),
                 robot_ns == 0 ? page::kUnknown : static_cast<double>(beat_age_ns) * 1e-9};
  if (joints_ns_ != kNever) {
    state.joint_count = joint_count_;
    state.joints_rad = joints_rad_;
  }
  if (pose_ns_ != kNever) {
    add_places(state);
  }
  add_estimate(state);
  return state;
}

void ViewSource::add_controller(page::ViewState& state, std::int64_t wall_ns) {
  NetworkState network;
  if (const auto read = network_.read(network)) {
    if (read.sequence != network_sequence_) {
      network_sequence_ = read.sequence;
      network_ns_ = wall_ns;
    }
    state.mode = static_cast<double>(network.mode);
    state.batches_late = network.late;
    state.batches_refused = network.refused;
    state.tails_played = network.tail_played;
  }
  NetworkHealth health;
  if (health_.read(health)) {
    for (std::size_t joint = 0; joint < joint_count_; ++joint) {
      state.joint_trouble[joint] = (health.missing >> joint & 1U) != 0 || health.faults[joint] != 0;
    }
  }
}

void ViewSource::add_estimate(page::ViewState& state) {
  Estimate estimate;
  if (!estimate_.read(estimate)) {
    return;
  }
  for (std::size_t side = 0; side < state.contact.size(); ++side) {
    state.contact[side] = static_cast<double>(estimate.contact[side]);
    state.foot_force_N[side] = estimate.foot_force[side];
  }
  MotionState motion;
  const bool moves = motion_.read(motion) && motion.state != 0;
  if (estimate.fall == estimate::fall::lies) {
    state.activity = page::Activity::lies;
  } else if (estimate.fall == estimate::fall::falls) {
    state.activity = page::Activity::falls;
  } else if (moves) {
    state.activity = page::Activity::moves;
  } else {
    state.activity = footsteps_.empty() ? page::Activity::stands : page::Activity::walks;
  }
}

void ViewSource::add_places(page::ViewState& state) const {
  const ros::Pose& base = odometry_.pose.pose;
  const ros::Twist& twist = odometry_.twist.twist;
  state.base_place_m = {base.position.x, base.position.y};
  state.base_height_m = base.position.z;
  state.base_turn = {base.orientation.x, base.orientation.y, base.orientation.z, base.orientation.w};
  state.velocity = {twist.linear.x, twist.linear.y, twist.angular.z};
  if (com_ns_ != kNever) {
    state.com_m = {com_.x - base.position.x, com_.y - base.position.y, com_.z};
    state.zmp_m = {zmp_.x - base.position.x, zmp_.y - base.position.y};
  }
  if (plan_ns_ != kNever) {
    state.planned_zmp_m = {planned_zmp_.x - base.position.x, planned_zmp_.y - base.position.y};
  }
  state.footstep_count = footsteps_.size();
  for (std::size_t step = 0; step < footsteps_.size(); ++step) {
    const ros::Pose& pose = footsteps_[step];
    state.footsteps[step] = {pose.position.x - base.position.x, pose.position.y - base.position.y,
                             yaw_of(pose.orientation)};
  }
}

}  // namespace gaitway::api
