// `gaitway serve`: the simulated robot at the pace of real time, with the robot API on a WebSocket, and the
// page.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/core/events.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/manager/plugin_requests.hpp"
#include "gaitway/msgclient/memory_block_thread.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/simulator/command_log.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/pace.hpp"
#include "gaitway/simulator/simulation_desk.hpp"
#include "tools/command_line.hpp"
#include "tools/run/mission_option.hpp"
#include "tools/run/navigation_option.hpp"
#include "tools/run/run_logs.hpp"
#include "tools/run/run_recorder.hpp"
#include "tools/run/run_report.hpp"
#include "tools/run/shipped_option.hpp"
#include "tools/run/world_option.hpp"
#include "tools/serve/api_entry.hpp"
#include "tools/serve/module_keeper.hpp"
#include "tools/serve/module_options.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;

struct ServeOptions {
  std::filesystem::path robot = process::default_robot_directory();  // folder with robot.urdf and robot.yaml
  std::filesystem::path config = process::default_config_file().parent_path() /
                                 "serve.yaml";  // plug-ins of the main controller, the api among them
  std::string profile;                          // of the bus; empty: what the robot's network file says
  bool accept_unproven = false;
  ModuleOptions module;
  std::optional<double> seconds;
  double speed = 1.0;  // times real time
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  WorldOptions world;
  std::optional<std::string> mission;  // none: the configuration's
  std::filesystem::path out = "out/serve";
  bool bus_log = false;
  bool quiet = false;
};

constexpr std::int64_t kLongestStop_ns = 5'000 * kMillisecond_ns;  // of the robot's time, until it stands

// Metrics, and what people ask.
class ServeObserver final : public simulator::CosimulationObserver {
 public:
  ServeObserver(simulator::Cosimulation& run, const std::filesystem::path& bus_log)
      : recorder(run, bus_log, false), commands(run) {
    recorder.mission().belongs_to_people();
  }
  void on_frame(const can::SimulatedBus::Delivery& delivery) override { recorder.on_frame(delivery); }
  void on_millisecond(std::int64_t now_ns) override {
    recorder.on_millisecond(now_ns);
    commands.on_millisecond(now_ns - kMillisecond_ns);
  }
  void on_orders(const msgcontroller::PassedOrders& orders, std::int64_t now_ns) override {
    commands.on_orders(orders, now_ns);
  }

  RunRecorder recorder;
  simulator::CommandLog commands;
};

core::Configuration configuration_of(const ServeOptions& options, const std::string& link,
                                     const std::optional<world::World>& world) {
  core::Configuration configuration = core::read_configuration(configuration_file(options.config));
  add_navigation(configuration, world);
  if (options.mission) set_mission(configuration, *options.mission);
  set_link(api_of(configuration), link);
  return configuration;
}

struct Loop {
  simulator::Cosimulation& run;
  simulator::SimulationDesk& desk;
  core::PluginRequests& requests;
  simulator::CommandLog& commands;
  RunLogs& logs;
  RunLogs::Summary so_far;
  core::EventPrinter printer{"gaitway serve"};
  bool quiet = false;

  void millisecond() {
    const std::int64_t now_ns = run.now_ns();
    desk.step();
    run.advance_millisecond();
    if (core::is_tick(now_ns)) {
      requests.step(now_ns);
    }
    constexpr std::int64_t kBetweenPrints_ns = 100 * kMillisecond_ns;
    if (!quiet && now_ns % kBetweenPrints_ns == 0) {
      printer.print(run.main_controller().events());
    }
    logs.look(run.main_controller().events(), so_far);
  }
  // Ends the walk by the safe tail, as fast as the computer can.
  void stand() {
    run.end_orders();
    commands.on_end(run.now_ns());
    const std::int64_t end_ns = run.now_ns() + kLongestStop_ns;
    run.apply({.at_s = 0.0, .action = simulator::StopEvent{}});
    do {
      millisecond();
    } while (run.now_ns() < end_ns && run.message_controller().mode() <= msgcontroller::Mode::safe_tail);
  }
};

void write_commands(const ServeOptions& options, const simulator::Cosimulation& run,
                    const ServeObserver& observer) {
  process::replace_text_file(options.out / "commands.yaml",
                             observer.commands.scenario(static_cast<double>(run.now_ns()) * 1e-9));
}

void write_results(const ServeOptions& options, simulator::Cosimulation& run, ServeObserver& observer,
                   RunLogs& logs, const simulator::Pace& pace, double wall_s) {
  logs.finish(run.main_controller().events());
  nlohmann::ordered_json result =
      summary(run, observer.recorder, {.wall_s = wall_s}, options.seed, options.mismatch);
  const process::DurationSummary late = pace.lateness_us();
  result["pace"] = {{"speed", options.speed},
                    {"lost_s", pace.lost_s()},
                    {"late_us", {{"p50", late.p50}, {"p99", late.p99}, {"max", late.max}}}};
  logs.try_to([&] { write_commands(options, run, observer); });
  logs.write_summary(result, true);
  if (!options.quiet) {
    fmt::print("{}  results                   {}\n", summary_table(result), options.out.string());
  }
}

