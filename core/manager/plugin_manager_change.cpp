// The manager's changes at run time: prepared off the tick, put in place between two batches, taken back when
// the new plug-in does not stand its trial.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gaitway/input/nearest_name.hpp"
#include "gaitway/manager/plugin_manager.hpp"
#include "plugin_trial.hpp"
#include "stand_in.hpp"

namespace gaitway::core {
namespace {

std::vector<ExternalTopic> topics_of_others(const msgclient::Client& client) {
  std::vector<ExternalTopic> external;
  for (const msgclient::TopicInfo& topic : client.directory()) {
    const bool ours = topic.writer == client.name();
    external.push_back({topic.descriptor.name, ours ? std::string() : topic.writer});
  }
  return external;
}

bool is_stand_in(const PluginSlot& slot) {
  return dynamic_cast<const StandIn*>(slot.plugin.get()) != nullptr;
}

}  // namespace

std::size_t PluginManager::index_of(std::string_view name) const noexcept {
  const auto same = [name](const auto& slot) { return slot->plugin->name() == name; };
  return static_cast<std::size_t>(std::find_if(slots_.begin(), slots_.end(), same) - slots_.begin());
}

std::size_t PluginManager::require(std::string_view name) const {
  const std::size_t index = index_of(name);
  if (index == slots_.size()) {
    std::vector<std::string> names;
    for (const auto& slot : slots_) {
      names.push_back(slot->plugin->name());
    }
    throw PluginError(
        fmt::format("there is no plug-in '{}'. {}", name, input::suggest(std::string(name), names)));
  }
  return index;
}

std::unique_ptr<PluginChange> PluginManager::prepare_replacement(const PluginEntry& entry) {
  std::optional<PluginTrial> trial;
  if (entry.isolation == Isolation::none) {
    trial.emplace(entry, source(), options_.isolation);
  }
  return plan_replacement(entry, load(entry), trial ? &*trial : nullptr);
}

std::unique_ptr<PluginChange> PluginManager::plan_replacement(const PluginEntry& entry,
                                                              std::unique_ptr<ManagedPlugin> plugin,
                                                              PluginTrial* trial) {
  const std::size_t old = index_of(entry.name);
  const ManagedPlugin* const predecessor = old < slots_.size() ? slots_[old]->plugin.get() : nullptr;
  auto slot = std::make_unique<PluginSlot>();
  slot->plugin = std::move(plugin);
  slot->entry = entry;
  slot->configured = predecessor != nullptr ? slots_[old]->configured : slots_.size();
  auto change = plan_change(entry.name, std::move(slot), old);
  if (trial != nullptr) {
    trial->first_step(client_, events_.now_ns());
  }
  ManagedPlugin& incoming = *change->incoming()->plugin;
  incoming.bind(client_, predecessor);
  contain(*change->incoming());
  incoming.activate();
  return change;
}

std::unique_ptr<PluginChange> PluginManager::prepare_reload(const std::string& name,
                                                            const std::string& library) {
  PluginEntry entry = slots_[require(name)]->entry;
  if (!library.empty()) {
    entry.library = library;
  }
  return prepare_replacement(entry);
}

std::unique_ptr<PluginChange> PluginManager::prepare_addition(const PluginEntry& entry) {
  if (index_of(entry.name) < slots_.size()) {
    throw PluginError(
        fmt::format("there is a plug-in '{}' already. Use reload, or another name", entry.name));
  }
  return prepare_replacement(entry);
}

std::unique_ptr<PluginChange> PluginManager::prepare_removal(const std::string& name) {
  return plan_change(name, nullptr, require(name));
}

std::unique_ptr<PluginChange> PluginManager::prepare_stop(const std::string& name) {
  const PluginSlot& running = *slots_[require(name)];
  if (is_stand_in(running)) {
    throw PluginError(fmt::format("'{}' is stopped already", name));
  }
  auto stand_in = std::make_unique<StandIn>(running.entry, StandIn::topics_for(running.plugin->node()),
                                            configuration_file_, events_);
  return plan_replacement(running.entry, std::move(stand_in), nullptr);
}

std::unique_ptr<PluginChange> PluginManager::prepare_start(const std::string& name) {
  const PluginSlot& stopped = *slots_[require(name)];
  if (!is_stand_in(stopped)) {
    throw PluginError(fmt::format("'{}' is not stopped. To load it anew, use reload", name));
  }
  return prepare_replacement(stopped.entry);
}

// Checks the data flow of the plug-ins as they will be.
std::unique_ptr<PluginChange> PluginManager::plan_change(const std::string& name,
                                                         std::unique_ptr<PluginSlot> incoming,
                                                         std::size_t old) const {
  std::vector<std::size_t> places;  // as PluginChange means them
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (i != old) {
      places.push_back(i);
    }
  }
  if (incoming != nullptr) {
    places.push_back(PluginChange::kIncoming);
  }
  const auto slot_at = [&](std::size_t place) -> const PluginSlot& {
    return place == PluginChange::kIncoming ? *incoming : *slots_[place];
  };
  std::sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(slot_at(a).configured, a) < std::pair(slot_at(b).configured, b);
  });
  std::vector<DataFlowNode> nodes;
  nodes.reserve(places.size());
  for (const std::size_t place : places) {
    nodes.push_back(slot_at(place).plugin->node());
  }
  const DataFlow flow = order_by_data_flow(nodes, topics_of_others(client_));
  std::vector<std::size_t> next;
  std::vector<std::vector<bool>> depends_on;
  for (const std::size_t index : flow.order) {
    next.push_back(places[index]);
    std::vector<bool> row;
    for (const std::size_t other : flow.order) {
      row.push_back(flow.depends_on[index][other]);
    }
    depends_on.push_back(std::move(row));
  }
  return std::make_unique<PluginChange>(name, std::move(incoming), std::move(next), std::move(depends_on),
                                        old < slots_.size() ? old : PluginChange::kIncoming);
}

