// Set-up of the plug-ins as a whole, and the step.
#include "gaitway/manager/plugin_manager.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/input/complaint.hpp"
#include "plugin_loader.hpp"

namespace gaitway::core {

PluginManager::PluginManager(const Configuration& configuration, const PluginManagerOptions& options,
                             msgclient::Client& client)
    : options_(options),
      configuration_file_(configuration.file),
      loader_(std::make_unique<PluginLoader>(configuration_file_, options_, events_, client)),
      changes_(plugins_, *loader_, client) {
  load_all(configuration, client);
  plugins_.put_in_order(configuration_file_, client);
  for (const auto& slot : plugins_.slots()) {
    slot->plugin->bind(client);
    loader_->contain(*slot);
  }
  try {
    runner_.emplace(options_, events_, client);
  } catch (const msgclient::TopicError& error) {
    throw PluginError(fmt::format("the manager's statistics: {}", error.what()));
  }
  activate_all();
}

PluginManager::~PluginManager() = default;

void PluginManager::activate_all() {
  for (const auto& slot : plugins_.slots()) {
    const WatchedCall call(watch_of(slot->entry), slot->watch_id);
    slot->plugin->activate();
  }
  events_.collect();
}

void PluginManager::load_all(const Configuration& configuration, const msgclient::Client& client) {
  for (const PluginEntry& entry : configuration.plugins) {
    if (plugins_.index_of(entry.name) < plugins_.size()) {
      throw ConfigurationError(
          fmt::format("{}:{}: name: '{}' is there twice. Names must be unique: give one of them "
                      "another name",
                      configuration.file.string(), entry.line, entry.name));
    }
    if (std::ranges::find(options_.stopped, entry.name) != options_.stopped.end()) {
      continue;
    }
    if (options_.try_at_start) {
      loader_->try_out(entry);
    }
    const std::uint32_t watch_id = options_.step_watch == nullptr ? 0 : options_.step_watch->add(entry.name);
    const WatchedCall call(watch_of(entry), watch_id);
    std::unique_ptr<ManagedPlugin> plugin = loader_->load(entry);
    plugins_.add(entry).plugin = std::move(plugin);
  }
  add_stand_ins(configuration, client);
}

void PluginManager::add_stand_ins(const Configuration& configuration, const msgclient::Client& client) {
  std::vector<DataFlowNode> loaded = plugins_.nodes();
  const std::vector<ExternalTopic> external = external_topics(client);
  for (const std::string& name : options_.stopped) {
    const auto entry = std::ranges::find(configuration.plugins, name, &PluginEntry::name);
    if (entry == configuration.plugins.end()) {
      std::vector<std::string> names;
      for (const PluginEntry& other : configuration.plugins) {
        names.push_back(other.name);
      }
      throw PluginError(fmt::format("{}: there is no plug-in '{}' to do without. {}",
                                    configuration.file.string(), name, input::suggest(name, names)));
    }
    const std::vector<std::string> topics = StandIn::topics_for(*entry, loaded, external);
    events_.add(
        0, 0, EventKind::warning, name,
        topics.empty() ? "stopped" : fmt::format("stopped; fallbacks write {}", fmt::join(topics, ", ")));
    PluginSlot& slot = plugins_.add(*entry);
    slot.plugin = std::make_unique<StandIn>(*entry, topics, configuration.file, events_);
    loaded.push_back(slot.plugin->node());
  }
}

void PluginManager::maintain(std::int64_t now_ns) noexcept {
  for (const auto& slot : plugins_.slots()) {
    slot->plugin->maintain(now_ns);
  }
}

int PluginManager::step(const Tick& tick) noexcept {
  end_trial(tick);
  events_.set_time(tick);
  runner_->begin(plugins_, tick);
  if (tick.batch) {
    changes_.begin(tick);
  }
  for (const auto& slot : plugins_.slots()) {
    if (!slot->stepped) {
      slot->plugin->take_snapshots();
    }
  }
  const int failed = step_all(tick);
  events_.collect();
  if (tick.batch) {
    runner_->publish_statistics(plugins_, tick);
  }
  return failed;
}

// Anew from the start when the order changes on the way.
int PluginManager::step_all(const Tick& tick) noexcept {
  const PluginSlot* const trial = changes_.trial();
  const StepRunner::Outcome outcome = runner_->step_all(plugins_, tick, trial);
  if (!outcome.trial_failed) {
    return outcome.failed;
  }
  changes_.take_back(tick, "the new one failed in its first step", trial->plugin->fault());
  return outcome.failed + runner_->step_all(plugins_, tick, nullptr).failed;
}

bool PluginManager::take_trial_back(const Tick& tick, std::string_view why) noexcept {
  if (changes_.trial() == nullptr) {
    return false;
  }
  changes_.take_back(tick, "the robot cannot go on with what it does", why);
  step_all(tick);
  return true;
}

}  // namespace gaitway::core
