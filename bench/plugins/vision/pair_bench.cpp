// What a pair of 320 x 240 pixels costs, whole and in parts: ground, a box, and a tag in view.
#include <benchmark/benchmark.h>

#include "watching_robot.hpp"

namespace gaitway::vision::testing {
namespace {

void prepare(WatchingRobot& robot, bool with_tag) {
  robot.head_pitch_rad(0.1);
  robot.scene.boxes.push_back({{1.3, 0.1, 0.1}, {0.2, 0.3, 0.2}, 0.2});
  if (with_tag) robot.scene.tags.push_back(facing_tag(7, {1.5, 0.4, 0.5}, 0.3));
}

// Only the work on pairs that are taken already.
void pair(benchmark::State& state, bool with_tag) {
  WatchingRobot robot;
  prepare(robot, with_tag);
  robot.watch(3);
  TakenPair kept;
  robot.spoil = [&kept](TakenPair& taken) { kept = taken; };
  robot.watch(1);
  kept.refer();
  std::uint64_t number = 100;
  for (auto _ : state) {
    kept.pair.number = ++number;
    kept.left[0] = static_cast<std::uint8_t>(number);  // no two are the same
    kept.right[0] = static_cast<std::uint8_t>(number);
    robot.vision().see(kept.pair, kept.pair.stamp_ns + WatchingRobot::kLatency_ns);
  }
}
BENCHMARK_CAPTURE(pair, without_tag, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pair, with_tag, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::vision::testing
