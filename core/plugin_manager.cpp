// Set-up of the plug-ins as a whole, and the step.
#include "gaitway/core/plugin_manager.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gaitway::core {
namespace {

constexpr std::size_t kReportedPlugins = std::size(PluginStatistics{}.steps);

}  // namespace

PluginManager::PluginManager(const Configuration& configuration, const PluginManagerOptions& options,
                             msgclient::Client& client)
    : options_(options) {
  try {
    load(configuration);
    put_in_order(configuration, client);
    for (const auto& slot : slots_) {
      slot->plugin->bind(client);
    }
    try {
      statistics_writer_ = std::make_unique<msgclient::Writer<PluginStatistics>>(
          client.write<PluginStatistics>("plugin_statistics"));
    } catch (const msgclient::TopicError& error) {
      throw PluginError(fmt::format("the manager's statistics: {}", error.what()));
    }
    for (const auto& slot : slots_) {
      slot->plugin->activate();
    }
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

void PluginManager::load(const Configuration& configuration) {
  const SearchPath path = plugin_search_path(options_.plugin_path);
  const PluginSource source{configuration.file, options_.robot_directory, path};
  for (const PluginEntry& entry : configuration.plugins) {
    const auto same = [&entry](const auto& slot) { return slot->plugin->name() == entry.name; };
    if (std::any_of(slots_.begin(), slots_.end(), same)) {
      throw ConfigurationError(
          fmt::format("{}:{}: name: '{}' is there twice. Names must be unique: give one of them "
                      "another name",
                      configuration.file.string(), entry.line, entry.name));
    }
    auto slot = std::make_unique<Slot>();
    slot->plugin = std::make_unique<LoadedPlugin>(entry, source, events_);
    slots_.push_back(std::move(slot));
  }
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
  std::vector<std::unique_ptr<Slot>> ordered;
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
  for (const auto& slot : slots_) {
    slot->failed = false;
    if (slot->plugin->is_due(tick)) {
      slot->plugin->take_snapshots();
    }
  }
  int failed = 0;
  for (const auto& slot : slots_) {
    if (slot->plugin->is_due(tick)) {
      step(*slot, tick);
      failed += slot->failed ? 1 : 0;
    }
  }
  if (tick.batch) {
    publish_statistics(tick);
  }
  return failed;
}

void PluginManager::step(Slot& slot, const Tick& tick) noexcept {
  const std::int64_t begin_ns = wall_ns();
  slot.failed = !slot.plugin->step(tick);
  slot.last_step_ns = wall_ns() - begin_ns;
  slot.step_wall.add(slot.last_step_ns);
  ++slot.steps;
  if (slot.failed) {
    ++slot.faults;
    events_.add(tick.now_ns, tick.tick, EventKind::fault, slot.plugin->name(), slot.plugin->fault());
  }
}

void PluginManager::publish_statistics(const Tick& tick) noexcept {
  statistics_.stamp_ns = tick.now_ns;
  const std::size_t count = std::min(slots_.size(), kReportedPlugins);
  statistics_.plugin_count = static_cast<std::uint32_t>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Slot& slot = *slots_[i];
    statistics_.steps[i] = slot.steps;
    statistics_.faults[i] = slot.faults;
    statistics_.last_step_ns[i] = slot.last_step_ns;
    statistics_.worst_step_ns[i] = slot.step_wall.max_ns();
  }
  statistics_writer_->publish(statistics_, tick.now_ns);
}

const ManagedPlugin* PluginManager::fault_behind(std::string_view topic) const noexcept {
  const auto writes = [topic](const auto& slot) { return slot->plugin->uses(topic, Access::write); };
  const auto writer = std::find_if(slots_.begin(), slots_.end(), writes);
  for (std::size_t i = 0; writer != slots_.end() && i < slots_.size(); ++i) {
    if (slots_[i]->failed && (*writer)->depends_on[i]) {
      return slots_[i]->plugin.get();
    }
  }
  return nullptr;
}

bool PluginManager::uses(std::string_view topic) const noexcept {
  constexpr std::array kAccesses{Access::read, Access::read_previous, Access::read_optional, Access::write};
  return std::any_of(slots_.begin(), slots_.end(), [&](const auto& slot) {
    return std::any_of(kAccesses.begin(), kAccesses.end(),
                       [&](Access access) { return slot->plugin->uses(topic, access); });
  });
}

std::vector<PluginTiming> PluginManager::timings() const {
  std::vector<PluginTiming> result;
  for (const auto& slot : slots_) {
    result.push_back({slot->plugin->name(), slot->steps, slot->faults, slot->step_wall.summary()});
  }
  return result;
}

}  // namespace gaitway::core
