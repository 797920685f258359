// What the simulated robot costs: a step with and without sensors while it stands, building it, and a
// picture.
#include <benchmark/benchmark.h>

#include "gaitway/simulator/camera.hpp"
#include "gaitway/simulator/plant.hpp"

namespace gaitway::simulator {
namespace {

urdf::RobotModel humanoid() {
  return urdf::load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
}

// Torques that hold the home posture.
void hold_home(const urdf::RobotModel& robot, const Plant& plant, std::vector<double>& torque_Nm) {
  for (std::size_t j = 0; j < torque_Nm.size(); ++j) {
    const urdf::Joint& joint = robot.joints[j];
    torque_Nm[j] = joint.servo.stiffness_Nm_per_rad *
                       (joint.home_rad - plant.sensors().encoder_count[j] * joint.encoder_count_rad) -
                   joint.servo.damping_Nms_per_rad * plant.velocities()[6 + j];
  }
}

// One millisecond of standing: physics, motors, all sensors with noise, contacts.
void standing_step(benchmark::State& state) {
  const urdf::RobotModel robot = humanoid();
  Plant plant(robot, {});
  std::vector<double> torque_Nm(robot.joints.size());
  for (auto _ : state) {
    hold_home(robot, plant, torque_Nm);
    plant.step(torque_Nm);
  }
  state.SetItemsProcessed(state.iterations());
  if (plant.fallen()) {
    state.SkipWithError("the robot fell");
  }
}
BENCHMARK(standing_step);

// The same torques again, physics alone: 4 s of standing for each iteration.
void standing_replay(benchmark::State& state) {
  const urdf::RobotModel robot = humanoid();
  Plant plant(robot, {});
  std::vector<double> torque_Nm(robot.joints.size());
  std::vector<float> recorded_Nm;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    hold_home(robot, plant, torque_Nm);
    plant.step(torque_Nm);
    for (const double torque : plant.sensors().motor_torque_Nm) {
      recorded_Nm.push_back(static_cast<float>(torque));
    }
  }
  for (auto _ : state) {
    state.SetIterationTime(plant.replay_wall_s(recorded_Nm));
  }
  state.SetItemsProcessed(state.iterations() * kSteps);
}
BENCHMARK(standing_replay)->UseManualTime()->Unit(benchmark::kMillisecond);

void build_plant(benchmark::State& state) {
  const urdf::RobotModel robot = humanoid();
  for (auto _ : state) {
    Plant plant(robot, {});
    benchmark::DoNotOptimize(plant.positions().data());
  }
}
BENCHMARK(build_plant)->Unit(benchmark::kMillisecond);

// 640 x 480 with shadows.
void picture(benchmark::State& state) {
  const Plant plant(humanoid(), {});
  Camera camera(plant, 640, 480);
  for (auto _ : state) {
    benchmark::DoNotOptimize(camera.render(plant.positions()).rgb.data());
  }
}
BENCHMARK(picture)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::simulator
