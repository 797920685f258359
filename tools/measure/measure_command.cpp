// `gaitway measure gait`: how well the robot walks, as a table.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "gaitway/input/text.hpp"
#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "tools/command_line.hpp"
#include "tools/measure/gait_measurement.hpp"
#include "tools/measure/measure_vision.hpp"
#include "tools/measure/rise_motions.hpp"
#include "tools/measure/series_player.hpp"
#include "tools/measure/trial_store.hpp"
#include "tools/measure/trials_elsewhere.hpp"

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
  std::optional<std::string> on;               // a place for trials; none: here
  std::optional<std::filesystem::path> store;  // with `on`
  std::optional<double> patience_s;            // with `on`
  bool plays_series = false;                   // a worker's
};

using Clock = std::chrono::steady_clock;

constexpr int kSeeds = 20, kQuickSeeds = 3, kMostSeeds = 1000, kMostJobs = 1024;
constexpr double kLongestPatience_s = 1e6;

int jobs_of(const MeasureGaitOptions& options) {
  return options.jobs ? *options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Loads everything once, so that what is wrong with it is said before the first trial. A worker's plug-ins
// have been tried by whoever asks.
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
  once.main_controller.try_at_start = !options.plays_series;
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
  // `elsewhere`: workers come and go, and their number is shown.
  MeasureProgress(bool wanted, bool elsewhere) : elsewhere_(elsewhere), line_(wanted) {}

  void show(const GaitProgress& progress) {
    if (Clock::now() < next_) {
      return;
    }
    next_ = Clock::now() + std::chrono::milliseconds(200);
    constexpr std::uint64_t kWidth = 24;
    const std::uint64_t filled =
        progress.trials_planned == 0 ? 0 : kWidth * progress.trials_done / progress.trials_planned;
    const std::string left = progress.remaining_s ? duration_text(*progress.remaining_s) + " left" : "";
    const std::string workers = elsewhere_ ? fmt::format(", {} workers", progress.workers) : "";
    line_.show(fmt::format("  [{:#<{}}{:.<{}}] {:<16} {} / {} trials, {}{} ", "", filled, "", kWidth - filled,
                           progress.row, progress.trials_done, progress.trials_planned, left, workers));
  }
  void tell(const std::string& news) {
    line_.show("");
    fmt::print(stderr, "gaitway measure gait: {}\n", input::terminal_text(news));
  }

 private:
  bool elsewhere_;
  ProgressLine line_;
  Clock::time_point next_ = Clock::now();
};

void write_results(const MeasureGaitOptions& options, const GaitReportHead& head,
                   const GaitMeasurement& measurement) {
  process::write_text_file(options.out / "gait.json", gait_json(head, measurement).dump(2) + "\n");
  process::write_text_file(options.out / "gait.md", gait_markdown(head, measurement));
  process::write_text_file(options.out / "gait.html", gait_page(head, measurement));
}

// The table's rows, and how they are measured.
struct Measured {
  std::vector<GaitRow> rows;
  TrialRobot robot;
};

Measured read_what_is_measured(const MeasureGaitOptions& options) {
  const core::Configuration plugins = core::read_configuration(options.config);
  std::vector<GaitRow> rows =
      chosen_rows(gait_table({.step_time_s = step_time_of(plugins), .quick = options.quick}), options.rows,
                  options.except);
  return {std::move(rows), load(options)};
}

// A worker's part of `--on`.
int play_for_others(const MeasureGaitOptions& options) {
  Measured measured = read_what_is_measured(options);
  const process::PrivateFolder plugins("gaitway_measure");
  pin_plugins(measured.robot.plugins, measured.robot.plugin_path, plugins.path());
  play_series(measured.robot, measured.rows, fingerprint_of(measured.robot));
  return kExitFine;
}

void check_place(const MeasureGaitOptions& options) {
  if (!options.on && (options.store || options.patience_s)) {
    throw std::invalid_argument(
        fmt::format("{}: is for trials that run by --on. Leave it out, or say where they run",
                    options.store ? "--store" : "--patience"));
  }
}

// Comes with the Python package.
constexpr const char* kTrialProgram = "gaitway-measure-on";

std::unique_ptr<TrialsElsewhere> place_of(const MeasureGaitOptions& options, std::uint64_t fingerprint,
                                          MeasureProgress& line) {
  if (!options.on) {
    return nullptr;
  }
  const std::filesystem::path beside =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / kTrialProgram;
  std::vector<std::string> command{std::filesystem::exists(beside) ? beside.string() : kTrialProgram,
                                   *options.on};
  if (options.store) command.insert(command.end(), {"--store", options.store->string()});
  if (options.patience_s)
    command.insert(command.end(), {"--patience", fmt::format("{}", *options.patience_s)});
  const TrialsElsewhere::Subject subject{std::filesystem::absolute(options.robot).string(),
                                         std::filesystem::absolute(options.config).string(), options.quick,
                                         fingerprint};
  try {
    return std::make_unique<TrialsElsewhere>(command, subject, [&line, &options](const std::string& news) {
      if (!options.quiet) line.tell(news);
    });
  } catch (const std::system_error& error) {
    throw std::invalid_argument(fmt::format(
        "--on {}: {} comes with the Python package, and cannot be run: {}. Install the wheel: pip "
        "install 'gaitway[dask]'",
        *options.on, kTrialProgram, error.code().message()));
  }
}

