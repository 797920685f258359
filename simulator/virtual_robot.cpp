// The `virtual_robot` process: the simulated body and its local controllers, paced by CLOCK_MONOTONIC, on a
// simulated bus that it serves on a socket, or on a CAN interface.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/can/simulated/bus_server.hpp"
#include "gaitway/can/simulated/socketcand_server.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/input/number_option.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/world/world_choice.hpp"
#include "interface_robot.hpp"

namespace {

using namespace gaitway;
using facts::kMillisecond_ns;

constexpr int kExitFine = 0;
constexpr int kPriority = 50;

struct Options {
  std::filesystem::path robot;
  std::string profile;
  std::filesystem::path bus;
  std::string can;  // a CAN interface instead
  std::filesystem::path sent_log;
  std::filesystem::path summary;
  std::filesystem::path walk_log;
  simulator::PlantOptions plant;
  double seconds = 0.0;
  std::string socketcand;  // empty: not served
  std::string world;       // empty: an endless floor
};

// Body, joints and bus in one time base, a millisecond after the other.
class VirtualRobot {
 public:
  VirtualRobot(const urdf::RobotModel& robot, const Options& options, std::int64_t start_ns)
      : now_ns_(start_ns),
        plant_(robot, options.plant),
        joints_(robot, options.plant.seed, simulator::kLargestClockDrift_ppm, options.plant.mismatch),
        watch_(plant_, options.walk_log, options.summary, start_ns),
        server_(options.bus, start_ns) {
    for (int joint = 0; joint < joints_.size(); ++joint) {
      transmitters_.emplace_back(server_.bus().attach());
    }
    joints_.step(now_ns_, plant_.sensors());
    if (!options.socketcand.empty()) {
      socketcand_.emplace(can::SocketcandAddress::parse(options.socketcand), server_.bus());
    }
  }

  // Takes in what the clients of the bus said.
  void listen() {
    server_.step();
    if (socketcand_) {
      socketcand_->step(now_ns_);
    }
  }
  void answer() {
    server_.flush();
    if (socketcand_) {
      socketcand_->flush(now_ns_);
    }
  }

  // Bus up to the new instant, body, local controllers: the order of the co-simulation.
  void advance_millisecond() {
    for (int joint = 0; joint < joints_.size(); ++joint) {
      offer(joint, now_ns_);
    }
    const std::int64_t until_ns = now_ns_ + kMillisecond_ns;
    if (socketcand_) {
      socketcand_->offer(now_ns_, until_ns);
    }
    while (const auto delivery = server_.advance(until_ns)) {
      deliver(*delivery);
      if (socketcand_) {
        socketcand_->on_delivery(*delivery);
      }
    }
    plant_.step(joints_.torque_Nm());
    now_ns_ = until_ns;
    joints_.step(now_ns_, plant_.sensors());
    watch_.look(plant_, now_ns_);
  }

  [[nodiscard]] can::BusServer& server() noexcept { return server_; }
  [[nodiscard]] const std::optional<can::SocketcandServer>& socketcand() const noexcept {
    return socketcand_;
  }
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  [[nodiscard]] double time_s() const noexcept { return watch_.time_s(now_ns_); }
  [[nodiscard]] const simulator::Plant& plant() const noexcept { return plant_; }
  [[nodiscard]] simulator::WalkWatch& watch() noexcept { return watch_; }
  [[nodiscard]] const simulator::WalkWatch& watch() const noexcept { return watch_; }

 private:
  void deliver(const can::SimulatedBus::Delivery& delivery) {
    for (int joint = 0; joint < joints_.size(); ++joint) {
      can::StationTransmitter& transmitter = transmitters_[static_cast<std::size_t>(joint)];
      transmitter.on_delivery(delivery);
      if (delivery.received_by(transmitter.station())) {
        joints_.on_frame(joint, delivery.frame, delivery.end_ns);
      }
    }
    for (int joint = 0; joint < joints_.size(); ++joint) {
      offer(joint, delivery.end_ns);  // an answer to a SYNC goes out at once
    }
  }
  void offer(int joint, std::int64_t now_ns) {
    joints_.offer(joint, transmitters_[static_cast<std::size_t>(joint)], server_.bus(), now_ns);
  }