bool PluginManager::schedule(std::unique_ptr<PluginChange> change) noexcept {
  if (change_ != nullptr) {
    return false;
  }
  change_ = std::move(change);
  change_phase_ = ChangePhase::waiting;
  return true;
}

// At a batch edge: state over, outputs over, the new order.
void PluginManager::begin_change(const Tick& tick) noexcept {
  PluginChange& change = *change_;
  PluginSlot* const incoming = change.incoming();
  const bool replaces = change.outgoing_index() != PluginChange::kIncoming;
  ManagedPlugin* const old = replaces ? slots_[change.outgoing_index()]->plugin.get() : nullptr;
  if (incoming != nullptr && old != nullptr) {
    // One that is out of service, or whose process is away, has nothing to hand on that is of use; and one
    // that is stopped has nobody to hand it on to.
    const bool hands_on = slots_[change.outgoing_index()]->containment.is_stepped() &&
                          old->recovery() == Recovery::not_needed && incoming->containment.is_stepped();
    if (hands_on && !old->save_state(change.state())) {
      return fail_change(tick, "the running one cannot hand its state on", old->fault());
    }
    if (!incoming->plugin->restore_state(change.state())) {
      return fail_change(tick, "the new one refuses the state that is handed on", incoming->plugin->fault());
    }
    incoming->plugin->take_outputs(*old);
  }
  if (old != nullptr) {
    old->take_snapshots();  // should it have to step in after all
  }
  trial_ = incoming;
  change.apply(slots_);
  change_phase_ = ChangePhase::trial;
}

void PluginManager::fail_change(const Tick& tick, std::string_view what, std::string_view why) noexcept {
  change_phase_ = ChangePhase::failed;
  std::array<char, 256>& text = change_->outcome();
  fmt::format_to_n(text.data(), text.size() - 1, "not changed: {}: {}", what, why).out[0] = '\0';
  events_.add(tick.now_ns, tick.tick, EventKind::error, change_->name(), text.data());
}

// Puts the old one back in its place, in the same tick: it and all that depend on it are stepped (again).
void PluginManager::take_change_back(const Tick& tick, std::string_view what, std::string_view why) noexcept {
  PluginChange& change = *change_;
  trial_ = nullptr;
  change.revert(slots_);
  const std::size_t old = change.outgoing_index();
  if (old != PluginChange::kIncoming) {
    slots_[old]->plugin->take_outputs(*change.incoming()->plugin);
    for (const auto& slot : slots_) {
      slot->stepped = slot->stepped && !slot->depends_on[old];
    }
    slots_[old]->stepped = false;
  }
  fail_change(tick, what, why);
}

bool PluginManager::take_trial_back(const Tick& tick, std::string_view why) noexcept {
  if (change_phase_ != ChangePhase::trial || trial_ == nullptr) {
    return false;
  }
  take_change_back(tick, "the robot cannot go on with what it does", why);
  step_all(tick);
  return true;
}

void PluginManager::end_trial(const Tick& tick) noexcept {
  if (change_phase_ != ChangePhase::trial) {
    return;
  }
  const PluginSlot* const outgoing = change_->outgoing();
  const std::string_view before = outgoing != nullptr ? outgoing->plugin->version() : "nothing";
  const std::string_view after = trial_ != nullptr ? trial_->plugin->version() : "nothing";
  std::array<char, 256>& text = change_->outcome();
  fmt::format_to_n(text.data(), text.size() - 1, "in place of {} now {}; {} bytes of state handed on", before,
                   after, change_->state().size)
      .out[0] = '\0';
  events_.add(tick.now_ns, tick.tick, EventKind::info, change_->name(), text.data());
  trial_ = nullptr;
  change_phase_ = ChangePhase::done;
}

std::optional<ChangeResult> PluginManager::take_result() {
  if (change_phase_ != ChangePhase::done && change_phase_ != ChangePhase::failed) {
    return std::nullopt;
  }
  ChangeResult result{change_phase_ == ChangePhase::done, change_->outcome().data(), nullptr};
  result.remains = std::move(change_);
  change_phase_ = ChangePhase::none;
  return result;
}

}  // namespace gaitway::core
