// `gaitway simulator`: a simulated robot in a world, with a page to walk it, plan, push, break, pause and
// rewind.

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/simulator/command_log.hpp"
#include "gaitway/timeline/director.hpp"
#include "gaitway/timeline/live_simulation.hpp"
#include "gaitway/world/world_choice.hpp"
#include "tools/command_line.hpp"
#include "tools/run/navigation_option.hpp"
#include "tools/run/run_report.hpp"
#include "tools/run/shipped_option.hpp"
#include "tools/serve/api_entry.hpp"
#include "tools/serve/module_keeper.hpp"
#include "tools/serve/module_options.hpp"
#include "tools/simulator/twin_choice.hpp"
#include "tools/simulator/way_preview.hpp"
#include "tools/twin/twin_server.hpp"

namespace gaitway::tools {
namespace {

struct SimulatorOptions {
  std::vector<std::string>
      robots;  // a folder with robot.urdf and robot.yaml, a real robot's address, or both
  std::filesystem::path robot_token_file, robot_ca_file;
  int preflight_robots = 20;
  std::filesystem::path config = process::default_config_file().parent_path() / "serve.yaml";
  std::string profile;  // of the bus; empty: what the robot's network file says
  bool accept_unproven = false;
  ModuleOptions module;
  std::optional<std::string> world;
  std::optional<std::uint64_t> world_seed;
  bool localization = true;
  std::uint64_t seed = 1;
  std::optional<double> mismatch;
  double speed = 1.0;
  bool paused = false;
  std::optional<double> seconds;
  std::filesystem::path out = "out/simulator";
  bool quiet = false;
};

constexpr int kLook_ms = 20;
constexpr std::int64_t kApiBudget_ns = 500'000'000;  // nobody waits for it, and the computer has more to do

// Where the processes of one simulator meet.
struct Sockets {
  explicit Sockets(const std::filesystem::path& folder)
      : memory(folder / "memory.sock"),
        link(folder / "link.sock"),
        orders(folder / "simulation.sock"),
        twin(folder / "twin.sock") {}
  std::filesystem::path memory, link, orders, twin;
};

// A twin is as its robot is described, in a room that nobody has described.
double mismatch_of(const SimulatorOptions& options, bool is_twin) {
  return options.mismatch.value_or(is_twin ? 0.0 : 1.0);
}
std::string world_of(const SimulatorOptions& options, bool is_twin) {
  return options.world.value_or(is_twin ? "empty" : "boxes");
}

// All plug-ins but the robot's side of the API, which comes when the simulation goes live. None has a process
// of its own: a simulation that is copied has no other processes.
core::Configuration plugins_of(const SimulatorOptions& options, const world::World& world,
                               core::PluginEntry& api) {
  core::Configuration configuration = core::read_configuration(configuration_file(options.config));
  add_navigation(configuration, world);
  api = api_of(configuration);
  api.containment.budget_ns = kApiBudget_ns;
  std::erase_if(configuration.plugins,
                [&api](const core::PluginEntry& entry) { return entry.name == api.name; });
  for (core::PluginEntry& entry : configuration.plugins) {
    if (core::is_python(entry.library)) {
      throw std::invalid_argument(fmt::format(
          "{}, line {}: plug-in '{}' is written in Python, which has a process of its own, and none "
          "can be rewound. Try it with gaitway run or gaitway serve",
          configuration.file.string(), entry.line, entry.name));
    }
    if (entry.isolation == core::Isolation::none) continue;
    fmt::print(
        stderr,
        "gaitway simulator: {}, line {}: plug-in '{}' runs in the simulation's own process here, since no "
        "other can be rewound\n",
        configuration.file.string(), entry.line, entry.name);
    entry.isolation = core::Isolation::none;
  }
  return configuration;
}

simulator::CosimulationOptions settings_of(const SimulatorOptions& options, const world::World& world,
                                           const std::optional<RobotNow>& now, const Sockets& sockets,
                                           core::PluginEntry& api) {
  simulator::CosimulationOptions settings;
  settings.plant.seed = options.seed;
  settings.plant.mismatch = mismatch_of(options, now.has_value());
  settings.plant.world = world;
  if (now && now->state == "stands") settings.plant.start_rad = now->joint_rad;
  settings.localization.is_there = options.localization;
  settings.main_controller.configuration = configuration_file(options.config);
  settings.main_controller.plugins = plugins_of(options, world, api);
  settings.main_controller.memory_socket = sockets.memory;
  settings.main_controller.isolation.lock_step = false;  // the API's process may hang as it likes
  return settings;
}

// What else a run of the commands must be told to be the same.
std::string replay_options(const SimulatorOptions& options, const std::filesystem::path& robot) {
  const SimulatorOptions usual;
  std::string text;
  const auto add = [&text](const char* name, const std::string& value, bool needed) {
    if (needed) text += fmt::format(" {} {}", name, value);
  };
  add("--robot", robot.string(), robot != process::default_robot_directory());
  add("--config", options.config.string(), options.config != usual.config);
  add("--profile", options.profile, !options.profile.empty());
  add("--seed", std::to_string(options.seed), options.seed != usual.seed);
  add("--mismatch", fmt::format("{}", options.mismatch.value_or(1.0)), options.mismatch.value_or(1.0) != 1.0);
  if (!options.localization) text += " --no-localization";
  return text;
}

// OUT/commands.yaml: what was asked and done so far, a whole scenario at every instant, since the past may be
// played anew: written once a second, so that a kill leaves it.
class CommandFile {
 public:
  CommandFile(const SimulatorOptions& options, const world::World& world, const urdf::RobotModel& robot)
      : options_(options), world_(world), robot_(robot) {}

