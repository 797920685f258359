// Plays a trial in the co-simulation.
#include "tools/measure/trial_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gaitway/process/working_copy.hpp"

namespace gaitway::tools {
namespace {

constexpr double kEndTolerance_s = 1e-9;

// What the processor did for this thread: other programs on the machine do not count.
std::int64_t thread_time_ns() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

// The joints stay stiff, and play on what they played.
void ignore_falls(core::Configuration& plugins) {
  const auto set = [](core::PluginEntry& plugin, const char* name, const char* text) {
    std::erase_if(plugin.parameters, [name](const auto& given) { return given.name == name; });
    plugin.parameters.push_back({.name = name, .text = text});
  };
  for (core::PluginEntry& plugin : plugins.plugins) {
    if (plugin.library == "libgaitway_plugin_stability.so") set(plugin, "fall_softness", "0");
    if (plugin.library == "libgaitway_plugin_trajectory.so") set(plugin, "fall_posture", "false");
  }
}

simulator::CosimulationOptions options_of(const TrialRobot& robot, const Trial& trial) {
  simulator::CosimulationOptions options;
  options.plant.seed = trial.seed;
  options.plant.conditions = trial.conditions;
  options.main_controller.configuration = robot.plugins.file;
  options.main_controller.plugins = robot.plugins;
  if (trial.stiff_in_fall) {
    ignore_falls(*options.main_controller.plugins);
  }
  options.main_controller.plugin_path = robot.plugin_path;
  options.main_controller.wall_clock = trial.times_compute ? &thread_time_ns : nullptr;
  return options;
}

void apply_push(simulator::Cosimulation& run, const TrialPush& push) {
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

TrialRun::TrialRun(const TrialRobot& robot, const Trial& trial)
    : trial_(trial), run_(robot.model, options_of(robot, trial)), watch_(run_, trial_) {
  if (trial_.corrupted_share > 0.0) {
    run_.apply({0.0, simulator::DisturbBusFault{.corruption = trial_.corrupted_share,
                                                .omission = 0.0,
                                                .duplicate = 0.0,
                                                .duration_s = trial_.seconds + 1.0}});
  }
}

bool TrialRun::goes_on() const {
  const bool in_time = run_.now_ns() < std::llround(trial_.seconds * 1e9);
  if (trial_.rise) {
    return in_time;
  }
  return trial_.watches_fall ? !watch_.fall_is_over() && (in_time || watch_.falls())
                             : in_time && !run_.plant().fallen();
}

bool TrialRun::is_due(double at_s) const {
  return at_s <= static_cast<double>(run_.now_ns()) * 1e-9 + kEndTolerance_s;
}

void TrialRun::advance_millisecond() {
  for (; commands_given_ < trial_.commands.size() && is_due(trial_.commands[commands_given_].at_s);
       ++commands_given_) {
    const TimedVelocity& command = trial_.commands[commands_given_];
    run_.apply({command.at_s, simulator::WalkEvent{.velocity_m_per_s = command.velocity.head<2>(),
                                                   .turn_rate_rad_per_s = command.velocity.z()}});
  }
  if (!pushed_ && trial_.push && is_due(trial_.push->at_s)) {
    apply_push(run_, *trial_.push);
    pushed_ = true;
  }
  if (!risen_ && trial_.rise && is_due(trial_.rise->at_s)) {
    run_.apply({trial_.rise->at_s, simulator::MotionEvent{trial_.rise->motion}});
    risen_ = true;
  }
  run_.advance_millisecond();
  watch_.look();
}

void TrialRun::advance_to(double at_s) {
  while (goes_on() && !is_due(at_s)) {
    advance_millisecond();
  }
}

TrialOutcome TrialRun::finish() {
  while (goes_on()) {
    advance_millisecond();
  }
  return watch_.outcome();
}

void TrialRun::go_on_in_copy_as(const Trial& trial) {
  run_.keep_to_this_process();
  trial_ = trial;
}

TrialOutcome run_trial(const TrialRobot& robot, const Trial& trial) {
  return TrialRun(robot, trial).finish();
}

namespace {

constexpr double kMillisecond_s = 1e-3;

// All of a trial but its push and its length.
nlohmann::ordered_json beginning_of(Trial trial) {
  trial.push.reset();
  trial.seconds = 0.0;
  return describe(trial);
}

// fork() copies one thread, and no other process.
bool may_be_copied(const TrialRobot& robot) {
  const bool isolated = std::ranges::any_of(robot.plugins.plugins, core::has_own_process);
  return !isolated && std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}) == 1;
}

TrialOutcome finish_in_copy(TrialRun& walk, const Trial& trial) {
  process::WorkingCopy copy([&](const process::WorkingCopy::Tell& tell) {
    walk.go_on_in_copy_as(trial);
    tell(to_json(walk.finish()).dump());
  });
  std::vector<std::string> told;
  while (!copy.done()) {
    std::ranges::move(copy.listen(), std::back_inserter(told));
  }
  return outcome_from_json(nlohmann::ordered_json::parse(told.at(0)));
}

// Returns whether to go on.
bool run_pushes(const TrialRobot& robot, std::span<const Trial> trials, std::size_t first,
                const TrialDone& done) {
  Trial unpushed = trials.back();  // the longest
  unpushed.push.reset();
  TrialRun walk(robot, unpushed);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    // The millisecond before the push is the trial's own: at its end the feet's places are noted.
    walk.advance_to(std::min(trials[i].push->at_s, trials[i].seconds) - kMillisecond_s);
    if (!done(first + i, finish_in_copy(walk, trials[i]))) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool shares_walk(const Trial& before, const Trial& next) {
  return before.push && next.push && next.push->at_s >= before.push->at_s && next.seconds >= before.seconds &&
         beginning_of(next) == beginning_of(before);
}

void run_trials(const TrialRobot& robot, std::span<const Trial> trials, const TrialDone& done) {
  for (std::size_t first = 0, end = 0; first < trials.size(); first = end) {
    for (end = first + 1; end < trials.size() && shares_walk(trials[end - 1], trials[end]);) {
      ++end;
    }
    const bool shared = end - first > 1 && may_be_copied(robot);
    end = shared ? end : first + 1;
    const bool go_on = shared ? run_pushes(robot, trials.subspan(first, end - first), first, done)
                              : done(first, run_trial(robot, trials[first]));
    if (!go_on) {
      return;
    }
  }
}

}  // namespace gaitway::tools
