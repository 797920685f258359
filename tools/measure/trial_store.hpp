// The outcomes of trials, kept in a file: a line of JSON each, written as soon as it is known, so that a
// measurement may be interrupted and goes on where it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>

#include "gaitway/process/file_descriptor.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// A hash of everything but the trial that an outcome depends on: the robot's description, the configuration,
// the plug-ins' libraries, and the code of this program. Throws core::PluginError for a library that cannot
// be loaded, std::runtime_error for a file that cannot be read.
std::uint64_t fingerprint_of(const TrialRobot& robot);

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
