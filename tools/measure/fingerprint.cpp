// What outcomes depend on, as one number.
#include <fmt/format.h>
#include <link.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/manager/plugin_library.hpp"
#include "tools/measure/content_hash.hpp"
#include "tools/measure/trial_store.hpp"

namespace gaitway::tools {
namespace {

// The program and the libraries that it was linked with; the plug-ins are not loaded yet.
std::vector<std::filesystem::path> own_code() {
  std::vector<std::filesystem::path> files{"/proc/self/exe"};
  dl_iterate_phdr(
      [](dl_phdr_info* object, std::size_t, void* out) {
        const std::filesystem::path name = object->dlpi_name;
        if (name.is_absolute() && std::filesystem::exists(name)) {  // the kernel's own object is no file
          static_cast<std::vector<std::filesystem::path>*>(out)->push_back(name);
        }
        return 0;
      },
      &files);
  return files;
}

}  // namespace

void ContentHash::add_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) {
    throw std::runtime_error(fmt::format("{}: cannot be read ({})", file.string(), std::strerror(errno)));
  }
  add(content);
  add(std::string_view("\0", 1));  // so that two files are not one
}

std::uint64_t fingerprint_of(const TrialRobot& robot) {
  ContentHash hash;
  for (const std::filesystem::path& file : own_code()) {
    hash.add_file(file);
  }
  hash.add_file(robot.model.directory / "robot.urdf");
  hash.add_file(robot.model.directory / "robot.yaml");
  hash.add_file(robot.plugins.file);
  for (const core::PluginEntry& plugin : robot.plugins.plugins) {
    const core::PluginLibrary library(plugin.library, robot.plugins.file.parent_path(),
                                      core::plugin_search_path(robot.plugin_path));
    hash.add_file(library.file());
  }
  return hash.value();
}

}  // namespace gaitway::tools
