// `gaitway campaign`: faults at random instants of a walk, and what becomes of the robot.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
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
#include "tools/campaign/campaign.hpp"
#include "tools/campaign/endurance.hpp"
#include "tools/campaign/real_time/real_time_command.hpp"
#include "tools/command_line.hpp"
#include "tools/measure/trial_store.hpp"

namespace gaitway::tools {
namespace {

using Clock = std::chrono::steady_clock;

// Exit codes beside 0, all rows hold, and 1, bad input: nothing was played.
constexpr int kExitRowFailed = 3;
constexpr std::uint64_t kInstants = 100, kQuickInstants = 4, kMostInstants = 1'000'000;
constexpr int kMostJobs = 1024, kMostRobots = 1000;

struct CampaignCommand {
  std::filesystem::path robot, config, out = "out/campaign";
  std::optional<std::uint64_t> instants;  // kInstants, or fewer with --quick
  std::optional<int> jobs;                // none: one a core
  std::vector<std::string> rows, except;
  std::string row;  // its trial `instant` alone, as a scenario
  std::optional<std::uint64_t> instant;
  std::optional<double> hours;  // of one fault after the other
  double speed_m_per_s = 0.2;
  int robots = 20;
  bool quick = false, list = false, quiet = false;
  bool real_time = false;
  std::optional<std::uint64_t> trials;  // of each row in real time
};

TrialRobot load_walker(const CampaignCommand& command) {
  TrialRobot robot{urdf::load_robot(command.robot), core::read_configuration(command.config)};
  msgcontroller::require_proven_network(robot.model, false);
  const core::PluginExchange plugins = core::put_in(
      robot.plugins, {}, {.robot_directory = command.robot, .plugin_path = core::plugin_search_path({})});
  if (const std::string commander = plugins.behaviour(); !commander.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: the plug-in '{}' orders walks itself, so no trial could say how the robot walks. "
                    "Run the campaign without it",
                    command.config.string(), commander));
  }
  const bool isolated = std::ranges::any_of(robot.plugins.plugins, core::has_own_process);
  if (isolated) {
    throw std::invalid_argument(
        fmt::format("{}: plug-ins in processes of their own cannot be copied with a walk. Run the campaign "
                    "with plug-ins that are not isolated",
                    command.config.string()));
  }
  return robot;
}

std::string shown_duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  return whole >= 3600 ? fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60)
                       : fmt::format("{}:{:02} min", whole / 60, whole % 60);
}

class CampaignProgress {
 public:
  explicit CampaignProgress(bool wanted) : line_(wanted) {}

  void show(const CampaignOptions::Progress& progress) {
    if (Clock::now() < next_) return;
    next_ = Clock::now() + std::chrono::milliseconds(200);
    constexpr std::uint64_t kWidth = 24;
    const std::uint64_t filled = kWidth * progress.done / progress.planned;
    line_.show(fmt::format("  [{:#<{}}{:.<{}}] {} / {} trials, {} left ", "", filled, "", kWidth - filled,
                           progress.done, progress.planned,
                           shown_duration(progress.remaining_s.value_or(0.0))));
  }

 private:
  ProgressLine line_;
  Clock::time_point next_ = Clock::now();
};

int list_rows(const std::vector<FaultRow>& table) {
  for (const FaultRow& row : table) {
    const char* const expected = row.expected == FaultExpectation::survives  ? "survives"
                                 : row.expected == FaultExpectation::physics ? "may fall"
                                 : row.expected == FaultExpectation::not_yet ? "not yet"
                                                                             : "no promise";
    fmt::print("  {:<28}{:<12}{}\n", row.name, expected, row.what);
  }
  return kExitFine;
}

int print_scenario(const CampaignCommand& command, const std::vector<FaultRow>& table) {
  if (!command.instant) {
    throw std::invalid_argument("--row: which of its trials? Give its number as --instant, from 0 on");
  }
  const std::vector<FaultRow> rows = chosen_fault_rows(table, {command.row}, {});
  fmt::print(
      "{}", scenario_text(draw_trial(rows.front(), *command.instant, command.robots, command.speed_m_per_s)));
  return kExitFine;
}

