// The `message_controller` process: owns the memory block, and runs the message controller in real time
// between the main controller's process and the bus. Cycle n starts at n * 80 ms of CLOCK_MONOTONIC, for
// every process of the robot.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "bus_connection.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/input/number_option.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/msgcontroller/bus_timeline.hpp"
#include "gaitway/msgcontroller/command_arbiter.hpp"
#include "gaitway/msgcontroller/message_controller.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/duration_histogram.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/summary_file.hpp"

namespace {

using namespace gaitway;

constexpr int kExitFine = 0;
constexpr int kPriority = 70;
constexpr std::int64_t kBetweenSummaries_ns = facts::kSecond_ns;
constexpr std::int64_t kBetweenTries_ns = 50 * facts::kMillisecond_ns;

struct Options {
  std::filesystem::path robot;
  std::string profile;
  bool accept_unproven = false;
  msgcontroller::BusChoice bus;
  std::filesystem::path memory;
  std::filesystem::path summary;
  std::vector<double> walk;  // forward m/s, left m/s, turn rad/s; empty: nobody here orders a walk
  double walk_after_s = 1.0;
  double wait_s = 5.0;
  double seconds = 0.0;
};

// Orders one walk after a while, as a scenario does.
class WalkPlayer {
 public:
  WalkPlayer(msgcontroller::CommandArbiter& arbiter, const Options& options, std::int64_t now_ns)
      : arbiter_(arbiter), due_ns_(now_ns + static_cast<std::int64_t>(options.walk_after_s * 1e9)) {
    walk_.walk = 1;
    walk_.velocity[0] = options.walk[0];
    walk_.velocity[1] = options.walk[1];
    walk_.turn_rate = options.walk[2];
  }
  void step(std::int64_t now_ns) noexcept {
    if (!ordered_ && now_ns >= due_ns_) {
      ordered_ = true;
      arbiter_.order(walk_, now_ns);
    }
  }

