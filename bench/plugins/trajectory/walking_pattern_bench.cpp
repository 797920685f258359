// Cost of one plan: eight points, the safe tail and the footsteps, in a steady walk and when the robot
// stands.
#include <benchmark/benchmark.h>

#include "gaitway/trajectory/walking_pattern.hpp"

namespace {

void plan_one_batch(benchmark::State& state, bool walk) {
  gaitway::trajectory::WalkingPattern pattern{gaitway::trajectory::GaitParameters{}};
  gaitway::WalkCommand command{};
  command.walk = walk ? 1 : 0;
  command.velocity[0] = 0.2;
  command.turn_rate = 0.1;
  const gaitway::Correction correction{};
  static gaitway::MotionPlan plan{};
  std::uint32_t sequence = 0;
  double tail_points = 0.0;
  for (auto _ : state) {
    ++sequence;
    pattern.plan(sequence, sequence * std::int64_t{80'000'000}, command, correction, plan);
    tail_points += plan.tail_count;
    benchmark::DoNotOptimize(plan);
  }
  state.counters["tail_points"] = tail_points / static_cast<double>(state.iterations());
}

BENCHMARK_CAPTURE(plan_one_batch, walking, true);
BENCHMARK_CAPTURE(plan_one_batch, standing, false);

}  // namespace
