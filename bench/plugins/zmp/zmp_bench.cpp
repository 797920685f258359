// Cost of one update of the state estimate: standing, where the feet hold the heading, and walking.
#include <benchmark/benchmark.h>

#include "gaitway/zmp/state_estimator.hpp"
#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

// The load changes from foot to foot every so many ticks; 0: it does not.
void update(benchmark::State& state, int step_ticks) {
  StateEstimator estimator(test::humanoid(), EstimatorParameters{});
  test::Sensors sensors;
  Estimate estimate{};
  std::int64_t now_ns = 0;
  int tick = 0;
  for (auto _ : state) {
    const double left = step_ticks == 0 ? 0.5 : tick / step_ticks % 2 == 0 ? 1.0 : 0.0;
    sensors.press(urdf::Side::left, left * test::weight_N(), {0.02, 0.01});
    sensors.press(urdf::Side::right, (1.0 - left) * test::weight_N(), {0.01, 0.0});
    now_ns += test::kTick_ns;
    sensors.stamp(now_ns);
    if (!estimator.update(now_ns, sensors.joints, sensors.forces, sensors.imu, estimate)) {
      return state.SkipWithError("no estimate");
    }
    benchmark::DoNotOptimize(estimate);
    ++tick;
  }
}

void BM_UpdateStanding(benchmark::State& state) {
  update(state, 0);
}
BENCHMARK(BM_UpdateStanding)->Unit(benchmark::kMicrosecond);

void BM_UpdateWalking(benchmark::State& state) {
  update(state, 40);
}
BENCHMARK(BM_UpdateWalking)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gaitway::zmp