 private:
  msgcontroller::CommandArbiter& arbiter_;
  std::int64_t due_ns_;
  WalkCommand walk_{};
  bool ordered_ = false;
};

// virtual_robot may still be starting, or an interface coming up: tries for a while. Nothing when told to
// stop meanwhile.
std::unique_ptr<msgcontroller::BusConnection> connect(const Options& options) {
  const std::int64_t until_ns = process::monotonic_ns() + static_cast<std::int64_t>(options.wait_s * 1e9);
  while (!process::stop_requested()) {
    try {
      return std::make_unique<msgcontroller::BusConnection>(options.bus);
    } catch (const can::BusError&) {
      if (process::monotonic_ns() >= until_ns) {
        throw;
      }
    }
    process::wait_until(process::monotonic_ns() + kBetweenTries_ns, {});
  }
  return nullptr;
}

struct LoopResult {
  std::int64_t begin_ns = 0, end_ns = 0;
  std::uint64_t missed = 0, stale = 0, absences = 0;
  process::DurationHistogram lateness;
};

// What the summary is made of, copied while the loop runs.
struct Figures {
  NetworkState state{};
  NetworkHealth health{};
  LoopResult loop;
  std::uint64_t bus_outages = 0;
  std::int64_t bus_away_ns = 0;
  bool has_interface = false;
  can::BusState bus_state{};
  can::SocketCanStatistics interface {};
  bool has_sent_log = false;
  process::LogCount sent_log{};
};
using Summary = process::SummaryFile<Figures>;

Figures figures_of(const msgcontroller::MessageController& controller,
                   const msgcontroller::BusConnection& bus, const LoopResult& loop) {
  Figures figures{.state = controller.state(), .health = controller.health(), .loop = loop};
  figures.bus_outages = bus.outages();
  figures.bus_away_ns = bus.away_ns();
  if (bus.interface() != nullptr) {
    figures.has_interface = true;
    figures.bus_state = bus.interface()->state();
    figures.interface = bus.interface()->statistics();
  }
  if (const auto log = bus.sent_log()) {
    figures.has_sent_log = true;
    figures.sent_log = *log;
  }
  return figures;
}

LoopResult run_loop(const Options& options, msgclient::MemoryBlock& block,
                    msgclient::MemoryBlockServer& server, msgcontroller::MessageController& controller,
                    msgcontroller::BusConnection& bus, msgcontroller::CommandArbiter& arbiter,
                    std::optional<Summary>& summary) {
  LoopResult result;
  result.begin_ns = process::monotonic_ns();
  const std::int64_t stop_ns = result.begin_ns + static_cast<std::int64_t>(options.seconds * 1e9);
  std::optional<WalkPlayer> walk;
  if (!options.walk.empty()) {
    walk.emplace(arbiter, options, result.begin_ns);
  }
  msgcontroller::BusTimeline timeline(controller, bus.port(), result.begin_ns);
  std::array<pollfd, 2> wakes{pollfd{-1, POLLIN, 0}, pollfd{server.wake_fd(), POLLIN, 0}};
  std::int64_t now_ns = result.begin_ns, next_summary_ns = now_ns;
  const auto count = [&] {
    result.end_ns = now_ns;
    result.missed = timeline.missed();
    result.stale = timeline.stale();
    result.absences = timeline.absences();
  };
  while (!process::stop_requested() && (options.seconds <= 0.0 || now_ns < stop_ns)) {
    const bool waits = timeline.waits();
    wakes[0].fd = bus.wake_fd();
    process::wait_until(timeline.next_ns() + (waits ? can::kLongestWait_ns : 0), wakes);
    now_ns = process::monotonic_ns();
    if (now_ns >= timeline.next_ns() && !waits) {
      result.lateness.add(now_ns - timeline.next_ns());
    }
    if (walk) {
      walk->step(now_ns);
    }
    arbiter.step(now_ns, controller.mode() == msgcontroller::Mode::emergency_stop);
    timeline.advance_to(now_ns);
    bus.report(now_ns);
    block.beat(now_ns);
    if (wakes[1].revents != 0 || now_ns >= server.due_ns()) {
      server.step(now_ns);
    }
    if (summary && now_ns >= next_summary_ns) {
      next_summary_ns = now_ns + kBetweenSummaries_ns;
      count();
      summary->offer(figures_of(controller, bus, result));
    }
  }
  count();
  return result;
}

nlohmann::ordered_json interface_summary(const Figures& figures, const std::string& interface) {
  nlohmann::ordered_json summary = {{"interface", interface}, {"state", can::name_of(figures.bus_state)}};
  for (const auto& [name, count] : can::counters(figures.interface)) {
    summary[std::string(name)] = count;
  }
  return summary;
}

std::string summary_text(const Figures& figures, const std::string& interface, bool ended) {
  const auto& [state, health, loop] = std::tie(figures.state, figures.health, figures.loop);
  const process::DurationSummary late = loop.lateness.summary();
  nlohmann::ordered_json summary = {
      {"ended", ended},
      {"seconds", static_cast<double>(loop.end_ns - loop.begin_ns) * 1e-9},
      {"handed_over", state.handed_over},
      {"late", state.late},
      {"refused", state.refused},
      {"tails_played", state.tail_played},
      {"repaired", state.repaired},
      {"resynchronised", state.resynchronised},
      {"missed_milliseconds", loop.missed},
      {"stale_frames", loop.stale},
      {"absences", loop.absences},
      {"bus_outages", figures.bus_outages},
      {"bus_away_s", static_cast<double>(figures.bus_away_ns) * 1e-9},
      {"network",
       {{"unknown_identifiers", health.unknown_identifiers},
        {"wrong_lengths", health.wrong_lengths},
        {"remote_frames", health.remote_frames},
        {"extended_frames", health.extended_frames},
        {"undefined_values", health.undefined_values},
        {"forged", health.forged},
        {"second_senders", health.second_senders},
        {"doubled", health.doubled},
        {"feedback_missing", health.feedback_missing},
        {"trajectories_lost", health.trajectories_lost},
        {"counts_differed", health.counts_differed}}},
      {"wake_up_latency_us", {{"p50", late.p50}, {"p99", late.p99}, {"max", late.max}}}};
  if (figures.has_interface) {
    summary["can"] = interface_summary(figures, interface);
  }
  if (figures.has_sent_log) {
    summary["sent_log"] = {{"lines", figures.sent_log.lines}, {"lost", figures.sent_log.lost}};
  }
  return summary.dump(2) + "\n";
}

// A summary that finds no room in its file is at least seen.
void write_summary(std::optional<Summary>& file, const std::string& text) {
  const std::string error = file ? file->end(text) : std::string();
  if (!error.empty()) {
    fmt::print(stderr, "message_controller: {}\n", error);
  }
  if (!file || !error.empty()) {
    fmt::print("{}", text);
  }
}

int run(const Options& options) {
  if (!options.bus.sent_log.empty() && options.bus.interface.empty()) {
    throw std::invalid_argument("--sent-log: needs --can; what is on the simulated bus, virtual_robot knows");
  }
  if (!options.walk.empty()) {
    msgcontroller::check_walk_option(options.walk);
  }
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  msgcontroller::require_proven_network(robot, options.accept_unproven);
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("message_controller");
  msgclient::EmiMessage adapter(client);
  msgclient::Client arbiter_client = block.local_client("arbiter");
  msgcontroller::CommandArbiter arbiter(arbiter_client);
  msgcontroller::MessageController controller(robot, client, adapter);
  controller.tell_commands(&arbiter);
  const std::unique_ptr<msgcontroller::BusConnection> bus = connect(options);
  if (!bus) {
    return kExitFine;
  }
  std::optional<msgclient::TopicGrant> simulated;
  if (bus->is_simulated()) simulated.emplace(msgclient::mark_simulated(client));
  block.beat(process::monotonic_ns());
  msgclient::MemoryBlockServer server(block, options.memory);
  std::optional<Summary> summary;
  if (!options.summary.empty()) {
    summary.emplace(
        options.summary,
        [interface = options.bus.interface](const Figures& figures) {
          return summary_text(figures, interface, false);
        },
        process::tell_on_stderr("message_controller"));
  }
  process::ask_for_real_time("message_controller", kPriority);
  const LoopResult result = run_loop(options, block, server, controller, *bus, arbiter, summary);
  bus->close();
  write_summary(summary, summary_text(figures_of(controller, *bus, result), options.bus.interface, true));
  return kExitFine;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{
      "The message controller in real time: owns the memory block, sends batches over the bus and plays the "
      "safe tail "
      "when none comes"};
  app.add_option("--robot", options.robot, "Folder with robot.urdf and robot.yaml")->required();
  app.add_option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  app.add_flag("--accept-unproven", options.accept_unproven,
               "Run even if some message of the bus may miss its deadline");
  CLI::Option_group* const bus = app.add_option_group("The bus, one of");
  bus->add_option("--bus", options.bus.socket, "Socket of the simulated bus, as served by virtual_robot");
  bus->add_option("--can", options.bus.interface, "CAN interface, which must be up, for example can0");
  bus->require_option(1);
  app.add_option(
      "--sent-log", options.bus.sent_log,
      "With --can: file for what was sent, in candump's format, in the order of the bus; goes on after "
      "what it holds, 256 MiB at most, those before in FILE.1");
  app.add_option("--memory", options.memory, "Socket to give out the memory block on")->required();
  app.add_option("--walk", options.walk,
                 "Order a walk VX,VY,WZ, as a person does: forward m/s, left m/s, turn rad/s")
      ->delimiter(',')
      ->check(input::number_within(-msgcontroller::kLargestTurnRate_rad_per_s,
                                   msgcontroller::kLargestTurnRate_rad_per_s));
  app.add_option("--walk-after", options.walk_after_s, "Seconds from the start to that command")
      ->check(input::number_within(0.0, 1e6))
      ->capture_default_str();
  app.add_option(
         "--wait", options.wait_s,
         "Seconds to wait for the bus at the start; one that goes away later is waited for without end")
      ->check(input::number_within(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--seconds", options.seconds, "Stop after this time; 0: when told to")
      ->check(input::number_within(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--summary", options.summary,
                 "File for the summary (JSON) instead of the terminal; written anew every second, so a kill "
                 "leaves one that has \"ended\": false");
  app.footer(
      "Examples:\n"
      "  message_controller --robot urdf/humanoid22 --bus /tmp/bus.sock --memory /tmp/memory.sock\n"
      "  message_controller --robot urdf/humanoid22 --bus b.sock --memory m.sock --walk 0.15,0,0 "
      "--walk-after 2\n"
      "  message_controller --robot urdf/humanoid22 --can can0 --memory m.sock\n"
      "Ends on SIGINT and SIGTERM; the joints then play out their batch and hold.\n"
      "A bus that goes away later on is waited for, however long: the memory block and its clients stay.\n"
      "Exit code: 0 ended as told, 1 the input was bad, or another one serves the memory block or the bus, "
      "and "
      "nothing moved.");
  return input::run_line(app, argc, argv, "message_controller", [&] {
    process::stop_on_signals();
    return run(options);
  });
}
