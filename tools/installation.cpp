// Finds the parts of an installation.
#include "gaitway/tools/installation.hpp"

#include <cstdlib>
#include <sstream>

namespace gaitway::tools {
namespace {

std::filesystem::path executable_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

// <prefix>/share/gaitway for an installed command, the source tree otherwise.
std::filesystem::path shared_folder() {
  const std::filesystem::path installed = executable_folder().parent_path() / "share" / "gaitway";
  return std::filesystem::exists(installed) ? installed : std::filesystem::path(GAITWAY_SOURCE_DIR);
}

}  // namespace

std::filesystem::path default_robot_directory() {
  return shared_folder() / "urdf" / "humanoid22";
}

std::filesystem::path default_config_file() {
  return shared_folder() / "core" / "config" / "walk.yaml";
}

std::vector<std::filesystem::path> plugin_directories() {
  std::vector<std::filesystem::path> folders;
  if (const char* const extra = std::getenv("GAITWAY_PLUGIN_PATH")) {
    std::stringstream list(extra);
    for (std::string folder; std::getline(list, folder, ':');) {
      folders.emplace_back(folder);
    }
  }
  folders.push_back(executable_folder().parent_path() / "lib");
  return folders;
}

}  // namespace gaitway::tools