  std::int64_t now_ns_;
  simulator::Plant plant_;
  simulator::JointNetwork joints_;
  simulator::WalkWatch watch_;
  can::BusServer server_;
  std::optional<can::SocketcandServer> socketcand_;
  std::vector<can::StationTransmitter> transmitters_;
};

struct LoopResult : simulator::WalkTiming {
  std::uint64_t waited = 0;       // milliseconds that waited for the message controller
  std::uint64_t not_awaited = 0;  // milliseconds that went on without it, since it took too long
};

// Steps all milliseconds that have come, unless a client whose pace the bus keeps is behind: then the body
// waits, too, for a bounded time, and makes up for it afterwards. So neither side's late wake-up disturbs the
// robot.
bool step_due(VirtualRobot& robot, std::int64_t now_ns, LoopResult& result) {
  bool stepped = false;
  for (std::int64_t due_ns = robot.now_ns() + kMillisecond_ns; due_ns <= now_ns; due_ns += kMillisecond_ns) {
    if (!robot.server().reached(due_ns - kMillisecond_ns)) {
      if (now_ns - due_ns < can::kLongestWait_ns) {
        break;
      }
      ++result.not_awaited;
    }
    robot.advance_millisecond();
    stepped = true;
  }
  return stepped;
}

nlohmann::ordered_json summary_of(VirtualRobot& robot, const LoopResult& loop) {
  const can::BusServer& server = robot.server();
  nlohmann::ordered_json summary = robot.watch().summary(robot.plant(), robot.now_ns(), loop);
  summary["waits_for_the_message_controller"] = loop.waited;
  summary["milliseconds_without_it"] = loop.not_awaited;
  summary["frames"] = server.bus().statistics().frames;
  summary["bus_load"] = server.bus().statistics().load(static_cast<std::int64_t>(robot.time_s() * 1e9));
  summary["late_frames"] = server.statistics().late_frames;
  if (robot.socketcand()) {
    const can::SocketcandStatistics& clients = robot.socketcand()->statistics();
    summary["socketcand"] = {
        {"clients", clients.clients},         {"turned_away", clients.turned_away},
        {"not_reading", clients.not_reading}, {"rejected_commands", clients.rejected_commands},
        {"frames", clients.frames},           {"untold_remote_frames", clients.untold_remote_frames}};
  }
  return summary;
}

LoopResult run_loop(VirtualRobot& robot, const Options& options) {
  LoopResult result;
  const std::int64_t begin_ns = process::monotonic_ns();
  const std::int64_t stop_ns = begin_ns + static_cast<std::int64_t>(options.seconds * 1e9);
  const int socketcand_fd = robot.socketcand() ? robot.socketcand()->wake_fd() : -1;  // -1: poll() skips it
  std::array<pollfd, 2> wakes{pollfd{robot.server().wake_fd(), POLLIN, 0}, pollfd{socketcand_fd, POLLIN, 0}};
  bool waiting = false;
  std::int64_t now_ns = begin_ns;
  while (!process::stop_requested() && (options.seconds <= 0.0 || now_ns < stop_ns)) {
    const std::int64_t due_ns = robot.now_ns() + kMillisecond_ns;
    process::wait_until(waiting ? due_ns + can::kLongestWait_ns : due_ns, wakes);
    now_ns = process::monotonic_ns();
    robot.listen();
    if (now_ns < due_ns) {
      continue;  // a client spoke; its frames wait for their millisecond
    }
    if (!waiting) {
      result.woke(now_ns - due_ns);
    }
    const bool stepped = step_due(robot, now_ns, result);
    robot.answer();
    const bool behind = robot.now_ns() + kMillisecond_ns <= now_ns;
    result.waited += behind && (stepped || !waiting) ? 1U : 0U;
    waiting = behind;
    if (robot.watch().summary_is_due(now_ns)) {
      result.wall_s = static_cast<double>(now_ns - begin_ns) * 1e-9;
      robot.watch().offer(summary_of(robot, result), now_ns);
    }
  }
  result.wall_s = static_cast<double>(process::monotonic_ns() - begin_ns) * 1e-9;
  return result;
}

int run(const Options& options) {
  if (!options.sent_log.empty() && options.can.empty()) {
    throw std::invalid_argument("--sent-log: needs --can");
  }
  if (!options.socketcand.empty() && !options.can.empty()) {
    throw std::invalid_argument(
        "--socketcand: serves the simulated bus, so it needs --bus; for an interface there is socketcand "
        "itself");
  }
  const urdf::RobotModel model = msgcontroller::load_robot(options.robot, options.profile);
  if (!options.can.empty()) {
    simulator::run_on_interface(model, {options.can, options.summary, options.walk_log, options.sent_log,
                                        options.plant, options.seconds, kPriority});
    return kExitFine;
  }
  const std::int64_t start_ns = process::monotonic_ns() / kMillisecond_ns * kMillisecond_ns;
  VirtualRobot robot(model, options, start_ns);
  if (robot.socketcand()) {
    fmt::print("virtual_robot: socketcand clients find the bus can0 on port {}\n",
               robot.socketcand()->port());
    std::fflush(stdout);
  }
  process::ask_for_real_time("virtual_robot", kPriority);
  const LoopResult result = run_loop(robot, options);
  robot.watch().end(summary_of(robot, result));
  return kExitFine;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{
      "The simulated robot in real time: body and local controllers, on a bus that it serves on a socket or "
      "on a CAN "
      "interface"};
  app.add_option("--robot", options.robot, "Folder with robot.urdf and robot.yaml")->required();
  app.add_option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  CLI::Option_group* const bus = app.add_option_group("The bus, one of");
  bus->add_option("--bus", options.bus, "Socket to serve a simulated bus on");
  bus->add_option("--can", options.can, "CAN interface, which must be up, for example vcan0");
  bus->require_option(1);
  app.add_option("--sent-log", options.sent_log,
                 "With --can: file for what the joints sent, in candump's format, in the order of the bus");
  app.add_option("--seed", options.plant.seed, "Seed of mismatch, noise and clock drifts")
      ->check(input::seed())
      ->capture_default_str();
  app.add_option("--mismatch", options.plant.mismatch, "Scale of what the planner does not know of the robot")
      ->check(input::number_within(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--world", options.world, "What it walks in (YAML): a file, or the name of a shipped one");
  app.add_option("--seconds", options.seconds, "Stop after this time; 0: when told to")
      ->check(input::number_within(0.0, 1e6))
      ->capture_default_str();
  app.add_option("--summary", options.summary,
                 "File for the summary (JSON) instead of the terminal; written anew every second, so a kill "
                 "leaves one that has \"ended\": false");
  app.add_option("--walk-log", options.walk_log, "File for where the base was, every 10 ms (CSV)");
  app.add_option("--socketcand", options.socketcand,
                 "Serve the bus to clients of the socketcand protocol, too: [ADDRESS:]PORT on the loopback; "
                 "29536 is the usual port, 0 takes any");
  app.footer(
      "Examples:\n"
      "  virtual_robot --robot urdf/humanoid22 --bus /tmp/bus.sock\n"
      "  virtual_robot --robot urdf/humanoid22 --bus /tmp/bus.sock --socketcand 29536\n"
      "  virtual_robot --robot urdf/humanoid22 --bus b.sock --seed 7 --seconds 60 --walk-log walk.csv\n"
      "  virtual_robot --robot urdf/humanoid22 --can vcan0\n"
      "Ends on SIGINT and SIGTERM. Exit code: 0 ended as told (whether the robot fell is in the summary), 1 "
      "the input "
      "was bad and nothing moved.");
  return input::run_line(app, argc, argv, "virtual_robot", [&] {
    process::stop_on_signals();
    if (!options.world.empty()) {
      options.plant.world =
          world::load_world({.name = options.world, .random_seed = {}, .written_in = "--world", .line = 0});
    }
    return run(options);
  });
}
