// How people reach the user interface module of a simulated robot: the options for it, and its command line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/command_line.hpp"

namespace gaitway::tools {

struct ModuleOptions {
  std::string address = "127.0.0.1";
  int port = 9090;
  std::optional<int> stop_port;
  std::string origins;  // further web origins that may connect, with commas between them
  std::filesystem::path token_file, certificate_file, key_file, limits;
};
void add_module_options(const CommandLine& command, ModuleOptions& options);

// What it is started for.
struct ModuleSurroundings {
  std::filesystem::path robot;  // folder
  std::string profile;          // of the bus; empty: the robot's own
  std::string link;             // unix:PATH
  std::string simulation;       // likewise
  std::filesystem::path recordings;
  std::string twin = {};  // likewise; empty: it is no twin
};
[[nodiscard]] std::vector<std::string> module_arguments(const ModuleOptions& options,
                                                        const ModuleSurroundings& surroundings);

}  // namespace gaitway::tools
