// Options first, then what a scenario says.
#include "tools/run/world_option.hpp"

#include <limits>
#include <stdexcept>

namespace gaitway::tools {

void add_world_options(const CommandLine& command, WorldOptions& options) {
  command.option(
      "--world", options.world,
      "What it walks in (YAML): a file, or the name of a shipped one, as `gaitway world list` shows "
      "them (default: an endless floor, or the scenario's)");
  command.option("--world-seed", options.seed, "Seed of the world's random courses, in place of their own")
      .between(0.0, std::numeric_limits<int>::max());  // a scenario can say it, too
}

std::optional<world::World> world_of(const WorldOptions& options,
                                     const std::optional<world::WorldChoice>& of_scenario) {
  std::optional<world::WorldChoice> choice = of_scenario;
  if (options.world) {
    choice =
        world::WorldChoice{.name = *options.world, .random_seed = {}, .written_in = "--world", .line = 0};
  }
  if (!choice) {
    if (options.seed) throw std::invalid_argument("--world-seed: needs a world. Add --world NAME");
    return std::nullopt;
  }
  if (options.seed) choice->random_seed = options.seed;
  return world::load_world(*choice);
}

}  // namespace gaitway::tools
