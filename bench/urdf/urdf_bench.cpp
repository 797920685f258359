// What the robot model costs: loading it, and one pass of forward kinematics over the whole body.
#include <benchmark/benchmark.h>

#include <random>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {
namespace {

RobotModel humanoid() {
  return load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
}

// 22 joints: poses of all links and the whole body's centre of mass; a new posture each time.
void forward_kinematics(benchmark::State& state) {
  const RobotModel robot = humanoid();
  ForwardKinematics kinematics(robot);
  std::mt19937 generator(1);
  std::vector<std::vector<double>> postures(256);
  for (auto& posture : postures) {
    for (const Joint& joint : robot.joints) {
      posture.push_back(std::uniform_real_distribution(joint.lower_rad, joint.upper_rad)(generator));
    }
  }
  std::size_t i = 0;
  for (auto _ : state) {
    kinematics.compute(postures[i++ % postures.size()]);
    benchmark::DoNotOptimize(kinematics.com_m().data());
  }
}
BENCHMARK(forward_kinematics);

void loading(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(humanoid());
  }
}
BENCHMARK(loading)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::urdf
