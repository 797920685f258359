// What boxes around the map's obstacles cost, where these are many: walls around a room, as noisy as they are
// seen from afar.
#include <benchmark/benchmark.h>
#include <Eigen/Geometry>

#include <random>

#include "gaitway/vision/obstacle_boxes.hpp"

namespace gaitway::vision::testing {
namespace {

HeightMap room(double spread_m) {
  HeightMap map(0.04);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, spread_m);
  const Eigen::Rotation2Dd turn(0.35);
  for (double along_m = -1.2; along_m < 1.2; along_m += 0.005) {
    for (const Eigen::Vector2d& wall :
         {Eigen::Vector2d(1.2, along_m), Eigen::Vector2d(along_m, 1.2), Eigen::Vector2d(along_m, -1.2)}) {
      const Eigen::Vector2d at_m = turn * (wall + Eigen::Vector2d(noise(random), noise(random)));
      const int cell = map.cell_at(at_m.x(), at_m.y());
      if (cell < 0) continue;
      for (int i = 0; i < 3; ++i) {
        map.see(cell, {.what = CellSighting::What::obstacle, .height_m = 0.4, .middle_m = at_m, .points = 4},
                1'000'000'000 + i);
      }
    }
  }
  return map;
}

void boxes_of_a_room(benchmark::State& state) {
  const HeightMap map = room(1e-3 * static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(boxes_in(map, {0.0, 0.0}));
}
BENCHMARK(boxes_of_a_room)->ArgName("spread_mm")->Arg(10)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::vision::testing
