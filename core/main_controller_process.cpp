// The `main_controller` process: the main controller in real time, beside a message controller process. All
// processes of one robot share CLOCK_MONOTONIC: cycle n starts at n * 80 ms of it.
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/core/events.hpp"
#include "gaitway/core/main_controller.hpp"
#include "gaitway/core/supervisor.hpp"
#include "gaitway/input/number_option.hpp"
#include "gaitway/manager/plugin_requests.hpp"
#include "gaitway/manager/step_watch.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/process/real_time.hpp"

namespace {

using namespace gaitway;

constexpr int kExitFine = 0;
constexpr int kExitLost = 3;
constexpr int kPriority = 60;
// Without a sign of life of the message controller for so long, the process ends; whoever supervises it
// starts it again.
constexpr std::int64_t kSilence_ns = 1'000'000'000;
// Between two looks for events to print: printing costs time, so never in each tick.
constexpr std::uint64_t kTicksBetweenPrints = 100;

struct Options {
  std::filesystem::path robot;
  std::filesystem::path socket;
  core::MainControllerOptions controller;
  double seconds = 0.0;
  bool quiet = false;
  bool supervised = false;
  int step_watch = -1;  // descriptor that the supervisor hands on; -1: nobody supervises
  pid_t supervisor = 0;
  std::vector<std::string> culprits;  // as --without, unless the configuration does not know them
};

struct LoopResult {
  int exit_code = kExitFine;
  std::uint64_t missed_ticks = 0;
  process::DurationHistogram lateness;
};

// Absolute deadlines: lateness of one tick does not move the next.
LoopResult run_ticks(core::MainController& controller, core::PluginRequests& requests,
                     const msgclient::Client& client, const Options& options) {
  LoopResult result;
  core::EventPrinter printer("main_controller");
  const std::int64_t begin_ns = process::monotonic_ns();
  std::int64_t deadline_ns = core::next_tick_ns(begin_ns);
  const std::int64_t end_ns = begin_ns + static_cast<std::int64_t>(options.seconds * 1e9);
  for (std::uint64_t tick = 0; !process::stop_requested(); ++tick) {
    std::int64_t now_ns = process::monotonic_ns();
    for (; now_ns < deadline_ns && !process::stop_requested(); now_ns = process::monotonic_ns()) {
      process::wait_until(deadline_ns, {});
    }
    if (process::stop_requested() || (options.seconds > 0.0 && now_ns >= end_ns)) {
      break;
    }
    result.lateness.add(now_ns - deadline_ns);
    controller.step(now_ns);
    if (options.controller.step_watch != nullptr) {
      options.controller.step_watch->count_tick();
    }
    controller.maintain(now_ns);
    if (now_ns - client.heartbeat_ns() > kSilence_ns) {
      fmt::print(stderr,
                 "main_controller: no sign of life of the message controller on {} for {} ms. Is it still "
                 "running?\n",
                 options.socket.string(), (now_ns - client.heartbeat_ns()) / facts::kMillisecond_ns);
      result.exit_code = kExitLost;
      break;
    }
    requests.step(now_ns);
    if (tick % kTicksBetweenPrints == 0 && !options.quiet) {
      printer.print(controller.events());
    }
    const std::int64_t next_ns = core::next_tick_ns(std::max(process::monotonic_ns(), deadline_ns));
    result.missed_ticks += static_cast<std::uint64_t>((next_ns - deadline_ns) / facts::kSlot_ns - 1);
    deadline_ns = next_ns;
  }
  while (printer.print(controller.events())) {
  }
  return result;
}

void print_summary(const core::MainController& controller, const LoopResult& loop) {
  const core::MainControllerStatistics s = controller.statistics();
  fmt::print("  ticks             {}, {} missed, late by p50 {:.0f} us, p99 {:.0f} us, max {:.0f} us\n",
             s.ticks, loop.missed_ticks, loop.lateness.summary().p50, loop.lateness.summary().p99,
             loop.lateness.summary().max);
  fmt::print(
      "  batches           {} handed over, {} accepted, {} late, {} refused there, {} refused here, {} "
      "spoiled by "
      "faults, {} without plan\n",
      s.handed_over, s.answers[0], s.answers[1], s.answers[2], s.refused_locally, s.spoiled, s.without_plan);
  fmt::print("  batch compute     p50 {:.0f} us, p99 {:.0f} us, max {:.0f} us\n", s.batch_compute_us.p50,
             s.batch_compute_us.p99, s.batch_compute_us.max);
  for (const core::PluginTiming& plugin : s.plugins) {
    fmt::print("  {:<17} {}, {} steps, {} faults, {} overruns, p50 {:.0f} us, p99 {:.0f} us, max {:.0f} us\n",
               plugin.name, core::service_state_name(plugin.state), plugin.steps, plugin.faults,
               plugin.overruns, plugin.step_us.p50, plugin.step_us.p99, plugin.step_us.max);
  }
}

// The same command line, without the wish to be supervised.
int run_supervised(int argc, char** argv, bool quiet) {
  core::SupervisorOptions options{.program = "/proc/self/exe", .arguments = {}, .quiet = quiet};
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) != "--supervised") {
      options.arguments.emplace_back(argv[i]);
    }
  }
  return core::supervise(options);
}

