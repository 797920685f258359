// `gaitway bus replay`: a recorded log, fed to the local controllers once more.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/bus/bus_options.hpp"
#include "tools/bus/log_input.hpp"
#include "tools/bus/log_replay.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitDiffers = 3;

struct BusReplayOptions {
  std::filesystem::path log;
  BusRobotOptions robot;
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  bool references_only = false;
  bool losses = false;
  std::optional<std::filesystem::path> scenario;  // of the recorded run
  std::filesystem::path out;                      // CSV; empty: none
};

std::string csv_header(const urdf::RobotModel& robot) {
  std::string header = "time_s";
  for (const urdf::Joint& joint : robot.joints) {
    header += fmt::format(",{0}_reference_count,{0}_reference_rad,{0}_position_rad", joint.name);
  }
  return header + "\n";
}

std::string csv_row(const urdf::RobotModel& robot, std::int64_t now_ns, const simulator::JointNetwork& joints,
                    const simulator::Plant& plant) {
  std::string row = fmt::format("{:.3f}", static_cast<double>(now_ns) * 1e-9);
  for (int joint = 0; joint < joints.size(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    row += fmt::format(",{},{:.6f},{:.6f}", joints.joint(joint).reference_count(),
                       joints.joint(joint).reference_rad(),
                       plant.sensors().encoder_count[j] * robot.joints[j].encoder_count_rad -
                           robot.joints[j].encoder_zero_rad);
  }
  return row + "\n";
}

void print(const BusReplayOptions& options, const BusRobot& robot, const ReplayResult& result,
           std::int64_t shift_ns) {
  if (shift_ns != 0) {
    fmt::print("the log does not begin at time 0: {:.3f} s taken off its times\n",
               static_cast<double>(shift_ns) * 1e-9);
  }
  fmt::print("{}: {:.3f} s, profile {}, seed {}, mismatch {}\n", options.log.string(),
             static_cast<double>(result.end_ns) * 1e-9, robot.profile.name, options.seed, options.mismatch);
  fmt::print("  frames fed to the joints    {:>9}\n", result.fed);
  fmt::print("  recorded answers            {:>9}\n", result.compared);
  fmt::print("  equal to the replayed ones  {:>9}{}\n", result.matched,
             options.references_only ? "  (state, toggles and reference count alone)" : "");
  if (result.doubled > 0) {
    fmt::print("  of these delivered twice    {:>9}\n", result.doubled);
  }
  fmt::print("  answers not in the log      {:>9}\n", result.not_in_log);
  if (result.fell) {
    fmt::print("  the simulated body fell\n");
  }
  if (result.equal()) {
    fmt::print("equal\n");
    return;
  }
  const ReplayDifference& first = *result.first;
  const auto joint = std::ranges::find(robot.model.joints, first.node, &urdf::Joint::node);
  fmt::print("differs first at {:.6f} s, node {} ({}), {}: recorded {}, replayed {}\n",
             static_cast<double>(first.time_ns + shift_ns) * 1e-9, first.node,
             joint == robot.model.joints.end() ? "?" : joint->name, first.field, first.recorded,
             first.replayed);
}

int replay_bus_log(const BusReplayOptions& options) {
  const BusRobot robot = load_bus_robot(options.robot);
  RobotLog log = read_robot_log(options.log, robot.profile);
  const std::int64_t shift_ns = log.shift_ns;
  ReplayOptions replay_options{
      .plant = {.seed = options.seed, .mismatch = options.mismatch, .conditions = {}},
      .comparison = options.references_only ? ReplayComparison::references : ReplayComparison::everything,
      .losses = options.losses};
  if (options.scenario) {
    simulator::Scenario scenario = simulator::load_scenario(*options.scenario, robot.model);
    replay_options.plant.conditions = scenario.conditions;
    replay_options.events = std::move(scenario.events);
  }
  LogReplay replay(robot.model, replay_options);
  std::string csv;
  if (!options.out.empty()) {
    process::write_text_file(options.out, csv);  // it can be written; said before the replay
    csv = csv_header(robot.model);
    replay.observe([&](std::int64_t now_ns, const auto& joints, const auto& plant) {
      csv += csv_row(robot.model, now_ns, joints, plant);
    });
  }
  const ReplayResult result = replay.run(log.frames);
  if (!options.out.empty()) {
    process::write_text_file(options.out, csv);
  }
  print(options, robot, result, shift_ns);
  return result.equal() ? kExitFine : kExitDiffers;
}

}  // namespace

void add_bus_replay(const CommandLine& bus) {
  const CommandLine command =
      bus.subcommand("replay", "Feed a recorded log to the local controllers and compare what they answer");
  BusReplayOptions& options = command.runs(replay_bus_log);
  command.option("log", options.log, "Bus log in candump's format").required();
  add_robot_options(command, options.robot);
  command.option("--seed", options.seed, "Seed of the recorded run");
  command.option("--mismatch", options.mismatch, "Mismatch of the recorded run").between(0.0, 10.0);
  command.option("--scenario", options.scenario,
                 "Scenario of the recorded run: its pushes and power failures, which no bus log holds");
  command.option("--references", options.references_only,
                 "Compare state, toggles and reference counts alone: what the log decides on any body");
  command.option("--losses", options.losses,
                 "Answers that are not in the log were lost on the bus: no difference");
  command.option("--out", options.out, "CSV file for each joint's reference and position, every 10 ms");
  command.footer(
      "Examples:\n"
      "  gaitway run --seed 7 --out out/run; gaitway bus replay out/run/bus.log --seed 7\n"
      "  gaitway bus replay paper.log --profile paper --out joints.csv\n"
      "  gaitway bus replay robot.log --references       a log of another body\n"
      "Exit code: 0 equal, 3 different, 1 the input was bad and nothing was fed.");
}

}  // namespace gaitway::tools
