// `gaitway measure gait`: how well the robot walks, as a table.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "tools/command_line.hpp"
#include "tools/measure/gait_measurement.hpp"
#include "tools/measure/measure_vision.hpp"
#include "tools/measure/rise_motions.hpp"
#include "tools/measure/trial_store.hpp"

namespace gaitway::tools {
namespace {

// Exit codes beside 0, every measured floor holds, and 1, bad input: nothing was measured.
constexpr int kExitFloorFailed = 3;

struct MeasureGaitOptions {
  std::filesystem::path robot;
  std::filesystem::path config;
  std::filesystem::path out = "out/gait";
  std::optional<int> seeds;  // 20, or fewer with --quick
  std::uint64_t first_seed = 1;
  std::optional<int> jobs;          // none: all cores
  std::vector<std::string> rows;    // none: all
  std::vector<std::string> except;  // of these
  bool quick = false;
  bool quiet = false;
};

using Clock = std::chrono::steady_clock;

constexpr int kSeeds = 20, kQuickSeeds = 3, kMostSeeds = 1000, kMostJobs = 1024;

int jobs_of(const MeasureGaitOptions& options) {
  return options.jobs ? *options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Loads everything once, so that what is wrong with it is said before the first trial.
TrialRobot load(const MeasureGaitOptions& options) {
  TrialRobot robot{urdf::load_robot(options.robot), core::read_configuration(options.config)};
  msgcontroller::require_proven_network(robot.model, false);
  const core::PluginExchange plugins = core::put_in(
      robot.plugins, {}, {.robot_directory = options.robot, .plugin_path = core::plugin_search_path({})});
  if (const std::string commander = plugins.behaviour(); !commander.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: the plug-in '{}' orders walks itself, so no trial could say how the robot walks. "
                    "Measure without it",
                    options.config.string(), commander));
  }
  simulator::CosimulationOptions once;
  once.main_controller.configuration = options.config;
  once.main_controller.plugins = robot.plugins;
  once.main_controller.try_at_start = true;
  const simulator::Cosimulation loads(robot.model, once);
  return robot;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  return whole >= 3600 ? fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60)
                       : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

// How far the measurement is, shown now and then.
class MeasureProgress {
 public:
  explicit MeasureProgress(bool wanted) : line_(wanted) {}

  void show(const GaitProgress& progress) {
    if (Clock::now() < next_) {
      return;
    }
    next_ = Clock::now() + std::chrono::milliseconds(200);
    constexpr std::uint64_t kWidth = 24;
    const std::uint64_t filled =
        progress.trials_planned == 0 ? 0 : kWidth * progress.trials_done / progress.trials_planned;
    line_.show(fmt::format("  [{:#<{}}{:.<{}}] {:<16} {} / {} trials, {} ", "", filled, "", kWidth - filled,
                           progress.row, progress.trials_done, progress.trials_planned,
                           progress.remaining_s ? duration_text(*progress.remaining_s) + " left" : ""));
  }

 private:
  ProgressLine line_;
  Clock::time_point next_ = Clock::now();
};

void write_results(const MeasureGaitOptions& options, const GaitReportHead& head,
                   const GaitMeasurement& measurement) {
  process::write_text_file(options.out / "gait.json", gait_json(head, measurement).dump(2) + "\n");
  process::write_text_file(options.out / "gait.md", gait_markdown(head, measurement));
  process::write_text_file(options.out / "gait.html", gait_page(head, measurement));
}

int measure_gait_table(const MeasureGaitOptions& options) {
  const auto started = Clock::now();
  const core::Configuration plugins = core::read_configuration(options.config);
  std::vector<GaitRow> rows =
      chosen_rows(gait_table({.step_time_s = step_time_of(plugins), .quick = options.quick}), options.rows,
                  options.except);
  TrialRobot robot = load(options);
  if (const std::string missing = without_rise_motions(rows, robot); !missing.empty()) {
    if (!options.rows.empty()) throw std::invalid_argument(missing);
    fmt::print(stderr, "gaitway measure gait: left out: {}\n", missing);
  }
  prepare_output(options.out);
  pin_plugins(robot.plugins, robot.plugin_path, options.out / "plugins");
  TrialStore store(options.out / "trials.jsonl", fingerprint_of(robot));
  remove_other_plugins(robot.plugins, options.out / "plugins");

  const int seeds = options.seeds.value_or(options.quick ? kQuickSeeds : kSeeds);
  GaitMeasurement measurement;
  {
    MeasureProgress line(!options.quiet);
    measurement = measure_gait(robot, rows, store,
                               {.seeds = seeds,
                                .first_seed = options.first_seed,
                                .jobs = jobs_of(options),
                                .progress = [&line](const GaitProgress& progress) { line.show(progress); }});
  }
  const GaitReportHead head{robot.model.name, options.config.filename().string(), seeds, options.first_seed,
                            options.quick};
  write_results(options, head, measurement);
  if (!options.quiet) {
    fmt::print("{}\n{} trials run, {} known from {}; {}. Plots: {}\n", gait_markdown(head, measurement),
               measurement.trials_run, measurement.trials_known, (options.out / "trials.jsonl").string(),
               duration_text(std::chrono::duration<double>(Clock::now() - started).count()),
               (options.out / "gait.html").string());
  }
  const bool holds = std::ranges::all_of(measurement.rows, &RowResult::floor_holds);
  return holds ? 0 : kExitFloorFailed;
}

std::string row_list() {
  std::string text;
  for (const GaitRow& row : gait_table({})) {
    text += fmt::format("  {:<18}{}\n", row.name, row.measure);
  }
  return text;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine measure = add_command(app, "measure");
  measure.needs_subcommand();
  const CommandLine command = measure.subcommand(
      "gait", "How fast the robot walks, what pushes and what ground it survives: a table, with plots");
  MeasureGaitOptions& gait = command.runs(measure_gait_table);
  gait.robot = process::default_robot_directory();
  gait.config = process::default_config_file();
  command.option("--quick", gait.quick,
                 "Fewer seeds, shorter walks, coarser levels: some minutes on two cores");
  command.option("--seeds", gait.seeds, "Robots to try, each with its own deviations (default 20, quick 3)")
      .between(1, kMostSeeds);
  command.option("--first-seed", gait.first_seed, "The first of them");
  command.option("--jobs", gait.jobs, "Trials side by side (default: one a core)").between(1, kMostJobs);
  command.option("--rows", gait.rows, "Rows of the table, by name; default: all");
  command.option("--except", gait.except, "Rows to leave out");
  command.option("--robot", gait.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--config", gait.config, "Plug-ins of the main controller (YAML)");
  command.option("--out", gait.out, "Folder for the results and for the trials' outcomes");
  command.option("--quiet", gait.quiet, "No progress line and no table");
  command.footer("Rows:\n" + row_list() +
                 "\nExamples:\n"
                 "  gaitway measure gait --quick\n"
                 "  gaitway measure gait --rows straight,heading --seeds 5\n"
                 "  gaitway measure gait --quick --except compute\n"
                 "  gaitway measure gait --config without_trims.yaml --out out/without_trims\n"
                 "An interrupted measurement goes on where it was when it is given the same --out.\n"
                 "Exit code: 0 each floor holds, 3 one does not, 1 the input was bad.");
  declare_measure_vision(measure);
  measure.footer(
      "Examples:\n  gaitway measure gait --quick\n  gaitway measure vision\n  gaitway measure gait --help");
}

}  // namespace gaitway::tools
