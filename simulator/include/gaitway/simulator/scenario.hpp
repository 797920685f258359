// A scenario: what is asked of the robot, and what is done to it, at which time. Read from YAML:
//
//   seconds: 20
//   world: boxes                               # a file beside this one, or a shipped one; world_choice.hpp
//   world_seed: 7                              # of its random courses; without it the world's own
//   conditions: {slope_deg: [5, 0]}              # of the ground and the body; see conditions.hpp
//   events:
//     - {at_s: 1.0, walk: [0.15, 0.0, 0.0]}        # forward m/s, left m/s, turn rad/s
//     - {at_s: 8.0, stand: true}                   # stop walking: finish the step and stand
//     - {at_s: 8.5, motion: wave}                  # a key-frame motion; leave_motion: true ends it early
//     - {at_s: 1.0, walk_to: {x_m: 2.3, y_m: 2.3, yaw_deg: 90}}   # on its own; leave_way: true ends that
//     - {at_s: 9.0, stop: true}                    # user command: the message controller plays the safe tail
//     - {at_s: 9.5, emergency_stop: hold}          # or: soft
//     - {at_s: 9.8, release: true}                 # of the emergency stop: the joints hold where they are
//     - {at_s: 10.0, push: {direction: [0, 1, 0], impulse_Ns: 1.0, duration_s: 0.1}}  # of the link with the
//     IMU;
//                                                                                     # body: another link
//     - {at_s: 12.0, fault: {kind: main_controller_silent, duration_s: 3.0}}
//     - {at_s: 15.0, fault: {kind: lose_frames, probability: 0.02, duration_s: 2.0}}
//     - {at_s: 16.0, fault: {kind: disturb_bus, corruption: 0.01, omission: 0.001, duplicate: 0.001,
//     duration_s: 60}}
//     - {at_s: 16.1, fault: {kind: jam, duration_s: 0.002}}                       # or also: stuck: true
//     - {at_s: 16.2, fault: {kind: bus_off, node: message_controller}}            # or a joint's name
//     - {at_s: 16.3, fault: {kind: joint_restarts, joint: left_knee, duration_s: 0.02}}
//     - {at_s: 16.4, fault: {kind: foreign_frame, id: 0x7AB, data: [1, 2, 3]}}    # or also: extended: true,
//     remote: true
//     - {at_s: 17.0, fault: {kind: plugin_fails, plugin: zmp, how: throws, duration_s: 1.0}}
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/manager/plugin_fault_table.hpp"
#include "gaitway/simulator/conditions.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world_choice.hpp"

namespace gaitway::simulator {

struct WalkEvent {
  Eigen::Vector2d velocity_m_per_s = Eigen::Vector2d::Zero();
  double turn_rate_rad_per_s = 0.0;
  bool walk = true;  // false: finish the step and stand
};
// Play a key-frame motion; without a name: leave the one that plays.
struct MotionEvent {
  std::string name;
};
// Walk to a place of the world; without one: leave the way that is being walked.
struct WalkToEvent {
  std::optional<std::array<double, 3>> goal;  // x m, y m, yaw rad, of the middle between the feet
};
struct StopEvent {};
struct ReleaseEvent {};
struct EmergencyStopEvent {
  bool soft = false;
};
// User command: one joint moves to an angle; refused unless the robot stands without a batch.
struct ManualJointEvent {
  int joint = 0;  // index in RobotModel::joints
  double position_rad = 0.0;
  int duration_slots = 1;  // time slots of 10 ms over which it moves there
};
inline constexpr double kLargestImpulse_Ns = 400.0;
struct PushEvent {
  std::string body;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  double impulse_Ns = 0.0;
  double duration_s = 0.1;
};
// The main controller makes no tick for a while; 0: never again.
struct MainControllerSilentFault {
  double duration_s = 0.0;
};
// Frames are lost on the wire, each with this probability.
struct LoseFramesFault {
  double probability = 0.0;
  double duration_s = 0.0;
};
// Errors at random, each attempt to send a frame meeting one with these probabilities (can::RandomFaults).
struct DisturbBusFault {
  double corruption = 0.0;
  double omission = 0.0;
  double duplicate = 0.0;
  double duration_s = 0.0;
};
// The bus is unusable for a while: noise, or stuck dominant.
struct JamFault {
  double duration_s = 0.0;
  bool stuck = false;
};
// A station's frames are destroyed until it is bus-off; it comes back as the standard has it.
struct BusOffFault {
  std::string node;  // a joint's name, or message_controller
};
// A local controller is without power for a while, its motor without torque. Afterwards it holds where its
// absolute encoder says that it is.
struct JointRestartsFault {
  std::string joint;
  double duration_s = 0.0;
};
// A station that does not belong there sends one frame.
struct ForeignFrameFault {
  can::Frame frame;
};
// A plug-in's steps fail for a while; 0: for ever.
struct PluginFault {
  std::string plugin;
  core::PluginFaultKind how = core::PluginFaultKind::throws;
  double duration_s = 0.0;
  double cost_s = 0.006;  // of a step that overruns
};

struct ScenarioEvent {
  double at_s = 0.0;
  std::variant<WalkEvent, MotionEvent, WalkToEvent, StopEvent, ReleaseEvent, EmergencyStopEvent,
               ManualJointEvent, PushEvent, MainControllerSilentFault, LoseFramesFault, DisturbBusFault,
               JamFault, BusOffFault, JointRestartsFault, ForeignFrameFault, PluginFault>
      action;
  bool asked = false;  // a user command that comes as people's do: through the queue, at a millisecond's edge
};

struct Scenario {
  double seconds = 20.0;
  Conditions conditions = {};
  std::optional<world::WorldChoice> world = std::nullopt;  // none: an endless floor
  std::vector<ScenarioEvent> events;                       // in order of time
};

// Throws input::InputError with file, line, field, value and rule. Pushes must name a link of `robot`, and
// every event must come before the end.
Scenario load_scenario(const std::filesystem::path& file, const urdf::RobotModel& robot);

// Stands for one second, then walks.
Scenario walk_scenario(double forward_m_per_s, double left_m_per_s, double turn_rate_rad_per_s,
                       double seconds);

}  // namespace gaitway::simulator
