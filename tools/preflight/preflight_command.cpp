// `gaitway preflight`: tries something on many simulated robots, and sends it to a real one if all stayed up.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/preflight/preflight.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/log_file.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "tools/command_line.hpp"
#include "tools/preflight/flight_sender.hpp"
#include "tools/preflight/robot_now.hpp"
#include "tools/run/navigation_option.hpp"
#include "tools/run/run_report.hpp"
#include "tools/run/world_option.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

struct PreflightCommand {
  std::filesystem::path robot = process::default_robot_directory();
  std::filesystem::path config = process::default_config_file();
  std::string profile;
  WorldOptions world;
  std::optional<std::vector<double>> walk;  // m/s, m/s, rad/s
  std::string motion;
  std::optional<std::vector<double>> to;  // m, m, deg
  std::optional<std::filesystem::path> scenario;
  std::vector<std::string> set;   // PLUGIN.PARAMETER=VALUE
  std::optional<double> seconds;  // none: kUsual_s, or the scenario's
  int robots = 20;
  double mismatch = 1.0;
  ApiAddress api;
  std::string from;  // URL of the robot's API; empty: no robot
  bool send = false;
  std::string override_reason;
  std::filesystem::path out = "out/preflight";
  bool json = false;
};

constexpr double kUsual_s = 20.0;
constexpr double kStandsFor_s = 4.0;  // after a walk
constexpr double kBegins_s = 1.0;     // what is asked for, in the flight: the robot has come to its stand
constexpr std::size_t kShortestReason = 10;
constexpr int kExitNotPassed = 2;
constexpr int kExitNotOnRecord = 4;

ParameterSetting setting_of(const std::string& text) {
  const std::size_t dot = text.find('.'), equals = text.find('=');
  if (dot == std::string::npos || equals == std::string::npos || dot == 0 || equals < dot + 2 ||
      equals + 1 == text.size()) {
    throw std::invalid_argument(fmt::format(
        "--set {}: wants PLUGIN.PARAMETER=VALUE, for example trajectory.step_time='0.3 s'", text));
  }
  return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
}

void check(const PreflightCommand& options) {
  const int tasks = (options.walk ? 1 : 0) + (options.motion.empty() ? 0 : 1) + (options.to ? 1 : 0) +
                    (options.scenario ? 1 : 0);
  if (tasks > 1) {
    throw std::invalid_argument("--walk, --motion, --to and --scenario: one of them is tried at a time");
  }
  if (tasks == 0 && options.set.empty()) {
    throw std::invalid_argument("nothing to try: give --walk, --motion, --to, --scenario or --set");
  }
  if (options.walk && (options.walk->empty() || options.walk->size() > 3)) {
    throw std::invalid_argument("--walk: wants VX[,VY[,WZ]] in m/s, m/s and rad/s, for example 0.15,0,0.1");
  }
  if (options.send && options.from.empty()) {
    throw std::invalid_argument("--send: to whom? Name the robot: --from ws://HOST:PORT");
  }
  if (options.send && options.scenario) {
    throw std::invalid_argument(
        "--scenario: faults and pushes cannot be sent. Send --walk, --motion, --to or --set");
  }
  if (!options.override_reason.empty() && !options.send) {
    throw std::invalid_argument("--override: there is nothing to send: add --send");
  }
  if (!options.override_reason.empty() && options.override_reason.size() < kShortestReason) {
    throw std::invalid_argument(
        fmt::format("--override '{}': a reason has {} characters at least, and is recorded",
                    options.override_reason, kShortestReason));
  }
}

RobotTask task_of(const PreflightCommand& options) {
  RobotTask task{.walk = options.walk,
                 .walk_seconds = options.seconds.value_or(kUsual_s) - kBegins_s,
                 .motion = options.motion,
                 .goal = std::nullopt,
                 .settings = {}};
  if (options.to)
    task.goal = std::array{(*options.to)[0], (*options.to)[1], (*options.to)[2] * facts::kRadPerDegree};
  for (const std::string& text : options.set) task.settings.push_back(setting_of(text));
  return task;
}

preflight::Flight flight_of(const PreflightCommand& options, const RobotTask& task,
                            const urdf::RobotModel& robot) {
  if (options.scenario) {
    simulator::Scenario scenario = simulator::load_scenario(*options.scenario, robot);
    const double seconds = options.seconds.value_or(scenario.seconds);
    if (!scenario.events.empty() && scenario.events.back().at_s >= seconds) {
      throw std::invalid_argument(
          fmt::format("--seconds {:g}: {} has an event at {:g} s, which nobody would see", seconds,
                      options.scenario->string(), scenario.events.back().at_s));
    }
    return {std::move(scenario.events), seconds};
  }
  preflight::Flight flight{.events = {}, .seconds = options.seconds.value_or(kUsual_s)};
  if (task.walk) {
    std::vector<double> walk = *task.walk;
    walk.resize(3, 0.0);
    flight.events = simulator::walk_scenario(walk[0], walk[1], walk[2], flight.seconds).events;
    // Whoever sends it has the robot stand afterwards, which is where a bad walk falls.
    flight.events.push_back({flight.seconds, simulator::WalkEvent{.walk = false}});
    flight.seconds += kStandsFor_s;
  }
  if (!task.motion.empty()) flight.events.push_back({kBegins_s, simulator::MotionEvent{task.motion}});
  if (task.goal) flight.events.push_back({kBegins_s, simulator::WalkToEvent{task.goal}});
  return flight;
}

