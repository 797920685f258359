// Finds the parts of an installation from the path of the running code.
#include "gaitway/process/installation.hpp"

#include <dlfcn.h>
#include <link.h>

#include <stdexcept>

namespace gaitway::process {
namespace {

// The program, or the shared library that this code was linked into.
std::filesystem::path own_file() {
  static const char mark = 0;
  Dl_info info{};
  if (dladdr(&mark, &info) != 0 && info.dli_fname != nullptr) {
    const std::filesystem::path file = info.dli_fname;
    if (file.filename().string().find(".so") != std::string::npos) {
      return std::filesystem::canonical(file);
    }
  }
  return std::filesystem::read_symlink("/proc/self/exe");
}

std::filesystem::path shared(const char* part) {
  const std::filesystem::path found = installation_root();
  if (found.empty()) {
    throw std::runtime_error("no share/gaitway beside or above " + own_file().string() +
                             ". Install gaitway as a whole, or name the files with options");
  }
  return found / "share" / "gaitway" / part;
}

// The nearest folder above that holds share/gaitway; empty: none does.
std::filesystem::path root_above(const std::filesystem::path& file) {
  for (std::filesystem::path folder = file.parent_path();; folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / "share" / "gaitway" / "urdf")) {
      return folder;
    }
    if (folder == folder.root_path()) {
      return {};
    }
  }
}

int take_root(dl_phdr_info* library, std::size_t, void* root) {
  const std::filesystem::path file = library->dlpi_name;
  if (file.filename().string().find(".so") == std::string::npos) return 0;  // a private copy has none
  std::error_code gone;
  const std::filesystem::path place = std::filesystem::canonical(file, gone);
  auto& found = *static_cast<std::filesystem::path*>(root);
  if (!gone) found = root_above(place);
  return found.empty() ? 0 : 1;
}

}  // namespace

// A plug-in is loaded from a private copy, which lies nowhere, and the program may be somebody else's, an
// interpreter: then another library of the process is the one that lies in the installation.
std::filesystem::path installation_root() {
  std::filesystem::path root = root_above(own_file());
  if (root.empty()) dl_iterate_phdr(&take_root, &root);
  return root;
}

std::filesystem::path default_robot_directory() {
  return shared("urdf") / "humanoid22";
}

std::filesystem::path config_directory() {
  return shared("config");
}
std::filesystem::path default_config_file() {
  return config_directory() / "walk.yaml";
}

std::filesystem::path scenario_directory() {
  return shared("scenarios");
}

std::filesystem::path world_directory() {
  return shared("worlds");
}

std::filesystem::path mission_directory() {
  return shared("missions");
}

std::filesystem::path template_directory() {
  return shared("templates");
}

std::filesystem::path motion_directory(const std::filesystem::path& robot_directory) {
  return robot_directory / "motions";
}

std::vector<std::filesystem::path> prepared_motion_directories(const std::filesystem::path& robot_directory) {
  std::vector<std::filesystem::path> folders{motion_directory(robot_directory)};
  const std::filesystem::path root = installation_root();
  std::error_code unknown;
  const std::filesystem::path robot = std::filesystem::weakly_canonical(robot_directory, unknown);
  if (!root.empty() && robot.has_filename()) {
    folders.push_back(root / "share" / "gaitway" / "prepared_motions" / robot.filename());
  }
  return folders;
}

std::filesystem::path calibration_directory() {
  return shared("calibration");
}

std::filesystem::path shipped_plugin_directory() {
  const std::filesystem::path found = installation_root();
  return found.empty() ? found : found / "lib" / "gaitway" / "plugins";
}

std::filesystem::path package_directory() {
  const std::filesystem::path found = shared("").parent_path().parent_path().parent_path();
  return found / "lib" / "cmake" / "gaitway";
}

}  // namespace gaitway::process
