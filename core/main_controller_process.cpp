// The `main_controller` process: the main controller in real time, beside a message controller process. All
// processes of one robot share CLOCK_MONOTONIC: cycle n starts at n * 80 ms of it.
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gaitway/core/events.hpp"
#include "gaitway/core/main_controller.hpp"
#include "gaitway/core/supervisor.hpp"
#include "gaitway/input/number_option.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/manager/plugin_requests.hpp"
#include "gaitway/manager/step_watch.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/process/real_time.hpp"

namespace {

using namespace gaitway;

constexpr int kExitFine = 0;
constexpr int kPriority = 60;
// Without a sign of life of the message controller for so long, the process ends; that its process has ended
// is known at once. Whoever supervises this one starts it again when there is a message controller.
constexpr std::int64_t kSilence_ns = 1'000'000'000;

struct Options {
  std::filesystem::path robot;
  std::filesystem::path socket;
  core::MainControllerOptions controller;
  double seconds = 0.0;
  std::filesystem::path events;  // file for them; or empty
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

// Whether there is still a message controller, as far as can be seen between two ticks.
class Presence {
 public:
  Presence(const msgclient::Client& client, std::string socket)
      : client_(client), socket_(std::move(socket)), wakes_{pollfd{client.hang_up_fd(), POLLRDHUP, 0}} {}

  // False: its process has ended.
  bool wait_until(std::int64_t deadline_ns) {
    process::wait_until(deadline_ns, wakes_);
    return wakes_[0].revents == 0;
  }
  // Once a tick; says what it is. Silence is counted in own ticks: who was stopped itself has heard nobody.
  bool is_lost() {
    const std::int64_t beat_ns = client_.heartbeat_ns();
    silent_ticks_ = beat_ns == beat_ns_ ? silent_ticks_ + 1 : 0;
    beat_ns_ = beat_ns;
    if (wakes_[0].revents != 0) {
      fmt::print(stderr, "main_controller: the message controller on {} has ended\n", socket_);
      return true;
    }
    if (silent_ticks_ * facts::kSlot_ns <= kSilence_ns) {
      return false;
    }
    fmt::print(stderr,
               "main_controller: no sign of life of the message controller on {} for {} ms. Is it still "
               "running?\n",
               socket_, silent_ticks_ * facts::kSlot_ns / facts::kMillisecond_ns);
    return true;
  }

 private:
  const msgclient::Client& client_;
  std::string socket_;
  std::array<pollfd, 1> wakes_;
  std::int64_t beat_ns_ = 0;
  std::int64_t silent_ticks_ = 0;
};

// Absolute deadlines: lateness of one tick does not move the next.
LoopResult run_ticks(core::MainController& controller, core::PluginRequests& requests,
                     const msgclient::Client& client, core::EventLines& events, const Options& options) {
  LoopResult result;
  const std::int64_t begin_ns = process::monotonic_ns();
  std::int64_t deadline_ns = core::next_tick_ns(begin_ns);
  Presence message_controller(client, options.socket.string());
  const std::int64_t end_ns = begin_ns + static_cast<std::int64_t>(options.seconds * 1e9);
  while (!process::stop_requested()) {
    std::int64_t now_ns = process::monotonic_ns();
    bool is_there = true;
    for (; is_there && now_ns < deadline_ns && !process::stop_requested(); now_ns = process::monotonic_ns()) {
      is_there = message_controller.wait_until(deadline_ns);
    }
    if (message_controller.is_lost()) {
      result.exit_code = core::kExitLost;
      break;
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
    requests.step(now_ns);
    events.step(controller.events());
    const std::int64_t next_ns = core::next_tick_ns(std::max(process::monotonic_ns(), deadline_ns));
    result.missed_ticks += static_cast<std::uint64_t>((next_ns - deadline_ns) / facts::kSlot_ns - 1);
    deadline_ns = next_ns;
  }
  return result;
}

void print_summary(const core::MainController& controller, const LoopResult& loop,
                   const process::LogCount& events, const Options& options) {
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
  if (!options.events.empty()) {
    fmt::print("  events            {} lines in {}, {} lost\n", events.lines, options.events.string(),
               events.lost);
  }
}

// A robot that has to come back does so without the file of its events, if need be.
core::EventLines event_lines(const Options& options) {
  try {
    return {"main_controller", options.events, !options.quiet};
  } catch (const std::runtime_error& error) {
    if (options.step_watch < 0) throw;
    fmt::print(stderr, "main_controller: {}\n", error.what());
    return {"main_controller", {}, !options.quiet};
  }
}

// The same command line, without the wish to be supervised.
int run_supervised(int argc, char** argv, const Options& settings) {
  core::SupervisorOptions options{.program = "/proc/self/exe",
                                  .arguments = {},
                                  .quiet = settings.quiet,
                                  .memory_socket = settings.socket};
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) != "--supervised") {
      options.arguments.emplace_back(argv[i]);
    }
  }
  return core::supervise(options);
}

