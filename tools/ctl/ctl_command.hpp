// `gaitway ctl`: commands a robot that is running, and changes its plug-ins.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "tools/ctl/robot_ctl.hpp"

namespace gaitway::tools {

inline constexpr int kExitRefused = 2;
inline constexpr int kExitNoAnswer = 3;

struct CtlOptions {
  std::filesystem::path socket;
  RobotCtlOptions robot;
  std::string plugin, library, parameter, value;
  double timeout_s = 10.0;
};

// `options` outlives the application.
CLI::App* add_ctl_command(CLI::App& app, CtlOptions& options);

// Sends the request of the subcommand that was parsed and waits for the answer. Throws when the socket cannot
// be reached or the input is no request.
int ctl(const CLI::App& command, const CtlOptions& options);

}  // namespace gaitway::tools
