// The virtual robot on a CAN interface: frames in, a millisecond of the body, frames out; and its run in real
// time.
#include "interface_robot.hpp"

#include <fmt/format.h>
#include <array>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/duration_histogram.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::simulator {

using facts::kMillisecond_ns;
namespace {

constexpr std::int64_t kEverything = std::numeric_limits<std::int64_t>::max();

}  // namespace

InterfaceRobot::InterfaceRobot(const urdf::RobotModel& robot, const PlantOptions& plant,
                               can::SocketCanPort& port, bool log_wanted, std::int64_t start_ns)
    : port_(port),
      plant_(robot, plant),
      joints_(robot, plant.seed, kLargestClockDrift_ppm),
      watch_(plant_, log_wanted, start_ns),
      next_ns_(start_ns + kMillisecond_ns) {
  joints_.step(start_ns, plant_.sensors());
}

void InterfaceRobot::advance_to(std::int64_t now_ns) {
  for (; next_ns_ <= now_ns; next_ns_ += kMillisecond_ns) {
    hear(next_ns_);
    plant_.step(joints_.torque_Nm());
    joints_.step(next_ns_, plant_.sensors());
    watch_.look(plant_, next_ns_);
    speak(next_ns_);
  }
  hear(kEverything);
  speak(now_ns);
}

void InterfaceRobot::hear(std::int64_t until_ns) {
  while (true) {
    if (!arrived_) {
      arrived_ = port_.receive();
    }
    if (!arrived_ || arrived_->end_ns > until_ns) {
      return;
    }
    for (int joint = 0; joint < joints_.size(); ++joint) {
      joints_.on_frame(joint, arrived_->frame, arrived_->end_ns);
    }
    arrived_.reset();
  }
}

void InterfaceRobot::speak(std::int64_t now_ns) {
  can::Frame frame;
  for (int joint = 0; joint < joints_.size(); ++joint) {
    while (port_.free_buffers() > 0 && joints_.take_frame(joint, frame)) {
      port_.transmit(frame, now_ns);
    }
  }
  port_.flush(now_ns);
}

namespace {

using facts::kMillisecond_ns;

struct LoopResult {
  double wall_s = 0.0;
  std::uint64_t overruns = 0;  // milliseconds that were made up for, since the process woke too late for them
  process::DurationHistogram lateness;
};

LoopResult run_loop(InterfaceRobot& robot, can::SocketCanPort& port, double seconds) {
  LoopResult result;
  can::SocketCanReporter reporter;
  const std::int64_t begin_ns = process::monotonic_ns();
  const std::int64_t stop_ns = begin_ns + static_cast<std::int64_t>(seconds * 1e9);
  std::array<pollfd, 1> wakes{pollfd{port.wake_fd(), POLLIN, 0}};
  std::int64_t now_ns = begin_ns;
  while (!process::stop_requested() && (seconds <= 0.0 || now_ns < stop_ns)) {
    const std::int64_t due_ns = robot.next_ns();
    process::wait_until(due_ns, wakes);
    now_ns = process::monotonic_ns();
    if (now_ns >= due_ns) {
      result.lateness.add(now_ns - due_ns);
      result.overruns += static_cast<std::uint64_t>((now_ns - due_ns) / kMillisecond_ns);
    }
    robot.advance_to(now_ns);
    if (const std::string news = reporter.news(port); !news.empty()) {
      fmt::print(stderr, "virtual_robot: {}\n", news);
    }
  }
  result.wall_s = static_cast<double>(process::monotonic_ns() - begin_ns) * 1e-9;
  return result;
}

nlohmann::ordered_json summary_of(const InterfaceRobot& robot, const can::SocketCanPort& port,
                                  const LoopResult& loop) {
  const process::DurationSummary late = loop.lateness.summary();
  nlohmann::ordered_json summary = {
      {"fell", robot.watch().fell_at_s().has_value()},
      {"distance_m", robot.distance_m()},
      {"seconds", robot.watch().time_s(robot.next_ns() - kMillisecond_ns)},
      {"wall_seconds", loop.wall_s},
      {"overruns", loop.overruns},
      {"wake_up_latency_us", {{"p50", late.p50}, {"p99", late.p99}, {"max", late.max}}},
      {"can", {{"interface", port.interface()}, {"state", can::name_of(port.state())}}}};
  for (const auto& [name, count] : can::counters(port.statistics())) {
    summary["can"][std::string(name)] = count;
  }
  if (robot.watch().fell_at_s()) {
    summary["fell_at_s"] = *robot.watch().fell_at_s();
  }
  return summary;
}

}  // namespace

void run_on_interface(const urdf::RobotModel& robot, const InterfaceRun& options) {
  std::optional<can::CandumpWriter> sent_log;
  can::SocketCanOptions port_options;
  port_options.transmit_buffers = can::FrameHeap::kCapacity;  // every joint's frames of a slot
  if (!options.sent_log.empty()) {
    port_options.sent_log = &sent_log.emplace(options.sent_log);
  }
  can::SocketCanPort port(options.interface, port_options);
  const std::int64_t start_ns = process::monotonic_ns() / kMillisecond_ns * kMillisecond_ns;
  InterfaceRobot body(robot, options.plant, port, !options.walk_log.empty(), start_ns);
  process::ask_for_real_time("virtual_robot", options.priority);
  const LoopResult loop = run_loop(body, port, options.seconds);
  can::finish_sending(port);
  const std::string summary = summary_of(body, port, loop).dump(2) + "\n";
  if (options.summary.empty()) {
    fmt::print("{}", summary);
  } else {
    process::write_text_file(options.summary, summary);
  }
  if (!options.walk_log.empty()) {
    body.watch().write_log(options.walk_log);
  }
  if (sent_log) {
    sent_log->close();
  }
}

}  // namespace gaitway::simulator
