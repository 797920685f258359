// The copy of the simulation that people see: it keeps the pace of the clock, lets them command the robot
// through the robot API, and does to it what it is told.
//
// Told {"do": "pace", "playing", "speed"} it plays or pauses; {"do": "order", "id", "order"} is a step, an
// event to apply, a push, or the question of the geometry (README.md), and is answered with {"answer": id,
// "ok", "text" or "result"}. It reports some fifty times a second: {"at_ns", "events", "digests", "bar",
// "state"}.
#pragma once

#include <filesystem>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/timeline/copy_channel.hpp"
#include "gaitway/timeline/replayed_run.hpp"

namespace gaitway::timeline {

struct LiveOptions {
  std::filesystem::path
      memory_socket;      // where the memory block is to be had; as the main controller's options say
  core::PluginEntry api;  // the robot's side of the robot API
  std::int64_t digest_every_ns = 0;  // whole milliseconds
  bool quiet = false;                // no events on stderr
};

// Until its channel ends: then ChannelEnded is thrown. Starts the plug-in `api`, and returns nothing before.
// Throws what its start throws.
[[noreturn]] void live(const LiveOptions& options, ReplayedRun& run, const CopyChannel& channel,
                       const nlohmann::json& told);

}  // namespace gaitway::timeline
