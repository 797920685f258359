// RobotModel and joint angles -> tf2_msgs/TFMessage.
#include <algorithm>
#include <utility>

#include "gaitway/api/frame_messages.hpp"
#include "gaitway/api/frame_names.hpp"
#include "gaitway/api/ros_time.hpp"

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

}  // namespace

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
    message_.transforms.push_back(between(link(foot.link).name, kSoleFrames[side]));
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

}  // namespace gaitway::api
