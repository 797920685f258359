// A change from its preparation to the end of its trial. Its slots move between two orders in memory that was
// reserved before.
#include "gaitway/manager/change_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "plugin_loader.hpp"

namespace gaitway::core {
namespace {

std::vector<ExternalTopic> topics_of_others(const msgclient::Client& client) {
  std::vector<ExternalTopic> topics = external_topics(client);
  for (ExternalTopic& topic : topics) {
    if (topic.writer == client.name()) {
      topic.writer.clear();
    }
  }
  return topics;
}

bool is_stand_in(const PluginSlot& slot) {
  return dynamic_cast<const StandIn*>(slot.plugin.get()) != nullptr;
}

}  // namespace

PluginChange::PluginChange(std::string name, std::unique_ptr<PluginSlot> incoming,
                           std::vector<std::size_t> next, std::vector<std::vector<bool>> depends_on,
                           std::size_t outgoing)
    : name_(std::move(name)),
      incoming_(std::move(incoming)),
      next_(std::move(next)),
      depends_on_(std::move(depends_on)),
      outgoing_index_(outgoing) {
  room_.reserve(next_.size() + 1);  // before the change there may be one more
}

void PluginChange::swap_dependencies(PluginSet::Slots& slots) noexcept {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    slots[i]->depends_on.swap(depends_on_[i]);
  }
}

