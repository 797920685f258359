// Feeds a recorded bus log to the local controllers, with the simulated body under them, and compares what
// they answer with what was recorded.
//
// Every frame that the joints did not send themselves reaches them at its recorded time; arbitration is given
// by the log. With seed and mismatch of the recorded run the answers are equal to the bit, since nothing else
// decides on them: the bus ends its frames on whole microseconds, which is what a log holds; clock drifts,
// masses, zeros and noise are drawn from the seed; a joint fills its feedback when it releases it, at a
// servo step or at the end of a frame that it received; and everything starts at time zero in the home
// posture. Pushes and power failures of joints are not on the bus: they must be given. A frame that some
// joints had and others had not, or had only when it was repeated, is in the log for all: no log tells. Such
// a log is replayed with the references compared alone.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/simulator/scenario.hpp"

namespace gaitway::tools {

// Which fields of the answers must be equal.
enum class ReplayComparison : std::uint8_t {
  everything,  // what the same body gives
  references   // state, toggles and reference count: what the log alone decides, on any body
};

struct ReplayOptions {
  simulator::PlantOptions plant{};
  double largest_clock_drift_ppm = 50.0;
  ReplayComparison comparison = ReplayComparison::everything;
  bool losses = false;  // answers that are not in the log were lost on the bus: that is no difference
  // What was done to the robot besides the bus, in order of time: pushes, and joints that lost their power.
  // Other events are on the bus themselves.
  std::vector<simulator::ScenarioEvent> events{};
};

// Where recorded and replayed answers part.
struct ReplayDifference {
  std::int64_t time_ns = 0;  // end of the recorded frame, or release of the one that is not in the log
  can::NodeId node = 0;
  std::string field;  // "feedback position"
  std::string recorded, replayed;
};

struct ReplayResult {
  std::uint64_t fed = 0;            // frames that the joints did not send themselves
  std::uint64_t compared = 0;       // the joints' recorded frames
  std::uint64_t matched = 0;        // of these
  std::uint64_t doubled = 0;        // of these: a frame that the bus delivered twice
  std::uint64_t not_in_log = 0;     // frames that the joints sent, but nobody recorded
  std::uint64_t error_reports = 0;  // lines of the log that are no frames: fed to nobody
  std::int64_t end_ns = 0;
  bool fell = false;
  std::optional<ReplayDifference> first;  // difference
  [[nodiscard]] bool equal() const noexcept { return !first; }
};

class LogReplay {
 public:
  // Throws what the robot's profile and body throw.
  LogReplay(const urdf::RobotModel& robot, const ReplayOptions& options);

  // After each time slot.
  using SlotObserver =
      std::function<void(std::int64_t now_ns, const simulator::JointNetwork&, const simulator::Plant&)>;
  void observe(SlotObserver observer) { observer_ = std::move(observer); }

  // A log in order of time, from the robot's start on. Once.
  ReplayResult run(std::span<const can::LoggedFrame> log);

 private:
  struct Answer {
    can::Frame frame;
    std::int64_t released_ns = 0;
  };
  void deliver(const can::LoggedFrame& logged);
  // The joint that alone sends this frame; -1: none does.
  [[nodiscard]] int sender_of(const can::Frame& frame) const noexcept;
  [[nodiscard]] bool is_on_wire(int joint, std::int64_t now_ns) const noexcept;
  void offer(int joint, std::int64_t now_ns);
  void offer_all(std::int64_t now_ns);
  void take_answer(int joint, const can::LoggedFrame& logged);
  void compare(int joint, const can::LoggedFrame& logged);
  void differ(int joint, std::int64_t time_ns, std::string field, std::string recorded, std::string replayed);
  void apply_events(std::int64_t now_ns);
  void apply(const simulator::ScenarioEvent& event, std::int64_t now_ns);

  ReplayOptions options_;
  can::Profile profile_;
  std::vector<can::NodeId> node_;  // of each joint
  const urdf::RobotModel robot_;
  simulator::Plant plant_;
  simulator::JointNetwork joints_;
  std::vector<std::optional<Answer>> waiting_;            // of each joint: its one transmit buffer
  std::vector<std::optional<Answer>> answered_;           // of each joint: its last answer in the log
  std::vector<std::optional<std::int64_t>> power_on_ns_;  // of each joint: it is without power until then
  std::vector<std::int64_t> in_step_ns_;  // of each joint: it hears frames that start from then on
  std::size_t next_event_ = 0;
  std::span<const can::LoggedFrame> to_come_;  // the rest of the log
  SlotObserver observer_;
  ReplayResult result_;
};

}  // namespace gaitway::tools
