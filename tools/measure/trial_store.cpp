// Hashes and copies files.
#include "tools/measure/trial_store.hpp"

#include <fmt/format.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "gaitway/process/installation.hpp"
#include "gaitway/trajectory/motion_table.hpp"

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

std::uint64_t fingerprint_of(const TrialRobot& robot) {
  ContentHash hash;
  for (const std::filesystem::path& file : own_code()) {
    hash.add_file(file);
  }
  hash.add_file(robot.model.directory / "robot.urdf");
  hash.add_file(robot.model.directory / "robot.yaml");
  for (const std::filesystem::path& mesh : robot.model.mesh_files()) {
    hash.add_file(mesh);
  }
  for (const std::filesystem::path& folder : process::prepared_motion_directories(robot.model.directory)) {
    for (const std::filesystem::path& motion : trajectory::motion_table_files(folder)) hash.add_file(motion);
  }
  hash.add_file(robot.plugins.file);
  for (const core::PluginEntry& plugin : robot.plugins.plugins) {
    const core::PluginLibrary library(plugin.library, robot.plugins.file.parent_path(),
                                      core::plugin_search_path(robot.plugin_path));
    hash.add_file(library.file());
  }
  return hash.value();
}

void pin_plugins(core::Configuration& plugins, const core::SearchPath& plugin_path,
                 const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> originals;  // all of them are found, or no folder is made
  for (const core::PluginEntry& plugin : plugins.plugins) {
    originals.push_back(
        core::PluginLibrary(plugin.library, plugins.file.parent_path(), core::plugin_search_path(plugin_path))
            .file());
  }
  if (!originals.empty()) std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < originals.size(); ++i) {
    const std::filesystem::path& original = originals[i];
    core::PluginEntry& plugin = plugins.plugins[i];
    const std::filesystem::path draft = folder / fmt::format("draft_{}", getpid());
    std::filesystem::copy_file(original, draft, std::filesystem::copy_options::overwrite_existing);
    ContentHash hash;
    hash.add_file(draft);  // of the copy: the original may change at any instant
    const std::filesystem::path pinned =
        folder / fmt::format("{}_{:016x}.so", original.stem().string(), hash.value());
    std::filesystem::rename(draft, pinned);
    plugin.library = std::filesystem::absolute(pinned).string();
  }
}

void remove_other_plugins(const core::Configuration& plugins, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> others;
  std::error_code none;  // there is no such folder: nothing was pinned
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    const std::string file = std::filesystem::absolute(entry.path()).string();
    if (std::ranges::none_of(plugins.plugins,
                             [&file](const core::PluginEntry& plugin) { return plugin.library == file; })) {
      others.push_back(entry.path());
    }
  }
  for (const std::filesystem::path& other : others) {
    std::filesystem::remove(other);
  }
}

namespace {

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) {
      return line;
    }
  }
  return {};
}

// Processor times are of the machine that took them.
std::string description_of(const Trial& trial) {
  nlohmann::ordered_json json = describe(trial);
  if (trial.times_compute) {
    json["processor"] = processor_name();
  }
  return json.dump();
}

}  // namespace

TrialStore::TrialStore(const std::filesystem::path& file, std::uint64_t fingerprint)
    : store_(file, fingerprint,
             [](const nlohmann::ordered_json& outcome) { static_cast<void>(outcome_from_json(outcome)); }) {}

std::optional<TrialOutcome> TrialStore::find(const Trial& trial) const {
  const nlohmann::ordered_json* const outcome = store_.find(description_of(trial));
  return outcome == nullptr ? std::nullopt : std::optional(outcome_from_json(*outcome));
}

void TrialStore::keep(const Trial& trial, const TrialOutcome& outcome) {
  store_.keep(description_of(trial), to_json(outcome));
}

}  // namespace gaitway::tools