void set_parameter(core::PluginEntry& entry, const ParameterSetting& setting) {
  std::erase_if(entry.parameters, [&setting](const auto& known) { return known.name == setting.parameter; });
  entry.parameters.push_back({setting.parameter, setting.value, entry.line});
}

core::Configuration plugins_of(const PreflightCommand& options, const RobotTask& task,
                               const std::optional<RobotNow>& now, const std::optional<world::World>& world) {
  core::Configuration plugins = core::read_configuration(options.config);
  // Of a served robot's configuration: nobody comes by a socket here.
  std::erase_if(plugins.plugins, [](const core::PluginEntry& entry) { return entry.child.local_sockets; });
  if (task.goal) add_navigation(plugins, world);
  // As the robot has them now: what somebody has changed there counts.
  for (const RobotParameter& one : now ? now->parameters : std::vector<RobotParameter>{}) {
    const auto entry = std::ranges::find(plugins.plugins, one.plugin, &core::PluginEntry::name);
    if (entry != plugins.plugins.end()) set_parameter(*entry, {one.plugin, one.name, one.value});
  }
  for (const ParameterSetting& one : task.settings) {
    const auto entry = std::ranges::find(plugins.plugins, one.plugin, &core::PluginEntry::name);
    if (entry == plugins.plugins.end()) {
      throw std::invalid_argument(fmt::format("--set {}.{}: {} has no plug-in '{}'", one.plugin,
                                              one.parameter, plugins.file.string(), one.plugin));
    }
    set_parameter(*entry, one);
  }
  return plugins;
}

preflight::PreflightOptions settings_of(const PreflightCommand& options, const RobotTask& task,
                                        const std::optional<RobotNow>& now) {
  preflight::PreflightOptions settings{.robot = {}, .robots = options.robots};
  auto world = world_of(options.world, std::nullopt);
  if (task.goal && !world) {
    world = world::load_world({.name = "empty", .random_seed = {}, .written_in = "--to", .line = 0});
  }
  if (now && now->place && world) {
    const auto& [x_m, y_m, yaw_rad] = *now->place;
    world->start = {.position_m = {x_m, y_m}, .yaw_rad = yaw_rad, .line = 0};
  }
  settings.robot.plant.mismatch = options.mismatch;
  settings.robot.localization.is_there = task.goal.has_value();
  settings.robot.main_controller.configuration = options.config;
  settings.robot.main_controller.plugins = plugins_of(options, task, now, world);
  settings.robot.plant.world = std::move(world);
  if (now) settings.robot.plant.start_rad = now->joint_rad;
  return settings;
}

// What was sent, to whom, and on whose word; a line each. Throws std::runtime_error when it is not on record.
void record(const PreflightCommand& options, const preflight::Verdict& verdict, const std::string& outcome) {
  const std::filesystem::path file = options.out / "sent.jsonl";
  const json line{
      {"time", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()))},
      {"robot", options.from},
      {"walk", options.walk ? json(*options.walk) : json()},
      {"motion", options.motion},
      {"to", options.to ? json(*options.to) : json()},
      {"set", options.set},
      {"passed", verdict.passed()},
      {"robots", verdict.trials.size()},
      {"override", options.override_reason},
      {"outcome", outcome}};
  process::LogFile log(file, {.start = process::LogOptions::Start::go_on});
  if (!log.append(line.dump() + "\n")) {
    throw std::runtime_error(fmt::format(
        "{}: what is sent must be on record, and cannot be written: {}. Make room, or choose another --out",
        file.string(), log.error()));
  }
  log.sync();
}

// Of what has been decided already: false, it is not on record, which is told.
bool note(const PreflightCommand& options, const preflight::Verdict& verdict, const std::string& outcome) {
  try {
    record(options, verdict, outcome);
    return true;
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "gaitway preflight: not on record: \"{}\": {}\n", outcome, error.what());
    return false;
  }
}

int send_or_refuse(const PreflightCommand& options, const RobotTask& task, const preflight::Verdict& verdict,
                   ApiClient& client, const std::string& change) {
  if (!verdict.all_passed() && options.override_reason.empty()) {
    static_cast<void>(note(options, verdict, "not sent"));
    fmt::print(
        stderr,
        "gaitway preflight: not sent. Whoever sends it nevertheless gives a reason: --override REASON\n");
    return kExitNotPassed;
  }
  if (!change.empty()) {
    static_cast<void>(note(options, verdict, "not sent: " + change));
    throw NotDone("not sent: " + change);
  }
  // Before it: whatever becomes of this process, it is on record that the robot was told.
  record(options, verdict, "begun");
  if (!options.json) {
    fmt::print("  sending     {}\n", options.from);
    std::fflush(stdout);
  }
  try {
    send(client, task);
  } catch (const std::exception& error) {
    static_cast<void>(note(options, verdict, error.what()));
    throw;
  }
  const bool on_record = note(options, verdict, "done");
  if (!options.json) fmt::print("  sent        {}: done\n", options.from);
  return on_record ? kExitFine : kExitNotOnRecord;
}

