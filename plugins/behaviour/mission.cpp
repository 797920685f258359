// Finds and reads the file of a mission.
#include "gaitway/behaviour_leaves/mission.hpp"

#include "gaitway/behaviour/read.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/shipped_files.hpp"

namespace gaitway::behaviour_leaves {

std::vector<std::string> shipped_missions() {
  return process::shipped_names(process::mission_directory(), ".xml");
}

std::filesystem::path find_mission(const std::string& name_or_path) {
  // Before the shipped ones are looked for: an author's own program need not lie beside these.
  if (process::is_file(name_or_path)) return name_or_path;
  if (std::error_code unknown; std::filesystem::is_directory(name_or_path, unknown)) {
    input::refuse({name_or_path, 0, "mission", "'" + name_or_path + "'", "it is a folder",
                   "Give the file of a behaviour tree"});
  }
  const auto shipped = process::find_shipped(process::mission_directory(), name_or_path, ".xml");
  if (shipped) return *shipped;
  input::refuse({name_or_path, 0, "mission", "'" + name_or_path + "'",
                 "there is no such file, and no mission of that name is shipped",
                 input::suggest(name_or_path, shipped_missions())});
}

Mission read_mission(const std::string& name_or_path, const behaviour::Registry& registry) {
  Mission mission{.file = find_mission(name_or_path), .tree = {}, .stand_up = {}};
  // Opening a pipe or a device may wait for ever, and whoever asked may be a stranger.
  if (!std::filesystem::is_regular_file(mission.file)) {
    input::refuse({mission.file, 0, "mission", "'" + name_or_path + "'", "it is no regular file",
                   "Give the file of a behaviour tree"});
  }
  const std::string text = input::read_text_file(mission.file, "Give the file of a behaviour tree");
  mission.tree = behaviour::parse_tree(text, mission.file, registry);
  mission.stand_up = behaviour::parse_tree_of_id(text, mission.file, registry, kStandUpTree);
  return mission;
}

}  // namespace gaitway::behaviour_leaves
