// Set-up of the plug-ins as a whole, and the step.
#include "gaitway/manager/plugin_manager.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolation/isolated_plugin.hpp"
#include "plugin_trial.hpp"

namespace gaitway::core {
namespace {

bool lies_in(const std::filesystem::path& inner, const std::filesystem::path& outer) {
  const std::filesystem::path path =
      std::filesystem::weakly_canonical(inner).lexically_relative(std::filesystem::weakly_canonical(outer));
  return !path.empty() && *path.begin() != "..";
}

// Whoever takes over a plug-in that serves the network writes files there: none of them must be loaded.
void require_apart(const PluginEntry& server, const Configuration& configuration, const SearchPath& path) {
  const auto refuse = [&](const std::filesystem::path& place) {
    throw ConfigurationError(fmt::format(
        "{}:{}: writes = '{}': '{}' lies there, from which plug-ins are loaded. Choose a folder of its own",
        configuration.file.string(), server.line, server.child.writes.string(), place.string()));
  };
  for (const std::filesystem::path& folder : path) {
    if (lies_in(folder, server.child.writes)) {
      refuse(folder);
    }
  }
  for (const PluginEntry& entry : configuration.plugins) {
    const std::filesystem::path file = configuration.file.parent_path() / entry.library;
    if (entry.library.find('/') != std::string::npos && lies_in(file, server.child.writes)) {
      refuse(file);
    }
  }
}

}  // namespace

PluginManager::PluginManager(const Configuration& configuration, const PluginManagerOptions& options,
                             msgclient::Client& client)
    : options_(options),
      configuration_file_(configuration.file),
      search_path_(plugin_search_path(options.plugin_path)),
      client_(client) {
  try {
    load_all(configuration);
    put_in_order(configuration, client);
    for (const auto& slot : slots_) {
      slot->plugin->bind(client);
      contain(*slot);
    }
    try {
      statistics_writer_ = std::make_unique<msgclient::Writer<PluginStatistics>>(
          client.write<PluginStatistics>("plugin_statistics"));
    } catch (const msgclient::TopicError& error) {
      throw PluginError(fmt::format("the manager's statistics: {}", error.what()));
    }
    for (const auto& slot : slots_) {
      const WatchedCall call(watch_of(slot->entry), slot->watch_id);
      slot->plugin->activate();
    }
    events_.collect();
  } catch (...) {
    unload();
    throw;
  }
}

PluginManager::~PluginManager() {
  unload();
}

void PluginManager::unload() noexcept {
  for (auto slot = slots_.rbegin(); slot != slots_.rend(); ++slot) {
    (*slot)->plugin->deactivate();
  }
  while (!slots_.empty()) {
    slots_.pop_back();
  }
}

std::unique_ptr<ManagedPlugin> PluginManager::load(const PluginEntry& entry) {
  std::unique_ptr<ManagedPlugin> plugin;
  if (entry.isolation == Isolation::process) {
    plugin = std::make_unique<IsolatedPlugin>(entry, source(), options_.isolation, events_);
  } else {
    plugin = std::make_unique<LoadedPlugin>(entry, source(), events_);
  }
  plugin->check_schedule();
  return plugin;
}

void PluginManager::maintain(std::int64_t now_ns) noexcept {
  for (const auto& slot : slots_) {
    slot->plugin->maintain(now_ns);
  }
}

void PluginManager::load_all(const Configuration& configuration) {
  for (const PluginEntry& entry : configuration.plugins) {
    if (index_of(entry.name) < slots_.size()) {
      throw ConfigurationError(
          fmt::format("{}:{}: name: '{}' is there twice. Names must be unique: give one of them "
                      "another name",
                      configuration.file.string(), entry.line, entry.name));
    }
    if (!entry.child.writes.empty()) {
      require_apart(entry, configuration, search_path_);
    }
    if (std::find(options_.left_out.begin(), options_.left_out.end(), entry.name) !=
        options_.left_out.end()) {
      continue;
    }
    if (options_.try_at_start && entry.isolation == Isolation::none) {
      const PluginTrial trial(entry, source(), options_.isolation);
    }
    auto slot = std::make_unique<PluginSlot>();
    slot->watch_id = options_.step_watch == nullptr ? 0 : options_.step_watch->add(entry.name);
    {
      const WatchedCall call(watch_of(entry), slot->watch_id);
      slot->plugin = load(entry);
    }
    slot->entry = entry;
    slot->configured = slots_.size();
    slots_.push_back(std::move(slot));
  }
  add_stand_ins(configuration);
}

void PluginManager::put_in_order(const Configuration& configuration, const msgclient::Client& client) {
  std::vector<DataFlowNode> nodes;
  for (const auto& slot : slots_) {
    nodes.push_back(slot->plugin->node());
  }
  std::vector<ExternalTopic> external;
  for (const msgclient::TopicInfo& topic : client.directory()) {
    external.push_back({topic.descriptor.name, topic.writer});
  }
  const DataFlow flow = [&] {
    try {
      return order_by_data_flow(nodes, external);
    } catch (const PluginError& error) {
      throw PluginError(fmt::format("{}: {}", configuration.file.string(), error.what()));
    }
  }();
  std::vector<std::unique_ptr<PluginSlot>> ordered;
  for (const std::size_t index : flow.order) {
    for (const std::size_t other : flow.order) {
      slots_[index]->depends_on.push_back(flow.depends_on[index][other]);
    }
  }
  for (const std::size_t index : flow.order) {
    ordered.push_back(std::move(slots_[index]));
  }
  slots_ = std::move(ordered);
}

int PluginManager::step(const Tick& tick) noexcept {
  end_trial(tick);
  declared_cost_ns_ = 0;
  events_.set_time(tick);
  for (const auto& slot : slots_) {
    slot->stepped = !slot->plugin->is_due(tick);
    if (!slot->stepped) {
      slot->failed = slot->covered = false;  // of the others, what became of their last turn still counts
    }
  }
  if (tick.batch && change_phase_ == ChangePhase::waiting) {
    begin_change(tick);
  }
  for (const auto& slot : slots_) {
    if (!slot->stepped) {
      slot->plugin->take_snapshots();
    }
  }
  const int failed = step_all(tick);
  events_.collect();
  if (tick.batch) {
    publish_statistics(tick);
  }
  return failed;
}

// Those that have not had their turn yet, in order; anew from the start when the order changes on the way.
int PluginManager::step_all(const Tick& tick) noexcept {
  int failed = 0;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    PluginSlot& slot = *slots_[i];
    if (slot.stepped) {
      continue;
    }
    step(slot, tick);
    if (slot.failed && &slot == trial_ && slot.containment.is_stepped()) {
      take_change_back(tick, "the new one failed in its first step", slot.plugin->fault());
      return failed + step_all(tick);
    }
    failed += slot.failed ? 1 : 0;
  }
  return failed;
}

