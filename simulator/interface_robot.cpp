// Figures and log of a walk; on a CAN interface frames in, a millisecond of the body, frames out, in real
// time.
#include "interface_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/candump_log.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::simulator {
namespace {

using facts::kMillisecond_ns;

constexpr std::int64_t kLogPeriod_ns = 10 * kMillisecond_ns;
constexpr std::uint64_t kLog_bytes = std::uint64_t{64} << 20;  // some four hours; and those before them
constexpr std::int64_t kEverything = std::numeric_limits<std::int64_t>::max();

}  // namespace

WalkWatch::WalkWatch(const Plant& plant, const std::filesystem::path& log, std::filesystem::path summary_file,
                     std::int64_t start_ns)
    : start_ns_(start_ns), start_m_(plant.truth().base.translation()) {
  if (!log.empty()) {
    log_ = std::make_unique<process::BackgroundLog>(
        process::LogFile(
            log, {.most_bytes = kLog_bytes, .head = "time_s,base_x_m,base_y_m,base_z_m,trunk_tilt_rad\n"}),
        process::BackgroundLogOptions{.tell = process::tell_on_stderr("virtual_robot")});
  }
  if (!summary_file.empty()) {
    summary_file_ = std::make_unique<process::SummaryFile<Text>>(
        std::move(summary_file), [](const Text& text) { return std::string(text.data()); },
        process::tell_on_stderr("virtual_robot"));
  }
}

void WalkWatch::look(const Plant& plant, std::int64_t now_ns) {
  if (!fell_at_s_ && plant.fallen()) {
    fell_at_s_ = time_s(now_ns);
    fmt::print(stderr, "virtual_robot: fell after {:.2f} s\n", *fell_at_s_);
  }
  if (log_ && (now_ns - start_ns_) % kLogPeriod_ns == 0) {
    const PlantTruth truth = plant.truth();
    const Eigen::Vector3d& base_m = truth.base.translation();
    std::array<char, 160> line{};
    const auto end =
        fmt::format_to_n(line.data(), line.size(), "{:.3f},{:.5f},{:.5f},{:.5f},{:.5f}\n", time_s(now_ns),
                         base_m.x(), base_m.y(), base_m.z(), truth.trunk_tilt_rad);
    log_->add({line.data(), end.out});
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

void WalkWatch::offer(nlohmann::ordered_json summary, std::int64_t now_ns) {
  constexpr std::int64_t kBetweenSummaries_ns = facts::kSecond_ns;
  next_summary_ns_ = now_ns + kBetweenSummaries_ns;
  summary["ended"] = false;
  const std::string text = summary.dump(2) + "\n";
  Text copy{};
  std::copy_n(text.begin(), std::min(text.size(), copy.size() - 1), copy.begin());
  summary_file_->offer(copy);
}

void WalkWatch::end(nlohmann::ordered_json summary) {
  summary["ended"] = true;
  if (log_) {
    const process::LogCount log = log_->close();
    summary["walk_log"] = {{"lines", log.lines}, {"lost", log.lost}};
  }
  const std::string text = summary.dump(2) + "\n";
  const std::string error = summary_file_ ? summary_file_->end(text) : std::string();
  if (!error.empty()) {
    fmt::print(stderr, "virtual_robot: {}\n", error);
  }
  if (!summary_file_ || !error.empty()) {
    fmt::print("{}", text);
  }
}

InterfaceRobot::InterfaceRobot(const urdf::RobotModel& robot, const PlantOptions& plant,
                               can::SocketCanPort& port, const InterfaceRun& files, std::int64_t start_ns)
    : port_(port),
      plant_(robot, plant),
      joints_(robot, plant.seed, kLargestClockDrift_ppm, plant.mismatch),
      watch_(plant_, files.walk_log, files.summary, start_ns),
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
    if (robot.watch().summary_is_due(now_ns)) {
      result.wall_s = static_cast<double>(now_ns - begin_ns) * 1e-9;
      robot.watch().offer(summary_of(robot, port, result), now_ns);
    }
    if (const std::string news = reporter.news(port); !news.empty()) {
      fmt::print(stderr, "virtual_robot: {}\n", news);
    }
  }
  result.wall_s = static_cast<double>(process::monotonic_ns() - begin_ns) * 1e-9;
  return result;
}

}  // namespace

void run_on_interface(const urdf::RobotModel& robot, const InterfaceRun& options) {
  std::optional<can::CandumpWriter> sent_log;
  can::SocketCanOptions port_options;
  port_options.transmit_buffers = can::FrameHeap::kCapacity;  // every joint's frames of a slot
  if (!options.sent_log.empty()) {
    port_options.sent_log = &sent_log.emplace(
        options.sent_log,
        can::CandumpOptions{.in_real_time = true, .tell = process::tell_on_stderr("virtual_robot")});
  }
  can::SocketCanPort port(options.interface, port_options);
  const std::int64_t start_ns = process::monotonic_ns() / kMillisecond_ns * kMillisecond_ns;
  InterfaceRobot body(robot, options.plant, port, options, start_ns);
  process::ask_for_real_time("virtual_robot", options.priority);
  const WalkTiming loop = run_loop(body, port, options.seconds);
  can::finish_sending(port);
  nlohmann::ordered_json summary = summary_of(body, port, loop);
  if (sent_log) {
    const process::LogCount log = sent_log->finish();
    summary["sent_log"] = {{"lines", log.lines}, {"lost", log.lost}};
  }
  body.watch().end(std::move(summary));
}

}  // namespace gaitway::simulator
