// Numbers, and the topics' arrays.
#include "gaitway/navigation/way.hpp"

#include <algorithm>
#include <cstddef>

namespace gaitway::navigation {

void Way::go_on(std::uint32_t after, std::span<const planning::Footstep> steps) {
  if (find(after) == nullptr) {
    steps_.clear();
    first_ = after + 1;
  } else {
    steps_.resize(after - first_ + 1);
  }
  steps_.insert(steps_.end(), steps.begin(), steps.end());
}

const planning::Footstep* Way::find(std::uint32_t number) const noexcept {
  const bool there = number >= first_ && number - first_ < steps_.size();
  return there ? &steps_[number - first_] : nullptr;
}

std::span<const planning::Footstep> Way::from(std::uint32_t number) const noexcept {
  const std::size_t gone = number > first_ ? std::min<std::size_t>(number - first_, steps_.size()) : 0;
  return std::span(steps_).subspan(gone);
}

void Way::tell(std::uint32_t number, const planning::Pose& odometry, FootstepPlan& to) const noexcept {
  const std::span<const planning::Footstep> rest = from(number);
  const std::span<const planning::Footstep> told =
      rest.first(std::min<std::size_t>(rest.size(), kMaxPlannedSteps));
  to.first = std::max(number, first_);
  to.step_count = static_cast<std::uint32_t>(told.size());
  to.ends = told.size() == rest.size() ? 1 : 0;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const planning::Pose pose = odometry.relative_of(told[i].pose);
    to.side[i] = static_cast<std::uint32_t>(told[i].side);
    to.step[i][0] = pose.x_m;
    to.step[i][1] = pose.y_m;
    to.step[i][2] = pose.yaw_rad;
  }
}

void Way::tell_rest(std::uint32_t landed, NavigationWay& to) const noexcept {
  const std::span<const planning::Footstep> rest = from(landed + 1);
  to.first = std::max(landed + 1, first_);
  to.step_count = static_cast<std::uint32_t>(std::min<std::size_t>(rest.size(), kMaxWaySteps));
  for (std::size_t i = 0; i < to.step_count; ++i) {
    to.side[i] = static_cast<std::uint8_t>(rest[i].side);
    to.step[i][0] = static_cast<float>(rest[i].pose.x_m);
    to.step[i][1] = static_cast<float>(rest[i].pose.y_m);
    to.step[i][2] = static_cast<float>(rest[i].pose.yaw_rad);
  }
}

double Way::distance_left_m(std::uint32_t landed, const planning::Pose& from_pose) const noexcept {
  const std::span<const planning::Footstep> rest = from(landed + 1);
  double way_m = 0.0;
  planning::Pose before = from_pose;
  for (std::size_t i = 1; i < rest.size(); ++i) {
    const planning::Pose middle = planning::middle_of(rest[i - 1].pose, rest[i].pose);
    way_m += planning::way_m(before, middle);
    before = middle;
  }
  return way_m;
}

}  // namespace gaitway::navigation
