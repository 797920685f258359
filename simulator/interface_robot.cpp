// Figures and log of a walk; on a CAN interface frames in, a millisecond of the body, frames out, in real
// time.
#include "interface_robot.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/candump_log.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::simulator {
namespace {

using facts::kMillisecond_ns;

constexpr std::int64_t kLogPeriod_ns = 10 * kMillisecond_ns;
constexpr std::int64_t kEverything = std::numeric_limits<std::int64_t>::max();

}  // namespace

WalkWatch::WalkWatch(const Plant& plant, bool log_wanted, std::int64_t start_ns)
    : log_wanted_(log_wanted), start_ns_(start_ns), start_m_(plant.truth().base.translation()) {}

void WalkWatch::look(const Plant& plant, std::int64_t now_ns) {
  if (!fell_at_s_ && plant.fallen()) {
    fell_at_s_ = time_s(now_ns);
    fmt::print(stderr, "virtual_robot: fell after {:.2f} s\n", *fell_at_s_);
  }
  if (log_wanted_ && (now_ns - start_ns_) % kLogPeriod_ns == 0) {
    const PlantTruth truth = plant.truth();
    log_.push_back({time_s(now_ns), truth.base.translation(), truth.trunk_tilt_rad});
  }
}

nlohmann::ordered_json WalkWatch::summary(const Plant& plant, std::int64_t now_ns,
                                          const WalkTiming& timing) const {
  const process::DurationSummary late = timing.lateness.summary();
  nlohmann::ordered_json summary = {
      {"fell", fell_at_s_.has_value()},
      {"distance_m", (plant.truth().base.translation() - start_m_).head<2>().norm()},
      {"seconds", time_s(now_ns)},
      {"wall_seconds", timing.wall_s},
      {"overruns", timing.overruns},
      {"wake_up_latency_us", {{"p50", late.p50}, {"p99", late.p99}, {"max", late.max}}}};
  if (fell_at_s_) {
    summary["fell_at_s"] = *fell_at_s_;
  }
  return summary;
}

void WalkWatch::write(const nlohmann::ordered_json& summary, const std::filesystem::path& summary_file,
                      const std::filesystem::path& log_file) const {
  if (summary_file.empty()) {
    fmt::print("{}\n", summary.dump(2));
  } else {
    process::write_text_file(summary_file, summary.dump(2) + "\n");
  }
  if (!log_wanted_) {
    return;
  }
  std::string text = "time_s,base_x_m,base_y_m,base_z_m,trunk_tilt_rad\n";
  for (const Row& row : log_) {
    text += fmt::format("{:.3f},{:.5f},{:.5f},{:.5f},{:.5f}\n", row.time_s, row.base_m.x(), row.base_m.y(),
                        row.base_m.z(), row.trunk_tilt_rad);
  }
  process::write_text_file(log_file, text);
}

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

WalkTiming run_loop(InterfaceRobot& robot, can::SocketCanPort& port, double seconds) {
  WalkTiming result;
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
      result.woke(now_ns - due_ns);
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
                                  const WalkTiming& loop) {
  nlohmann::ordered_json summary =
      robot.watch().summary(robot.plant(), robot.next_ns() - kMillisecond_ns, loop);
  summary["can"] = {{"interface", port.interface()}, {"state", can::name_of(port.state())}};
  for (const auto& [name, count] : can::counters(port.statistics())) {
    summary["can"][std::string(name)] = count;
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
  const WalkTiming loop = run_loop(body, port, options.seconds);
  can::finish_sending(port);
  body.watch().write(summary_of(body, port, loop), options.summary, options.walk_log);
  if (sent_log) {
    sent_log->close();
  }
}

}  // namespace gaitway::simulator
