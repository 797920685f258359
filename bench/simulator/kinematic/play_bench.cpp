// What a second of a trajectory costs to play with all rules, and with each kind of them alone.
#include <benchmark/benchmark.h>

#include <cmath>

#include "gaitway/kinematic/play.hpp"

namespace gaitway::kinematic {
namespace {

constexpr std::size_t kRows = 1000;

// Marches on the spot, arms swinging: every joint moves, feet are lifted in turn.
Trajectory marching(const urdf::RobotModel& robot) {
  Trajectory trajectory{.name = "march", .kind = "bench", .joint_count = robot.joints.size()};
  for (std::size_t row = 0; row < kRows; ++row) {
    const double phase = 2.0 * M_PI * static_cast<double>(row) / 80.0;
    for (const urdf::Joint& joint : robot.joints)
      trajectory.joint_rad.push_back(joint.home_rad + 0.1 * std::sin(phase));
    for (const urdf::Side side : urdf::kSides) {
      const double lift = 0.3 * std::max(0.0, std::sin(side == urdf::Side::left ? phase : -phase));
      const auto& leg = robot.legs[urdf::index_of(side)].joints;
      for (const auto& [place, share] : {std::pair{2, -1.0}, {3, 2.0}, {4, -1.0}}) {
        const auto j = static_cast<std::size_t>(leg[static_cast<std::size_t>(place)]);
        trajectory.joint_rad[row * trajectory.joint_count + j] = robot.joints[j].home_rad + share * lift;
      }
    }
  }
  trajectory.points_of_wire = true;
  return trajectory;
}

// The label `x_real_time` is how many seconds of the trajectory a second of the computer plays.
void play_march(benchmark::State& state, Checks checks, int half_window) {
  const urdf::RobotModel robot = urdf::load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
  Trajectory trajectory = marching(robot);
  trajectory.half_window = half_window;
  for (auto _ : state) benchmark::DoNotOptimize(play(robot, trajectory, checks).findings.size());
  state.counters["x_real_time"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kRows * facts::kSlot_s, benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(play_march, everything, Checks{}, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(play_march, everything_smoothed, Checks{}, 5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(play_march, zmp_alone, (Checks{.joints = false, .self_collision = false, .soles = false}),
                  1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::kinematic
