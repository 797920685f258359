// `gaitway motion`: key-frame motions, from their files to points and pictures.
#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct MotionOptions {
  std::string motion;  // name of a shipped motion, or a file
  std::filesystem::path folder, robot;
  std::filesystem::path out;
  int pictures = 8;
};

// Adds the subcommand and those below it; `options` is filled when it is parsed.
CLI::App* add_motion_command(CLI::App& app, MotionOptions& options);

// Does what was parsed; returns the exit code. Throws std::runtime_error for a motion that cannot be planned.
int motion_command(const CLI::App& command, const MotionOptions& options);

}  // namespace gaitway::tools
