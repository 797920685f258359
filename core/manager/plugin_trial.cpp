// An isolated plug-in without the bounds of one: in the end it is to run in-process.
#include "plugin_trial.hpp"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace gaitway::core
