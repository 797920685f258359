// Slots move between two orders, in memory that was reserved before.
#include "gaitway/manager/plugin_change.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::core {

PluginChange::PluginChange(std::string name, std::unique_ptr<PluginSlot> incoming,
                           std::vector<std::size_t> next, std::vector<std::vector<bool>> depends_on,
                           std::size_t outgoing)
    : name_(std::move(name)),
      has_incoming_(incoming != nullptr),
      incoming_(std::move(incoming)),
      next_(std::move(next)),
      depends_on_(std::move(depends_on)),
      outgoing_index_(outgoing) {
  room_.reserve(next_.size() + 1);  // before the change there may be one more
}

void PluginChange::swap_dependencies(std::vector<std::unique_ptr<PluginSlot>>& slots) noexcept {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    slots[i]->depends_on.swap(depends_on_[i]);
  }
}

void PluginChange::apply(std::vector<std::unique_ptr<PluginSlot>>& slots) noexcept {
  room_.clear();
  for (const std::size_t from : next_) {
    room_.push_back(std::move(from == kIncoming ? incoming_ : slots[from]));
  }
  if (outgoing_index_ != kIncoming) {
    outgoing_ = std::move(slots[outgoing_index_]);
  }
  slots.swap(room_);
  swap_dependencies(slots);
}

void PluginChange::revert(std::vector<std::unique_ptr<PluginSlot>>& slots) noexcept {
  swap_dependencies(slots);
  const std::size_t before = room_.size();
  for (std::size_t i = 0; i < before; ++i) {
    const auto at = std::find(next_.begin(), next_.end(), i);
    room_[i] = std::move(at == next_.end() ? outgoing_ : slots[static_cast<std::size_t>(at - next_.begin())]);
  }
  const auto in = std::find(next_.begin(), next_.end(), kIncoming);
  if (in != next_.end()) {
    incoming_ = std::move(slots[static_cast<std::size_t>(in - next_.begin())]);
  }
  slots.swap(room_);
}

}  // namespace gaitway::core
