// Which key-frame motion plays, as a message.
#pragma once

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::api {

[[nodiscard]] ros::MotionState motion_state_of(const gaitway::MotionState& motion);

}  // namespace gaitway::api
