// What the virtual robot's process watches and writes, whatever its bus is; and the virtual robot on a CAN
// interface.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/duration_histogram.hpp"
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
  WalkWatch(const Plant& plant, bool log_wanted, std::int64_t start_ns);

  // To be called after each millisecond; the first fall is printed.
  void look(const Plant& plant, std::int64_t now_ns);

  [[nodiscard]] double time_s(std::int64_t now_ns) const noexcept {
    return static_cast<double>(now_ns - start_ns_) * 1e-9;
  }
  [[nodiscard]] nlohmann::ordered_json summary(const Plant& plant, std::int64_t now_ns,
                                               const WalkTiming& timing) const;
  // The summary, to the terminal without a file of its own; where the base was, every 10 ms (CSV), where a
  // log is wanted. Throws what process::write_text_file() throws.
  void write(const nlohmann::ordered_json& summary, const std::filesystem::path& summary_file,
             const std::filesystem::path& log_file) const;

 private:
  struct Row {
    double time_s;
    Eigen::Vector3d base_m;
    double trunk_tilt_rad;
  };
  bool log_wanted_;
  std::int64_t start_ns_;
  Eigen::Vector3d start_m_;
  std::optional<double> fell_at_s_;
  std::vector<Row> log_;
};

inline constexpr double kLargestClockDrift_ppm = 50.0;  // of a joint's clock

// The virtual robot on a CAN interface: body and local controllers in this process, the bus and everyone else
// outside. What a real robot is to the message controller.
class InterfaceRobot {
 public:
  // All joints send through `port`, which outlives the robot; each of them receives what others send on the
  // bus.
  InterfaceRobot(const urdf::RobotModel& robot, const PlantOptions& plant, can::SocketCanPort& port,
                 bool log_wanted, std::int64_t start_ns);

  // All milliseconds up to `now_ns`, each with the frames that came before it; then the joints hear what has
  // come since, and answer.
  void advance_to(std::int64_t now_ns);

  // The end of the millisecond that runs.
  [[nodiscard]] std::int64_t next_ns() const noexcept { return next_ns_; }
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

struct InterfaceRun {
  std::string interface;
  std::filesystem::path summary;   // empty: the terminal
  std::filesystem::path walk_log;  // empty: none
  std::filesystem::path sent_log;  // empty: none
  PlantOptions plant;
  double seconds = 0.0;  // 0: until told to stop
  int priority = 0;      // SCHED_FIFO
};

// Returns when its time is over or it is told to stop. Throws can::BusError when the interface cannot be used
// at the start, std::runtime_error when a file cannot be written.
void run_on_interface(const urdf::RobotModel& robot, const InterfaceRun& options);

}  // namespace gaitway::simulator
