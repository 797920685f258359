// One plug-in after the other, and what is made of its step.
#include "gaitway/manager/step_runner.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace gaitway::core {
namespace {

constexpr double kJump = 1000.0;

// Onto a number of each output's field.
double offset_of(PluginFaultKind kind) noexcept {
  return kind == PluginFaultKind::not_a_number ? std::numeric_limits<double>::quiet_NaN()
         : kind == PluginFaultKind::jumps      ? kJump
                                               : 0.0;
}

}  // namespace

StepRunner::StepRunner(const PluginManagerOptions& options, EventLog& events, msgclient::Client& client)
    : options_(options),
      events_(events),
      statistics_writer_(client.write<PluginStatistics>("plugin_statistics")) {}

void StepRunner::begin(PluginSet& plugins, const Tick& tick) noexcept {
  declared_cost_ns_ = 0;
  for (const auto& slot : plugins.slots()) {
    slot->stepped = !slot->plugin->is_due(tick);
    if (!slot->stepped) {
      slot->failed = slot->covered = false;  // of the others, what became of their last turn still counts
    }
  }
}

StepRunner::Outcome StepRunner::step_all(PluginSet& plugins, const Tick& tick,
                                         const PluginSlot* trial) noexcept {
  Outcome outcome;
  for (const auto& slot : plugins.slots()) {
    if (slot->stepped) {
      continue;
    }
    const bool on_trial = slot.get() == trial;
    step(*slot, tick, on_trial);
    if (slot->failed && on_trial && slot->containment.is_stepped()) {
      outcome.trial_failed = true;
      return outcome;
    }
    outcome.failed += slot->failed ? 1 : 0;
  }
  return outcome;
}

void StepRunner::step(PluginSlot& slot, const Tick& tick, bool on_trial) noexcept {
  slot.stepped = true;
  if (!slot.containment.is_stepped()) {
    slot.covered = slot.containment.fallbacks().act(tick, *slot.plugin);
    slot.failed = !slot.covered || slot.containment.state() == ServiceState::out_of_service;
    return;
  }
  const PluginFault injected = options_.injected_faults == nullptr
                                   ? PluginFault{}
                                   : options_.injected_faults->at(slot.plugin->name(), tick.now_ns);
  if (on_trial) {
    slot.plugin->answer_at_once();
  }
  const std::int64_t begin_ns = wall_ns();
  const bool fine = run_step(slot, tick, injected.kind);
  slot.last_step_ns = wall_ns() - begin_ns;
  slot.step_wall.add(slot.last_step_ns);
  slot.worst_input_age_ns = std::max(slot.worst_input_age_ns, slot.plugin->take_input_age_ns());
  ++slot.steps;
  declared_cost_ns_ += injected.cost_ns;
  const std::int64_t cost_ns = injected.cost_ns + (options_.wall_time_decides ? slot.last_step_ns : 0);
  const bool overrun = fine && slot.containment.is_over_budget(cost_ns);
  if (overrun) {
    std::array<char, 80> text{};
    slot.plugin->set_fault(format_into(text, "took {} us; its budget is {} us", cost_ns / 1000,
                                       slot.containment.budget_ns() / 1000));
  }
  if (fine && !overrun && slot.plugin->is_under_way()) {
    keep_verdict(slot, tick);
    return;
  }
  slot.failed = !fine || overrun;
  slot.failed ? note_fault(slot, tick, overrun, on_trial) : note_success(slot, tick);
}

bool StepRunner::run_step(PluginSlot& slot, const Tick& tick, PluginFaultKind injected) noexcept {
  if (injected == PluginFaultKind::throws) {
    slot.plugin->set_fault("a fault that was injected: step() threw");
    return false;
  }
  const WatchedCall call(options_.step_watch, slot.watch_id);
  return slot.plugin->prepare(tick, offset_of(injected));
}

