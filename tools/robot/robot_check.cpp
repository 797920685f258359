// The whole chain, with what the planner does not know of the robot.
#include "tools/robot/robot_check.hpp"

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/instance/event_log.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "tools/run/run_metrics.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::tools {
namespace {

constexpr double kHeld = 0.8;         // of the commanded speed: else it does not walk
constexpr double kMostLacking = 0.1;  // of the batches
constexpr double kGathersSpeed_s = 3.0;
constexpr double kSettles_s = 2.0;
constexpr double kTrembles = 0.05;  // of sqrt(g / h): fifteen times what humanoid22 turns at rest

simulator::ScenarioEvent walk_at(double at_s, double forward_m_per_s) {
  return {at_s, simulator::WalkEvent{.velocity_m_per_s = {forward_m_per_s, 0.0}}};
}

std::string first_warning(const core::EventLog& log) {
  for (std::uint64_t number = log.first(); number < log.total(); ++number) {
    const core::Event& event = log[number];
    if (event.kind == core::EventKind::info || event.kind == core::EventKind::warning) continue;
    return std::string(event.source()) + ": " + std::string(event.text());
  }
  return "";
}

}  // namespace

RobotCheckOutcome check_robot(const urdf::RobotModel& robot, std::uint64_t seed,
                              const RobotCheckOptions& options, const std::function<void(double)>& progress) {
  simulator::CosimulationOptions how;
  how.plant.seed = seed;
  how.plant.mismatch = options.mismatch;
  how.main_controller.configuration = options.configuration;
  how.main_controller.plugin_path = options.plugin_path;
  simulator::Cosimulation run(robot, how);
  RunRecorder recorder(run, {}, false);
  run.observe(&recorder);
  const double end_s = kStepsUntil_s + options.walk_s;
  RobotCheckOutcome outcome;
  outcome.seed = seed;
  RootMeanSquare stand_turn_rate_rad_per_s;
  const auto advance_to = [&](double time_s) {
    while (static_cast<double>(run.now_ns()) * 1e-9 < time_s && !recorder.metrics().fell) {
      run.advance_millisecond();
      if (outcome.reached == RobotCheckOutcome::Reached::nothing && run.plant().time_s() > kSettles_s)
        stand_turn_rate_rad_per_s.add(run.plant().sensors().angular_velocity_rad_per_s.norm());
      if (progress && run.now_ns() % 100'000'000 == 0) progress(static_cast<double>(run.now_ns()) * 1e-9);
    }
    return !recorder.metrics().fell;
  };
  const auto apply = [&](const simulator::ScenarioEvent& event) {
    recorder.on_event(event, run.now_ns());
    run.apply(event);
  };
  using Reached = RobotCheckOutcome::Reached;
  if (advance_to(kStandUntil_s)) {
    outcome.reached = Reached::stand;
    apply(walk_at(kStandUntil_s, 0.0));
    if (advance_to(kStepsUntil_s)) {
      outcome.reached = Reached::steps;
      apply(walk_at(kStepsUntil_s, options.speed_m_per_s));
      bool up = advance_to(kStepsUntil_s + kGathersSpeed_s);
      const double path_m = recorder.metrics().path_m, walked_s = recorder.metrics().walked_s;
      up = up && advance_to(end_s);
      const double steady_s = recorder.metrics().walked_s - walked_s;
      if (steady_s > 0.0) outcome.speed_m_per_s = (recorder.metrics().path_m - path_m) / steady_s;
      if (up) outcome.reached = Reached::walk;
    }
  }
  recorder.finish();
  const RunMetrics& metrics = recorder.metrics();
  outcome.fell = metrics.fell;
  outcome.fell_at_s = metrics.fell_at_s;
  outcome.drift_m = metrics.lateral_drift_m();
  outcome.stand_turn_rate_rad_per_s = stand_turn_rate_rad_per_s.value();
  outcome.trembles = outcome.reached >= Reached::stand &&
                     outcome.stand_turn_rate_rad_per_s >
                         kTrembles * std::sqrt(facts::kGravity_m_per_s2 / robot.hip_height_m);
  outcome.batches = run.main_controller().statistics().handed_over;
  outcome.refused =
      run.main_controller().statistics().refused_locally + run.message_controller().state().refused;
  outcome.first_refusal = first_warning(run.main_controller().events());
  const double ahead = std::copysign(1.0, options.speed_m_per_s);
  const bool held = options.speed_m_per_s == 0.0 ||
                    ahead * outcome.speed_m_per_s >= kHeld * std::abs(options.speed_m_per_s);
  // After a refused batch a safe tail plays, in which there are none.
  const double cycles = static_cast<double>(run.now_ns()) / static_cast<double>(facts::kCycle_ns);
  const bool lacks_many = static_cast<double>(outcome.batches) < (1.0 - kMostLacking) * cycles;
  if (outcome.reached == Reached::walk && (!held || lacks_many)) outcome.reached = Reached::steps;
  return outcome;
}

}  // namespace gaitway::tools
