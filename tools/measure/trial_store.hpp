// The outcomes of the gait measurement's trials. What outcomes depend on, as one number, and copies of the
// plug-ins' libraries that a measurement of hours runs with, so that a build meanwhile changes nothing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/plugin_library.hpp"
#include "tools/measure/gait_trial.hpp"
#include "tools/measure/outcome_store.hpp"

namespace gaitway::tools {

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

// An OutcomeStore of the gait measurement's trials.
class TrialStore {
 public:
  // Throws as OutcomeStore's constructor does.
  TrialStore(const std::filesystem::path& file, std::uint64_t fingerprint);

  [[nodiscard]] std::optional<TrialOutcome> find(const Trial& trial) const;
  // Throws std::runtime_error when the file cannot be written.
  void keep(const Trial& trial, const TrialOutcome& outcome);
  void leave_file() { store_.leave_file(); }  // as OutcomeStore's

 private:
  OutcomeStore store_;
};

}  // namespace gaitway::tools
