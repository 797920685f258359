// Plays a trial in the co-simulation.
#include <cmath>
#include <cstdint>
#include <ctime>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/tools/gait_trial.hpp"
#include "trial_watch.hpp"

namespace gaitway::tools {
namespace {

constexpr double kTolerance_s = 1e-9;

// What the processor did for this thread: other programs on the machine do not count.
std::int64_t thread_time_ns() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

void leave_stiff(core::Configuration& plugins) {
  for (core::PluginEntry& plugin : plugins.plugins) {
    if (plugin.library == "libgaitway_plugin_stability.so") {
      std::erase_if(plugin.parameters, [](const auto& given) { return given.name == "fall_softness"; });
      plugin.parameters.push_back({.name = "fall_softness", .text = "0"});
    }
  }
}

simulator::CosimulationOptions options_of(const TrialRobot& robot, const Trial& trial) {
  simulator::CosimulationOptions options;
  options.plant.seed = trial.seed;
  options.plant.conditions = trial.conditions;
  options.main_controller.configuration = robot.plugins.file;
  options.main_controller.plugins = robot.plugins;
  if (trial.stiff_in_fall) {
    leave_stiff(*options.main_controller.plugins);
  }
  options.main_controller.plugin_path = robot.plugin_path;
  options.main_controller.wall_clock = trial.times_compute ? &thread_time_ns : nullptr;
  return options;
}

void push(simulator::Cosimulation& run, const TrialPush& push) {
  const Eigen::Matrix3d rotation = run.plant().truth().base.linear();
  const double towards_rad = std::atan2(rotation(1, 0), rotation(0, 0)) + push.direction_rad;
  simulator::PushEvent event;
  event.body =
      run.robot().links[static_cast<std::size_t>(run.robot().imu.link)].name;  // the trunk bears the IMU
  event.direction = {std::cos(towards_rad), std::sin(towards_rad), 0.0};
  event.impulse_Ns = push.impulse_Ns;
  event.duration_s = kTrialPush_s;
  run.apply({push.at_s, event});
}

}  // namespace

TrialOutcome run_trial(const TrialRobot& robot, const Trial& trial) {
  simulator::Cosimulation run(robot.model, options_of(robot, trial));
  TrialWatch watch(run, trial);
  if (trial.corrupted_share > 0.0) {
    run.apply({0.0, simulator::DisturbBusFault{.corruption = trial.corrupted_share,
                                               .omission = 0.0,
                                               .duplicate = 0.0,
                                               .duration_s = trial.seconds + 1.0}});
  }
  auto command = trial.commands.begin();
  bool push_due = trial.push.has_value();
  const std::int64_t end_ns = std::llround(trial.seconds * 1e9);
  const auto goes_on = [&] {
    return trial.watches_fall ? !watch.fall_is_over() && (run.now_ns() < end_ns || watch.falls())
                              : run.now_ns() < end_ns && !run.plant().fallen();
  };
  while (goes_on()) {
    const double now_s = static_cast<double>(run.now_ns()) * 1e-9 + kTolerance_s;
    for (; command != trial.commands.end() && command->at_s <= now_s; ++command) {
      run.apply({command->at_s, simulator::WalkEvent{.velocity_m_per_s = command->velocity.head<2>(),
                                                     .turn_rate_rad_per_s = command->velocity.z()}});
    }
    if (push_due && trial.push->at_s <= now_s) {
      push(run, *trial.push);
      push_due = false;
    }
    run.advance_millisecond();
    watch.look();
  }
  return watch.outcome();
}

}  // namespace gaitway::tools
