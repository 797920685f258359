// What a plug-in manager is told beside its configuration.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/instance/plugin_library.hpp"
#include "gaitway/isolation/settings.hpp"
#include "gaitway/manager/plugin_fault_table.hpp"
#include "gaitway/manager/step_watch.hpp"

namespace gaitway::core {

// How long things take, for reports. nullptr: nothing is measured.
using WallClock = std::int64_t (*)() noexcept;
inline std::int64_t steady_clock_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

struct PluginManagerOptions {
  std::filesystem::path robot_directory;
  SearchPath plugin_path;                   // before GAITWAY_PLUGIN_PATH and the shipped plug-ins
  WallClock wall_clock = &steady_clock_ns;  // measures steps; nullptr: they count as 0
  IsolationOptions isolation = {};          // of plug-ins in processes of their own
  // Whether measured time counts against the budgets, as in real time. In virtual time only declared costs
  // do.
  bool wall_time_decides = false;
  const PluginFaultTable* injected_faults = nullptr;  // nullptr: none; outlives the manager
  StepWatch* step_watch = nullptr;                    // nullptr: nobody watches; outlives the manager
  // Whether each in-process plug-in is first constructed in a throw-away process, so that one that crashes or
  // hangs there is refused by name. Changes at run time always go that way.
  bool try_at_start = false;
  // No robot of metal: plug-ins in Python are loaded.
  bool simulated = false;
  // Of the configuration's plug-ins: not loaded; fallbacks write their topics.
  std::vector<std::string> stopped = {};
  // Where the memory block's server takes clients: for plug-ins that are clients of their own. Empty:
  // nowhere.
  std::filesystem::path memory_socket = {};
};

}  // namespace gaitway::core
