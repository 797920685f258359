// The part of `gaitway ctl` that speaks with a robot through its API.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

struct RobotCtlOptions {
  ApiAddress api;
  std::vector<double> velocity;  // forward m/s, left m/s, turn rad/s
  double seconds = 1.0;          // to walk
  bool soft = false;
  std::string joint, motion, recording, topic;
  double position_rad = 0.0;
  double duration_s = 1.0;
  int count = 1;  // messages to show; 0: without end
};

// Adds options and subcommands to `gaitway ctl`; `options` outlives it.
void add_robot_ctl(CLI::App& ctl, RobotCtlOptions& options);
// Whether one of these subcommands was parsed.
[[nodiscard]] bool is_robot_ctl(const CLI::App& ctl);
// Carries it out; the exit code, as of `gaitway ctl`. Throws ApiError.
int robot_ctl(const CLI::App& ctl, const RobotCtlOptions& options);

// What the API answers to a service call, printed; the exit code.
int call_and_print(ApiClient& client, const std::string& service, const nlohmann::json& arguments);

}  // namespace gaitway::tools
