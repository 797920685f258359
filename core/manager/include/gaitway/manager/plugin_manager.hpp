// Loads the plug-ins of a configuration, checks that they fit together, and steps them in the order of their
// data flow.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/event_log.hpp"
#include "gaitway/manager/change_control.hpp"
#include "gaitway/manager/manager_options.hpp"
#include "gaitway/manager/plugin_set.hpp"
#include "gaitway/manager/step_runner.hpp"
#include "gaitway/msgclient/client.hpp"

namespace gaitway::core {

class PluginManager {
 public:
  // Loads and constructs all plug-ins, checks the data flow, opens the topics and activates; if anything is
  // wrong, everything is unloaded again. Throws ConfigurationError or PluginError. Writes the topic
  // `plugin_statistics`.
  PluginManager(const Configuration& configuration, const PluginManagerOptions& options,
                msgclient::Client& client);
  ~PluginManager();
  PluginManager(const PluginManager&) = delete;
  PluginManager& operator=(const PluginManager&) = delete;

  // Steps every plug-in that is due. What fails (a throw, a number that is not finite or beyond its limits, a
  // step over budget) is counted, reported and publishes nothing: its fallback writes its topics before those
  // that depend on them are stepped. It is stepped again at its next turn, unless it failed too often: then
  // it is out of service. Returns how many failed or are out of service. For the cycle.
  int step(const Tick& tick) noexcept;
  // What faults that were injected made the last step cost.
  [[nodiscard]] std::int64_t declared_cost_ns() const noexcept { return runner_->declared_cost_ns(); }

  // Off the tick, once after each: replaces the processes of isolated plug-ins that ended.
  void maintain(std::int64_t now_ns) noexcept;

  // Changes while the robot walks, made by the next step() that prepares a batch. If the new plug-in fails in
  // that step, the old one takes its turn in the same tick and stays.
  [[nodiscard]] ChangeControl& changes() noexcept { return changes_; }
  // Between step() and end_trial(): what the new plug-in did is of no use. Puts the old one back and steps it
  // and all that depend on it again. False: there is no new plug-in on trial.
  bool take_trial_back(const Tick& tick, std::string_view why) noexcept;
  // The new plug-in has stood its first tick. The next step() says so, too.
  void end_trial(const Tick& tick) noexcept { changes_.end_trial(tick); }

  // Nullptr: nobody watches.
  [[nodiscard]] StepWatch* step_watch() const noexcept { return options_.step_watch; }
  // As PluginSet has it.
  [[nodiscard]] const ManagedPlugin* fault_behind(std::string_view topic) const noexcept {
    const PluginSlot* const slot = plugins_.fault_behind(topic);
    return slot == nullptr ? nullptr : slot->plugin.get();
  }
  [[nodiscard]] const PluginSet& plugins() const noexcept { return plugins_; }
  [[nodiscard]] std::size_t size() const noexcept { return plugins_.size(); }
  // In the order of the steps: 0 <= index < size().
  [[nodiscard]] const ManagedPlugin& plugin(std::size_t index) const noexcept {
    return *plugins_[index].plugin;
  }
  [[nodiscard]] std::vector<PluginTiming> timings() const { return plugins_.timings(); }
  [[nodiscard]] EventLog& events() noexcept { return events_; }
  [[nodiscard]] const EventLog& events() const noexcept { return events_; }

 private:
  void load_all(const Configuration& configuration, const msgclient::Client& client);
  void add_stand_ins(const Configuration& configuration, const msgclient::Client& client);
  void activate_all();
  // Of an entry's set-up at the start. A process of its own has its own limit of time, and a crash there
  // stays there.
  [[nodiscard]] StepWatch* watch_of(const PluginEntry& entry) const noexcept {
    return has_own_process(entry) ? nullptr : options_.step_watch;
  }
  int step_all(const Tick& tick) noexcept;

  const PluginManagerOptions options_;
  const std::filesystem::path configuration_file_;
  EventLog events_;  // outlives the plug-ins, which report until they are destroyed
  std::unique_ptr<PluginLoader> loader_;
  PluginSet plugins_;
  std::optional<StepRunner> runner_;
  ChangeControl changes_;
};

}  // namespace gaitway::core
