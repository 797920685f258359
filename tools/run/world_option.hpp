// The options of a command with which somebody chooses the robot's world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gaitway/world/world_choice.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {

struct WorldOptions {
  std::optional<std::string> world;  // a file, or the name of a shipped one
  std::optional<std::uint64_t> seed;
};

// --world and --world-seed.
void add_world_options(const CommandLine& command, WorldOptions& options);

// What is chosen, by option or otherwise by a scenario. Throws input::InputError, std::invalid_argument for a
// seed without a world.
[[nodiscard]] std::optional<world::World> world_of(const WorldOptions& options,
                                                   const std::optional<world::WorldChoice>& of_scenario);

}  // namespace gaitway::tools
