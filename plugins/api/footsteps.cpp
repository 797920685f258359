// MotionPlan -> geometry_msgs/PoseArray.
#include <algorithm>

#include "gaitway/api/frame_messages.hpp"
#include "gaitway/api/frame_names.hpp"
#include "gaitway/api/ros_time.hpp"

namespace gaitway::api {
namespace {

ros::Pose pose_of(const Eigen::Vector3d& step, const Eigen::Isometry3d& odom_from_plan) noexcept {
  const Eigen::Vector3d place = odom_from_plan * Eigen::Vector3d(step.x(), step.y(), 0.0);
  const Eigen::Quaterniond turn(odom_from_plan.linear() *
                                Eigen::AngleAxisd(step.z(), Eigen::Vector3d::UnitZ()).toRotationMatrix());
  return {{place.x(), place.y(), place.z()}, {turn.x(), turn.y(), turn.z(), turn.w()}};
}

}  // namespace

Footsteps::Footsteps() {
  message_.header.frame_id = kOdomFrame;
}

bool Footsteps::update(const MotionPlan* plan, std::int64_t instant_ns,
                       const Eigen::Isometry3d& odom_from_plan) {
  const std::size_t count = plan != nullptr ? std::min<std::size_t>(plan->footstep_count, kMaxFootsteps) : 0;
  bool changed = false;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (plan->footstep_landing_ns[i] <= instant_ns) continue;
    const Eigen::Vector3d step(plan->footstep[i][0], plan->footstep[i][1], plan->footstep[i][2]);
    if (kept == steps_.size()) steps_.emplace_back(step + Eigen::Vector3d::Ones());
    changed = changed || steps_[kept] != step;
    steps_[kept] = step;
    ++kept;
  }
  changed = changed || kept != steps_.size();
  steps_.resize(kept);
  if (!changed) return false;
  message_.header.stamp = ros_time(instant_ns);
  message_.poses.clear();
  for (const Eigen::Vector3d& step : steps_) message_.poses.push_back(pose_of(step, odom_from_plan));
  return true;
}

}  // namespace gaitway::api