void PluginManager::set_parameter(std::string_view plugin, std::string_view parameter,
                                  const std::string& text) {
  ParameterChange change = prepare_parameter(plugin, parameter, text);
  if (!apply(change)) {
    throw PluginError(fmt::format("{}: parameter '{}': {}", change.slot->plugin->place(), parameter,
                                  change.slot->plugin->fault()));
  }
  keep(change);
}

ParameterChange PluginManager::prepare_parameter(std::string_view plugin, std::string_view parameter,
                                                 const std::string& text) const {
  PluginSlot& slot = *slots_[require(plugin)];
  ParameterChange change{&slot, std::string(parameter), text, {}, {}};
  change.value = slot.plugin->parameters().read_change(parameter, change.text);
  change.shown = value_text(change.value);
  return change;
}

bool PluginManager::apply(ParameterChange& change) noexcept {
  ManagedPlugin& plugin = *change.slot->plugin;
  if (!plugin.set_parameter(change.parameter.c_str(), change.value)) {
    return false;
  }
  plugin.parameters().keep(change.parameter, change.shown);
  return true;
}

void PluginManager::keep(const ParameterChange& change) {
  auto& entries = change.slot->entry.parameters;
  std::erase_if(entries, [&](const ParameterEntry& entry) { return entry.name == change.parameter; });
  entries.push_back({change.parameter, change.text, change.slot->entry.line});
}

