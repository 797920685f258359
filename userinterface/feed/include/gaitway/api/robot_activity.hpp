// What the robot does, in a word, out of what its parts publish.
#pragma once

#include <cstdint>
#include <string_view>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::api {

enum class Activity : std::uint8_t { stands, walks, plays, stops, stopped, falls, fallen, gone };

// Null: nothing is known of it.
struct ActivityEvidence {
  const NetworkState* network = nullptr;
  const Estimate* estimate = nullptr;
  const PlannedState* planned = nullptr;
  const gaitway::MotionState* motion = nullptr;
  std::int64_t heartbeat_age_ns = 0;
};

[[nodiscard]] Activity activity_of(const ActivityEvidence& evidence) noexcept;
[[nodiscard]] std::string_view word_of(Activity activity) noexcept;
[[nodiscard]] ros::RobotState robot_state_of(Activity activity, std::int64_t robot_ns);

}  // namespace gaitway::api
