// A plug-in's first moments in a throw-away process, before it comes near the manager's own.
#pragma once

#include <cstdint>

#include "gaitway/manager/loaded_plugin.hpp"
#include "gaitway/msgclient/client.hpp"
#include "isolation/isolated_plugin.hpp"

namespace gaitway::core {

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

}  // namespace gaitway::core