// A step without an answer yet: what the last answer was still counts.
void StepRunner::keep_verdict(PluginSlot& slot, const Tick& tick) noexcept {
  slot.failed = slot.containment.state() == ServiceState::failing;
  if (slot.failed) {
    slot.covered = slot.containment.fallbacks().act(tick, *slot.plugin);
  }
}

void StepRunner::note_success(PluginSlot& slot, const Tick& tick) noexcept {
  slot.plugin->commit();
  const std::int64_t since_ns = slot.containment.failing_since_ns();
  const std::uint64_t faults = slot.containment.note_success(tick);
  if (faults == 0 || slot.containment.fallbacks().is_none()) {
    return;
  }
  std::array<char, 100> text{};
  events_.add(tick, EventKind::info, slot.plugin->name(),
              format_into(text, "works again, after {} faults since {:.3f} s", faults,
                          static_cast<double>(since_ns) * 1e-9));
}

void StepRunner::note_fault(PluginSlot& slot, const Tick& tick, bool overrun, bool on_trial) noexcept {
  slot.plugin->discard();
  ++slot.faults;
  const std::string& name = slot.plugin->name();
  Containment& containment = slot.containment;
  const Recovery recovery = slot.plugin->recovery();
  if (containment.is_news(tick, recovery)) {
    events_.add(tick, EventKind::fault, name, slot.plugin->fault());
  }
  if (on_trial) {
    return;  // the old one takes its turn
  }
  FallbackSet& fallbacks = containment.fallbacks();
  const bool given_up = containment.note_fault(tick, overrun, recovery);
  const bool first = containment.faults_in_a_row() == 1;
  slot.covered = fallbacks.act(tick, *slot.plugin);
  std::array<char, 250> text{};
  if (given_up) {
    events_.add(
        tick, EventKind::error, name,
        format_into(text,
                    "out of service after {} faults since {:.3f} s ({} since start); fallback: {}; "
                    "the last fault: {}",
                    containment.reason().faults, static_cast<double>(containment.reason().since_ns) * 1e-9,
                    slot.faults, fallbacks.name(), slot.plugin->fault()));
  } else if (first && !fallbacks.is_none()) {
    events_.add(tick, EventKind::warning, name,
                format_into(text, "fallback '{}' stands in", fallbacks.name()));
  }
}

// Percentiles cost some microseconds each: one plug-in a batch.
void StepRunner::publish_statistics(PluginSet& plugins, const Tick& tick) noexcept {
  const std::size_t count = std::min<std::size_t>(plugins.size(), kReportedPlugins);
  statistics_.stamp_ns = tick.now_ns;
  statistics_.plugin_count = static_cast<std::uint32_t>(count);
  if (count > 0) {
    PluginSlot& slot = plugins[tick.batch_sequence % count];
    slot.p50_step_ns = static_cast<std::int64_t>(slot.step_wall.percentile_ns(0.5));
    slot.p99_step_ns = static_cast<std::int64_t>(slot.step_wall.percentile_ns(0.99));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const PluginSlot& slot = plugins[i];
    const std::string& name = slot.plugin->name();
    std::fill(std::begin(statistics_.name[i]), std::end(statistics_.name[i]), std::uint8_t{0});
    std::copy_n(name.begin(), std::min(name.size(), std::size(statistics_.name[i]) - 1), statistics_.name[i]);
    statistics_.steps[i] = slot.steps;
    statistics_.faults[i] = slot.faults;
    statistics_.overruns[i] = slot.containment.overruns();
    statistics_.state[i] = static_cast<std::uint32_t>(slot.containment.state());
    statistics_.budget_ns[i] = slot.containment.budget_ns();
    statistics_.last_step_ns[i] = slot.last_step_ns;
    statistics_.p50_step_ns[i] = slot.p50_step_ns;
    statistics_.p99_step_ns[i] = slot.p99_step_ns;
    statistics_.worst_step_ns[i] = slot.step_wall.max_ns();
    statistics_.worst_input_age_ns[i] = slot.worst_input_age_ns;
  }
  statistics_writer_.publish(statistics_, tick.now_ns);
}

}  // namespace gaitway::core
