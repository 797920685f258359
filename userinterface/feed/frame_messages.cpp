// Frames, poses and plans -> ROS messages.
#include "gaitway/api/frame_messages.hpp"

#include <algorithm>

namespace gaitway::api {
namespace {

void set(ros::Transform& transform, const Eigen::Vector3d& place_m, const Eigen::Quaterniond& turn) noexcept {
  transform.translation = {place_m.x(), place_m.y(), place_m.z()};
  transform.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
}

ros::TransformStamped between(std::string_view parent, std::string_view child) {
  ros::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  return transform;
}

ros::Pose pose_of(const Eigen::Vector3d& step, const Eigen::Isometry3d& odom_from_plan) noexcept {
  const Eigen::Vector3d place = odom_from_plan * Eigen::Vector3d(step.x(), step.y(), 0.0);
  const Eigen::Quaterniond turn(odom_from_plan.linear() *
                                Eigen::AngleAxisd(step.z(), Eigen::Vector3d::UnitZ()).toRotationMatrix());
  return {{place.x(), place.y(), place.z()}, {turn.x(), turn.y(), turn.z(), turn.w()}};
}

}  // namespace

ros::Odometry make_odometry(const urdf::RobotModel& model) {
  ros::Odometry message;
  message.header.frame_id = kOdomFrame;
  message.child_frame_id = model.links.front().name;
  return message;
}

void fill(ros::Odometry& message, const RobotFrames& frames, std::int64_t stamp_ns) noexcept {
  const Eigen::Vector3d& place = frames.odom_from_base().translation();
  const Eigen::Quaterniond turn(frames.odom_from_base().linear());
  const Eigen::Vector3d& linear = frames.linear_velocity_m_per_s();
  const Eigen::Vector3d& angular = frames.angular_velocity_rad_per_s();
  message.header.stamp = ros_time(stamp_ns);
  message.pose.pose.position = {place.x(), place.y(), place.z()};
  message.pose.pose.orientation = {turn.x(), turn.y(), turn.z(), turn.w()};
  message.twist.twist.linear = {linear.x(), linear.y(), linear.z()};
  message.twist.twist.angular = {angular.x(), angular.y(), angular.z()};
}

std::string sole_frame(const urdf::RobotModel& model, urdf::Side side) {
  std::string name(kSoleFrames[urdf::index_of(side)]);
  while (std::ranges::find(model.links, name, &urdf::Link::name) != model.links.end()) name += "_frame";
  return name;
}

LinkTransforms::LinkTransforms(const urdf::RobotModel& model)
    : base_(between(kOdomFrame, model.links.front().name)) {
  const auto link = [&](int index) -> const urdf::Link& {
    return model.links[static_cast<std::size_t>(index)];
  };
  for (const urdf::Joint& joint : model.joints) {
    joints_.push_back({joint.origin.translation(), Eigen::Quaterniond(joint.origin.linear()), joint.axis});
    message_.transforms.push_back(between(link(joint.parent_link).name, link(joint.child_link).name));
    set(message_.transforms.back().transform, joints_.back().place_m, joints_.back().turn);
  }
  for (std::size_t side = 0; side < kSoleFrames.size(); ++side) {
    const urdf::Foot& foot = model.feet[side];
    message_.transforms.push_back(between(link(foot.link).name, sole_frame(model, urdf::kSides[side])));
    set(message_.transforms.back().transform, foot.sole.translation(),
        Eigen::Quaterniond(foot.sole.linear()));
  }
}

void LinkTransforms::fill(std::span<const double> position_rad, const Eigen::Isometry3d* odom_from_base,
                          std::int64_t stamp_ns) {
  const std::size_t without_base = joints_.size() + kSoleFrames.size();
  if (odom_from_base == nullptr) {
    message_.transforms.resize(without_base);
  } else {
    if (message_.transforms.size() == without_base) message_.transforms.push_back(base_);
    set(message_.transforms.back().transform, odom_from_base->translation(),
        Eigen::Quaterniond(odom_from_base->linear()));
  }
  for (std::size_t i = 0; i < std::min(joints_.size(), position_rad.size()); ++i) {
    const JointFrame& joint = joints_[i];
    const Eigen::Quaterniond turn = joint.turn * Eigen::AngleAxisd(position_rad[i], joint.axis);
    message_.transforms[i].transform.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
  }
  const ros::Time stamp = ros_time(stamp_ns);
  for (ros::TransformStamped& transform : message_.transforms) transform.header.stamp = stamp;
}

ros::PointStamped make_ground_point() {
  ros::PointStamped message;
  message.header.frame_id = kOdomFrame;
  return message;
}

void fill(ros::PointStamped& message, const Eigen::Isometry3d& odom_from_frame,
          const Eigen::Vector3d& point_m, std::int64_t stamp_ns) noexcept {
  const Eigen::Vector3d place = odom_from_frame * point_m;
  message.header.stamp = ros_time(stamp_ns);
  message.point = {place.x(), place.y(), place.z()};
}

Footsteps::Footsteps() {
  message_.header.frame_id = kOdomFrame;
}

bool Footsteps::update(const PlannedState& planned, const Eigen::Isometry3d& odom_from_plan) {
  const std::size_t count = std::min<std::size_t>(planned.footstep_count, kMaxFootsteps);
  bool changed = count != steps_.size();
  steps_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d step(planned.footstep[i]);
    changed = changed || steps_[i] != step;
    steps_[i] = step;
  }
  if (!changed) return false;
  message_.header.stamp = ros_time(planned.stamp_ns);
  message_.poses.clear();
  for (const Eigen::Vector3d& step : steps_) message_.poses.push_back(pose_of(step, odom_from_plan));
  return true;
}

}  // namespace gaitway::api
