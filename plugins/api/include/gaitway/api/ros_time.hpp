// Nanoseconds of the robot's clock as a ROS time.
#pragma once

#include <cstdint>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {

[[nodiscard]] constexpr ros::Time ros_time(std::int64_t time_ns) noexcept {
  using facts::kSecond_ns;
  std::int64_t seconds = time_ns / kSecond_ns;
  std::int64_t rest_ns = time_ns % kSecond_ns;
  if (rest_ns < 0) {
    --seconds;
    rest_ns += kSecond_ns;
  }
  return {static_cast<std::int32_t>(seconds), static_cast<std::uint32_t>(rest_ns)};
}

}  // namespace gaitway::api
