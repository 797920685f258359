// Finds the file of a world.
#include "gaitway/world/world_choice.hpp"

#include <algorithm>

#include "gaitway/input/complaint.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::world {

std::vector<std::string> shipped_worlds() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(process::world_directory(), none)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

World load_world(const WorldChoice& choice) {
  const std::filesystem::path shipped = process::world_directory();
  for (const std::filesystem::path& file : {choice.written_in.parent_path() / choice.name,
                                            shipped / choice.name, shipped / (choice.name + ".yaml")}) {
    std::error_code unknown;
    if (std::filesystem::exists(file, unknown) && !std::filesystem::is_directory(file, unknown)) {
      return read_world(file, choice.random_seed);
    }
  }
  input::refuse({choice.written_in, choice.line, "world", "'" + choice.name + "'",
                 "there is no such file, and no world of that name is shipped",
                 input::suggest(choice.name, shipped_worlds())});
}

}  // namespace gaitway::world
