// In-process or isolated, tried before or not, and within which bounds.
#include "plugin_loader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/manager/fallback.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {
namespace {

constexpr std::int64_t kStartLimit_ns = 5'000'000'000;  // what takes longer is taken to hang

IsolationOptions trial_options(IsolationOptions options) {
  options.lock_step = true;
  options.start_limit_ns = std::min(options.start_limit_ns, kStartLimit_ns);
  options.memory_limit_bytes = 0;
  return options;
}

}  // namespace

PluginTrial::PluginTrial(const PluginEntry& entry, const PluginSource& source,
                         const IsolationOptions& isolation)
    : plugin_(entry, source, trial_options(isolation), unheard_) {}

void PluginTrial::first_step(msgclient::Client& client, std::int64_t now_ns) {
  plugin_.bind_inputs(client);
  plugin_.activate();
  Tick tick = tick_at(now_ns);
  while (!tick.batch) {
    tick = tick_at(next_tick_ns(tick.now_ns));
  }
  plugin_.take_snapshots();
  plugin_.prepare(tick);
  plugin_.discard();
  if (plugin_.recovery() != Recovery::not_needed) {
    throw PluginError(fmt::format("{}: tried in a process of its own: {}", plugin_.place(), plugin_.fault()));
  }
}

PluginLoader::PluginLoader(const std::filesystem::path& configuration_file,
                           const PluginManagerOptions& options, EventLog& events, msgclient::Client& client)
    : configuration_file_(configuration_file),
      options_(options),
      search_path_(plugin_search_path(options.plugin_path)),
      events_(events),
      client_(client) {}

std::unique_ptr<ManagedPlugin> PluginLoader::load(const PluginEntry& entry) {
  std::unique_ptr<ManagedPlugin> plugin;
  if (is_python(entry.library) && !options_.simulated) {
    throw PluginError(fmt::format(
        "{}:{}: plug-in '{}' is written in Python ({}), which is for simulated robots alone; this message "
        "controller does not say that its robot is one. Write it in C++",
        configuration_file_.string(), entry.line, entry.name, entry.library));
  }
  if (has_own_process(entry)) {
    plugin = std::make_unique<IsolatedPlugin>(entry, source(), options_.isolation, events_);
  } else {
    plugin = std::make_unique<LoadedPlugin>(entry, source(), events_);
  }
  plugin->check_schedule();
  return plugin;
}

std::unique_ptr<PluginTrial> PluginLoader::try_out(const PluginEntry& entry) const {
  return has_own_process(entry) ? nullptr
                                : std::make_unique<PluginTrial>(entry, source(), options_.isolation);
}

void PluginLoader::contain(PluginSlot& slot) {
  ContainmentSettings settings = slot.entry.containment;
  if (slot.plugin->node().uses.empty()) {
    settings.fallback = FallbackKind::by_topics;  // of a stand-in that has nothing to write
  }
  const FallbackSource source{client_, options_.robot_directory};
  slot.containment =
      Containment(settings, slot.plugin->period(), FallbackSet(*slot.plugin, settings.fallback, source));
  if (dynamic_cast<const StandIn*>(slot.plugin.get()) != nullptr) {
    slot.containment.stop();
  } else if (options_.step_watch != nullptr) {
    slot.watch_id = options_.step_watch->add(slot.plugin->name());
  }
}

}  // namespace gaitway::core
