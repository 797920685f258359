// Steps the plug-ins of a set, each contained: what it costs, what it published, and who stands in for it.
#pragma once

#include <cstdint>

#include "gaitway/instance/event_log.hpp"
#include "gaitway/manager/manager_options.hpp"
#include "gaitway/manager/plugin_set.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

class StepRunner {
 public:
  // Writes the topic `plugin_statistics`. All three outlive it. Throws msgclient::TopicError.
  StepRunner(const PluginManagerOptions& options, EventLog& events, msgclient::Client& client);

  // --- For the cycle.
  // Whose turn it is in this tick.
  void begin(PluginSet& plugins, const Tick& tick) noexcept;
  struct Outcome {
    int failed = 0;  // or out of service
    bool trial_failed = false;
  };
  // Those that have not had their turn yet, in order. `trial`, the new plug-in in its first tick (nullptr:
  // there is none), has no fallback: where it fails, the rest waits for its predecessor.
  Outcome step_all(PluginSet& plugins, const Tick& tick, const PluginSlot* trial) noexcept;
  void publish_statistics(PluginSet& plugins, const Tick& tick) noexcept;

  // What faults that were injected made the last tick cost.
  [[nodiscard]] std::int64_t declared_cost_ns() const noexcept { return declared_cost_ns_; }

 private:
  void step(PluginSlot& slot, const Tick& tick, bool on_trial) noexcept;
  bool run_step(PluginSlot& slot, const Tick& tick, PluginFaultKind injected) noexcept;
  void keep_verdict(PluginSlot& slot, const Tick& tick) noexcept;
  void note_success(PluginSlot& slot, const Tick& tick) noexcept;
  void note_fault(PluginSlot& slot, const Tick& tick, bool overrun, bool on_trial) noexcept;
  [[nodiscard]] std::int64_t wall_ns() const noexcept {
    return options_.wall_clock == nullptr ? 0 : options_.wall_clock();
  }

  const PluginManagerOptions& options_;
  EventLog& events_;
  std::int64_t declared_cost_ns_ = 0;
  msgclient::Writer<PluginStatistics> statistics_writer_;
  PluginStatistics statistics_{};
};

}  // namespace gaitway::core
