// The published experiment, rerun: what the messages of a walking robot's bus take, by the bus's own clock;
// as tables beside the published ones, and as pictures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/messages.hpp"
#include "tools/bus/bus_options.hpp"
#include "tools/bus/bus_watch.hpp"

namespace gaitway::tools {

// How long the bus needs for one message of every node: the published experiment's "12 messages". A set is
// one frame of each node, in whatever order. A node that comes again before the others have, or a frame that
// comes half a period after the first, begins a new set.
class FrameSetMeter {
 public:
  // `nodes`: how many frames make a set. `period_ns`: from set to set.
  FrameSetMeter(std::size_t nodes, std::int64_t period_ns) : nodes_(nodes), period_ns_(period_ns) {}

  // One frame of the message that is metered: its first bit's start, and its length with interframe space.
  void take(can::NodeId node, std::int64_t start_ns, std::int64_t length_ns);

  // Bus time of a set: the sum of its frames, interframe spaces included.
  [[nodiscard]] const Spread& bus_time_ms() const noexcept { return bus_time_ms_; }
  // From the first bit of a set to the end of its last interframe space, of the sets whose frames followed
  // each other without a gap: the same, read from the bus's clock.
  [[nodiscard]] const Spread& back_to_back_ms() const noexcept { return back_to_back_ms_; }
  // From the first bit of a set to the end of its last interframe space, whatever lies in between.
  [[nodiscard]] const Spread& span_ms() const noexcept { return span_ms_; }
  [[nodiscard]] std::uint64_t incomplete() const noexcept { return incomplete_; }

 private:
  std::size_t nodes_;
  std::int64_t period_ns_;
  std::set<can::NodeId> seen_;  // of the set that is under way
  std::int64_t first_ns_ = 0, last_ns_ = 0;
  std::int64_t bus_time_ns_ = 0;
  Spread bus_time_ms_, back_to_back_ms_, span_ms_;
  std::uint64_t incomplete_ = 0;
};

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

// Tables 6 and 7 of the published experiment, measured and published values beside each other.
//
// Which messages the bus carries, and what was measured of each.
[[nodiscard]] std::string message_table(const BusMeasurement& measurement, const BusRobot& robot);

// What the bus needs for one message of every node, and for a user command.
[[nodiscard]] std::string time_table(const BusMeasurement& measurement, const BusRobot& robot);

// Both tables.
[[nodiscard]] nlohmann::ordered_json to_json(const BusMeasurement& measurement, const BusRobot& robot);

// By how much a measured time is longer than the published one.
[[nodiscard]] constexpr double difference_percent(double measured, double published) noexcept {
  return 100.0 * (measured / published - 1.0);
}

// Who has the bus when: one time slot with a row for every identifier, and a whole cycle with a row for every
// message. Stand-alone SVG files.
//
// The fullest time slot of the newest whole cycle. Marks how late each frame might have come, by the
// analysis, where its release is known. Both are empty when there was no whole cycle.
[[nodiscard]] std::string slot_picture(const BusMeasurement& measurement, const BusRobot& robot);
[[nodiscard]] std::string cycle_picture(const BusMeasurement& measurement, const BusRobot& robot);

}  // namespace gaitway::tools
