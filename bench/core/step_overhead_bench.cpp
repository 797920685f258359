// What the manager adds to a plug-in's step: the same plug-ins once under a manager as in real time (clock,
// budgets, step watch, fallbacks), once called straight through their function table with a bare copy for
// each topic.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "direct_host.hpp"
#include "gaitway/instance/plugin_instance.hpp"
#include "gaitway/manager/plugin_manager.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "rivals.hpp"

namespace gaitway::core {
namespace {

constexpr double kMost_us = 1.0;  // a plug-in and step
enum : std::size_t { kManaged, kDirect, kManagedBatch, kDirectBatch, kWays };

PluginManagerOptions real_time_options(StepWatch& watch) {
  PluginManagerOptions options;
  options.robot_directory = GAITWAY_TEST_ROBOT;
  options.plugin_path = {GAITWAY_TEST_PLUGINS};
  options.wall_time_decides = true;
  options.step_watch = &watch;
  return options;
}

// The tick of either, in turns; those that prepare a batch apart.
template <class Before, class Managed, class Direct>
void step_both(benchmark::State& state, Rivals& rivals, const Before& before, const Managed& managed,
               const Direct& direct) {
  std::int64_t now_ns = kTickPhase_ns;
  for (auto iteration : state) {
    std::int64_t sum_ns = 0;
    for (std::uint32_t slot = 0; slot < facts::kSlotsPerCycle; ++slot) {
      const Tick tick = tick_at(now_ns);
      before(tick);
      const std::int64_t begin_ns = steady_clock_ns();
      managed(tick);
      const std::int64_t end_ns = steady_clock_ns();
      rivals.add(tick.batch ? kManagedBatch : kManaged, end_ns - begin_ns);
      sum_ns += end_ns - begin_ns;
      rivals.time(tick.batch ? kDirectBatch : kDirect, [&] { direct(tick); });
      now_ns += facts::kSlot_ns;
    }
    state.SetIterationTime(static_cast<double>(sum_ns) * 1e-9 / facts::kSlotsPerCycle);
  }
}

void judge_overhead(benchmark::State& state, const Rivals& rivals, double plugins, bool every_batch) {
  const auto each = [&](std::size_t rival) { return rivals.percentile_us(rival) / plugins; };
  const double batch = each(kManagedBatch) - each(kDirectBatch);
  const double overhead = every_batch ? batch : each(kManaged) - each(kDirect);
  state.counters["managed_us"] = each(every_batch ? kManagedBatch : kManaged);
  state.counters["direct_us"] = each(every_batch ? kDirectBatch : kDirect);
  state.counters["overhead_us"] = overhead;
  state.counters["overhead_batch_us"] = batch;  // with the statistics that the manager publishes
  judge(state, overhead <= kMost_us, "at most 1 us a plug-in and step");
}

// Each reads the topic of the one before.
void overhead_of_chain(benchmark::State& state) {
  const std::int64_t length = state.range(0);
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("bench");
  StepWatch watch = StepWatch::make();
  const PluginLibrary library("relay.so", {}, {GAITWAY_TEST_PLUGINS});
  DirectTopics topics;
  std::vector<std::unique_ptr<DirectPlugin>> plugins;
  std::string text = "plugins:\n";
  for (std::int64_t i = 0; i < length; ++i) {
    const std::string to = fmt::format("t{}", i), from = i == 0 ? "" : fmt::format("t{}", i - 1);
    text += fmt::format(
        "  - {{name: p{}, library: relay.so, budget: 80 ms, parameters: {{to: {}, from: '{}'}}}}\n", i, to,
        from);
    plugins.push_back(std::make_unique<DirectPlugin>(
        library.entry(), topics, "", std::map<std::string, std::string>{{"to", to}, {"from", from}}));
    plugins.back()->activate();
  }
  PluginManager manager(parse_configuration(text, "bench.yaml"), real_time_options(watch), client);
  Rivals rivals(kWays);
  step_both(
      state, rivals, [](const Tick&) {}, [&](const Tick& tick) { manager.step(tick); },
      [&](const Tick& tick) {
        for (const auto& plugin : plugins) {
          plugin->step(abi_tick(tick));
        }
      });
  judge_overhead(state, rivals, static_cast<double>(length), false);
}
BENCHMARK(overhead_of_chain)->Arg(1)->Arg(8)->UseManualTime()->Iterations(20000);

// A topic from elsewhere, for both.
template <class T>
class Surrounding {
 public:
  Surrounding(msgclient::Client& client, DirectTopics& topics, const char* name)
      : writer_(client.write<T>(name)), direct_(topics[name]) {}
  void write(std::int64_t now_ns) {
    const T value{};
    writer_.publish(value, now_ns);
    std::memcpy(direct_.value.data(), &value, sizeof value);
    direct_.stamp_ns = now_ns;
    ++direct_.sequence;
  }

 private:
  msgclient::Writer<T> writer_;
  DirectTopic& direct_;
};

// A shipped plug-in alone. `write(now_ns)` writes what it reads.
template <class Write>
void step_shipped(benchmark::State& state, const char* file, msgclient::MemoryBlock& block,
                  DirectTopics& topics, const Write& write) {
  msgclient::Client client = block.local_client("bench");
  StepWatch watch = StepWatch::make();
  const PluginLibrary library(file, {}, {});
  DirectPlugin direct(library.entry(), topics, GAITWAY_TEST_ROBOT);
  PluginManager manager(
      parse_configuration("plugins:\n  - {name: it, library: " + std::string(file) + ", budget: 80 ms}\n",
                          "bench.yaml"),
      real_time_options(watch), client);
  direct.activate();
  const bool every_batch = manager.plugin(0).period() == Period::batch;
  Rivals rivals(kWays);
  int failed = 0;
  step_both(
      state, rivals, write, [&](const Tick& tick) { failed += manager.step(tick); },
      [&](const Tick& tick) {
        failed += (tick.batch || !every_batch) && direct.step(abi_tick(tick)) != GAITWAY_OK ? 1 : 0;
      });
  if (failed > 0) {
    state.SkipWithError("the plug-in failed: nothing was measured");
    return;
  }
  judge_overhead(state, rivals, 1.0, every_batch);
}

void overhead_of_stability(benchmark::State& state) {
  msgclient::MemoryBlock block;
  msgclient::Client others = block.local_client("others");
  DirectTopics topics;
  Surrounding<Estimate> estimate(others, topics, "estimate");
  Surrounding<MotionPlan> plan(others, topics, "motion_plan");
  step_shipped(state, GAITWAY_STABILITY, block, topics, [&](const Tick& tick) {
    estimate.write(tick.now_ns);
    if (tick.batch) {
      plan.write(tick.now_ns);
    }
  });
}
BENCHMARK(overhead_of_stability)->UseManualTime()->Iterations(20000);

// Its plan is 27 kB, every eighth tick.
void overhead_of_trajectory(benchmark::State& state) {
  msgclient::MemoryBlock block;
  msgclient::Client others = block.local_client("others");
  DirectTopics topics;
  Surrounding<Correction> correction(others, topics, "correction");
  step_shipped(state, GAITWAY_TRAJECTORY, block, topics,
               [&](const Tick& tick) { correction.write(tick.now_ns); });
}
BENCHMARK(overhead_of_trajectory)->UseManualTime()->Iterations(20000);

}  // namespace
}  // namespace gaitway::core
