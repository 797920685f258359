// Sends to a robot what was tried before.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

struct ParameterSetting {
  std::string plugin, parameter, value;
};

// What is to be done; of walk, motion and goal one at most.
struct RobotTask {
  std::optional<std::vector<double>> walk;  // m/s ahead, m/s to the left, rad/s
  double walk_seconds = 0.0;
  std::string motion;
  std::optional<std::array<double, 3>> goal;  // x m, y m, yaw rad
  std::vector<ParameterSetting> settings;     // first
};

// Takes the command for as long as it lasts. Returns when the robot has done it, or, of a way, has begun it
// and arrived. Throws ApiError with the robot's words when it refuses, NoAnswer.
void send(ApiClient& client, const RobotTask& task);

}  // namespace gaitway::tools
