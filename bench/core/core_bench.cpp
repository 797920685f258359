// What the framework itself costs: a plug-in's step over the border, loading and unloading, the check of a
// joint plan.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "gaitway/core/joint_plan_check.hpp"
#include "gaitway/manager/plugin_manager.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {
namespace {

// Plug-ins in a chain: each reads the topic of the one before and writes its own.
Configuration chain(std::int64_t length) {
  std::string text = "plugins:\n";
  for (std::int64_t i = 0; i < length; ++i) {
    const std::string from = i == 0 ? "" : ", from: t" + std::to_string(i - 1);
    text += "  - {name: p" + std::to_string(i) + ", library: relay.so, parameters: {to: t" +
            std::to_string(i) + from + "}}\n";
  }
  return parse_configuration(text, "bench.yaml");
}

PluginManagerOptions options(WallClock clock) {
  PluginManagerOptions result;
  result.plugin_path = {GAITWAY_TEST_PLUGINS};
  result.wall_clock = clock;
  return result;
}

void step_of_chain(benchmark::State& state, WallClock clock) {
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("bench");
  PluginManager manager(chain(state.range(0)), options(clock), client);
  std::int64_t now_ns = kTickPhase_ns;
  for (auto iteration : state) {
    manager.step(tick_at(now_ns));
    now_ns += facts::kSlot_ns;
  }
  state.counters["per_plugin"] =
      benchmark::Counter(static_cast<double>(state.range(0)),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(step_of_chain, not_measured, nullptr)->Arg(1)->Arg(8);
BENCHMARK_CAPTURE(step_of_chain, measured, &steady_clock_ns)->Arg(1)->Arg(8);

void load_and_unload(benchmark::State& state) {
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("bench");
  const Configuration configuration = chain(1);
  for (auto iteration : state) {
    PluginManager manager(configuration, options(nullptr), client);
    benchmark::DoNotOptimize(manager.size());
  }
}
BENCHMARK(load_and_unload);

// The longest plan: 208 points of 22 joints.
void check_joint_plan(benchmark::State& state) {
  const urdf::RobotModel robot = urdf::load_robot(GAITWAY_TEST_ROBOT);
  const JointPlanCheck check(robot);
  auto plan = std::make_unique<JointPlan>();
  plan->joint_count = static_cast<std::uint32_t>(robot.joints.size());
  plan->tail_count = kMaxTailPoints;
  std::vector<double> start;
  for (const urdf::Joint& joint : robot.joints) {
    for (auto& point : plan->position) {
      point[start.size()] = static_cast<float>(joint.home_rad);
    }
    start.push_back(joint.home_rad);
  }
  for (auto iteration : state) {
    benchmark::DoNotOptimize(check.check(*plan, start));
  }
}
BENCHMARK(check_joint_plan);

}  // namespace
}  // namespace gaitway::core
