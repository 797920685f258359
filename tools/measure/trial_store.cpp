// Hashes and copies files; appends outcomes.
#include "tools/measure/trial_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

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
  for (const std::filesystem::path& mesh : robot.model.mesh_files()) {
    hash.add_file(mesh);
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
  std::filesystem::create_directories(folder);
  for (core::PluginEntry& plugin : plugins.plugins) {
    const std::filesystem::path original =
        core::PluginLibrary(plugin.library, plugins.file.parent_path(), core::plugin_search_path(plugin_path))
            .file();
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
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
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
    : file_(file),
      fingerprint_(fingerprint),
      descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {
  if (!descriptor_) {
    throw std::invalid_argument(
        fmt::format("{}: cannot be opened ({}). Choose another --out", file.string(), std::strerror(errno)));
  }
  if (flock(descriptor_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw std::invalid_argument(
        fmt::format("{}: another measurement is writing there. Wait for its end, or choose another --out",
                    file.string()));
  }
  read();
}

void TrialStore::read() {
  std::ifstream in(file_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t whole = text.rfind('\n') + 1;  // 0 if there is none
  if (whole < text.size() && ftruncate(descriptor_.get(), static_cast<off_t>(whole)) != 0) {
    throw std::runtime_error(fmt::format("{}: {}", file_.string(), std::strerror(errno)));
  }
  int number = 0;
  for (std::size_t start = 0; start < whole; ++number) {
    const std::size_t end = text.find('\n', start);
    const std::string_view line = std::string_view(text).substr(start, end - start);
    start = end + 1;
    try {
      const auto json = nlohmann::ordered_json::parse(line);
      outcomes_.insert_or_assign(json.at("key").get<std::string>(), outcome_from_json(json.at("outcome")));
    } catch (const nlohmann::json::exception& error) {
      throw std::invalid_argument(
          fmt::format("{}:{}: no outcome of a trial ({}). Remove the line, or the file", file_.string(),
                      number + 1, error.what()));
    }
  }
}

std::string TrialStore::key_of(const std::string& description) const {
  ContentHash hash;
  hash.add(description);
  return fmt::format("{:016x}{:016x}", fingerprint_, hash.value());
}

std::optional<TrialOutcome> TrialStore::find(const Trial& trial) const {
  const std::string key = key_of(description_of(trial));
  const auto found = outcomes_.find(key);
  return found == outcomes_.end() ? std::nullopt : std::optional(found->second);
}

void TrialStore::keep(const Trial& trial, const TrialOutcome& outcome) {
  const std::string description = description_of(trial);
  const std::string key = key_of(description);
  const std::string line = fmt::format("{{\"key\":\"{}\",\"trial\":{},\"outcome\":{}}}\n", key, description,
                                       to_json(outcome).dump());
  // One call writes the whole line or, on a full disk, a part that the next start drops.
  if (write(descriptor_.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    throw std::runtime_error(
        fmt::format("{}: cannot be written to its end ({})", file_.string(), std::strerror(errno)));
  }
  outcomes_.insert_or_assign(key, outcome);
}

}  // namespace gaitway::tools