// By name, before the first of its topics is refused by another name.
void refuse_second(const msgclient::Client& client, const Options& options) {
  const std::vector<msgclient::TopicInfo> topics = client.directory();
  if (std::ranges::any_of(topics, [&](const auto& topic) { return topic.writer == client.name(); })) {
    throw std::runtime_error(fmt::format(
        "another main controller is connected to the message controller on {}: end that one first, or name "
        "another robot's --socket",
        options.socket.string()));
  }
}

// From the first tick to the last.
int control(const urdf::RobotModel& robot, msgclient::Client& client, const Options& options) {
  core::EventLines events = event_lines(options);
  msgclient::EmiHost host(client);
  core::MainController controller(robot, client, host, options.controller);
  core::PluginRequests requests(client, controller.plugins());
  const core::PluginWorkshop workshop(requests);
  process::ask_for_real_time("main_controller", kPriority);
  const LoopResult result = run_ticks(controller, requests, client, events, options);
  if (options.controller.step_watch != nullptr) {
    options.controller.step_watch->end();
  }
  const process::LogCount lines = events.end(controller.events());
  if (!options.quiet) {
    print_summary(controller, result, lines, options);
  }
  return result.exit_code;
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
  std::optional<msgclient::Client> client;
  try {
    client.emplace(msgclient::Client::connect(options.socket, "main_controller"));
    refuse_second(*client, options);
    options.controller.simulated = msgclient::is_marked_simulated(*client);
    return control(robot, *client, options);
  } catch (const msgclient::TopicError& error) {
    // At whatever step of the start it went away.
    if (!watch || (client && !client->server_has_ended())) {
      throw;
    }
    fmt::print(stderr, "main_controller: {}\n", input::terminal_text(error.what()));
    return core::kExitLost;
  }
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
  app.add_option(
      "--events", options.events,
      "File for events, a line of JSON each, after those that it holds; 16 MiB at most, those before in "
      "FILE.1");
  app.add_flag("--quiet", options.quiet, "No events on the terminal, and no summary");
  app.add_option("--without", options.controller.stopped,
                 "Plug-ins of the configuration that are not loaded; built-in fallbacks write their topics")
      ->allow_extra_args(false);
  app.add_flag("--supervised", options.supervised,
               "Start again at once when a plug-in brings the process down, without that plug-in; wait for a "
               "message controller that is not there, or went away");
  app.add_option("--step-watch", options.step_watch)->group("");  // the supervisor's own
  app.add_option("--supervisor", options.supervisor)->group("");
  app.add_option("--culprit", options.culprits)->group("")->allow_extra_args(false);
  app.footer(
      "Examples:\n"
      "  main_controller --socket /run/gaitway.sock --robot urdf/humanoid22 --config core/config/walk.yaml\n"
      "  GAITWAY_PLUGIN_PATH=~/sway/build main_controller --socket s.sock --robot r --config sway.yaml "
      "--seconds 60\n"
      "  main_controller --socket s.sock --robot r --config c.yaml --supervised --events events.jsonl\n"
      "Ends on SIGINT and SIGTERM; the message controller then plays the safe tail to its end and the robot "
      "stands.\n"
      "Exit code: 0 ended as told, 1 the input was bad, or another main controller runs, and nothing moved, "
      "3 "
      "not supervised: the message controller went away, 4 supervised: plug-ins brought it down more than "
      "three times within a minute, 128 + N supervised: signal N ended it while it stopped.");
  return input::run_line(app, argc, argv, "main_controller", [&] {
    process::stop_on_signals();
    return options.supervised ? run_supervised(argc, argv, options) : run(options);
  });
}
