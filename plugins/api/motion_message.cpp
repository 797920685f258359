// MotionState -> gaitway_msgs/MotionState.
#include "gaitway/api/motion_message.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "gaitway/api/fixed_text.hpp"
#include "gaitway/api/ros_time.hpp"

namespace gaitway::api {
namespace {

constexpr std::array<std::string_view, 5> kStates{"none", "approaching", "playing", "leaving", "unknown"};
constexpr std::array<std::string_view, 5> kResults{"none", "finished", "left", "broken off", "unknown"};

std::string name_in(const std::array<std::string_view, 5>& names, std::uint32_t value) {
  return std::string(names[std::min<std::size_t>(value, names.size() - 1)]);
}

}  // namespace

ros::MotionState motion_state_of(const gaitway::MotionState& motion) {
  ros::MotionState message;
  message.header.stamp = ros_time(motion.stamp_ns);
  message.motion = text_of(motion.name);
  message.state = name_in(kStates, motion.state);
  message.time = motion.time;
  message.duration = motion.duration;
  message.ended = motion.ended;
  message.result = name_in(kResults, motion.result);
  return message;
}

}  // namespace gaitway::api
