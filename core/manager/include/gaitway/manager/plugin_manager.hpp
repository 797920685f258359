// Loads the plug-ins of a configuration, checks that they fit together, and steps them in the order of their
// data flow.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/isolation/settings.hpp"
#include "gaitway/manager/configuration.hpp"
#include "gaitway/manager/data_flow.hpp"
#include "gaitway/manager/event_log.hpp"
#include "gaitway/manager/loaded_plugin.hpp"
#include "gaitway/manager/plugin_change.hpp"
#include "gaitway/manager/plugin_fault_table.hpp"
#include "gaitway/manager/plugin_library.hpp"
#include "gaitway/manager/step_watch.hpp"
#include "gaitway/manager/wall_clock.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/tick.hpp"

namespace gaitway::core {

class PluginTrial;

struct PluginManagerOptions {
  std::filesystem::path robot_directory;
  SearchPath plugin_path;                   // before GAITWAY_PLUGIN_PATH and the shipped plug-ins
  WallClock wall_clock = &steady_clock_ns;  // measures steps; nullptr: they count as 0
  IsolationOptions isolation = {};          // of plug-ins in processes of their own
  // Whether measured time counts against the budgets, as in real time. In virtual time only declared costs
  // do.
  bool wall_time_decides = false;
  const PluginFaultTable* injected_faults = nullptr;  // nullptr: none; outlives the manager
  StepWatch* step_watch = nullptr;                    // nullptr: nobody watches; outlives the manager
  // Whether each in-process plug-in is first constructed in a throw-away process, so that one that crashes or
  // hangs there is refused by name. Changes at run time always go that way.
  bool try_at_start = false;
  // Of the configuration's plug-ins: not loaded; fallbacks write their topics.
  std::vector<std::string> left_out = {};
  // Where the memory block's server takes clients: for plug-ins that are clients of their own. Empty:
  // nowhere.
  std::filesystem::path memory_socket = {};
};

struct PluginTiming {
  std::string name;
  std::uint64_t steps = 0;
  std::uint64_t faults = 0;
  process::DurationSummary step_us;  // wall time
  std::uint64_t overruns = 0;        // of the faults: steps over budget
  ServiceState state = ServiceState::works;
};

// A live parameter's new value on its way.
struct ParameterChange {
  PluginSlot* slot = nullptr;  // stays where it is until the next change of plug-ins
  std::string parameter;
  std::string text;  // as it was asked for
  gaitway_value value{};
  std::string shown;  // the value's text; the old one's once it is applied
};

class PluginManager {
 public:
  // Loads and constructs all plug-ins, checks the data flow, opens the topics and activates; if anything is
  // wrong, everything is unloaded again. Throws ConfigurationError or PluginError. Writes the topic
  // `plugin_statistics`.
  PluginManager(const Configuration& configuration, const PluginManagerOptions& options,
                msgclient::Client& client);
  // Deactivates, destroys and unloads, each in reverse order of the steps.
  ~PluginManager();
  PluginManager(const PluginManager&) = delete;
  PluginManager& operator=(const PluginManager&) = delete;

  // Steps every plug-in that is due. What fails (a throw, a number that is not finite or beyond its limits, a
  // step over budget) is counted, reported and publishes nothing: its fallback writes its topics before those
  // that depend on them are stepped. It is stepped again at its next turn, unless it failed too often: then
  // it is out of service. Returns how many failed or are out of service. For the cycle.
  int step(const Tick& tick) noexcept;
  // What faults that were injected made the last step cost.
  [[nodiscard]] std::int64_t declared_cost_ns() const noexcept { return declared_cost_ns_; }

  // Off the tick, once after each: replaces the processes of isolated plug-ins that ended.
  void maintain(std::int64_t now_ns) noexcept;

