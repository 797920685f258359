// What the virtual robot's process watches and writes, whatever its bus is; and the virtual robot on a CAN
// interface.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/background_log.hpp"
#include "gaitway/process/duration_histogram.hpp"
#include "gaitway/process/summary_file.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

// How the process kept its pace.
struct WalkTiming {
  double wall_s = 0.0;
  std::uint64_t overruns = 0;  // milliseconds that were made up for, since the process woke too late for them
  process::DurationHistogram lateness;

  void woke(std::int64_t late_ns) {
    lateness.add(late_ns);
    overruns += static_cast<std::uint64_t>(late_ns / facts::kMillisecond_ns);
  }
};

// Where the robot goes and whether it falls, for the summary and the log of the process.
class WalkWatch {
 public:
  // `log`: file for where the base was, every 10 ms (CSV); `summary_file`: for the summary. Either may be
  // empty. They are written beside the body's work: a kill leaves what had happened, a full or slow disk
  // costs lines. Throws std::runtime_error naming a log that cannot be written.
  WalkWatch(const Plant& plant, const std::filesystem::path& log, std::filesystem::path summary_file,
            std::int64_t start_ns);

  // To be called after each millisecond; the first fall is printed.
  void look(const Plant& plant, std::int64_t now_ns);

  [[nodiscard]] double time_s(std::int64_t now_ns) const noexcept {
    return static_cast<double>(now_ns - start_ns_) * 1e-9;
  }
  [[nodiscard]] nlohmann::ordered_json summary(const Plant& plant, std::int64_t now_ns,
                                               const WalkTiming& timing) const;
  // Whether a second has passed since the last summary, and there is a file for it.
  [[nodiscard]] bool summary_is_due(std::int64_t now_ns) const noexcept {
    return summary_file_ && now_ns >= next_summary_ns_;
  }
  // One that is not the last.
  void offer(nlohmann::ordered_json summary, std::int64_t now_ns);
  // The last one, to the terminal without a file of its own, or where that has no room; ends the log.
  void end(nlohmann::ordered_json summary);

 private:
  using Text = std::array<char, 8192>;  // of a summary, ended by NUL

  std::unique_ptr<process::BackgroundLog> log_;
  std::unique_ptr<process::SummaryFile<Text>> summary_file_;
  std::int64_t next_summary_ns_ = 0;
  std::int64_t start_ns_;
  Eigen::Vector3d start_m_;
  std::optional<double> fell_at_s_;
};

inline constexpr double kLargestClockDrift_ppm = 50.0;  // of a joint's clock

struct InterfaceRun {
  std::string interface;
  std::filesystem::path summary;   // empty: the terminal
  std::filesystem::path walk_log;  // empty: none
  std::filesystem::path sent_log;  // empty: none
  PlantOptions plant;
  double seconds = 0.0;  // 0: until told to stop
  int priority = 0;      // SCHED_FIFO
};

// The virtual robot on a CAN interface: body and local controllers in this process, the bus and everyone else
// outside. What a real robot is to the message controller.
class InterfaceRobot {
 public:
  // All joints send through `port`, which outlives the robot; each of them receives what others send on the
  // bus.
  InterfaceRobot(const urdf::RobotModel& robot, const PlantOptions& plant, can::SocketCanPort& port,
                 const InterfaceRun& files, std::int64_t start_ns);

  // All milliseconds up to `now_ns`, each with the frames that came before it; then the joints hear what has
  // come since, and answer.
  void advance_to(std::int64_t now_ns);

  // The end of the millisecond that runs.
  [[nodiscard]] std::int64_t next_ns() const noexcept { return next_ns_; }
  [[nodiscard]] WalkWatch& watch() noexcept { return watch_; }
  [[nodiscard]] const WalkWatch& watch() const noexcept { return watch_; }
  [[nodiscard]] const Plant& plant() const noexcept { return plant_; }

 private:
  void hear(std::int64_t until_ns);
  void speak(std::int64_t now_ns);

  can::SocketCanPort& port_;
  Plant plant_;
  JointNetwork joints_;
  WalkWatch watch_;
  std::optional<can::TimedFrame> arrived_;  // its millisecond has not come yet
  std::int64_t next_ns_;
};

// Returns when its time is over or it is told to stop. Throws can::BusError when the interface cannot be used
// at the start, std::runtime_error when a file cannot be written.
void run_on_interface(const urdf::RobotModel& robot, const InterfaceRun& options);

}  // namespace gaitway::simulator
