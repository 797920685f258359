// `gaitway calibrate`: joint zeros, trunk and force cells from standing poses.

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_adaptation.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#ifdef GAITWAY_HAS_VISION
#include "tools/calibrate/camera/camera_command.hpp"
#endif
#include "tools/calibrate/calibration_report.hpp"
#include "tools/calibrate/standing_measurement.hpp"
#include "tools/command_line.hpp"

namespace gaitway::calibration {
namespace {

using tools::add_command;
using tools::CommandLine;
using tools::ProgressLine;

constexpr int kExitMisfit = 3;  // the measurements do not fit the robot

struct CalibrateOptions {
  bool simulate = false;
  std::filesystem::path measurements, bus_log;  // empty: none
  std::filesystem::path robot, poses;
  std::uint64_t seed = 1;
  int seeds = 1, rounds = 4;
  double mismatch = 1.0;
  double measure_s = 1.0;
  double play_deg = 0.0, floor_deg = 0.0;
  std::optional<double> weighed_kg;
  double weighed_deviation_kg = 0.01;
  std::filesystem::path out, record;
  bool quiet = false;
};

constexpr int kMostSeeds = 1000, kMostRounds = 10;

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument(what);
}

void check(const CalibrateOptions& o) {
  const int sources = int{o.simulate} + int{!o.measurements.empty()} + int{!o.bus_log.empty()};
  require(
      sources == 1,
      "calibrate: give either --simulate or --measurements FILE or --bus-log FILE, and one of them alone");
  require(!(o.simulate && o.weighed_kg),
          "--weighed-kg: the simulated robot is weighed by itself. Leave it out");
  require(o.measurements.empty() || o.record.empty(),
          "--record: the measurements come from a file already. Leave it out");
  require(o.seeds == 1 || (o.out.empty() && o.record.empty()),
          "--out, --record: these are of one robot. Leave --seeds out");
}

std::filesystem::path shipped_poses() {
  return process::calibration_directory() / "standing.yaml";
}

// The shipped poses are made for the shipped robot: another one takes them in its own size, and as long.
motion::Motion poses_of(const CalibrateOptions& options, const urdf::RobotModel& robot) {
  if (options.poses != shipped_poses()) return motion::read_motion(options.poses, robot);
  const urdf::RobotModel shipped =
      urdf::load_robot(process::default_robot_directory(), urdf::CalibrationUse::left_out);
  const motion::Motion original = motion::read_motion(options.poses, shipped);
  motion::Motion poses = motion::adapt_motion(shipped, original, robot).motion;
  for (std::size_t i = 0; i < poses.keys.size(); ++i) poses.keys[i].hold_s = original.keys[i].hold_s;
  return poses;
}

motion::MotionPlan plan_poses(const CalibrateOptions& options, const urdf::RobotModel& robot) {
  const motion::Motion poses = poses_of(options, robot);
  bool any = false;
  for (const motion::Key& key : poses.keys) any = any || key.hold_s >= options.measure_s;
  require(any, fmt::format("{}: no pose is held for --measure-s {}. Raise hold_s, or measure for less time",
                           options.poses.string(), options.measure_s));
  return motion::plan_motion(robot, poses, {}).plan;
}

SimulatedCalibration simulate(const CalibrateOptions& options, const urdf::RobotModel& robot,
                              const motion::MotionPlan& poses, std::uint64_t seed, const ProgressLine& line) {
  return calibrate_simulated(
      robot, poses,
      {.seed = seed,
       .mismatch = options.mismatch,
       .play_rad = options.play_deg * facts::kRadPerDegree,
       .rounds = options.rounds,
       .measured_s = options.measure_s,
       .weighing_deviation_kg = options.weighed_deviation_kg,
       .progress = [&](int round, const std::string& pose) {
         line.show(fmt::format("  seed {}, round {} of {}: {}", seed, round, options.rounds, pose));
       }});
}

int finish(const CalibrateOptions& options, const urdf::RobotModel& robot, const Calibration& calibration,
           const RobotDeviations* truth) {
  if (!options.quiet) fmt::print("{}", report_text(robot, calibration, truth));
  if (calibration.misfit > kLargestMisfit) {
    fmt::print(stderr,
               "gaitway: the measurements leave {:.1f} times unexplained what their noise explains (at most "
               "{:.1f} is sound). Look for a foot that stood on something, moved, or another robot's "
               "description\n",
               calibration.misfit, kLargestMisfit);
    return kExitMisfit;
  }
  if (!options.out.empty()) {
    process::write_text_file(options.out, calibration_text(robot, calibration, std::time(nullptr)));
    if (!options.quiet) {
      fmt::print("{}: written. Beside robot.yaml, named calibration.yaml, it is used.\n",
                 options.out.string());
    }
  }
  return 0;
}

int from_simulation(const CalibrateOptions& options, const urdf::RobotModel& robot) {
  const motion::MotionPlan poses = plan_poses(options, robot);
  CalibrationStatistics statistics;
  std::optional<SimulatedCalibration> last;
  {
    const ProgressLine line(!options.quiet);
    for (int i = 0; i < options.seeds; ++i) {
      last = simulate(options, robot, poses, options.seed + static_cast<std::uint64_t>(i), line);
      statistics.add(robot, *last);
    }
  }
  if (options.seeds > 1) {
    fmt::print("{} robots. RMS errors before and after, claimed deviations, RMS of error / claim:\n{}",
               options.seeds, statistics.text());
    return 0;
  }
  if (!options.record.empty()) {
    process::write_text_file(options.record,
                             measurement_text({last->settings.weighing, last->measurements}, robot));
  }
  return finish(options, robot, last->calibration, &last->truth);
}

// Of a robot that is not simulated here; `file` is where they come from.
int from_measurements(const CalibrateOptions& options, const urdf::RobotModel& robot,
                      const MeasurementFile& measured, const std::filesystem::path& file) {
  CalibrationSettings settings;
  settings.weighing = measured.weighing;
  if (options.weighed_kg) settings.weighing = Weighing{*options.weighed_kg, options.weighed_deviation_kg};
  if (options.play_deg > 0.0) allow_play(options.play_deg * facts::kRadPerDegree, settings.standing);
  settings.standing.floor_tilt_rad = options.floor_deg * facts::kRadPerDegree;
  if (!options.record.empty()) {
    process::write_text_file(options.record, measurement_text({settings.weighing, measured.poses}, robot));
  }
  try {
    return finish(options, robot, calibrate(robot, measured.poses, settings), nullptr);
  } catch (const CalibrationError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), error.what()));
  }
}

