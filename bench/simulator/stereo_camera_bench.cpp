// What a pair of pictures costs: size and shadow map; a robot that stands, and one whose head moves.
#include <benchmark/benchmark.h>

#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/simulator/stereo_camera.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::simulator {
namespace {

const urdf::RobotModel& robot() {
  static const urdf::RobotModel model = urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22");
  return model;
}

urdf::StereoCamera camera_of(bool large) {
  urdf::StereoCamera camera = urdf::stereo_camera_of(robot()).value();
  if (!large) return camera;
  camera.width_px *= 2;
  camera.height_px *= 2;
  for (urdf::LensParameters& lens : camera.lens) {
    for (double* const number : {&lens.fx_px, &lens.fy_px, &lens.cx_px, &lens.cy_px}) *number *= 2.0;
  }
  return camera;
}

// Of the whole: sixteen poses, two drawings, lens, noise, publishing.
void pair_of_pictures(benchmark::State& state) {
  const bool large = state.range(0) == 640, moves = state.range(2) != 0;
  PlantOptions options;
  options.world = world::read_world(GAITWAY_WORLDS "/course.yaml");
  Plant plant(robot(), options);
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("camera");
  StereoCamera camera(client, robot(), camera_of(large),
                      {.shadow_px = static_cast<int>(state.range(1)), .lost_share = 0.0}, options);
  const std::vector<double> limp(robot().joints.size(), 0.0);
  std::int64_t now_ns = 0;
  const auto take = [&] {
    for (int ms = 0; ms < 80; ++ms, now_ns += 1'000'000) {
      if (moves && ms < 20) {  // it sinks and bows
        state.PauseTiming();
        plant.step(limp);
        state.ResumeTiming();
      }
      camera.step(now_ns, plant, true);
    }
  };
  take();
  for (auto _ : state) take();
  if (!camera.failure().empty()) state.SkipWithError(camera.failure().c_str());
}
BENCHMARK(pair_of_pictures)
    ->ArgNames({"width_px", "shadow_px", "moves"})
    ->Args({320, 0, 0})
    ->Args({320, 1024, 0})
    ->Args({320, 4096, 0})
    ->Args({320, 1024, 1})
    ->Args({640, 0, 0})
    ->Args({640, 1024, 0})
    ->Args({640, 1024, 1})
    ->Unit(benchmark::kMillisecond);

// A camera whose pictures nobody wants.
void unwanted(benchmark::State& state) {
  PlantOptions options;
  const Plant plant(robot(), options);
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("camera");
  StereoCamera camera(client, robot(), camera_of(false), {}, options);
  std::int64_t now_ns = 0;
  for (auto _ : state) camera.step(now_ns += 1'000'000, plant, false);
}
BENCHMARK(unwanted);

}  // namespace
}  // namespace gaitway::simulator