int serve(const ServeOptions& options) {
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  msgcontroller::require_proven_network(robot, options.accept_unproven);
  prepare_output(options.out);
  const process::PrivateFolder folder("gaitway_serve");
  const std::string link = "unix:" + (folder.path() / "link.sock").string();
  msgclient::MemoryBlock block;
  const msgclient::MemoryBlockThread block_thread(block, folder.path() / "memory.sock");

  simulator::CosimulationOptions settings;
  settings.plant.seed = options.seed;
  settings.plant.mismatch = options.mismatch;
  settings.plant.world = world_of(options.world, std::nullopt);
  settings.memory_block = &block;
  settings.people_outside = true;
  settings.localization.is_there = true;
  settings.main_controller.configuration = configuration_file(options.config);
  settings.main_controller.plugins = configuration_of(options, link, settings.plant.world);
  settings.main_controller.try_at_start = true;
  settings.main_controller.memory_socket = folder.path() / "memory.sock";
  settings.main_controller.isolation.lock_step = false;  // the API's process may hang as it likes
  simulator::Cosimulation run(robot, settings);
  ServeObserver observer(run, options.bus_log ? options.out / "bus.log" : std::filesystem::path());
  run.observe(&observer);
  msgclient::Client requests_client = block.local_client("plugin_requests");
  core::PluginRequests requests(requests_client, run.plugins());
  const core::PluginWorkshop workshop(requests);

  const std::filesystem::path simulation = folder.path() / "simulation.sock";
  simulator::SimulationDesk desk(run, simulation, [&observer](const simulator::ScenarioEvent& push) {
    observer.commands.on_applied(push);
  });

  const ModuleKeeper module(module_arguments(options.module, {.robot = options.robot,
                                                              .profile = options.profile,
                                                              .link = link,
                                                              .simulation = "unix:" + simulation.string(),
                                                              .recordings = options.out / "recordings"}));

  RunLogs logs(options.out, robot, observer.recorder,
               [](const std::string& news) { fmt::print(stderr, "gaitway serve: {}\n", news); });
  const std::int64_t began_ns = process::monotonic_ns();
  const auto wall_s = [began_ns] { return static_cast<double>(process::monotonic_ns() - began_ns) * 1e-9; };
  const auto so_far = [&] {
    try {
      write_commands(options, run, observer);
    } catch (const std::runtime_error&) {  // a full disk: the summary tells, and the last one is tried again
    }
    return summary(run, observer.recorder, {.wall_s = wall_s()}, options.seed, options.mismatch);
  };
  Loop loop{.run = run,
            .desk = desk,
            .requests = requests,
            .commands = observer.commands,
            .logs = logs,
            .so_far = so_far,
            .quiet = options.quiet};
  simulator::Pace pace(options.speed);
  const auto end_ns = options.seconds ? static_cast<std::int64_t>(std::llround(*options.seconds * 1e9))
                                      : std::numeric_limits<std::int64_t>::max();
  process::stop_on_signals();
  while (run.now_ns() < end_ns && pace.wait({})) {
    loop.millisecond();
  }
  if (process::stop_requested()) {
    loop.stand();
  }
  while (!options.quiet && loop.printer.print(run.main_controller().events())) {
  }
  write_results(options, run, observer, logs, pace, wall_s());
  return exit_code(outcome_of(run, observer.recorder).verdict);
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "serve");
  ServeOptions& options = command.runs(serve);
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command.option(
      "--config", options.config,
      "Plug-ins of the main controller (YAML); a file, or the name of a shipped one. An api is added");
  add_module_options(command, options.module);
  command.option("--seconds", options.seconds, "Virtual time to run; without it until told to stop")
      .between(0.001, 86400.0 * 365.0);
  command.option("--speed", options.speed, "Times real time").between(0.01, 100.0);
  command.option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  command.option("--accept-unproven", options.accept_unproven,
                 "Run even if some message of the bus may miss its deadline");
  command.option("--seed", options.seed, "Seed of mismatch, noise and clock drifts");
  command.option("--mismatch", options.mismatch, "Scale of what the planner does not know of the robot")
      .between(0.0, 10.0);
  add_world_options(command, options.world);
  command.option(
      "--mission", options.mission,
      "Behaviour tree to begin with (XML): a file, the name of a shipped one, or none (default: the "
      "configuration's, stand_up_after_falls, which gets up after falls)");
  command.option("--out", options.out, "Folder for the results and recordings");
  command.option("--bus-log", options.bus_log, "Log every frame; 0.4 GB an hour");
  command.option("--quiet", options.quiet, "No events and no table");
  command.footer(
      "Examples:\n"
      "  gaitway serve                              until Ctrl-C; its page is http://127.0.0.1:9090\n"
      "  gaitway serve --world boxes\n"
      "  gaitway serve --world course --config eyes --mission find_and_walk_to_tag\n"
      "  gaitway serve --mission none               after a fall it lies until it is told to get up\n"
      "  gaitway serve --port 9191 --seconds 60 --speed 2\n"
      "  gaitway serve --address 0.0.0.0 --token-file token --certificate-file cert.pem --key-file key.pem\n"
      "  gaitway run --scenario out/serve/commands.yaml      plays what was asked once more\n"
      "Exit code: 0 the robot stayed up, 2 it fell, 3 more than a tenth of its batches were refused, or it "
      "had none; 1 the\n"
      "input was bad and nothing moved.");
}

}  // namespace gaitway::tools
