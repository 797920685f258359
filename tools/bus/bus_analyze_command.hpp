// `gaitway bus analyze`: how long each message of a bus takes in the worst case, and how much more it could
// carry.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct BusAnalyzeOptions {
  std::filesystem::path robot;                    // folder with robot.urdf and robot.yaml
  std::optional<std::filesystem::path> messages;  // instead of a robot: see message_list.hpp
  std::string profile;                            // instead of what the robot's network file says
  std::optional<double> jitter_ms;  // of every message of the robot; as `gaitway run` asks for when left out
  // They add up. When both are left out: of a robot, what `gaitway run` asks for, and none of messages.
  std::vector<std::string> errors;    // see error_option.hpp
  std::optional<double> jam_ms;       // one jam at the worst instant
  std::int64_t bit_rate = 1'000'000;  // bit/s
  bool priorities = false;            // print the best order even if it is not needed
  bool json = false;
};

inline constexpr int kExitMisses = 3;  // a message may miss its deadline

// Adds the subcommand with its options and examples; `options` is filled when it is parsed.
CLI::App* add_bus_analyze_command(CLI::App& bus, BusAnalyzeOptions& options);

// Prints the analysis; returns 0 when every message meets its deadline, kExitMisses otherwise. Throws
// std::exception on bad input.
int analyze_bus(const BusAnalyzeOptions& options);

}  // namespace gaitway::tools
