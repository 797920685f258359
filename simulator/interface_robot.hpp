// The virtual robot on a CAN interface: body and local controllers in this process, the bus and everyone else
// outside. What a real robot is to the message controller.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "walk_watch.hpp"

namespace gaitway::simulator {

inline constexpr double kLargestClockDrift_ppm = 50.0;  // of a joint's clock

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
  [[nodiscard]] double distance_m() const { return watch_.distance_m(plant_); }

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
