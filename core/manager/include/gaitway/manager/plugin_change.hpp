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

#include "gaitway/manager/plugin_set.hpp"

namespace gaitway::core {

// Everything that the tick needs to put it in place, and to take it back, without allocating. Made by
// ChangeControl::prepare_*.
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