// The joints of the log had the calibration that lies in the robot's folder, if one does.
int from_bus_log(const CalibrateOptions& options, const urdf::RobotModel& robot) {
  std::vector<double> zero_in_use_rad;
  for (const urdf::Joint& joint : urdf::load_robot(options.robot).joints) {
    zero_in_use_rad.push_back(joint.encoder_zero_rad);
  }
  MeasurementFile measured;
  try {
    measured.poses =
        standing_poses(robot, zero_in_use_rad, can::read_candump_log(options.bus_log), options.measure_s);
  } catch (const StandingLogError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", options.bus_log.string(), error.what()));
  }
  if (!options.quiet) fmt::print("{} poses in {}\n", measured.poses.size(), options.bus_log.string());
  return from_measurements(options, robot, measured, options.bus_log);
}

void add_inputs(const CommandLine& command, CalibrateOptions& options) {
  command.option("--simulate", options.simulate,
                 "The simulated robot takes the poses; what is true stands beside what is found");
  command.option("--measurements", options.measurements, "Measured poses of a robot (YAML)");
  command.option("--bus-log", options.bus_log,
                 "Log of a robot's bus (candump -L, or bus.log of a run) while it took the poses");
  command.option("--robot", options.robot, "Folder of the robot's description");
  command.option("--weighed-kg", options.weighed_kg, "What the robot weighs, if the file does not say it")
      .between(0.001, 1000.0);
  command.option("--weighed-deviation-kg", options.weighed_deviation_kg, "How far that may be off")
      .between(1e-6, 100.0);
  command.option("--play-deg", options.play_deg, "Play of each joint, whole width").between(0.0, 2.0);
  command
      .option("--floor-deg", options.floor_deg,
              "How far the floor may lean (standard deviation; with --measurements)")
      .between(0.0, 5.0);
  command.option("--measure-s", options.measure_s, "How long each pose is measured, at the end of its hold")
      .between(0.1, 60.0);
  command.option("--record", options.record,
                 "File for the measurements (of the last round), as --measurements reads them");
  command.option("--out", options.out, "File for the calibration, such as calibration.yaml");
  command.option("--quiet", options.quiet, "No progress and no table");
}

void add_simulation(const CommandLine& command, CalibrateOptions& options) {
  command.option("--poses", options.poses, "The poses: a motion that holds its keys");
  command.option("--seed", options.seed, "Which robot: its deviations and its noise");
  command.option("--seeds", options.seeds, "Calibrate that many robots and show how well it goes")
      .between(1, kMostSeeds);
  command.option("--mismatch", options.mismatch, "Scale of the robot's deviations").between(0.0, 10.0);
  command
      .option("--rounds", options.rounds,
              "How often the poses are taken at most, with the zeros found before")
      .between(1, kMostRounds);
}

int calibrate_command(const CalibrateOptions& options) {
  check(options);
  const urdf::RobotModel robot = urdf::load_robot(options.robot, urdf::CalibrationUse::left_out);
  if (robot.feet[0].sensor != urdf::FootSensor::cells) {
    input::refuse({options.robot / "robot.yaml", 0, "feet", "",
                   "a calibration needs four force cells in each foot",
                   "Measure joint zeros and the trunk by hand, and write them into calibration.yaml"});
  }
  if (options.simulate) return from_simulation(options, robot);
  if (!options.bus_log.empty()) return from_bus_log(options, robot);
  return from_measurements(options, robot, read_measurements(options.measurements, robot),
                           options.measurements);
}

void declare(const CommandLine& app) {
  const CommandLine command = add_command(app, "calibrate");
  CalibrateOptions& options = command.runs(calibrate_command);
  options.robot = process::default_robot_directory();
  options.poses = shipped_poses();
  add_inputs(command, options);
  add_simulation(command.group("Simulation"), options);
#ifdef GAITWAY_HAS_VISION
  declare_camera(command);
#endif
  command.footer(
      "Examples:\n"
      "  gaitway calibrate --simulate --seed 3 --out calibration.yaml\n"
      "  gaitway calibrate --simulate --seeds 20\n"
      "  gaitway calibrate --bus-log out/serve/bus.log --weighed-kg 6.87 --out calibration.yaml\n"
      "  gaitway calibrate --measurements standing.yaml --weighed-kg 6.87 --out calibration.yaml\n"
      "Exit code: 0 found, 3 the measurements do not fit the robot, 1 the input was bad.");
}

}  // namespace
}  // namespace gaitway::calibration

void gaitway::tools::declare_program(const CommandLine& program) {
  calibration::declare(program);
}
