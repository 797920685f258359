// What the API may do to the robot: the whole of it. Implemented over the link to the main controller in the
// module, and by a recorder in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::api {

// How old an order may be when it comes; the robot's side judges the same again, by its own clock.
inline constexpr std::int64_t kVelocityValidity_ns = 200'000'000;
inline constexpr std::int64_t kOrderValidity_ns = 1'000'000'000;

struct Velocity {
  double forward_m_per_s = 0.0;
  double left_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;
  bool operator==(const Velocity&) const = default;
};

// Of the world, of the middle between the feet.
struct Goal {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

// HeadCommand::mode, with the numbers that the schema gives.
enum class LookMode : std::uint32_t { ahead = 0, direction = 1, point = 2, scan = 3, hold = 4 };

// Where the head is to look; what its mode does not name means nothing.
struct Look {
  LookMode mode = LookMode::ahead;
  double yaw_rad = 0.0, pitch_rad = 0.0;    // of the neck, to the left and down, from ahead
  double extent_rad = 0.0, period_s = 0.0;  // of a scan; period 0: as the robot has it
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;   // of a point, in odometry
  double speed_rad_per_s = 0.0;             // at most; 0: as the robot has it
};

// BehaviourRequest::verb, likewise.
enum class MissionVerb : std::uint32_t { start = 0, end = 1, change = 2 };

// core::PluginVerb, with the numbers that the schema gives.
enum class PluginVerb : std::uint32_t {
  reload = 0,
  load = 1,
  unload = 2,
  set_parameter = 3,
  describe_parameter = 6
};

struct PluginOrder {
  PluginVerb verb = PluginVerb::reload;
  std::string plugin;
  std::string library;      // of reload and load; empty: where it was
  std::string parameter;    // of set_parameter
  std::string value;        // of set_parameter; with its unit
  std::uint32_t index = 0;  // of describe_parameter
};

struct PluginStatus {
  std::string name;
  std::string state;  // for people: "works", "out of service", ...
  std::uint64_t steps = 0, faults = 0, overruns = 0;
  double p50_step_us = 0.0, p99_step_us = 0.0, worst_step_us = 0.0;
};

struct JointLimits {
  std::string name;
  double lower_rad = 0.0, upper_rad = 0.0;
};

// A recording in the recordings folder.
struct RecordingStatus {
  std::string file;           // its path
  std::uint64_t bytes = 0;    // as far as it has been written
  std::int64_t start_ns = 0;  // by the computer's clock, since 1970
};
struct RecordingList {
  std::vector<RecordingStatus> newest;  // the newest first
  std::size_t count = 0;                // that were looked at
  bool complete = true;                 // there are no more in the folder
};

// What became of an order that takes time.
struct OrderResult {
  std::uint32_t number = 0;  // as the order's call returned it
  bool done = false;
  std::string
      text;  // for people; of describe_parameter: a facts::ParameterLine; of recordings: the file's path
  RecordingList recordings = {};  // of list_recordings()
};

// None of these blocks. Numbers of orders are never 0. `age_ns`: so long ago, at most, the client gave the
// order; the robot does not carry out what has become older than its kind may be.
class RobotPort {
 public:
  virtual ~RobotPort() = default;

  // The robot's clock, virtual or real; 0 while the robot is not there.
  [[nodiscard]] virtual std::int64_t now_ns() const = 0;
  // Whether the message controller is alive, and can be heard.
  [[nodiscard]] virtual bool connected() const = 0;
  // Which part does not answer while it is not so, for people.
  [[nodiscard]] virtual std::string_view silent_part() const = 0;
  // Whether an emergency stop holds: all that moves the robot is in vain until it is released.
  [[nodiscard]] virtual bool emergency_stopped() const = 0;
  // What the robot does, in a word of /robot_state; empty: not known.
  [[nodiscard]] virtual std::string_view activity() const = 0;

  // Walk with this velocity until so much robot time has passed without a new command.
  virtual std::optional<std::uint32_t> walk(const Velocity& velocity, std::int64_t holds_ns,
                                            std::int64_t age_ns) = 0;
  // End the walk by the next steps, and stand. A motion goes on.
  virtual void stand() = 0;

  // Orders: the number under which take_result() tells of it, or nothing when the way is blocked (a full
  // queue). The way of a stop never is.
  virtual std::optional<std::uint32_t> stop() = 0;  // plays the safe tail at once
  virtual std::optional<std::uint32_t> emergency_stop(bool soft) = 0;
  // Ends an emergency stop: the joints hold where they are, and the robot goes to its stand from there.
  virtual std::optional<std::uint32_t> release(std::int64_t age_ns) = 0;
  virtual std::optional<std::uint32_t> move_joint(int joint, double position_rad, double duration_s,
                                                  std::int64_t age_ns) = 0;
  // An empty name: leave the motion that plays, if any. Answered when it begins, or is refused.
  virtual std::optional<std::uint32_t> play_motion(std::string_view name, std::int64_t age_ns) = 0;
  // Answered when the way is planned, or refused.
  virtual std::optional<std::uint32_t> walk_to(const Goal& goal, std::int64_t age_ns) = 0;
  virtual std::optional<std::uint32_t> leave_way(std::int64_t age_ns) = 0;
  virtual std::optional<std::uint32_t> look(const Look& look, std::int64_t age_ns) = 0;
  // A person takes the command of the robot, or lets it go to its behaviour. Answered when it is so, or will
  // not be.
  virtual std::optional<std::uint32_t> take_command(std::int64_t age_ns) = 0;
  virtual std::optional<std::uint32_t> let_command_go(std::int64_t age_ns) = 0;
  // `mission`: of start; empty: the one that is loaded. Answered by the behaviour.
  virtual std::optional<std::uint32_t> mission(MissionVerb verb, std::string_view mission,
                                               std::int64_t age_ns) = 0;
  virtual std::optional<std::uint32_t> order(const PluginOrder& order) = 0;
  virtual std::optional<OrderResult> take_result() = 0;

  [[nodiscard]] virtual const std::vector<JointLimits>& joints() const = 0;
  [[nodiscard]] virtual std::vector<PluginStatus> plugins() const = 0;

  // Orders, too: files take the time that their disk does. Each throws std::runtime_error: why it cannot be,
  // for people. `name`: of the file, without folder; checked by the caller to be a plain name; empty: after
  // the time.
  virtual std::uint32_t start_recording(std::string_view name) = 0;
  virtual std::uint32_t stop_recording() = 0;
  virtual std::uint32_t list_recordings(std::size_t most) = 0;
};

}  // namespace gaitway::api
