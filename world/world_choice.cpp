// Finds the file of a world.
#include "gaitway/world/world_choice.hpp"

#include "gaitway/input/complaint.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/shipped_files.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::world {

std::vector<std::string> shipped_worlds() {
  return process::shipped_names(process::world_directory(), ".yaml");
}

World load_world(const WorldChoice& choice) {
  const std::filesystem::path beside = choice.written_in.parent_path() / choice.name;
  if (process::is_file(beside)) return read_world(beside, choice.random_seed);
  const auto shipped = process::find_shipped(process::world_directory(), choice.name, ".yaml");
  if (shipped) return read_world(*shipped, choice.random_seed);
  input::refuse({choice.written_in, choice.line, "world", "'" + choice.name + "'",
                 "there is no such file, and no world of that name is shipped",
                 input::suggest(choice.name, shipped_worlds())});
}

}  // namespace gaitway::world
