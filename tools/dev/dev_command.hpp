// `gaitway dev`: a plug-in's source is watched, built and put into the walking robot at each change.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

namespace gaitway::tools {

struct DevOptions {
  std::filesystem::path project;  // folder with the plug-in's CMakeLists.txt
  std::filesystem::path build;    // empty: build/ in it
  std::vector<double> walk{0.15, 0.0, 0.0};
  double seconds = 0.0;     // of wall time; 0: until it is interrupted
  bool in_process = false;  // else in a process of its own
};

// `options` outlives the application.
CLI::App* add_dev_command(CLI::App& app, DevOptions& options);

// Returns the exit code. Throws when the project is none, or its first build does not give a plug-in.
int develop(const DevOptions& options);

}  // namespace gaitway::tools