void PluginManager::copy_value(std::string_view plugin, std::size_t parameter,
                               std::span<char> to) const noexcept {
  to[0] = '\0';
  const std::size_t index = index_of(plugin);
  if (index == slots_.size() || parameter >= slots_[index]->plugin->parameters().declared().size()) {
    return;
  }
  const std::string& value = slots_[index]->plugin->parameters().declared()[parameter].value;
  const std::size_t length = std::min(value.size(), to.size() - 1);
  std::copy_n(value.begin(), length, to.begin());
  to[length] = '\0';
}

bool PluginManager::serves_network(std::string_view plugin) const noexcept {
  const std::size_t index = index_of(plugin);
  return index < slots_.size() && slots_[index]->entry.child.serves_network;
}

const ManagedPlugin* PluginManager::fault_behind(std::string_view topic) const noexcept {
  const PluginSlot* const slot = slot_behind(topic);
  return slot == nullptr ? nullptr : slot->plugin.get();
}

bool PluginManager::is_trial_to_blame(std::string_view topic) const noexcept {
  if (trial_ == nullptr || !is_behind(*trial_, topic)) {
    return false;
  }
  const PluginSlot* const slot = slot_behind(topic);
  const bool failed_before =
      slot != nullptr && (!slot->containment.is_stepped() || slot->containment.faults_in_a_row() > 1);
  return slot == trial_ ? slot->containment.is_stepped() : !failed_before;
}

// One that nobody writes any more has its last writer behind it, whoever that was.
bool PluginManager::is_behind(const PluginSlot& slot, std::string_view topic) const noexcept {
  const auto writes = [topic](const auto& other) { return other->plugin->uses(topic, Access::write); };
  const auto writer = std::find_if(slots_.begin(), slots_.end(), writes);
  for (std::size_t i = 0; writer != slots_.end() && i < slots_.size(); ++i) {
    if (slots_[i].get() == &slot) {
      return (*writer)->depends_on[i];
    }
  }
  return true;
}

const PluginSlot* PluginManager::slot_behind(std::string_view topic) const noexcept {
  const auto writes = [topic](const auto& slot) { return slot->plugin->uses(topic, Access::write); };
  const auto writer = std::find_if(slots_.begin(), slots_.end(), writes);
  for (std::size_t i = 0; writer != slots_.end() && i < slots_.size(); ++i) {
    if (slots_[i]->failed && !slots_[i]->covered && (*writer)->depends_on[i]) {
      return slots_[i].get();
    }
  }
  return nullptr;
}

bool PluginManager::uses(std::string_view topic) const noexcept {
  const auto reads = [topic](FallbackKind kind) {
    const auto topics = topics_read_by(kind);
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
  };
  return std::any_of(slots_.begin(), slots_.end(), [&](const auto& slot) {
    const auto& fallbacks = slot->containment.fallbacks().kinds();
    return std::any_of(kAccesses.begin(), kAccesses.end(),
                       [&](Access access) { return slot->plugin->uses(topic, access); }) ||
           std::any_of(fallbacks.begin(), fallbacks.end(), reads);
  });
}

std::vector<PluginTiming> PluginManager::timings() const {
  std::vector<PluginTiming> result;
  for (const auto& slot : slots_) {
    result.push_back({slot->plugin->name(), slot->steps, slot->faults, slot->step_wall.summary(),
                      slot->containment.overruns(), slot->containment.state()});
  }
  return result;
}

}  // namespace gaitway::core
