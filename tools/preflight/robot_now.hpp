// Where a robot is, as its API tells: the posture of its joints, what it does, and its place in the room.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

struct RobotParameter {
  std::string plugin, name, value;  // the value as a configuration has it
  bool operator==(const RobotParameter&) const = default;
};

struct RobotNow {
  std::vector<double> joint_rad;                // in the order of RobotModel::joints
  std::string state;                            // of /robot_state: "stands", "walks", ...
  std::optional<std::array<double, 3>> place;   // x m, y m, yaw rad in its map; none: it does not say
  std::optional<std::array<double, 2>> base_m;  // of its odometry: x, y; none: it does not say
  std::vector<RobotParameter> parameters;       // of its plug-ins; empty: nobody has asked (ask_state)
};

// Why what was tried from `then` cannot be sent to the robot as it is `now`: it does not stand, or not where
// it stood, or its plug-ins have other parameters. Empty: it can.
[[nodiscard]] std::string change_between(const RobotNow& then, const RobotNow& now,
                                         const urdf::RobotModel& robot);

// Throws ApiError: it is not understood, is of another release, or another robot than `robot`; NoAnswer.
[[nodiscard]] RobotNow ask_where(ApiClient& client, const urdf::RobotModel& robot);
// And its plug-ins' parameters: some seconds, since the robot tells one in two of its slots.
[[nodiscard]] RobotNow ask_state(ApiClient& client, const urdf::RobotModel& robot);

}  // namespace gaitway::tools
