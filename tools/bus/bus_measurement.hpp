// The published experiment, rerun: what the messages of a walking robot's bus take, by the bus's own clock.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/can/bus_port.hpp"
#include "tools/bus/bus_robot.hpp"
#include "tools/bus/bus_watch.hpp"
#include "tools/bus/frame_set_meter.hpp"

namespace gaitway::tools {

// What was published of the robot with twelve local controllers: the bus at 1 Mb/s, frames of eight bytes.
struct PublishedTimes {
  static constexpr std::size_t kNodes = 12;
  static constexpr double kTrajectories_ms = 1.412;  // twelve
  static constexpr double kSensors_ms = 1.414;       // twelve
  static constexpr double kUserCommand_ms = 0.117;   // one
  static constexpr double kUserCommandOnJoints_ms = 10.0;
};

// Manual joint commands, sent while the robot stands.
struct UserCommandFigures {
  Spread length_us;               // as sent: four data bytes, interframe space included
  Spread eight_byte_length_us;    // the same commands, filled up with zeros to eight bytes
  Spread two_commands_length_us;  // two of them in one frame of eight bytes
  Spread on_joints_ms;            // from the mailbox to the end of the frame
  std::uint64_t asked = 0;        // some may be refused: a joint that moves by hand already, for example
};

// Takes the frames of one stretch of time; the same for the simulated bus and for an interface.
class BusMeasurement {
 public:
  BusMeasurement(const BusRobot& robot, BusClock clock);

  void take(const can::TimedFrame& frame);
  // A real user command's frame.
  void take_user_command(const can::Frame& frame);
  void user_command_on_joints(std::int64_t time_ns) {
    user_commands_.on_joints_ms.add(static_cast<double>(time_ns) * 1e-6);
  }
  void user_command_asked() noexcept { ++user_commands_.asked; }

  [[nodiscard]] const BusWatch& watch() const noexcept { return watch_; }
  [[nodiscard]] const FrameSetMeter& trajectories() const noexcept { return trajectories_; }
  [[nodiscard]] const FrameSetMeter& feedbacks() const noexcept { return feedbacks_; }
  [[nodiscard]] const UserCommandFigures& user_commands() const noexcept { return user_commands_; }
  // The frames of the newest whole cycle, and when it began.
  [[nodiscard]] std::span<const can::TimedFrame> cycle() const noexcept { return cycle_; }
  [[nodiscard]] std::int64_t cycle_start_ns() const noexcept { return cycle_start_ns_; }

 private:
  BusWatch watch_;
  FrameSetMeter trajectories_, feedbacks_;
  UserCommandFigures user_commands_;
  std::vector<can::TimedFrame> cycle_, growing_;
  std::int64_t cycle_start_ns_ = 0, growing_start_ns_ = 0;
};

struct BusExperiment {
  std::array<double, 3> walk{0.1, 0.0, 0.0};  // forward m/s, left m/s, turn rad/s
  double seconds = 20.0;                      // of which the first three are not measured
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  std::filesystem::path config;  // plug-ins of the main controller
};

// Standing still for a second and getting into step for two.
inline constexpr double kNotMeasured_s = 3.0;

// Walks, and then sends user commands to a robot that stands. Throws std::runtime_error when the robot falls,
// and what the co-simulation throws.
[[nodiscard]] BusMeasurement measure_simulated_bus(const BusRobot& robot, const BusExperiment& experiment);

}  // namespace gaitway::tools