  // Now and then. A disk that takes nothing costs the file, which is told once.
  void look(const timeline::Timeline& timeline) {
    const std::int64_t now_ns = process::monotonic_ns();
    if (now_ns < due_ns_) return;
    due_ns_ = now_ns + facts::kSecond_ns;
    try {
      write(timeline);
      told_.clear();
    } catch (const std::runtime_error& error) {
      if (std::exchange(told_, error.what()) != error.what()) {
        fmt::print(stderr, "gaitway simulator: {}; it is tried again\n", error.what());
      }
    }
  }
  // How many events it has. Throws std::runtime_error.
  std::size_t write(const timeline::Timeline& timeline) {
    std::vector<simulator::ScenarioEvent> events;
    const double seconds = static_cast<double>(timeline.recorded_ns()) * 1e-9;
    for (const timeline::TimedEvent& event : timeline.events()) {
      // What was done at the very end has had no time to happen.
      if (event.at_ns < timeline.recorded_ns()) events.push_back(timeline::scenario_event(event, robot_));
    }
    if (seconds <= 0.0) return 0;
    std::string text = simulator::scenario_text(seconds, world_, events, robot_);
    if (text == written_) return events.size();
    process::replace_text_file(file(), text);
    written_ = std::move(text);
    return events.size();
  }
  [[nodiscard]] std::filesystem::path file() const { return options_.out / "commands.yaml"; }

