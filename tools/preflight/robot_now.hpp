// Where a robot is, as its API tells: the posture of its joints, what it does, and its place in the room.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

struct RobotNow {
  std::vector<double> joint_rad;               // in the order of RobotModel::joints
  std::string state;                           // of /robot_state: "stands", "walks", ...
  std::optional<std::array<double, 3>> place;  // x m, y m, yaw rad in its map; none: it does not say
};

// Throws ApiError: not understood, or the robot there has other joints than `robot`; NoAnswer.
[[nodiscard]] RobotNow ask_where(ApiClient& client, const urdf::RobotModel& robot);

}  // namespace gaitway::tools