  // --- Changes while the robot walks. One at a time: prepare, schedule, step until there is a result.
  // Off the tick, by another thread if need be: tries the plug-in in a throw-away process, loads and
  // constructs it, checks the data flow with it in place of its namesake (or beside the others if it has
  // none), opens its inputs and activates it. Throws ConfigurationError or PluginError, and nothing has
  // changed.
  [[nodiscard]] std::unique_ptr<PluginChange> prepare_replacement(const PluginEntry& entry);
  // The same plug-in anew, with its parameters; `library`: from this file; empty: from where it was.
  [[nodiscard]] std::unique_ptr<PluginChange> prepare_reload(const std::string& name,
                                                             const std::string& library = {});
  // Beside the others. Throws PluginError also if there is one of that name.
  [[nodiscard]] std::unique_ptr<PluginChange> prepare_addition(const PluginEntry& entry);
  [[nodiscard]] std::unique_ptr<PluginChange> prepare_removal(const std::string& name);
  // Fallbacks take its place, and its code is unloaded; until it is started again, afresh, from its entry.
  [[nodiscard]] std::unique_ptr<PluginChange> prepare_stop(const std::string& name);
  [[nodiscard]] std::unique_ptr<PluginChange> prepare_start(const std::string& name);
  // The change takes place in the next step() that prepares a batch: the old plug-in's state and outputs go
  // over to the new one. If the new one fails in that step, the old one takes its turn in the same tick and
  // stays. False: another change is on its way.
  bool schedule(std::unique_ptr<PluginChange> change) noexcept;
  // Between step() and end_trial(): what the new plug-in did is of no use. Puts the old one back and steps it
  // and all that depend on it again. False: there is no new plug-in on trial.
  bool take_trial_back(const Tick& tick, std::string_view why) noexcept;
  // The new plug-in has stood its first tick. The next step() says so, too.
  void end_trial(const Tick& tick) noexcept;
  // Off the tick: what became of the change. Nothing while it is under way.
  [[nodiscard]] std::optional<ChangeResult> take_result();
  // Changes a live parameter, of later versions, too, in three parts. Off the tick, by another thread if need
  // be: reads the value. Throws ConfigurationError or PluginError.
  [[nodiscard]] ParameterChange prepare_parameter(std::string_view plugin, std::string_view parameter,
                                                  const std::string& text) const;
  // Between two steps, no allocation. False: the plug-in refuses it, and its fault() says
  // why.
  static bool apply(ParameterChange& change) noexcept;
  // By the thread that prepared it: a reload keeps it.
  static void keep(const ParameterChange& change);
  // All three. Throws PluginError also if the plug-in refuses it.
  void set_parameter(std::string_view plugin, std::string_view parameter, const std::string& text);
  // Throws PluginError if there is no such plug-in.
  [[nodiscard]] const ParameterSet& parameters_of(std::string_view plugin) const {
    return slots_[require(plugin)]->plugin->parameters();
  }
  // Copies a parameter's value, as text, cut off where the room ends. Empty if there is none such. For the
  // tick's thread, which alone changes values.
  void copy_value(std::string_view plugin, std::size_t parameter, std::span<char> to) const noexcept;
  // Whether it faces the network. False if there is no such plug-in.
  [[nodiscard]] bool serves_network(std::string_view plugin) const noexcept;

  // Whether in the last step a plug-in failed on which this topic depends (its writer, or a plug-in that the
  // writer reads from in the same tick, directly or not) and no fallback wrote all its topics. The first such
  // plug-in; nullptr: none.
  [[nodiscard]] const ManagedPlugin* fault_behind(std::string_view topic) const noexcept;
  // Whether it may be the plug-in on trial that keeps this topic from use: not if a plug-in behind it failed
  // before already, or is stopped.
  [[nodiscard]] bool is_trial_to_blame(std::string_view topic) const noexcept;
  // Whether a plug-in uses the topic.
  [[nodiscard]] bool uses(std::string_view topic) const noexcept;

