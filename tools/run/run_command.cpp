// `gaitway run`: reads the inputs, lets the co-simulation run with a progress line, writes the results.
#include "tools/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "tools/run/eyes_option.hpp"
#include "tools/run/mission_option.hpp"
#include "tools/run/navigation_option.hpp"
#include "tools/run/run_logs.hpp"
#include "tools/run/run_recorder.hpp"
#include "tools/run/run_report.hpp"
#include "tools/run/shipped_option.hpp"
#include "tools/run/snapshots.hpp"
#include "tools/run/world_option.hpp"

namespace gaitway::tools {
namespace {

struct RunOptions {
  std::filesystem::path robot = process::default_robot_directory();  // folder with robot.urdf and robot.yaml
  std::string profile;           // of the bus; empty: what the robot's network file says
  bool accept_unproven = false;  // run even if the bus cannot be proven
  std::filesystem::path config = process::default_config_file();  // plug-ins of the main controller
  std::vector<std::filesystem::path> with;  // libraries put into it; see manager/plugin_exchange.hpp
  std::optional<std::filesystem::path> scenario;
  std::optional<std::vector<double>> walk;  // forward m/s, left m/s, turn rad/s
  std::optional<std::vector<double>> to;    // x m, y m, yaw deg
  std::optional<std::string> mission;       // of the behaviour
  bool localization = true;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  WorldOptions world;
  std::filesystem::path out = "out/run";
  bool pictures = true;
  std::optional<std::vector<double>> film;    // from and to when the film strip shows the run, s
  std::optional<std::filesystem::path> eyes;  // folder for what the robot's cameras see
  bool quiet = false;
};

using Clock = std::chrono::steady_clock;

constexpr double kDefaultSeconds = 20.0;
constexpr double kLongestWay_s = 120.0;      // a run that walks to a place ends when the robot is there
constexpr double kStand_s = 1.0;             // before it
constexpr double kLongestMission_s = 120.0;  // one that has ended ends its run
constexpr double kAfterWay_s = 1.0;
constexpr double kDefaultSpeed_m_per_s = 0.15;  // of a body as large as humanoid22
constexpr double kAfterFall_s = 1.0;            // shown after a fall, before the run ends
constexpr double kFirstPicture_s = 0.5;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Stands for a second, then walks there.
simulator::Scenario way_scenario(const std::vector<double>& to, double seconds) {
  simulator::Scenario scenario;
  scenario.seconds = seconds;
  scenario.events.push_back(
      {kStand_s, simulator::WalkToEvent{std::array{to[0], to[1], to[2] * facts::kRadPerDegree}}});
  return scenario;
}

simulator::Scenario scenario_of(const RunOptions& options, const urdf::RobotModel& robot) {
  if (options.scenario) {
    simulator::Scenario scenario = simulator::load_scenario(
        file_or_shipped("--scenario", *options.scenario, process::scenario_directory()), robot);
    scenario.seconds = options.seconds.value_or(scenario.seconds);
    return scenario;
  }
  if (options.mission) {
    simulator::Scenario scenario;
    scenario.seconds = options.seconds.value_or(kLongestMission_s);
    return scenario;
  }
  if (options.to) return way_scenario(*options.to, options.seconds.value_or(kLongestWay_s));
  const facts::BodyScale larger = robot.body_scale();
  std::vector<double> walk =
      options.walk.value_or(std::vector<double>{kDefaultSpeed_m_per_s * larger.factor("m/s")});
  walk.resize(3, 0.0);
  return simulator::walk_scenario(walk[0], walk[1], walk[2], options.seconds.value_or(kDefaultSeconds));
}

// A plug-in that commands the robot is not contradicted by the default. What a scenario asks for takes the
// command from it, as a person would.
void leave_walk_to(const std::string& plugin, const RunOptions& options, simulator::Scenario& scenario) {
  const auto walks = [](const simulator::ScenarioEvent& event) {
    return std::holds_alternative<simulator::WalkEvent>(event.action);
  };
  if (options.walk) {
    throw std::invalid_argument(fmt::format(
        "--walk: the plug-in '{}' commands the robot, and a person's walk would keep it from that. Leave "
        "the walk out, or the plug-in; a scenario may do both",
        plugin));
  }
  if (!options.scenario) std::erase_if(scenario.events, walks);
}

bool changes_world(const simulator::ScenarioEvent& event) {
  return std::holds_alternative<simulator::SpawnEvent>(event.action) ||
         std::holds_alternative<simulator::MoveEvent>(event.action) ||
         std::holds_alternative<simulator::RemoveEvent>(event.action);
}

bool gets_up_after(const simulator::Scenario& scenario, double fell_at_s) {
  return std::ranges::any_of(scenario.events, [fell_at_s](const auto& event) {
    return event.at_s > fell_at_s && std::holds_alternative<simulator::MotionEvent>(event.action);
  });
}

// Runs the scenario to its end, or to a second after a fall from which no motion lifts the robot, or after
// the end of its way or mission; returns the wall time that it took.
double simulate(simulator::Cosimulation& cosimulation, const simulator::Scenario& scenario,
                bool ends_with_way, bool draws, RunRecorder& recorder, Snapshots& snapshots, EyeFiles& eyes,
                RunLogs& logs, const RunLogs::Summary& so_far, const ProgressLine& progress) {
  const auto started = Clock::now();
  const auto end_ns = static_cast<std::int64_t>(std::llround(scenario.seconds * 1e9));
  auto next_event = scenario.events.begin();
  std::int64_t last_ns = end_ns;
  while (cosimulation.now_ns() < std::min(end_ns, last_ns)) {
    const double now_s = static_cast<double>(cosimulation.now_ns()) * 1e-9;
    while (next_event != scenario.events.end() && next_event->at_s <= now_s + 1e-9) {
      recorder.on_event(*next_event, cosimulation.now_ns());
      if (draws && changes_world(*next_event)) snapshots.draw_before_change(cosimulation.plant());
      cosimulation.apply(*next_event++);
    }
    cosimulation.advance_millisecond();
    snapshots.look(cosimulation.plant());
    eyes.look(cosimulation);
    logs.look(cosimulation.main_controller().events(), so_far);
    if (const RunMetrics& metrics = recorder.metrics(); metrics.fell && !scenario.to_the_end &&
                                                        last_ns == end_ns &&
                                                        !gets_up_after(scenario, metrics.fell_at_s)) {
      last_ns = cosimulation.now_ns() + static_cast<std::int64_t>(kAfterFall_s * 1e9);
    }
    if (last_ns == end_ns && ((ends_with_way && recorder.way().ended()) || recorder.mission().ended())) {
      last_ns = cosimulation.now_ns() + static_cast<std::int64_t>(kAfterWay_s * 1e9);
    }
    if (cosimulation.now_ns() % 100'000'000 == 0) {
      const double wall_s = seconds_since(started);
      progress.show(fmt::format("  {:6.1f} / {:.1f} s   {:5.1f} x real time   x = {:+.2f} m ", now_s,
                                scenario.seconds, wall_s > 0.0 ? now_s / wall_s : 0.0,
                                cosimulation.plant().positions()[0]));
    }
  }
  logs.finish(cosimulation.main_controller().events());
  eyes.finish(cosimulation);
  logs.try_to([&eyes] { eyes.require_all(); });
  progress.show("");
  return seconds_since(started);
}

void check(const RunOptions& options) {
  if (options.mission && options.mission->empty()) {
    throw std::invalid_argument("--mission: is empty. Give a file, or the name of a shipped mission");
  }
  if (options.walk && (options.walk->empty() || options.walk->size() > 3)) {
    throw std::invalid_argument("--walk: wants VX[,VY[,WZ]] in m/s, m/s and rad/s, for example 0.15,0,0.1");
  }
  if (options.film && !(options.film->size() == 2 && (*options.film)[0] >= 0.0 &&
                        (*options.film)[1] > (*options.film)[0] && std::isfinite((*options.film)[1]))) {
    throw std::invalid_argument("--film: wants FROM,TO in s, the second one later, for example 3.5,5");
  }
}

// Whether something needs the plug-in that walks ways.
bool walks_ways(const simulator::Scenario& scenario) {
  return std::ranges::any_of(scenario.events, [](const auto& event) {
    const auto* const fault = std::get_if<simulator::PluginFault>(&event.action);
    return std::holds_alternative<simulator::WalkToEvent>(event.action) ||
           (fault != nullptr && fault->plugin == kNavigationName);
  });
}

core::Configuration configuration_of(const RunOptions& options, bool navigates,
                                     const std::optional<world::World>& world) {
  core::Configuration configuration = core::read_configuration(configuration_file(options.config));
  const bool decides = std::ranges::any_of(
      configuration.plugins, [](const core::PluginEntry& plugin) { return plugin.name == kBehaviourName; });
  if (navigates || decides) add_navigation(configuration, world);
  if (options.mission) set_mission(configuration, *options.mission);
  return configuration;
}

core::PluginExchange plugins_of(const RunOptions& options, bool navigates,
                                const std::optional<world::World>& world) {
  core::PluginExchange plugins =
      core::put_in(configuration_of(options, navigates, world), options.with,
                   {.robot_directory = options.robot, .plugin_path = core::plugin_search_path({})});
  for (const core::AddedPlugin& added : plugins.added) {
    if (!options.quiet) {
      fmt::print("{}\n", core::describe(added));
    }
  }
  return plugins;
}

// What the scenario plays must be among the motions that the shipped planner finds; other planners know their
// own. People may ask for what there is not, and a record of that plays again.
void require_known_motions(const simulator::Scenario& scenario, const RunOptions& options,
                           const core::Configuration& configuration) {
  std::vector<std::filesystem::path> folders = process::prepared_motion_directories(options.robot);
  for (const core::PluginEntry& plugin : configuration.plugins) {
    for (const core::ParameterEntry& parameter : plugin.parameters) {
      if (parameter.name == "motions") {
        folders.emplace_back(parameter.text);
      }
    }
  }
  std::vector<std::string> known;
  for (const std::filesystem::path& folder : folders) {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
      if (entry.path().extension() == ".motion") known.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(known);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  for (const simulator::ScenarioEvent& event : scenario.events) {
    const auto* const motion = std::get_if<simulator::MotionEvent>(&event.action);
    if (motion != nullptr && !event.asked && !motion->name.empty() &&
        std::ranges::find(known, motion->name) == known.end()) {
      const std::string remedy =
          known.empty()
              ? fmt::format("The robot has none yet. Take one over: gaitway motion adapt {} --robot {}",
                            motion->name, options.robot.string())
              : input::suggest(motion->name, known);
      throw std::invalid_argument(fmt::format("{}: the event at {:g} s: there is no motion '{}'. {}",
                                              options.scenario->string(), event.at_s, motion->name, remedy));
    }
  }
}

// Plug-ins that all work, but of which none moves a joint, are somebody's mistake.
void require_joint_plan(const core::PluginExchange& plugins, const RunOptions& options) {
  const bool all_known = plugins.descriptions.size() == plugins.configuration.plugins.size();
  if (all_known && plugins.writer_of("joint_plan").empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: no plug-in writes the topic 'joint_plan', so nothing would move. Add 'kinematics', or another "
        "plug-in that writes it",
        options.config.string()));
  }
}

// What became of the robot comes first; a run that went well says by its code that its logs have not.
int exit_code_with(const RunLogs& logs, int outcome, const RunOptions& options) {
  constexpr int kExitIncomplete = 4;
  if (logs.complete()) return outcome;
  fmt::print(stderr, "gaitway: the results in {} are incomplete; make room on the disk and run again\n",
             options.out.string());
  return outcome == 0 ? kExitIncomplete : outcome;
}

int run(const RunOptions& options) {
  check(options);
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  msgcontroller::require_proven_network(robot, options.accept_unproven);
  simulator::Scenario scenario = scenario_of(options, robot);
  const std::optional<world::World> world = world_of(options.world, scenario.world);
  const bool navigates = walks_ways(scenario) || options.mission.has_value();
  if (options.mission) scenario.to_the_end = true;  // a fall may be what it gets up from
  const core::PluginExchange plugins = plugins_of(options, navigates, world);
  const std::string commander = plugins.behaviour();
  if (!commander.empty()) {
    leave_walk_to(commander, options, scenario);
  }
  simulator::CosimulationOptions cosimulation_options;
  cosimulation_options.plant.seed = options.seed;
  cosimulation_options.plant.mismatch = options.mismatch;
  cosimulation_options.plant.conditions = scenario.conditions;
  cosimulation_options.plant.world = world;
  cosimulation_options.localization.is_there = options.localization && navigates;
  cosimulation_options.main_controller.configuration = options.config;
  cosimulation_options.main_controller.try_at_start = true;
  cosimulation_options.main_controller.plugins = plugins.configuration;
  cosimulation_options.camera.always = options.eyes.has_value();
  simulator::Cosimulation cosimulation(robot, cosimulation_options);
  require_joint_plan(plugins, options);
  if (plugins.writer_of("motion_state") == "trajectory") {
    require_known_motions(scenario, options, plugins.configuration);
  }
  EyeFiles eyes(options.eyes, cosimulation);
  prepare_output(options.out);

  RunRecorder recorder(cosimulation, options.out / "bus.log", true);
  cosimulation.observe(&recorder);
  Snapshots snapshots =
      options.film ? Snapshots((*options.film)[0],
                               ((*options.film)[1] - (*options.film)[0]) / (Snapshots::kPictures - 1), false)
      : options.to || options.mission
          ? Snapshots(kFirstPicture_s, 1.0, true)
          : Snapshots(kFirstPicture_s, scenario.seconds / Snapshots::kPictures, false);
  const ProgressLine progress(!options.quiet);
  RunLogs logs(options.out, robot, recorder, [&progress](const std::string& news) {
    progress.show("");
    fmt::print(stderr, "gaitway: {}\n", news);
  });
  RunTiming timing;
  const auto began = Clock::now();
  const auto so_far = [&] {
    timing.wall_s = seconds_since(began);
    return summary(cosimulation, recorder, timing, options.seed, options.mismatch);
  };
  timing.wall_s = simulate(cosimulation, scenario, options.to.has_value(), options.pictures, recorder,
                           snapshots, eyes, logs, so_far, progress);
  timing.physics_only_wall_s = cosimulation.plant().replay_wall_s(recorder.torques());

  nlohmann::ordered_json result = summary(cosimulation, recorder, timing, options.seed, options.mismatch);
  logs.write_summary(result, true);
  const std::filesystem::path strip = options.out / "walk.png";
  if (options.pictures) {
    try {
      snapshots.write(cosimulation.plant(), strip);
    } catch (const std::runtime_error& error) {
      fmt::print(stderr, "gaitway: no pictures: {}\n", error.what());
    }
  }
  const core::MainControllerStatistics statistics = cosimulation.main_controller().statistics();
  logs.try_to([&] {
    write_report(options.out / "report.html",
                 {robot, cosimulation.plant().solids(), recorder, statistics, result, strip});
  });
  if (!options.quiet) {
    fmt::print("{}  results                   {}\n", summary_table(result),
               (options.out / "report.html").string());
  }
  return exit_code_with(logs, exit_code(outcome_of(cosimulation, recorder).verdict), options);
}

}  // namespace