void write_campaign(const std::filesystem::path& out, const CampaignHead& head, const Campaign& campaign) {
  process::write_text_file(out / "campaign.json", campaign_json(head, campaign).dump(2) + "\n");
  process::write_text_file(out / "campaign.md", campaign_markdown(head, campaign));
  process::write_text_file(out / "campaign.csv", campaign_csv(campaign));
  process::write_text_file(out / "campaign.svg", campaign_picture(head, campaign));
}

int tell_result(const CampaignCommand& command, const CampaignHead& head, const Campaign& campaign,
                double wall_s) {
  if (!command.quiet) {
    fmt::print("{}\n{} trials played, {} known from {}; {}.\n", campaign_markdown(head, campaign),
               campaign.run, campaign.known, (command.out / "trials.jsonl").string(), shown_duration(wall_s));
  }
  bool all_hold = true;
  for (const CampaignRow& row : campaign.rows) {
    if (row.holds()) continue;
    all_hold = false;
    const auto fell = std::ranges::find_if(row.trials, [&row](const PlayedTrial& one) {
      return one.outcome.fell && (row.row.expected == FaultExpectation::survives || !one.outcome.reacted());
    });
    fmt::print(stderr,
               "gaitway: row {}: {} of {} fall. One of them: gaitway campaign --row {} --instant {} > "
               "fall.yaml && gaitway run --scenario fall.yaml --seed {}\n",
               row.row.name, row.falls(), row.trials.size(), row.row.name, fell->trial.number,
               fell->trial.seed);
  }
  return all_hold ? kExitFine : kExitRowFailed;
}