void PluginChange::apply(PluginSet::Slots& slots) noexcept {
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

void PluginChange::revert(PluginSet::Slots& slots) noexcept {
  swap_dependencies(slots);
  const std::size_t before = room_.size();
  for (std::size_t i = 0; i < before; ++i) {
    const auto at = std::ranges::find(next_, i);
    room_[i] = std::move(at == next_.end() ? outgoing_ : slots[static_cast<std::size_t>(at - next_.begin())]);
  }
  const auto in = std::ranges::find(next_, kIncoming);
  if (in != next_.end()) {
    incoming_ = std::move(slots[static_cast<std::size_t>(in - next_.begin())]);
  }
  slots.swap(room_);
}

// --- Preparing.

ChangeControl::ChangeControl(PluginSet& plugins, PluginLoader& loader, msgclient::Client& client)
    : plugins_(plugins), loader_(loader), events_(loader.events()), client_(client) {}

std::unique_ptr<PluginChange> ChangeControl::prepare_replacement(const PluginEntry& entry) {
  const std::unique_ptr<PluginTrial> trial = loader_.try_out(entry);
  return plan_replacement(entry, loader_.load(entry), trial.get());
}

std::unique_ptr<PluginChange> ChangeControl::plan_replacement(const PluginEntry& entry,
                                                              std::unique_ptr<ManagedPlugin> plugin,
                                                              PluginTrial* trial) {
  const std::size_t old = plugins_.index_of(entry.name);
  const ManagedPlugin* const predecessor = old < plugins_.size() ? plugins_[old].plugin.get() : nullptr;
  auto slot = std::make_unique<PluginSlot>();
  slot->plugin = std::move(plugin);
  slot->entry = entry;
  slot->configured = predecessor != nullptr ? plugins_[old].configured : plugins_.size();
  auto change = plan_change(entry.name, std::move(slot), old);
  if (trial != nullptr) {
    trial->first_step(client_, events_.now_ns());
  }
  ManagedPlugin& incoming = *change->incoming()->plugin;
  incoming.bind(client_, predecessor);
  loader_.contain(*change->incoming());
  incoming.activate();
  return change;
}

std::unique_ptr<PluginChange> ChangeControl::prepare_reload(const std::string& name,
                                                            const std::string& library) {
  PluginEntry entry = plugins_[plugins_.require(name)].entry;
  if (!library.empty()) {
    entry.library = library;
  }
  return prepare_replacement(entry);
}

std::unique_ptr<PluginChange> ChangeControl::prepare_addition(const PluginEntry& entry) {
  if (plugins_.index_of(entry.name) < plugins_.size()) {
    throw PluginError(
        fmt::format("there is a plug-in '{}' already. Use reload, or another name", entry.name));
  }
  return prepare_replacement(entry);
}

std::unique_ptr<PluginChange> ChangeControl::prepare_removal(const std::string& name) {
  return plan_change(name, nullptr, plugins_.require(name));
}

std::unique_ptr<PluginChange> ChangeControl::prepare_stop(const std::string& name) {
  const PluginSlot& running = plugins_[plugins_.require(name)];
  if (is_stand_in(running)) {
    throw PluginError(fmt::format("'{}' is stopped already", name));
  }
  auto stand_in = std::make_unique<StandIn>(running.entry, StandIn::topics_for(running.plugin->node()),
                                            loader_.configuration_file(), events_);
  return plan_replacement(running.entry, std::move(stand_in), nullptr);
}

std::unique_ptr<PluginChange> ChangeControl::prepare_start(const std::string& name) {
  const PluginSlot& stopped = plugins_[plugins_.require(name)];
  if (!is_stand_in(stopped)) {
    throw PluginError(fmt::format("'{}' is not stopped. To load it anew, use reload", name));
  }
  return prepare_replacement(stopped.entry);
}

// Checks the data flow of the plug-ins as they will be.
std::unique_ptr<PluginChange> ChangeControl::plan_change(const std::string& name,
                                                         std::unique_ptr<PluginSlot> incoming,
                                                         std::size_t old) const {
  std::vector<std::size_t> places;  // as PluginChange means them
  for (std::size_t i = 0; i < plugins_.size(); ++i) {
    if (i != old) {
      places.push_back(i);
    }
  }
  if (incoming != nullptr) {
    places.push_back(PluginChange::kIncoming);
  }
  const auto slot_at = [&](std::size_t place) -> const PluginSlot& {
    return place == PluginChange::kIncoming ? *incoming : plugins_[place];
  };
  std::ranges::sort(places, [&](std::size_t a, std::size_t b) {
    return std::pair(slot_at(a).configured, a) < std::pair(slot_at(b).configured, b);
  });
  std::vector<DataFlowNode> nodes;
  nodes.reserve(places.size());
  for (const std::size_t place : places) {
    nodes.push_back(slot_at(place).plugin->node());
  }
  DataFlow flow = order_by_data_flow(nodes, topics_of_others(client_));
  std::vector<std::size_t> next;
  for (const std::size_t index : flow.order) {
    next.push_back(places[index]);
  }
  return std::make_unique<PluginChange>(name, std::move(incoming), std::move(next),
                                        std::move(flow.depends_on),
                                        old < plugins_.size() ? old : PluginChange::kIncoming);
}

bool ChangeControl::schedule(std::unique_ptr<PluginChange> change) noexcept {
  if (change_ != nullptr) {
    return false;
  }
  change_ = std::move(change);
  phase_ = Phase::waiting;
  return true;
}

void ChangeControl::begin(const Tick& tick) noexcept {
  if (phase_ != Phase::waiting) {
    return;
  }
  PluginChange& change = *change_;
  PluginSlot* const incoming = change.incoming();
  const bool replaces = change.outgoing_index() != PluginChange::kIncoming;
  ManagedPlugin* const old = replaces ? plugins_[change.outgoing_index()].plugin.get() : nullptr;
  if (old != nullptr) {
    old->take_answer();
  }
  if (incoming != nullptr && old != nullptr) {
    // One that is out of service, or whose process is away, has nothing to hand on that is of use; and one
    // that is stopped has nobody to hand it on to.
    const bool hands_on = plugins_[change.outgoing_index()].containment.is_stepped() &&
                          old->recovery() == Recovery::not_needed && incoming->containment.is_stepped();
    if (hands_on && !old->save_state(change.state())) {
      return fail(tick, "the running one cannot hand its state on", old->fault());
    }
    if (!incoming->plugin->restore_state(change.state())) {
      return fail(tick, "the new one refuses the state that is handed on", incoming->plugin->fault());
    }
  }
  if (old != nullptr && !old->hand_in(tick)) {
    events_.add(tick, EventKind::fault, old->name(), old->fault());
  }
  if (incoming != nullptr && old != nullptr) {
    incoming->plugin->take_outputs(*old);
  }
  if (old != nullptr) {
    old->take_snapshots();  // should it have to step in after all
  }
  trial_ = incoming;
  change.apply(plugins_.slots());
  phase_ = Phase::trial;
}

void ChangeControl::fail(const Tick& tick, std::string_view what, std::string_view why) noexcept {
  phase_ = Phase::failed;
  events_.add(tick, EventKind::error, change_->name(),
              format_into(change_->outcome(), "not changed: {}: {}", what, why));
}

void ChangeControl::take_back(const Tick& tick, std::string_view what, std::string_view why) noexcept {
  PluginChange& change = *change_;
  trial_ = nullptr;
  change.revert(plugins_.slots());
  const std::size_t old = change.outgoing_index();
  if (old != PluginChange::kIncoming) {
    plugins_[old].plugin->take_outputs(*change.incoming()->plugin);
    for (const auto& slot : plugins_.slots()) {
      slot->stepped = slot->stepped && !slot->depends_on[old];
    }
    plugins_[old].stepped = false;
  }
  fail(tick, what, why);
}

void ChangeControl::end_trial(const Tick& tick) noexcept {
  if (phase_ != Phase::trial) {
    return;
  }
  const PluginSlot* const outgoing = change_->outgoing();
  const std::string_view before = outgoing != nullptr ? outgoing->plugin->version() : "nothing";
  const std::string_view after = trial_ != nullptr ? trial_->plugin->version() : "nothing";
  events_.add(tick, EventKind::info, change_->name(),
              format_into(change_->outcome(), "in place of {} now {}; {} bytes of state handed on", before,
                          after, change_->state().size));
  trial_ = nullptr;
  phase_ = Phase::done;
}

bool ChangeControl::is_trial_to_blame(std::string_view topic) const noexcept {
  if (trial_ == nullptr || !plugins_.is_behind(*trial_, topic)) {
    return false;
  }
  const PluginSlot* const slot = plugins_.fault_behind(topic);
  const bool failed_before =
      slot != nullptr && (!slot->containment.is_stepped() || slot->containment.faults_in_a_row() > 1);
  return slot == trial_ ? slot->containment.is_stepped() : !failed_before;
}

void ChangeControl::set_parameter(std::string_view plugin, std::string_view parameter,
                                  const std::string& text) {
  ParameterChange change = prepare_parameter(plugin, parameter, text);
  if (!apply(change)) {
    throw PluginError(fmt::format("{}: parameter '{}': {}", change.slot->plugin->place(), parameter,
                                  change.slot->plugin->fault()));
  }
  keep(change);
}

ParameterChange ChangeControl::prepare_parameter(std::string_view plugin, std::string_view parameter,
                                                 const std::string& text) const {
  PluginSlot& slot = plugins_[plugins_.require(plugin)];
  ParameterChange change{&slot, std::string(parameter), text, {}, {}};
  change.value = slot.plugin->parameters().read_change(parameter, change.text);
  change.shown = value_text(change.value);
  return change;
}

bool ChangeControl::apply(ParameterChange& change) noexcept {
  ManagedPlugin& plugin = *change.slot->plugin;
  if (!plugin.set_parameter(change.parameter.c_str(), change.value)) {
    return false;
  }
  plugin.parameters().keep(change.parameter, change.shown);
  return true;
}

void ChangeControl::keep(const ParameterChange& change) {
  auto& entries = change.slot->entry.parameters;
  std::erase_if(entries, [&](const ParameterEntry& entry) { return entry.name == change.parameter; });
  entries.push_back({change.parameter, change.text, change.slot->entry.line});
}

std::optional<ChangeResult> ChangeControl::take_result() {
  if (phase_ != Phase::done && phase_ != Phase::failed) {
    return std::nullopt;
  }
  ChangeResult result{phase_ == Phase::done, change_->outcome().data(), nullptr};
  result.remains = std::move(change_);
  phase_ = Phase::none;
  return result;
}

}  // namespace gaitway::core
