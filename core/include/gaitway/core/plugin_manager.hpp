// Loads the plug-ins of a configuration, checks that they fit together, and steps them in the order of their
// data flow.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/core/configuration.hpp"
#include "gaitway/core/data_flow.hpp"
#include "gaitway/core/event_log.hpp"
#include "gaitway/core/loaded_plugin.hpp"
#include "gaitway/core/plugin_library.hpp"
#include "gaitway/core/tick.hpp"
#include "gaitway/core/wall_clock.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/duration_histogram.hpp"

namespace gaitway::core {

struct PluginManagerOptions {
  std::filesystem::path robot_directory;
  SearchPath plugin_path;                   // before GAITWAY_PLUGIN_PATH and ../lib beside the executable
  WallClock wall_clock = &steady_clock_ns;  // measures steps; nullptr: they count as 0
};

struct PluginTiming {
  std::string name;
  std::uint64_t steps = 0;
  std::uint64_t faults = 0;
  process::DurationSummary step_us;  // wall time
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

  // Steps every plug-in that is due. What fails is counted, reported, publishes nothing, and is stepped again
  // at its next turn. Returns how many failed. For the cycle.
  int step(const Tick& tick) noexcept;

  // Whether in the last step a plug-in failed on which this topic depends: its writer, or a plug-in that the
  // writer reads from in the same tick, directly or not. The first such plug-in; nullptr: none.
  [[nodiscard]] const ManagedPlugin* fault_behind(std::string_view topic) const noexcept;
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
  struct Slot {  // a plug-in and what is counted about it
    std::unique_ptr<ManagedPlugin> plugin;
    std::vector<bool> depends_on;  // [index in the order of the steps]
    process::DurationHistogram step_wall;
    std::uint64_t steps = 0;
    std::uint64_t faults = 0;
    std::int64_t last_step_ns = 0;
    bool failed = false;  // in the last step
  };

  void load(const Configuration& configuration);
  void put_in_order(const Configuration& configuration, const msgclient::Client& client);
  void unload() noexcept;
  void step(Slot& slot, const Tick& tick) noexcept;
  void publish_statistics(const Tick& tick) noexcept;
  [[nodiscard]] std::int64_t wall_ns() const noexcept {
    return options_.wall_clock == nullptr ? 0 : options_.wall_clock();
  }

  PluginManagerOptions options_;
  EventLog events_;
  std::vector<std::unique_ptr<Slot>> slots_;  // in the order of the steps
  std::unique_ptr<msgclient::Writer<PluginStatistics>> statistics_writer_;
  PluginStatistics statistics_{};
};

}  // namespace gaitway::core
