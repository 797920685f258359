// Makes plug-ins from the entries of a configuration, in this process or in one of their own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "gaitway/instance/event_log.hpp"
#include "gaitway/instance/loaded_plugin.hpp"
#include "gaitway/manager/manager_options.hpp"
#include "gaitway/manager/plugin_set.hpp"
#include "gaitway/msgclient/client.hpp"
#include "isolation/isolated_plugin.hpp"

namespace gaitway::core {

// A plug-in's first moments in a throw-away process, before it comes near the manager's own: isolated, but
// without the bounds of one that stays so.
class PluginTrial {
 public:
  // Constructs the entry's plug-in there. Throws what constructing it here would throw; and PluginError when
  // it crashes or hangs.
  PluginTrial(const PluginEntry& entry, const PluginSource& source, const IsolationOptions& isolation);

  // Opens its inputs, activates it and steps it once, at the next batch after `now_ns`. What it publishes is
  // thrown away, and a fault of that step is no matter. Throws PluginError when it crashes or hangs.
  void first_step(msgclient::Client& client, std::int64_t now_ns);

 private:
  EventLog unheard_;
  IsolatedPlugin plugin_;
};

class PluginLoader {
 public:
  // All four outlive it.
  PluginLoader(const std::filesystem::path& configuration_file, const PluginManagerOptions& options,
               EventLog& events, msgclient::Client& client);

  // Constructs it. Throws ConfigurationError or PluginError.
  [[nodiscard]] std::unique_ptr<ManagedPlugin> load(const PluginEntry& entry);
  // In a throw-away process first, if it is to run in this one; else nullptr. Throws the same.
  std::unique_ptr<PluginTrial> try_out(const PluginEntry& entry) const;
  // Budget, fallback and watch of a plug-in whose topics are declared. Throws PluginError.
  void contain(PluginSlot& slot);

  [[nodiscard]] const std::filesystem::path& configuration_file() const noexcept {
    return configuration_file_;
  }
  [[nodiscard]] const SearchPath& search_path() const noexcept { return search_path_; }
  [[nodiscard]] EventLog& events() noexcept { return events_; }

 private:
  [[nodiscard]] PluginSource source() const {
    return {configuration_file_, options_.robot_directory, search_path_, options_.memory_socket};
  }

  const std::filesystem::path& configuration_file_;
  const PluginManagerOptions& options_;
  SearchPath search_path_;
  EventLog& events_;
  msgclient::Client& client_;
};

}  // namespace gaitway::core
