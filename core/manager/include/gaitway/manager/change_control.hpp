// Changes of the plug-ins while the robot walks: prepared off the tick, put in place between two batches,
// taken back when the new plug-in does not stand its trial.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/event_log.hpp"
#include "gaitway/manager/plugin_set.hpp"
#include "gaitway/msgclient/client.hpp"

namespace gaitway::core {

class PluginLoader;
class PluginTrial;

// A change on its way: everything that the tick needs to put it in place, and to take it back, without
// allocating. Made by ChangeControl::prepare_*.
class PluginChange {
 public:
  static constexpr std::size_t kIncoming = std::numeric_limits<std::size_t>::max();

  // `next`: the order of the steps after the change: indices into the slots before it, or kIncoming.
  // `outgoing`: index of the slot that leaves, or kIncoming: none does.
  PluginChange(std::string name, std::unique_ptr<PluginSlot> incoming, std::vector<std::size_t> next,
               std::vector<std::vector<bool>> depends_on, std::size_t outgoing);

  // Moves the slots to the new order, and back. For the cycle.
  void apply(PluginSet::Slots& slots) noexcept;
  void revert(PluginSet::Slots& slots) noexcept;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  // Nullptr when it is in place, or when there is none.
  [[nodiscard]] PluginSlot* incoming() const noexcept { return incoming_.get(); }
  // Nullptr before apply(), or when there is none.
  [[nodiscard]] PluginSlot* outgoing() const noexcept { return outgoing_.get(); }
  [[nodiscard]] std::size_t outgoing_index() const noexcept { return outgoing_index_; }
  [[nodiscard]] PluginState& state() noexcept { return *state_; }
  // What became of it, for people.
  [[nodiscard]] std::array<char, 256>& outcome() noexcept { return outcome_; }

 private:
  void swap_dependencies(PluginSet::Slots& slots) noexcept;

  std::string name_;
  std::unique_ptr<PluginSlot> incoming_, outgoing_;
  std::vector<std::size_t> next_;
  std::vector<std::vector<bool>> depends_on_;  // of the order that is not in force
  std::size_t outgoing_index_;
  PluginSet::Slots room_;
  std::unique_ptr<PluginState> state_ = std::make_unique<PluginState>();
  std::array<char, 256> outcome_{};
};

// What became of a change.
struct ChangeResult {
  bool done = false;
  std::string_view text;                  // for people; lives as long as `remains`
  std::unique_ptr<PluginChange> remains;  // destroys the plug-in that is no longer needed; before the manager
};

// A live parameter's new value on its way.
struct ParameterChange {
  PluginSlot* slot = nullptr;  // stays where it is until the next change of plug-ins
  std::string parameter;
  std::string text;  // as it was asked for
  gaitway_value value{};
  std::string shown;  // the value's text; the old one's once it is applied
};

// One change at a time: prepare, schedule, step until there is a result.
class ChangeControl {
 public:
  // All three outlive it.
  ChangeControl(PluginSet& plugins, PluginLoader& loader, msgclient::Client& client);

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
  // Off the tick: what became of the change. Nothing while it is under way.
  [[nodiscard]] std::optional<ChangeResult> take_result();

  // Changes a live parameter, of later versions, too, in three parts. Off the tick, by another thread if need
  // be: reads the value. Throws ConfigurationError or PluginError.
  [[nodiscard]] ParameterChange prepare_parameter(std::string_view plugin, std::string_view parameter,
                                                  const std::string& text) const;
  // Between two steps, no allocation. False: the plug-in refuses it, and its fault() says why.
  static bool apply(ParameterChange& change) noexcept;
  // By the thread that prepared it: a reload keeps it.
  static void keep(const ParameterChange& change);
  // All three. Throws PluginError also if the plug-in refuses it.
  void set_parameter(std::string_view plugin, std::string_view parameter, const std::string& text);

  // --- The manager's, for the cycle.
  // At a batch edge: state over, outputs over, the new order.
  void begin(const Tick& tick) noexcept;
  // The new plug-in in its first tick; nullptr: there is none.
  [[nodiscard]] const PluginSlot* trial() const noexcept { return trial_; }
  // Puts the old one back in its place, in the same tick: it and all that depend on it are to be stepped
  // (again). Only with a trial.
  void take_back(const Tick& tick, std::string_view what, std::string_view why) noexcept;
  // The new plug-in has stood its first tick.
  void end_trial(const Tick& tick) noexcept;
  // Whether it may be the plug-in on trial that keeps this topic from use: not if it is not behind it, or if
  // a plug-in behind it failed before already, or is stopped.
  [[nodiscard]] bool is_trial_to_blame(std::string_view topic) const noexcept;

 private:
  enum class Phase : std::uint8_t { none, waiting, trial, done, failed };

  // With what takes the place of its namesake, ready to be scheduled.
  [[nodiscard]] std::unique_ptr<PluginChange> plan_replacement(const PluginEntry& entry,
                                                               std::unique_ptr<ManagedPlugin> plugin,
                                                               PluginTrial* trial);
  [[nodiscard]] std::unique_ptr<PluginChange> plan_change(const std::string& name,
                                                          std::unique_ptr<PluginSlot> incoming,
                                                          std::size_t old) const;
  void fail(const Tick& tick, std::string_view what, std::string_view why) noexcept;

  PluginSet& plugins_;
  PluginLoader& loader_;
  EventLog& events_;
  msgclient::Client& client_;
  std::unique_ptr<PluginChange> change_;
  Phase phase_ = Phase::none;
  PluginSlot* trial_ = nullptr;
};

}  // namespace gaitway::core