preflight::Verdict try_it(const PreflightCommand& options, const urdf::RobotModel& robot,
                          const preflight::Flight& flight, const preflight::PreflightOptions& settings) {
  const ProgressLine progress(!options.json);
  const preflight::Verdict verdict =
      preflight::fly(robot, flight, settings, [&progress](std::size_t done, std::size_t all) {
        progress.show(fmt::format("  {} of {} simulated robots", done, all));
      });
  progress.show("");
  prepare_output(options.out);
  process::write_text_file(options.out / "verdict.json", preflight::verdict_json(verdict).dump(2) + "\n");
  const std::filesystem::path picture = options.out / "worst.png";
  std::string drawn = picture.string();
  try {
    preflight::draw_trial(picture, robot, flight, settings, verdict.worst());
  } catch (const std::runtime_error& error) {
    drawn = fmt::format("none: {}", error.what());
  }
  if (options.json) {
    fmt::print("{}\n", preflight::verdict_json(verdict).dump(2));
  } else {
    fmt::print("{}  picture     {}\n", preflight::verdict_text(verdict), drawn);
  }
  return verdict;
}

int preflight_command(const PreflightCommand& options) {
  check(options);
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  const RobotTask task = task_of(options);
  const preflight::Flight flight = flight_of(options, task, robot);
  std::optional<RobotNow> now;
  if (!options.from.empty()) {
    ApiAddress address = options.api;
    address.url = options.from;
    ApiClient client(address);
    now = ask_state(client, robot);
    if (options.send && now->state != "stands") {
      throw NotDone(fmt::format("not tried: the robot {} and must stand", input::terminal_text(now->state)));
    }
  }
  const preflight::Verdict verdict = try_it(options, robot, flight, settings_of(options, task, now));
  if (!options.send) return verdict.all_passed() ? kExitFine : kExitNotPassed;
  ApiAddress address = options.api;
  address.url = options.from;
  ApiClient client(address);
  return send_or_refuse(options, task, verdict, client,
                        change_between(*now, ask_state(client, robot), robot));
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "preflight");
  PreflightCommand& options = command.runs(preflight_command);
  constexpr int kNumbers = 3;
  command.option("--walk", options.walk, "VX[,VY[,WZ]] in m/s, m/s and rad/s: walk so until the end");
  command.option("--motion", options.motion, "Play this key-frame motion");
  command.option("--to", options.to, "X,Y,YAW in m, m and degrees: walk to this place of the world")
      .values(kNumbers);
  command.option("--scenario", options.scenario,
                 "Whatever happens in this scenario (YAML); it cannot be sent");
  command.option("--set", options.set, "PLUGIN.PARAMETER=VALUE: with this value; several may be given");
  command.option(
      "--from", options.from,
      "ws://HOST:PORT or wss://HOST:PORT, a robot's API: the simulated robots begin in its posture, and "
      "at its place");
  command.option("--token-file", options.api.token_file, "File with the token that the robot wants");
  command.option("--ca", options.api.ca_file,
                 "Whom to trust (PEM), where the robot's certificate is its own");
  command.option("--send", options.send, "Then send it to that robot, if all of them stayed up");
  command.option("--override", options.override_reason,
                 "Send it even if one fell: the reason, which is recorded in OUT/sent.jsonl");
  command.option("--robots", options.robots, "How many simulated robots").between(1, 1000);
  command
      .option("--seconds", options.seconds,
              "How long each of them is watched: 20 without it, or as long as the scenario")
      .between(1.5, 600.0);
  command.option("--mismatch", options.mismatch, "Scale of how they differ from their description")
      .between(0.0, 10.0);
  add_world_options(command, options.world);
  command.option("--robot", options.robot, "Folder with robot.urdf, robot.yaml and calibration.yaml");
  command.option("--config", options.config, "Plug-ins of the main controller (YAML)");
  command.option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  command.option("--out", options.out, "Folder for verdict, picture and the record of what was sent");
  command.option("--json", options.json, "The verdict as JSON");
  command.footer(
      "Examples:\n"
      "  gaitway preflight --walk 0.2\n"
      "  gaitway preflight --motion wave --from ws://127.0.0.1:9090 --send\n"
      "  gaitway preflight --to 1,0.5,0 --world boxes --from wss://robot:9090 --token-file token --send\n"
      "  gaitway preflight --walk 0.15 --set trajectory.com_height='0.36 m'\n"
      "Exit code: 0 all stayed up, and it was sent if that was asked; 2 not all stayed up; 3 the robot did "
      "not do "
      "it; 1 the\n"
      "input was bad, or the robot refused, or what was to be sent could not be put on record first; 4 it "
      "was "
      "sent, but its\n"
      "end is not on record.");
}

}  // namespace gaitway::tools
