// A change of the running plug-ins: prepared off the tick, put in place at a batch edge, tried for one tick.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/manager/containment.hpp"
#include "gaitway/manager/managed_plugin.hpp"
#include "gaitway/process/duration_histogram.hpp"

namespace gaitway::core {

// A plug-in in its manager, and what is counted about it.
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

// Everything that the tick needs to put it in place, and to take it back, without allocating. Made by
// PluginManager::prepare_*.
class PluginChange {
 public:
  static constexpr std::size_t kIncoming = std::numeric_limits<std::size_t>::max();

  // `next`: the order of the steps after the change: indices into the slots before it, or kIncoming.
  // `outgoing`: index of the slot that leaves, or kIncoming: none does.
  PluginChange(std::string name, std::unique_ptr<PluginSlot> incoming, std::vector<std::size_t> next,
               std::vector<std::vector<bool>> depends_on, std::size_t outgoing);

  // Moves the slots to the new order, and back. For the cycle.
  void apply(std::vector<std::unique_ptr<PluginSlot>>& slots) noexcept;
  void revert(std::vector<std::unique_ptr<PluginSlot>>& slots) noexcept;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  // Nullptr when it is in place, or when there is none.
  [[nodiscard]] PluginSlot* incoming() const noexcept { return incoming_.get(); }
  // Nullptr before apply(), or when there is none.
  [[nodiscard]] PluginSlot* outgoing() const noexcept { return outgoing_.get(); }
  [[nodiscard]] bool has_incoming() const noexcept { return has_incoming_; }
  [[nodiscard]] std::size_t outgoing_index() const noexcept { return outgoing_index_; }
  [[nodiscard]] PluginState& state() noexcept { return *state_; }
  // What became of it, for people.
  [[nodiscard]] std::array<char, 256>& outcome() noexcept { return outcome_; }

 private:
  void swap_dependencies(std::vector<std::unique_ptr<PluginSlot>>& slots) noexcept;

  std::string name_;
  bool has_incoming_;
  std::unique_ptr<PluginSlot> incoming_, outgoing_;
  std::vector<std::size_t> next_;
  std::vector<std::vector<bool>> depends_on_;  // of the order that is not in force
  std::size_t outgoing_index_;
  std::vector<std::unique_ptr<PluginSlot>> room_;
  std::unique_ptr<PluginState> state_ = std::make_unique<PluginState>();
  std::array<char, 256> outcome_{};
};

// What became of a change.
struct ChangeResult {
  bool done = false;
  std::string_view text;                  // for people; lives as long as `remains`
  std::unique_ptr<PluginChange> remains;  // destroys the plug-in that is no longer needed; before the manager
};

}  // namespace gaitway::core