  [[nodiscard]] std::size_t size() const noexcept { return slots_.size(); }
  // In the order of the steps: 0 <= index < size().
  [[nodiscard]] const ManagedPlugin& plugin(std::size_t index) const noexcept {
    return *slots_[index]->plugin;
  }
  [[nodiscard]] std::vector<PluginTiming> timings() const;
  [[nodiscard]] EventLog& events() noexcept { return events_; }
  [[nodiscard]] const EventLog& events() const noexcept { return events_; }

 private:
  enum class ChangePhase : std::uint8_t { none, waiting, trial, done, failed };

  [[nodiscard]] bool is_behind(const PluginSlot& slot, std::string_view topic) const noexcept;
  [[nodiscard]] const PluginSlot* slot_behind(std::string_view topic) const noexcept;
  // Of an entry's set-up at the start. A process of its own has its own limit of time, and a crash there
  // stays there.
  [[nodiscard]] StepWatch* watch_of(const PluginEntry& entry) const noexcept {
    return entry.isolation == Isolation::none ? options_.step_watch : nullptr;
  }
  void load_all(const Configuration& configuration);
  [[nodiscard]] PluginSource source() const {
    return {configuration_file_, options_.robot_directory, search_path_, options_.memory_socket};
  }
  [[nodiscard]] std::unique_ptr<ManagedPlugin> load(const PluginEntry& entry);
  void put_in_order(const Configuration& configuration, const msgclient::Client& client);
  void unload() noexcept;
  void add_stand_ins(const Configuration& configuration);
  // Budget, fallback and watch of a plug-in whose topics are declared.
  void contain(PluginSlot& slot);
  int step_all(const Tick& tick) noexcept;
  void step(PluginSlot& slot, const Tick& tick) noexcept;
  bool run_step(PluginSlot& slot, const Tick& tick) noexcept;
  void note_success(PluginSlot& slot, const Tick& tick) noexcept;
  void note_fault(PluginSlot& slot, const Tick& tick, bool overrun) noexcept;
  [[nodiscard]] std::size_t index_of(std::string_view name) const noexcept;  // size(): none has this name
  [[nodiscard]] std::size_t require(std::string_view name) const;            // throws PluginError
  // With what takes the place of slot `old`, ready to be scheduled.
  [[nodiscard]] std::unique_ptr<PluginChange> plan_replacement(const PluginEntry& entry,
                                                               std::unique_ptr<ManagedPlugin> plugin,
                                                               PluginTrial* trial);
  [[nodiscard]] std::unique_ptr<PluginChange> plan_change(const std::string& name,
                                                          std::unique_ptr<PluginSlot> incoming,
                                                          std::size_t old) const;
  void begin_change(const Tick& tick) noexcept;
  void fail_change(const Tick& tick, std::string_view what, std::string_view why) noexcept;
  void take_change_back(const Tick& tick, std::string_view what, std::string_view why) noexcept;
  void fill_statistics(const Tick& tick) noexcept;
  void publish_statistics(const Tick& tick) noexcept;
  [[nodiscard]] std::int64_t wall_ns() const noexcept {
    return options_.wall_clock == nullptr ? 0 : options_.wall_clock();
  }

  PluginManagerOptions options_;
  std::filesystem::path configuration_file_;
  SearchPath search_path_;
  msgclient::Client& client_;
  EventLog events_;  // outlives the plug-ins, which report until they are destroyed
  std::vector<std::unique_ptr<PluginSlot>> slots_;  // in the order of the steps
  std::unique_ptr<PluginChange> change_;
  ChangePhase change_phase_ = ChangePhase::none;
  std::int64_t declared_cost_ns_ = 0;
  PluginSlot* trial_ = nullptr;  // the new plug-in in its first tick
  std::unique_ptr<msgclient::Writer<PluginStatistics>> statistics_writer_;
  PluginStatistics statistics_{};
};

}  // namespace gaitway::core
