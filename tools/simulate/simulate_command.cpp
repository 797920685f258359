// `gaitway simulate`: trajectories and ZMPs on the robot without dynamics.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "tools/command_line.hpp"
#include "tools/simulate/simulation_report.hpp"
#include "tools/simulate/trajectory_source.hpp"

namespace gaitway::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestWalk_s = 3600.0;

struct SimulateOptions {
  std::string file, against;
  std::optional<std::vector<double>> walk;  // forward m/s, left m/s, turn rad/s
  double seconds = 10.0;                    // of the walk
  std::filesystem::path robot = process::default_robot_directory();
  std::string profile;
  std::filesystem::path report;
  bool json = false, quiet = false;
};

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <class Read>
Played played_of(const urdf::RobotModel& robot, const kinematic::Checks& checks, const ProgressLine& progress,
                 const std::string& name, const Read& read) {
  progress.show(fmt::format("  {}: reading", name));
  Played played;
  const auto started = Clock::now();
  played.trajectory = read();
  played.reading_s = since_s(started);
  const auto begun = Clock::now();
  played.course = kinematic::play(robot, played.trajectory, checks, [&](double share) {
    progress.show(fmt::format("  {}: {:3.0f} %", name, 100.0 * share));
  });
  played.playing_s = since_s(begun);
  progress.show("");
  return played;
}

std::array<double, 3> walk_of(const SimulateOptions& options) {
  std::array<double, 3> walk{};
  if (options.walk->empty() || options.walk->size() > walk.size())
    throw std::invalid_argument("--walk: wants VX[,VY[,WZ]] in m/s, m/s and rad/s, for example 0.15,0,0.1");
  std::ranges::copy(*options.walk, walk.begin());
  return walk;
}

int tell(const SimulateOptions& options, const Simulation& simulation) {
  if (!options.report.empty()) write_simulation_page(options.report, simulation);
  if (options.json) {
    fmt::print("{}\n", simulation_json(simulation).dump(2));
  } else if (!options.quiet) {
    fmt::print("{}", simulation_text(simulation));
    if (!options.report.empty()) fmt::print("  report                {}\n", options.report.string());
  }
  const bool found = std::ranges::any_of(
      simulation.played, [](const Played& played) { return !played.course.findings.empty(); });
  return found ? kExitNotDone : kExitFine;
}

int simulate(const SimulateOptions& options, Subject subject) {
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  kinematic::Checks checks;
  checks.zmp = subject == Subject::zmp;
  checks.joints = checks.self_collision = checks.soles = subject == Subject::trajectory;
  const ProgressLine progress(!options.quiet);
  Simulation simulation{robot, subject, {}};
  if (options.walk) {
    simulation.played.push_back(played_of(robot, checks, progress, "walk", [&] {
      return plan_walk(robot, walk_of(options), options.seconds);
    }));
  }
  for (const std::string& file : {options.file, options.against}) {
    if (file.empty()) continue;
    simulation.played.push_back(
        played_of(robot, checks, progress, file, [&] { return read_trajectory(robot, file); }));
  }
  return tell(options, simulation);
}

int simulate_trajectory(const SimulateOptions& options) {
  return simulate(options, Subject::trajectory);
}

int simulate_zmp(const SimulateOptions& options) {
  if (options.file.empty() == !options.walk)
    throw std::invalid_argument("wants either a FILE or --walk VX,VY,WZ, and not both. See --help");
  return simulate(options, Subject::zmp);
}

void add_shared_options(const CommandLine& command, SimulateOptions& options) {
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--profile", options.profile,
                 "Messages of a bus log: full or paper. Without it, what the robot's network file says");
  command.option(
      "--report", options.report,
      "HTML file with everything in itself: the robot to be played, slowly, too; curves; findings");
  command.option("--json", options.json, "All figures as JSON");
  command.option("--quiet", options.quiet, "No progress line and no table");
}

constexpr const char* kSources =
    "FILE is the name of one of the robot's motions, a motion file (.yaml), a prepared one (.motion), points "
    "of "
    "`gaitway motion\nplan` (.csv), the folder of a run or its states.csv, a bus log (.log: the batches as "
    "joints "
    "play them), or a recording of the\nrobot API (.mcap).\n";

void add_trajectory(const CommandLine& simulate_command) {
  const CommandLine command = simulate_command.subcommand(
      "trajectory", "Joint limits, speeds, torques, steps of the wire, self-collision, soles");
  SimulateOptions& options = command.runs(simulate_trajectory);
  command.option("file", options.file, "What is played").required();
  command.option("--against", options.against, "Another one, beside it");
  add_shared_options(command, options);
  command.footer(
      fmt::format("{}Examples:\n"
                  "  gaitway simulate trajectory kick --report kick.html\n"
                  "  gaitway simulate trajectory out/run --against out/other_run --report compared.html\n"
                  "  gaitway simulate trajectory out/run/bus.log --json\n"
                  "Exit code: 0 no finding, 3 findings, 1 the input was bad and nothing was played.",
                  kSources));
}

void add_zmp(const CommandLine& simulate_command) {
  const CommandLine command = simulate_command.subcommand(
      "zmp",
      "ZMPs over the support polygon: planned, of all masses, of the force cells, of the contact solver");
  SimulateOptions& options = command.runs(simulate_zmp);
  command.option("file", options.file, "What is played");
  command.option("--walk", options.walk, "Plan this walk and play it: VX[,VY[,WZ]] in m/s, m/s and rad/s");
  command.option("--seconds", options.seconds, "How long it walks").between(1.0, kLongestWalk_s);
  add_shared_options(command, options);
  command.footer(fmt::format(
      "{}What a source has no ZMP of is said to be not known: force cells and contact solver are in runs, "
      "force "
      "cells in recordings.\n"
      "Examples:\n"
      "  gaitway simulate zmp --walk 0.15,0,0.1 --report walk.html\n"
      "  gaitway simulate zmp out/run --report run.html\n"
      "Exit code: 0 all over the support polygon, 3 one is not, 1 the input was bad and nothing was played.",
      kSources));
}

}  // namespace

void declare_program(const CommandLine& program) {
  const CommandLine command = add_command(program, "simulate");
  command.needs_subcommand();
  add_trajectory(command);
  add_zmp(command);
  command.footer(
      "Examples:\n"
      "  gaitway simulate trajectory kick --report kick.html\n"
      "  gaitway simulate zmp --walk 0.15,0,0.1 --report walk.html\n"
      "Exit code: 0 no finding, 3 findings, 1 the input was bad.");
}

}  // namespace gaitway::tools