int measure_gait_table(const MeasureGaitOptions& options) {
  const auto started = Clock::now();
  check_place(options);
  if (options.plays_series) {
    return play_for_others(options);
  }
  auto [rows, robot] = read_what_is_measured(options);
  if (const std::string missing = without_rise_motions(rows, robot); !missing.empty()) {
    if (!options.rows.empty()) throw std::invalid_argument(missing);
    fmt::print(stderr, "gaitway measure gait: left out: {}\n", missing);
  }
  prepare_output(options.out);
  pin_plugins(robot.plugins, robot.plugin_path, options.out / "plugins");
  const std::uint64_t fingerprint = fingerprint_of(robot);
  TrialStore store(options.out / "trials.jsonl", fingerprint);
  remove_other_plugins(robot.plugins, options.out / "plugins");

  const int seeds = options.seeds.value_or(options.quick ? kQuickSeeds : kSeeds);
  GaitMeasurement measurement;
  try {
    MeasureProgress line(!options.quiet, options.on.has_value());
    const std::unique_ptr<TrialsElsewhere> place = place_of(options, fingerprint, line);
    measurement = measure_gait(robot, rows, store,
                               {.seeds = seeds,
                                .first_seed = options.first_seed,
                                .jobs = jobs_of(options),
                                .progress = [&line](const GaitProgress& progress) { line.show(progress); },
                                .elsewhere = place.get()});
  } catch (const ElsewhereError& error) {
    fmt::print(stderr, "gaitway measure gait: {}\n", input::terminal_text(error.what()));
    return error.exit_code();
  }
  const GaitReportHead head{robot.model.name, options.config.filename().string(), seeds, options.first_seed,
                            options.quick};
  write_results(options, head, measurement);
  if (!options.quiet) {
    fmt::print("{}\n{} trials run, {} known from {}{}; {}. Plots: {}\n", gait_markdown(head, measurement),
               measurement.trials_run, measurement.trials_known, (options.out / "trials.jsonl").string(),
               options.on ? " or the store" : "",
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

void declare_options(const CommandLine& command, MeasureGaitOptions& gait) {
  gait.robot = process::default_robot_directory();
  gait.config = process::default_config_file();
  command.option("--quick", gait.quick,
                 "Fewer seeds, shorter walks, coarser levels: some minutes on two cores");
  command.option("--seeds", gait.seeds, "Robots to try, each with its own deviations (default 20, quick 3)")
      .between(1, kMostSeeds);
  command.option("--first-seed", gait.first_seed, "The first of them");
  const Option jobs =
      command.option("--jobs", gait.jobs, "Trials side by side (default: one a core)").between(1, kMostJobs);
  command.option("--rows", gait.rows, "Rows of the table, by name; default: all");
  command.option("--except", gait.except, "Rows to leave out");
  command.option("--robot", gait.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--config", gait.config, "Plug-ins of the main controller (YAML)");
  command.option("--out", gait.out, "Folder for the results and for the trials' outcomes");
  command.option("--quiet", gait.quiet, "No progress line and no table");
  command
      .option(
          "--on", gait.on,
          "Where trials run (default: in copies of this process): local or local:N, processes of the Python "
          "package; dask://HOST:PORT, a cluster")
      .excludes(jobs);
  command.option("--store", gait.store,
                 "With --on: folder in which what ran is kept (default: as gaitway sweep)");
  command
      .option("--patience", gait.patience_s,
              "With --on: seconds to wait where no worker is there (default 60)")
      .between(0.0, kLongestPatience_s);
  command.option("--plays-series", gait.plays_series, "What a worker of --on runs").hidden();
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine measure = add_command(app, "measure");
  measure.needs_subcommand();
  const CommandLine command = measure.subcommand(
      "gait", "How fast the robot walks, what pushes and what ground it survives: a table, with plots");
  declare_options(command, command.runs(measure_gait_table));
  command.footer(
      "Rows:\n" + row_list() +
      "\nExamples:\n"
      "  gaitway measure gait --quick\n"
      "  gaitway measure gait --rows straight,heading --seeds 5\n"
      "  gaitway measure gait --quick --except compute\n"
      "  gaitway measure gait --config without_trims.yaml --out out/without_trims\n"
      "  gaitway measure gait --on dask://10.0.0.5:8786\n"
      "An interrupted measurement goes on where it was when it is given the same --out.\n"
      "Exit code: 0 each floor holds, 3 one does not, 1 the input was bad. With --on, too: 4 what ran "
      "could not be kept,\n5 two workers gave two results for one trial, 6 trials are missing (no "
      "workers); the same command goes on from there.");
  declare_measure_vision(measure);
  measure.footer(
      "Examples:\n  gaitway measure gait --quick\n  gaitway measure vision\n  gaitway measure gait --help");
}

}  // namespace gaitway::tools
