// In-process or isolated, and within which bounds.
#include "plugin_loader.hpp"

#include "isolation/isolated_plugin.hpp"
#include "stand_in.hpp"

namespace gaitway::core {

PluginLoader::PluginLoader(const std::filesystem::path& configuration_file,
                           const PluginManagerOptions& options, EventLog& events, msgclient::Client& client)
    : configuration_file_(configuration_file),
      options_(options),
      search_path_(plugin_search_path(options.plugin_path)),
      events_(events),
      client_(client) {}

std::unique_ptr<ManagedPlugin> PluginLoader::load(const PluginEntry& entry) {
  std::unique_ptr<ManagedPlugin> plugin;
  if (entry.isolation == Isolation::process) {
    plugin = std::make_unique<IsolatedPlugin>(entry, source(), options_.isolation, events_);
  } else {
    plugin = std::make_unique<LoadedPlugin>(entry, source(), events_);
  }
  plugin->check_schedule();
  return plugin;
}

std::unique_ptr<PluginTrial> PluginLoader::try_out(const PluginEntry& entry) const {
  return entry.isolation == Isolation::none
             ? std::make_unique<PluginTrial>(entry, source(), options_.isolation)
             : nullptr;
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
