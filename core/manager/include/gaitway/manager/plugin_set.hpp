// The plug-ins that run, in the order of their steps, and what their data flow says of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/manager/containment.hpp"
#include "gaitway/manager/data_flow.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/process/duration_histogram.hpp"

namespace gaitway::core {

// A plug-in in its manager, and what is counted about it. Stays where it is while the order changes.
struct PluginSlot {
  std::unique_ptr<ManagedPlugin> plugin;
  PluginEntry entry;             // as it was loaded
  std::size_t configured = 0;    // its place in the configuration: the order where data flow leaves it open
  std::vector<bool> depends_on;  // [index in the order of the steps]
  process::DurationHistogram step_wall;
  std::uint64_t steps = 0;
  std::uint64_t faults = 0;
  std::int64_t last_step_ns = 0;
  std::int64_t p50_step_ns = 0, p99_step_ns = 0;  // when it was last its turn
  bool stepped = false;                           // in this tick
  bool failed = false;                            // in the last step, or out of service
  bool covered = false;                           // and its fallback wrote all its topics
  Containment containment;
  std::int64_t worst_input_age_ns = 0;
  std::uint32_t watch_id = 0;  // by which StepWatch knows it
};

// What lies in the memory block, and who writes it.
[[nodiscard]] std::vector<ExternalTopic> external_topics(const msgclient::Client& client);

struct PluginTiming {
  std::string name;
  std::uint64_t steps = 0;
  std::uint64_t faults = 0;
  process::DurationSummary step_us;  // wall time
  std::uint64_t overruns = 0;        // of the faults: steps over budget
  ServiceState state = ServiceState::works;
};

class PluginSet {
 public:
  using Slots = std::vector<std::unique_ptr<PluginSlot>>;

  PluginSet() = default;
  PluginSet(const PluginSet&) = delete;
  PluginSet& operator=(const PluginSet&) = delete;
  // Deactivates, destroys and unloads, each in reverse order of the steps.
  ~PluginSet();

  // At its end, until put_in_order().
  PluginSlot& add(const PluginEntry& entry);
  // By their data flow. Throws PluginError with the configuration's file.
  void put_in_order(const std::filesystem::path& configuration_file, const msgclient::Client& client);

  [[nodiscard]] Slots& slots() noexcept { return slots_; }
  [[nodiscard]] const Slots& slots() const noexcept { return slots_; }
  [[nodiscard]] std::size_t size() const noexcept { return slots_.size(); }
  [[nodiscard]] PluginSlot& operator[](std::size_t index) const noexcept { return *slots_[index]; }
  [[nodiscard]] std::size_t index_of(std::string_view name) const noexcept;  // size(): none has this name
  [[nodiscard]] std::size_t require(std::string_view name) const;            // throws PluginError
  [[nodiscard]] std::vector<DataFlowNode> nodes() const;

  // Whether a plug-in or a fallback uses the topic.
  [[nodiscard]] bool uses(std::string_view topic) const noexcept;
  // Of the plug-ins on which this topic depends (its writer, and whom the writer reads from in the same tick,
  // directly or not) the first that failed in the last step and whose fallback did not write all its topics;
  // nullptr: none.
  [[nodiscard]] const PluginSlot* fault_behind(std::string_view topic) const noexcept;
  // Whether the topic depends on it. One that nobody writes any more depends on whoever was changed last.
  [[nodiscard]] bool is_behind(const PluginSlot& slot, std::string_view topic) const noexcept;

  // Throws PluginError if there is no such plug-in.
  [[nodiscard]] const ParameterSet& parameters_of(std::string_view plugin) const {
    return slots_[require(plugin)]->plugin->parameters();
  }
  // Copies a parameter's value, as text, cut off where the room ends. Empty if there is none such. For the
  // tick's thread, which alone changes values.
  void copy_value(std::string_view plugin, std::size_t parameter, std::span<char> to) const noexcept;
  // Whether it may use Unix sockets, over which users reach the robot. False if there is no such plug-in.
  [[nodiscard]] bool local_sockets(std::string_view plugin) const noexcept;
  [[nodiscard]] std::vector<PluginTiming> timings() const;

 private:
  Slots slots_;
};

}  // namespace gaitway::core
