// `gaitway bus measure`: the published experiment, rerun.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/process/installation.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/bus/bus_listener.hpp"
#include "tools/bus/bus_measurement.hpp"
#include "tools/bus/bus_options.hpp"

namespace gaitway::tools {
namespace {

struct BusMeasureOptions {
  BusRobotOptions robot;
  std::filesystem::path config = process::default_config_file();
  std::vector<double> walk{0.1};
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  std::optional<std::filesystem::path> socket;  // measure a running robot's bus instead
  std::optional<std::string> interface;         // 〃
  std::filesystem::path out;                    // folder for pictures and tables; empty: none
  bool json = false;
};

constexpr double kDefaultSeconds = 20.0;
constexpr double kShortest_s = kNotMeasured_s + 1.0;  // a dozen cycles

BusMeasurement simulate(const BusMeasureOptions& options, const BusRobot& robot) {
  BusExperiment experiment{.seconds = options.seconds.value_or(kDefaultSeconds),
                           .seed = options.seed,
                           .mismatch = options.mismatch,
                           .config = options.config};
  experiment.walk = {};
  if (options.walk.empty() || options.walk.size() > experiment.walk.size()) {
    throw std::invalid_argument("--walk: wants VX[,VY[,WZ]] in m/s, m/s and rad/s, for example 0.1,0,0.1");
  }
  std::ranges::copy(options.walk, experiment.walk.begin());
  if (experiment.seconds < kShortest_s) {
    throw std::invalid_argument(fmt::format(
        "--seconds {}: must be at least {}: the first {} s, until the robot walks steadily, are not measured",
        experiment.seconds, kShortest_s, kNotMeasured_s));
  }
  return measure_simulated_bus(robot, experiment);
}

BusMeasurement listen(const BusMeasureOptions& options, const BusRobot& robot) {
  BusListener listener({.socket = options.socket, .interface = options.interface});
  BusMeasurement measurement(robot, BusClock::robot);
  process::stop_on_signals();
  const double seconds = options.seconds.value_or(kDefaultSeconds);
  listener.listen_until(process::monotonic_ns() + static_cast<std::int64_t>(seconds * 1e9),
                        [&](const can::TimedFrame& frame) { measurement.take(frame); });
  return measurement;
}

void write_results(const BusMeasureOptions& options, const BusRobot& robot, const BusMeasurement& measurement,
                   const std::string& tables) {
  std::filesystem::create_directories(options.out);
  process::write_text_file(options.out / "slot.svg", slot_picture(measurement, robot));
  process::write_text_file(options.out / "cycle.svg", cycle_picture(measurement, robot));
  process::write_text_file(options.out / "tables.txt", tables);
  process::write_text_file(options.out / "tables.json", to_json(measurement, robot).dump(2) + "\n");
}

int measure_bus(const BusMeasureOptions& options) {
  const BusRobot robot = load_bus_robot(options.robot);
  const bool live = options.socket || options.interface;
  const BusMeasurement measurement = live ? listen(options, robot) : simulate(options, robot);
  if (measurement.watch().frames() == 0) {
    fmt::print(stderr, "gaitway: no frame was heard\n");
    return kExitBusUnwell;
  }
  const std::string tables = message_table(measurement, robot) + "\n" + time_table(measurement, robot);
  if (!options.out.empty()) {
    write_results(options, robot, measurement, tables);
  }
  fmt::print("{}", options.json ? to_json(measurement, robot).dump(2) + "\n" : tables);
  return kExitFine;
}

}  // namespace

void add_bus_measure(const CommandLine& bus) {
  const CommandLine command =
      bus.subcommand("measure", "Rerun the published experiment: what the messages take, measured");
  BusMeasureOptions& options = command.runs(measure_bus);
  add_robot_options(command, options.robot);
  command.option("--config", options.config, "Plug-ins of the main controller (YAML)");
  command.option("--walk", options.walk, "Walk VX[,VY[,WZ]]: forward m/s, left m/s, turn rad/s");
  command
      .option("--seconds", options.seconds,
              "Virtual time to walk, the first 3 s not measured; or time to listen (default 20)")
      .between(0.01, 86400.0);
  command.option("--seed", options.seed, "Seed of mismatch, noise and clock drifts");
  command.option("--mismatch", options.mismatch, "Scale of what the planner does not know of the robot")
      .between(0.0, 10.0);
  const Option socket =
      command.option("--bus", options.socket, "Listen on the socket of virtual_robot's bus instead");
  command.option("--can", options.interface, "Listen on a CAN interface of this machine instead")
      .excludes(socket);
  command.option("--out", options.out, "Folder for slot.svg, cycle.svg, tables.txt and tables.json");
  command.option("--json", options.json, "Print the tables as JSON");
  command.footer(
      "Examples:\n"
      "  gaitway bus measure --profile paper --out out/measure\n"
      "  gaitway bus measure --profile full --walk 0.2 --seconds 30 --json\n"
      "  gaitway bus measure --profile paper --can can0 --seconds 10\n"
      "Where the bus has no bit timing of its own (vcan), lengths are computed from the frames' content.\n"
      "Exit code: 0 measured, 3 no frame was heard, 1 the input was bad or the robot fell.");
}

}  // namespace gaitway::tools