void add_run(const CommandLine& program) {
  const CommandLine command = add_command(program, "run");
  RunOptions& options = command.runs(run);
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--config", options.config,
                 "Plug-ins of the main controller (YAML); a file, or the name of a shipped one");
  command.repeated(
      "--with", options.with,
      "Plug-in library to run, in the place of those whose topics it writes; may be given again");
  const Option scenario = command.option("--scenario", options.scenario,
                                         "Timed commands, pushes and faults (YAML); a file, or the name of a "
                                         "shipped one");
  command
      .option("--walk", options.walk, "Walk VX[,VY[,WZ]]: forward m/s, left m/s, turn rad/s (default 0.15)")
      .excludes(scenario);
  const Option mission = command.option(
      "--mission", options.mission,
      "Behaviour tree to run (XML): a file, or the name of a shipped one; the run ends when it has");
  command
      .option("--to", options.to,
              "Walk to X,Y,YAW in m, m and degrees of the world, and end there: footsteps are planned "
              "through the world and followed")
      .excludes(scenario)
      .excludes(mission)
      .values(3);
  command.option("!--no-localization", options.localization,
                 "Nothing in the room tells a robot on its way where it is: dead reckoning alone");
  command
      .option("--seconds", options.seconds,
              "Virtual time to run (default 20, or the scenario's; with --to and --mission at most 120)")
      .between(0.001, 86400.0);
  command.option("--seed", options.seed, "Seed of mismatch, noise and clock drifts");
  command.option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  command.option("--accept-unproven", options.accept_unproven,
                 "Run even if some message of the bus may miss its deadline");
  command.option("--mismatch", options.mismatch, "Scale of what the planner does not know of the robot")
      .between(0.0, 10.0);
  add_world_options(command, options.world);
  command.option("--out", options.out, "Folder for the results");
  command.option("!--no-pictures", options.pictures, "Draw no film strip");
  command.option("--film", options.film,
                 "FROM,TO: the film strip shows this part of the run [s] (default: all of it)");
  command.option("--eyes", options.eyes,
                 "Folder for each pair of pictures that the robot's cameras take, side by side");
  command.option("--quiet", options.quiet, "No progress line and no table");
  command.footer(
      "Examples:\n"
      "  gaitway run                                      walks straight on at 0.15 m/s for 20 s\n"
      "  gaitway run --walk 0.1,0.03,0.2 --seconds 30     forward, sideways and turning\n"
      "  gaitway run --scenario push.yaml --seed 7 --out out/push\n"
      "  gaitway run --scenario push.yaml --film 3.9,5    pictures of the first push\n"
      "  gaitway run --world boxes --world-seed 3         in a room with boxes\n"
      "  gaitway run --world boxes --to 2.3,2,90          to a place in it\n"
      "  gaitway run --mission patrol                     what a behaviour tree decides\n"
      "  gaitway run --with build/libsway.so              with a plug-in of yours\n"
      "Exit code: 0 the robot stayed up and did what it was asked, 2 it fell, 3 it stayed up, but walked or "
      "turned less than\n"
      "half of what was commanded (start-ups not counted), or more than a tenth of its batches were refused, "
      "or it had none; 1 the "
      "input was bad\n"
      "and nothing moved, 4 as 0, but results are incomplete: the disk was full, which costs lines of logs "
      "and "
      "never the run\n"
      "(what is missing is said, and stands in summary.json). Until the end, and so after a kill, "
      "summary.json "
      "has \"ended\": false.\n"
      "With --mission: 0 it succeeded, falls or not, or it is one without an end and "
      "the "
      "robot "
      "is on its feet,\n"
      "2 the robot lies at the end, 3 the mission failed, has not come to its end, or waits at the end "
      "because somebody else "
      "commands.");
}

}  // namespace gaitway::tools
