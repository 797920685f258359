// `gaitway bus monitor`: a bus in the terminal, live or from a log.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/bus/bus_listener.hpp"
#include "tools/bus/bus_options.hpp"
#include "tools/bus/bus_watch_text.hpp"

namespace gaitway::tools {
namespace {

struct BusMonitorOptions {
  BusRobotOptions robot;
  std::optional<std::filesystem::path> socket;  // of a simulated bus
  std::optional<std::string> interface;         // of SocketCAN
  std::optional<std::filesystem::path> log;
  bool all = false;
  std::optional<double> seconds;
};

// A clock that shows a date counts seconds since 1970; the robot's own clock starts with the run or the
// machine.
constexpr std::int64_t kCalendar_ns = 1'000'000'000'000'000'000;
constexpr std::int64_t kTerminalRefresh_ns = 500'000'000;
constexpr std::int64_t kPipedRefresh_ns = 1'000'000'000;

int verdict(const BusWatch& watch, const can::Proof& proof) {
  if (watch.frames() == 0) {
    fmt::print(stderr, "gaitway: no frame was heard\n");
    return kExitBusUnwell;
  }
  return beyond_bound(watch, proof).empty() ? kExitFine : kExitBusUnwell;
}

int monitor_log(const BusMonitorOptions& options, const BusRobot& robot) {
  const std::vector<can::LoggedFrame> log = can::read_candump_log(*options.log);
  const bool dated = !log.empty() && log.front().time_ns >= kCalendar_ns;
  BusWatch watch(robot.profile, robot.nodes, dated ? BusClock::other : BusClock::robot);
  ListenerState listener;
  for (const can::LoggedFrame& logged : log) {
    if (logged.error) {
      watch.take_error_reports(1);
      const can::ErrorReport report = can::read_error_frame(logged.frame.id, logged.frame.data);
      listener.state = report.state.value_or(report.restarted ? can::BusState::error_active : listener.state);
      listener.errors = report.counters.value_or(listener.errors);
      continue;
    }
    watch.take({.frame = logged.frame,
                .start_ns = logged.time_ns - can::frame_bits(logged.frame) * facts::kBitTime_ns,
                .end_ns = logged.time_ns});
  }
  const BusWindow whole = watch.close_window(watch.last_ns());
  const std::string source = options.log->string();
  BusWatchView view{.source = source, .every_identifier = options.all};
  if (watch.error_reports() > 0) {
    view.listener = listener;
  }
  fmt::print("{}", bus_watch_text(watch, whole, robot.proof, view));
  return verdict(watch, robot.proof);
}

// Each line erases what was there before, and the rest of the screen goes last: no flicker.
std::string screen(const std::string& text) {
  std::string shown = "\x1b[H";
  for (const char c : text) {
    shown += c == '\n' ? std::string("\x1b[K\n") : std::string(1, c);
  }
  return shown + "\x1b[J";
}

void show(const std::string& text, bool terminal) {
  fmt::print("{}", terminal ? screen(text) : text + "\n");
  std::fflush(stdout);
}

int monitor_live(const BusMonitorOptions& options, const BusRobot& robot) {
  BusListener listener({.socket = options.socket, .interface = options.interface});
  BusWatch watch(robot.profile, robot.nodes, BusClock::robot);
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  const std::int64_t refresh_ns = terminal ? kTerminalRefresh_ns : kPipedRefresh_ns;
  const std::int64_t begin_ns = process::monotonic_ns();
  const std::int64_t end_ns =
      options.seconds ? begin_ns + static_cast<std::int64_t>(*options.seconds * 1e9) : kCalendar_ns;
  process::stop_on_signals();
  if (terminal) {
    fmt::print("\x1b[2J");
  }
  for (std::int64_t block_ns = begin_ns; block_ns < end_ns && listener.open();) {
    block_ns = std::min(block_ns + refresh_ns, end_ns);
    listener.listen_until(block_ns, [&](const can::TimedFrame& frame) { watch.take(frame); });
    watch.take_error_reports(listener.take_error_reports());
    if (process::stop_requested()) {
      break;
    }
    const BusWatchView view{
        .source = listener.name(), .every_identifier = options.all, .listener = listener.state()};
    show(bus_watch_text(watch, watch.close_window(process::monotonic_ns()), robot.proof, view), terminal);
  }
  return verdict(watch, robot.proof);
}

int monitor_bus(const BusMonitorOptions& options) {
  const BusRobot robot = load_bus_robot(options.robot);
  return options.log ? monitor_log(options, robot) : monitor_live(options, robot);
}

}  // namespace

void add_bus_monitor(const CommandLine& bus) {
  const CommandLine command = bus.subcommand(
      "monitor", "Show a bus in the terminal: load, rates, worst responses, unknown frames, errors");
  BusMonitorOptions& options = command.runs(monitor_bus);
  const CommandLine source = command.group("What to listen to", true);
  source.option("--bus", options.socket, "Socket of virtual_robot's bus");
  source.option("--can", options.interface, "CAN interface of this machine");
  source.option("--log", options.log, "Bus log in candump's format");
  add_robot_options(command, options.robot);
  command.option("--all", options.all, "Each identifier on a line of its own, too");
  command.option("--seconds", options.seconds, "End after this time; without it, on Ctrl-C")
      .between(0.01, 1e6);
  command.footer(
      "Examples:\n"
      "  gaitway bus monitor --bus /tmp/bus.sock\n"
      "  gaitway bus monitor --can can0 --all --seconds 10 >bus.txt\n"
      "  gaitway bus monitor --log out/run/bus.log\n"
      "Exit code: 0 all responses within what is proven, 3 one was longer or nothing was heard, 1 the input "
      "was\n"
      "bad or nobody serves the bus.");
}

}  // namespace gaitway::tools