int jobs_of(const CampaignCommand& command) {
  return command.jobs.value_or(std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

// One fault after the other for hours.
int endure(const CampaignCommand& command, const std::vector<FaultRow>& rows) {
  const TrialRobot robot = load_walker(command);
  const std::vector<FaultRow> passing = passing_rows(rows, robot.model);
  if (passing.empty()) {
    throw std::invalid_argument(
        "--hours: none of these rows has faults that are survived and pass by themselves");
  }
  prepare_output(command.out);
  EnduranceOptions options{.hours = *command.hours,
                           .robots = command.robots,
                           .jobs = jobs_of(command),
                           .speed_m_per_s = command.speed_m_per_s,
                           .progress = {}};
  std::vector<EnduranceRun> runs;
  {
    ProgressLine line(!command.quiet);
    options.progress = [&line](double share) { line.show(fmt::format("  {:.1f} % played ", 100.0 * share)); };
    runs = run_endurance(robot, passing, options);
  }
  process::write_text_file(command.out / "endurance.json", endurance_json(runs).dump(2) + "\n");
  for (const EnduranceRun& run : runs) {
    for (std::size_t fall = 0; fall < run.falls.size(); ++fall) {
      process::write_text_file(command.out / fall_file(run, fall), run.falls[fall].scenario);
    }
  }
  const std::string text = endurance_markdown(options, runs);
  process::write_text_file(command.out / "endurance.md", text);
  if (!command.quiet) fmt::print("{}", text);
  const bool all_up = std::ranges::all_of(runs, [](const EnduranceRun& run) { return run.falls.empty(); });
  return all_up ? kExitFine : kExitRowFailed;
}

int run_real_time(const CampaignCommand& command) {
  if (command.quick || command.instants || command.hours || command.jobs || !command.row.empty()) {
    throw std::invalid_argument(
        "--real-time: goes with none of --quick, --instants, --hours, --jobs and --row. Leave them out, and "
        "say "
        "with --trials how often each fault happens");
  }
  RealTimeCommand real_time{.robot = command.robot,
                            .out = command.out,
                            .speed_m_per_s = command.speed_m_per_s,
                            .rows = command.rows,
                            .except = command.except,
                            .list = command.list,
                            .quiet = command.quiet};
  if (command.trials) real_time.trials = *command.trials;
  return run_in_real_time(real_time);
}

int run_the_campaign(const CampaignCommand& command) {
  if (command.real_time) return run_real_time(command);
  if (command.trials)
    throw std::invalid_argument("--trials: goes with --real-time; in virtual time it is --instants");
  const auto started = Clock::now();
  const std::vector<FaultRow> table = fault_table(urdf::load_robot(command.robot));
  if (command.list) return list_rows(table);
  if (command.hours && (!command.row.empty() || command.instants || command.quick)) {
    throw std::invalid_argument(
        "--hours: goes with neither --row nor --instants nor --quick. Leave one of them out");
  }
  if (!command.row.empty()) return print_scenario(command, table);
  const std::vector<FaultRow> rows = chosen_fault_rows(table, command.rows, command.except);
  if (command.hours) return endure(command, rows);
  TrialRobot robot = load_walker(command);
  prepare_output(command.out);
  pin_plugins(robot.plugins, robot.plugin_path, command.out / "plugins");
  OutcomeStore store(
      command.out / "trials.jsonl", fingerprint_of(robot),
      [](const nlohmann::ordered_json& outcome) { static_cast<void>(fault_outcome_from_json(outcome)); });
  remove_other_plugins(robot.plugins, command.out / "plugins");
  CampaignOptions options{.instants = command.instants.value_or(command.quick ? kQuickInstants : kInstants),
                          .robots = command.robots,
                          .speed_m_per_s = command.speed_m_per_s,
                          .jobs = jobs_of(command),
                          .progress = {}};
  Campaign campaign;
  {
    CampaignProgress line(!command.quiet);
    options.progress = [&line](const CampaignOptions::Progress& progress) { line.show(progress); };
    campaign = run_campaign(robot, rows, store, options);
  }
  const CampaignHead head{robot.model.name, command.config.filename().string(), options, command.quick};
  write_campaign(command.out, head, campaign);
  return tell_result(command, head, campaign, std::chrono::duration<double>(Clock::now() - started).count());
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "campaign");
  CampaignCommand& options = command.runs(run_the_campaign);
  options.robot = process::default_robot_directory();
  options.config = process::default_config_file();
  command.option("--quick", options.quick, "Four instants of each row: some minutes on two cores");
  command.option("--instants", options.instants, "Trials of each row (default 100, quick 4)")
      .between(1, static_cast<double>(kMostInstants));
  command.option("--speed", options.speed_m_per_s, "Of the walk [m/s]").between(0.05, 0.5);
  command.option("--rows", options.rows, "Rows of the table, by name; default: all");
  command.option("--except", options.except, "Rows to leave out");
  command.option("--list", options.list, "Show the rows, and play nothing");
  command.option("--row", options.row,
                 "Print one trial of this row as a scenario, and play nothing; with --instant");
  command.option("--instant", options.instant, "The number of that trial, as campaign.csv has it");
  command
      .option("--hours", options.hours,
              "Instead: for so many hours of each robot, one fault after the other, every 10 s on average")
      .between(0.001, 1000.0);
  command.option(
      "--real-time", options.real_time,
      "Instead: faults of processes and of the operating system, with a robot under 'gaitway robot up'");
  command.option("--trials", options.trials, "Of each row in real time (default 10), some 6 s each")
      .between(1, static_cast<double>(kMostInstants));
  command.option("--robots", options.robots, "That take turns, each with its own deviations")
      .between(1, kMostRobots);
  command.option("--jobs", options.jobs, "Walks side by side (default: one a core)").between(1, kMostJobs);
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--config", options.config, "Plug-ins of the main controller (YAML)");
  command.option("--out", options.out, "Folder for the results and for the trials' outcomes");
  command.option("--quiet", options.quiet, "No progress line and no table");
  command.footer(
      "Examples:\n"
      "  gaitway campaign --quick\n"
      "  gaitway campaign --instants 1000 --rows jam,joint_bus_off\n"
      "  gaitway campaign --speed 0.35 --out out/campaign_fast\n"
      "  gaitway campaign --hours 8 --robots 4\n"
      "  gaitway campaign --real-time --rows main_controller_killed,clock_back_1h --trials 20\n"
      "  gaitway campaign --row dead_knee --instant 3 > knee.yaml && gaitway run --scenario knee.yaml --seed "
      "4\n"
      "Results: campaign.md, .json, .csv (a line for each trial) and .svg in --out. A campaign that was "
      "broken "
      "off, or that\nis to have more instants, goes on where it was when it is given the same --out.\n"
      "In real time: real_time.md, .json and .csv. Ctrl-C takes the robot down and sums up what is known; "
      "the rest "
      "is played\nby the next call. Exit code then: 2 no robot fell, but not all came back, or it was broken "
      "off.\n"
      "Exit code: 0 no fall but in rows that may fall, and there the robot knew before the impact; 3 there "
      "was "
      "one;\n1 the input was bad.");
}

}  // namespace gaitway::tools
