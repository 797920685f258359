// The outcomes of trials, kept in a file: a line of JSON each, written as soon as it is known, so that a
// measurement may be interrupted and goes on where it was. What outcomes depend on, as one number, and copies
// of the plug-ins' libraries that a measurement of hours runs with, so that a build meanwhile changes
// nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/plugin_library.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// A 64-bit hash of texts and files: FNV-1a.
class ContentHash {
 public:
  void add(std::string_view bytes) noexcept {
    for (const char byte : bytes) {
      state_ = (state_ ^ static_cast<unsigned char>(byte)) * 0x0000'0100'0000'01B3ULL;
    }
  }
  // Its bytes. Throws std::runtime_error that names the file when it cannot be read.
  void add_file(const std::filesystem::path& file);
  [[nodiscard]] std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0xCBF2'9CE4'8422'2325ULL;
};

// A hash of everything but the trial that an outcome depends on: the robot's description, the configuration,
// the plug-ins' libraries, and the code of this program. Throws core::PluginError for a library that cannot
// be loaded, std::runtime_error for a file that cannot be read.
std::uint64_t fingerprint_of(const TrialRobot& robot);

// Copies each library into the folder, under a name that its content determines, and lets the configuration
// name the copies. Throws core::PluginError for a library that cannot be loaded, std::runtime_error when the
// copy fails.
void pin_plugins(core::Configuration& plugins, const core::SearchPath& plugin_path,
                 const std::filesystem::path& folder);

// Removes the copies in the folder that the configuration does not name; for whoever has the folder for
// himself.
void remove_other_plugins(const core::Configuration& plugins, const std::filesystem::path& folder);

// One process at a time has the file.
class TrialStore {
 public:
  // Reads what is there; a last line that was cut off is dropped. `fingerprint` becomes part of each key.
  // Throws std::invalid_argument for a line that is no trial, or while another process has the file.
  TrialStore(const std::filesystem::path& file, std::uint64_t fingerprint);

  [[nodiscard]] std::optional<TrialOutcome> find(const Trial& trial) const;
  // Throws std::runtime_error when the file cannot be written.
  void keep(const Trial& trial, const TrialOutcome& outcome);
  // For a copy of the process that fork() made: the file stays the first process's alone, and can be
  // another's as soon as that one has ended. Nothing is kept any more.
  void leave_file() { descriptor_ = {}; }

 private:
  [[nodiscard]] std::string key_of(const std::string& description) const;
  void read();

  std::filesystem::path file_;
  std::uint64_t fingerprint_;
  process::FileDescriptor descriptor_;
  std::unordered_map<std::string, TrialOutcome> outcomes_;  // by key
};

}  // namespace gaitway::tools
