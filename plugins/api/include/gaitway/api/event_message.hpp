// The main controller's events as ROS log messages.
#pragma once

#include <cstdint>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::api {

[[nodiscard]] ros::Log log_of(const Event& event);
// Of events that came faster than they were read.
[[nodiscard]] ros::Log log_of_missed(std::uint64_t count, std::int64_t stamp_ns);

}  // namespace gaitway::api
