// What a pair of pictures costs: size and shadow map; a robot that stands, and one whose head moves.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

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

// Holds the home posture and turns the head to and fro, at up to 1.9 rad/s.
class Neck {
 public:
  explicit Neck(Plant& plant)
      : plant_(plant),
        neck_(static_cast<std::size_t>(robot().joint_index("neck_yaw"))),
        torque_Nm_(robot().joints.size()) {}
  void turn(double now_s) {
    for (std::size_t j = 0; j < torque_Nm_.size(); ++j) {
      const urdf::Joint& joint = robot().joints[j];
      const double goal_rad =
          joint.home_rad + (j == neck_ ? 0.3 * std::sin(2.0 * std::numbers::pi * now_s) : 0.0);
      torque_Nm_[j] = joint.servo.stiffness_Nm_per_rad *
                          (goal_rad - plant_.sensors().encoder_count[j] * joint.encoder_count_rad) -
                      joint.servo.damping_Nms_per_rad * plant_.velocities()[6 + j];
    }
    plant_.step(torque_Nm_);
  }

 private:
  Plant& plant_;
  std::size_t neck_;
  std::vector<double> torque_Nm_;
};

// Of the whole: sixteen poses, two drawings, lens, noise, publishing. Where it moves, 80 ms of physics, too.
void pair_of_pictures(benchmark::State& state) {
  const bool large = state.range(0) == 640, moves = state.range(2) != 0;
  PlantOptions options;
  options.world = world::read_world(GAITWAY_WORLDS "/course.yaml");
  Plant plant(robot(), options);
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("camera");
  StereoCamera camera(client, robot(), camera_of(large),
                      {.shadow_px = static_cast<int>(state.range(1)), .lost_share = 0.0}, options);
  Neck neck(plant);
  std::int64_t now_ns = 0;
  const auto take = [&] {
    for (int ms = 0; ms < 80; ++ms, now_ns += 1'000'000) {
      if (moves) neck.turn(1e-9 * static_cast<double>(now_ns));
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
    ->Args({320, 512, 0})
    ->Args({320, 1024, 0})
    ->Args({320, 4096, 0})
    ->Args({320, 512, 1})
    ->Args({640, 0, 0})
    ->Args({640, 512, 0})
    ->Args({640, 512, 1})
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
