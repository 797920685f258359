// Walks, and lets copies of the walk meet their faults.
#include "tools/campaign/fault_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "gaitway/process/working_copy.hpp"
#include "tools/campaign/fault_watch.hpp"

namespace gaitway::tools {
namespace {

constexpr double kRounding_s = 1e-9;
constexpr std::int64_t kStopWatched_ns = 60'000'000;

// The lines that a copy of this process tells.
std::vector<std::string> told_by(const std::function<void(const process::WorkingCopy::Tell&)>& work) {
  process::WorkingCopy copy(work);
  std::vector<std::string> told;
  while (!copy.done()) std::ranges::move(copy.listen(), std::back_inserter(told));
  return told;
}

class FaultRun {
 public:
  FaultRun(const TrialRobot& robot, std::uint64_t seed, double speed_m_per_s)
      : run_(robot.model, walk_options(robot, seed)), walk_{kWalkFrom_s, walk_of(speed_m_per_s)} {}

  // Up to the millisecond that begins then; the walk begins on the way.
  void walk_to(double at_s) {
    for (; !is_due(at_s); run_.advance_millisecond()) {
      if (!walks_ && is_due(kWalkFrom_s)) {
        run_.apply(walk_);
        walks_ = true;
      }
    }
  }
  // In a copy of the process: from here on it is that trial.
  FaultOutcome play(const FaultTrial& trial);
  void keep_to_this_process() { run_.keep_to_this_process(); }

 private:
  static simulator::WalkEvent walk_of(double speed_m_per_s) {
    return {.velocity_m_per_s = {speed_m_per_s, 0.0}};
  }
  [[nodiscard]] bool is_due(double at_s) const {
    return at_s <= static_cast<double>(run_.now_ns()) * 1e-9 + kRounding_s;
  }
  std::optional<double> stop_in_copy();

  simulator::Cosimulation run_;
  simulator::ScenarioEvent walk_;
  bool walks_ = false;
};

FaultOutcome FaultRun::play(const FaultTrial& trial) {
  std::vector<simulator::ScenarioEvent> events = events_of(trial, run_.robot());
  walk_.at_s = trial.instant_s + kWatched_s;
  events.push_back(walk_);
  FaultWatch watch(run_, trial.speed_m_per_s);
  run_.observe(&watch);
  std::size_t next = 0;
  std::optional<double> stop_s;
  bool stop_tried = false;
  const double end_s = trial.instant_s + kWatched_s + kWalkAgain_s;
  while (!is_due(end_s) && !watch.fall_is_over()) {
    for (; next < events.size() && is_due(events[next].at_s); ++next) run_.apply(events[next]);
    if (!stop_tried && is_due(trial.instant_s + kStopAfter_s)) {
      stop_tried = true;
      stop_s = stop_in_copy();
      run_.observe(&watch);
    }
    run_.advance_millisecond();
  }
  run_.observe(nullptr);
  FaultOutcome outcome = watch.outcome();
  outcome.stop_s = stop_s;
  return outcome;
}

// The trial goes on as if nobody had asked.
std::optional<double> FaultRun::stop_in_copy() {
  const std::vector<std::string> told = told_by([this](const process::WorkingCopy::Tell& tell) {
    StopWatch stop(run_.message_controller().profile());
    run_.observe(&stop);
    const std::int64_t asked_ns = run_.now_ns();
    run_.apply({static_cast<double>(asked_ns) * 1e-9, simulator::EmergencyStopEvent{}, true});
    while (!stop.sent_ns() && run_.now_ns() < asked_ns + kStopWatched_ns) run_.advance_millisecond();
    if (stop.sent_ns()) tell(std::to_string(*stop.sent_ns() - asked_ns));
  });
  return told.empty() ? std::nullopt : std::optional(1e-9 * std::stod(told.front()));
}

}  // namespace

simulator::CosimulationOptions walk_options(const TrialRobot& robot, std::uint64_t seed) {
  simulator::CosimulationOptions options;
  options.plant.seed = seed;
  options.main_controller.configuration = robot.plugins.file;
  options.main_controller.plugins = robot.plugins;
  options.main_controller.plugin_path = robot.plugin_path;
  return options;
}

std::vector<simulator::ScenarioEvent> events_of(const FaultTrial& trial, const urdf::RobotModel& robot) {
  std::vector<simulator::ScenarioEvent> events;
  for (const FaultAction& action : trial.actions) {
    events.push_back(simulator::parse_action("{" + action.text + "}", "row " + trial.row, robot));
    events.back().at_s = trial.instant_s + action.after_s;
  }
  return events;
}

void run_fault_trials(const TrialRobot& robot, std::span<const FaultTrial> trials,
                      const FaultTrialDone& done) {
  if (trials.empty()) return;
  FaultRun walk(robot, trials.front().seed, trials.front().speed_m_per_s);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    walk.walk_to(trials[i].instant_s);
    const std::vector<std::string> told = told_by([&](const process::WorkingCopy::Tell& tell) {
      walk.keep_to_this_process();
      tell(to_json(walk.play(trials[i])).dump());
    });
    done(i, fault_outcome_from_json(nlohmann::ordered_json::parse(told.at(0))));
  }
}

}  // namespace gaitway::tools