int run(Options options) {
  std::optional<core::StepWatch> watch;
  if (options.step_watch >= 0) {
    watch.emplace(core::StepWatch::open(options.step_watch));
    options.controller.step_watch = &*watch;
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // never without its supervisor
    if (getppid() != options.supervisor) {
      return kExitFine;  // it is gone already
    }
  }
  options.controller.plugins = core::read_configuration(options.controller.configuration);
  for (const core::PluginEntry& plugin : options.controller.plugins->plugins) {
    if (std::ranges::find(options.culprits, plugin.name) != options.culprits.end()) {
      options.controller.stopped.push_back(plugin.name);
    }
  }
  options.controller.wall_time_decides = true;
  options.controller.memory_socket = std::filesystem::absolute(options.socket);
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  msgclient::Client client = msgclient::Client::connect(options.socket, "main_controller");
  msgclient::EmiHost host(client);
  core::MainController controller(robot, client, host, options.controller);
  core::PluginRequests requests(client, controller.plugins());
  const core::PluginWorkshop workshop(requests);
  process::ask_for_real_time("main_controller", kPriority);
  const LoopResult result = run_ticks(controller, requests, client, options);
  if (watch) {
    watch->end();
  }
  if (!options.quiet) {
    print_summary(controller, result);
  }
  return result.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.controller.isolation.lock_step = false;
  options.controller.try_at_start = true;
  CLI::App app{
      "The main controller in real time: steps the plug-ins and hands their plans to a message controller "
      "process"};
  app.add_option("--socket", options.socket, "Socket of the message controller's memory block")->required();
  app.add_option("--robot", options.robot, "Folder with robot.urdf and robot.yaml")->required();
  app.add_option("--config", options.controller.configuration, "Plug-ins and their parameters (YAML)")
      ->required();
  app.add_option("--plugin-path", options.controller.plugin_path,
                 "Folders to look for plug-ins in, before GAITWAY_PLUGIN_PATH and the shipped ones");
  app.add_option("--seconds", options.seconds, "Stop after this time; 0: when told to")
      ->check(input::number_within(0.0, 1e6))
      ->capture_default_str();
  app.add_flag("--quiet", options.quiet, "No events and no summary");
  app.add_option("--without", options.controller.stopped,
                 "Plug-ins of the configuration that are not loaded; built-in fallbacks write their topics")
      ->allow_extra_args(false);
  app.add_flag("--supervised", options.supervised,
               "Start again at once when a plug-in brings the process down, without that plug-in");
  app.add_option("--step-watch", options.step_watch)->group("");  // the supervisor's own
  app.add_option("--supervisor", options.supervisor)->group("");
  app.add_option("--culprit", options.culprits)->group("")->allow_extra_args(false);
  app.footer(
      "Examples:\n"
      "  main_controller --socket /run/gaitway.sock --robot urdf/humanoid22 --config core/config/walk.yaml\n"
      "  GAITWAY_PLUGIN_PATH=~/sway/build main_controller --socket s.sock --robot r --config sway.yaml "
      "--seconds 60\n"
      "Ends on SIGINT and SIGTERM; the message controller then plays the safe tail to its end and the robot "
      "stands.\n"
      "Exit code: 0 ended as told, 1 the input was bad and nothing moved, 3 the message controller went "
      "away, 4 supervised: it died more than three times within a minute, 128 + N supervised: signal N ended "
      "it "
      "while it stopped.");
  return input::run_line(app, argc, argv, "main_controller", [&] {
    process::stop_on_signals();
    return options.supervised ? run_supervised(argc, argv, options.quiet) : run(options);
  });
}