 private:
  const SimulatorOptions& options_;
  const world::World& world_;
  const urdf::RobotModel& robot_;
  std::int64_t due_ns_ = 0;
  std::string written_, told_;
};

void write_commands(const SimulatorOptions& options, const urdf::RobotModel& robot, bool is_twin,
                    timeline::Director& director, CommandFile& commands) {
  const auto digest = director.finish();
  const double seconds = static_cast<double>(director.timeline().recorded_ns()) * 1e-9;
  const std::size_t events = commands.write(director.timeline());
  if (seconds <= 0.0 || options.quiet) return;
  fmt::print("gaitway simulator: {:.3f} s, {} events, digest {}; ", seconds, events,
             digest ? fmt::format("{:016x}", *digest) : "unknown");
  if (is_twin) {
    fmt::print("what was asked is in {}, but for the posture in which the robot was at the start\n",
               commands.file().string());
  } else {
    fmt::print("once more: gaitway run{} --scenario {}\n", replay_options(options, robot.directory),
               commands.file().string());
  }
}

// Until it is told to stop, or its time is over.
void serve(const SimulatorOptions& options, timeline::Director& director, TwinServer* twin,
           CommandFile& commands) {
  process::stop_on_signals();
  const auto end_ns = options.seconds ? static_cast<std::int64_t>(*options.seconds * 1e9)
                                      : std::numeric_limits<std::int64_t>::max();
  while (!process::stop_requested() && director.now_ns() < end_ns) {
    director.step(kLook_ms);
    commands.look(director.timeline());
    if (twin == nullptr) continue;
    twin->set_pace({.plays = director.playing(), .speed = director.speed(), .run = director.run()});
    for (const std::string& line : twin->take_lines()) {
      if (!options.quiet) fmt::print(stderr, "gaitway simulator: {}\n", input::terminal_text(line));
    }
  }
}

// nullptr: there is no real robot.
std::unique_ptr<TwinServer> twin_of(const SimulatorOptions& options, const TwinChoice& choice,
                                    const urdf::RobotModel& robot, const world::World& world,
                                    const std::filesystem::path& socket) {
  if (!choice.there) return nullptr;
  return std::make_unique<TwinServer>(
      TwinOptions{.there = *choice.there,
                  .here = own_api(options.module),
                  .flight_arguments = flight_arguments(*choice.there, robot.directory, options.config, world,
                                                       options.preflight_robots),
                  .out = options.out / "preflight"},
      robot, socket);
}

int simulate(const SimulatorOptions& options) {
  const TwinChoice choice = twin_choice(options.robots, options.robot_token_file, options.robot_ca_file);
  const bool is_twin = choice.there.has_value();
  const urdf::RobotModel robot = msgcontroller::load_robot(choice.folder, options.profile);
  msgcontroller::require_proven_network(robot, options.accept_unproven);
  world::World world = world::load_world({.name = world_of(options, is_twin),
                                          .random_seed = options.world_seed,
                                          .written_in = "--world",
                                          .line = 0});
  std::optional<RobotNow> now;
  if (is_twin) {
    now = ask_real_robot(*choice.there, robot);
    if (now->place) world.start = {{(*now->place)[0], (*now->place)[1]}, (*now->place)[2], 0};
  }
  prepare_output(options.out);
  const process::PrivateFolder folder("gaitway_simulator");
  const Sockets sockets(folder.path());
  timeline::LiveOptions live{.memory_socket = sockets.memory,
                             .api = {},
                             .digest_every_ns = timeline::Timeline::kSpacing_ns,
                             .quiet = options.quiet};
  const simulator::CosimulationOptions settings = settings_of(options, world, now, sockets, live.api);
  set_link(live.api, "unix:" + sockets.link.string());
  // First: what comes after it has threads.
  timeline::CopyHandle start = timeline::start_simulation(
      [&] { return std::make_unique<timeline::ReplayedRun>(robot, settings); },
      [&live](timeline::ReplayedRun& run, const timeline::CopyChannel& channel, const nlohmann::json& told) {
        timeline::live(live, run, channel, told);
      });
  WayPreview preview(robot, world);
  timeline::Director director(std::move(start), {.socket = sockets.orders,
                                                 .playing = !options.paused,
                                                 .speed = options.speed,
                                                 .world = world.name,
                                                 .plan_way = [&preview](const auto& goal, const auto& state) {
                                                   return preview.plan(goal, state);
                                                 }});
  const ModuleKeeper module(
      module_arguments(options.module, {.robot = choice.folder,
                                        .profile = options.profile,
                                        .link = "unix:" + sockets.link.string(),
                                        .simulation = "unix:" + sockets.orders.string(),
                                        .recordings = options.out / "recordings",
                                        .twin = is_twin ? "unix:" + sockets.twin.string() : ""}));
  std::unique_ptr<TwinServer> twin = twin_of(options, choice, robot, world, sockets.twin);
  CommandFile commands(options, world, robot);
  serve(options, director, twin.get(), commands);
  twin.reset();
  write_commands(options, robot, is_twin, director, commands);
  return kExitFine;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "simulator");
  SimulatorOptions& options = command.runs(simulate);
  command.option("--world", options.world,
                 "A file, or the name of a shipped world (`gaitway world list`); without it boxes, and empty "
                 "for a twin");
  command.option("--world-seed", options.world_seed, "Seed of its random courses, in place of their own")
      .between(0.0, std::numeric_limits<int>::max());
  command.repeated("--robot", options.robots,
                   "Folder with robot.urdf and robot.yaml; or ws://HOST:PORT or wss://HOST:PORT, a real "
                   "robot's API, whose twin it is "
                   "then; given twice, both");
  command.option("--robot-token-file", options.robot_token_file,
                 "File with the token that the real robot wants");
  command.option("--robot-ca", options.robot_ca_file,
                 "Whom to trust (PEM), where the real robot's certificate is its own");
  command
      .option("--preflight-robots", options.preflight_robots,
              "How many simulated robots try what is to be sent to the real one: fewer are quicker, and show "
              "less")
      .between(1, 1000);
  command.option(
      "--config", options.config,
      "Plug-ins of the main controller (YAML); a file, or the name of a shipped one. An api is added");
  add_module_options(command, options.module);
  command.option("--speed", options.speed, "Times real time, at first")
      .between(timeline::kSlowest, timeline::kFastest);
  command.option("--paused", options.paused, "Begin paused");
  command.option("--seconds", options.seconds, "Virtual time to run; without it until told to stop")
      .between(0.001, 86400.0 * 365.0);
  command.option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  command.option("--accept-unproven", options.accept_unproven,
                 "Run even if some message of the bus may miss its deadline");
  command.option("--seed", options.seed, "Seed of mismatch, noise and clock drifts");
  command
      .option("--mismatch", options.mismatch,
              "Scale of what the planner does not know of the robot: 1 without it, and 0 for a twin")
      .between(0.0, 10.0);
  command.option("!--no-localization", options.localization,
                 "Nothing in the room tells the robot where it is: it walks by its own odometry");
  command.option("--out", options.out, "Folder for what was asked (commands.yaml) and for recordings");
  command.option("--quiet", options.quiet, "No events");
  command.footer(
      "Examples:\n"
      "  gaitway simulator                           until Ctrl-C; its page is http://127.0.0.1:9090\n"
      "  gaitway simulator --world doorway --speed 2\n"
      "  gaitway simulator --world my_world.yaml --port 9191 --paused\n"
      "  gaitway simulator --robot ws://robot:9090 --robot-token-file token      the twin of a real robot\n"
      "  gaitway run --scenario out/simulator/commands.yaml     plays what was done once more, headless\n"
      "On the page: click the floor to choose where to walk; docs/simulator.md tells the rest.\n"
      "Exit code: 0 it was told to stop, 1 the input was bad and nothing moved.");
}

}  // namespace gaitway::tools
