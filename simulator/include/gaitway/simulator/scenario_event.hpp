// What a scenario asks of the robot, or does to it or to its world, at one instant; and how people write it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "gaitway/can/frame.hpp"
#include "gaitway/manager/plugin_fault_table.hpp"
#include "gaitway/msgcontroller/command_arbiter.hpp"
#include "gaitway/simulator/camera_fault.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::input {
class YamlValue;
}

namespace gaitway::simulator {

inline constexpr double kLongestRun_s = 86400.0;

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
// Look somewhere; angles from ahead, yaw to the left and pitch down.
struct HeadEvent {
  enum class Mode { ahead, direction, point, scan, hold };  // as HeadCommand has them
  Mode mode = Mode::ahead;
  std::array<double, 2> direction_rad{};              // of direction, and the middle of a scan
  double extent_rad = 0.0, period_s = 0.0;            // of a scan; period 0: as the planner has it
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  // in odometry
  double speed_rad_per_s = 0.0;                       // 0: as the planner has it
};
// A person takes the command without any order, or lets it go.
struct CommandEvent {
  msgcontroller::CommandVerb verb = msgcontroller::CommandVerb::let_go;
};
inline constexpr std::array<std::pair<std::string_view, msgcontroller::CommandVerb>, 3> kCommandVerbs{
    {{"take", msgcontroller::CommandVerb::take},
     {"let_go", msgcontroller::CommandVerb::let_go},
     {"is_lost", msgcontroller::CommandVerb::is_lost}}};
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
// The message controller hears and says nothing for a while; 0: for ever. Either it has stopped and goes on
// afterwards, or it has died and a fresh one is started, which knows nothing of before; the main controller,
// to which its memory is gone, starts anew a little later.
struct MessageControllerSilentFault {
  double duration_s = 0.0;
  bool restarts = false;
};
// Frames are lost on the wire, each with this probability.
struct LoseFramesFault {
  double probability = 0.0;
  double duration_s = 0.0;
  std::string batch_of = {};  // a joint: only its trajectory frames, first and repeated; empty: all frames
};
// One station receives nothing for a while that others receive, and neither it nor a sender notices.
struct MissesFramesFault {
  std::string node = {};  // a joint's name, or message_controller
  double duration_s = 0.0;
};
// A station sends one frame again and again, as fast as the bus takes it.
struct BabbleFault {
  std::string node = {};  // a joint's name, or message_controller; empty: one that does not belong there
  can::Frame frame;
  double duration_s = 0.0;
};
// The batch of the main controller that is handed over next comes late or damaged; or one is handed over at
// once that ought not to be: made of the newest plan and numbered for the running cycle (old), for the one
// after the next (early), for the next one (stale), or for the next one with other points (garbage).
struct BatchFault {
  enum class How { late, damaged, old, early, stale, garbage };
  How how = How::late;
  double late_s = 0.0;  // of one that is late
};
inline constexpr std::array<std::pair<std::string_view, BatchFault::How>, 6> kBatchFaultNames{
    {{"late", BatchFault::How::late},
     {"damaged", BatchFault::How::damaged},
     {"old", BatchFault::How::old},
     {"early", BatchFault::How::early},
     {"stale", BatchFault::How::stale},
     {"garbage", BatchFault::How::garbage}}};
// All motors give at most this part of their torque for a while, and no controller is told.
struct SupplySagsFault {
  double torque_factor = 0.5;
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
  std::string node = {};  // a joint's name, or message_controller
};
// A local controller is without power for a while, its motor without torque. Afterwards it holds where its
// absolute encoder says that it is.
struct JointRestartsFault {
  std::string joint;
  double duration_s = 0.0;
};
// A local controller is without power for good, its motor without torque.
struct JointDiesFault {
  std::string joint;
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

// A sensor tells something else than what is; 0: for ever.
struct SensorFault {
  // noisy: thirty times its noise, an encoder by 20 counts; biased: off by what sensor_faults.cpp says;
  // exchanged: what its counterpart of the other side reads, and the other way round, or the IMU's x for its
  // y.
  enum class How { freezes, reads_zero, noisy, biased, exchanged };
  std::string sensor;  // kImuSensor, one of kFootSensors, or a joint: its encoder
  How how = How::freezes;
  double duration_s = 0.0;
};
inline constexpr std::string_view kImuSensor = "imu";
inline constexpr std::array<std::string_view, 2> kFootSensors{"left_foot", "right_foot"};
inline constexpr std::array<std::pair<std::string_view, SensorFault::How>, 5> kSensorFaultNames{
    {{"freezes", SensorFault::How::freezes},
     {"reads_zero", SensorFault::How::reads_zero},
     {"noisy", SensorFault::How::noisy},
     {"biased", SensorFault::How::biased},
     {"exchanged", SensorFault::How::exchanged}}};
// The sensor of the other side: left_ for right_ and the other way round; empty: it has none.
[[nodiscard]] std::string counterpart_of(std::string_view sensor);
// Put something into the world: a thing that can be pushed, or what stands fast.
struct SpawnEvent {
  std::string name;
  world::Solid::Shape shape = world::Solid::Shape::box;
  Eigen::Vector3d size_m = Eigen::Vector3d::Constant(0.1);  // whole; a cylinder's axis is z
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();     // of its centre
  double yaw_rad = 0.0;
  std::optional<double> mass_kg;  // none: it stands fast
  world::Colour colour{0.8, 0.5, 0.2};
};
// Put a thing, or what was spawned, somewhere else; it comes to rest there.
struct MoveEvent {
  std::string name;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // of its centre
  double yaw_rad = 0.0;
};
// Take away what was spawned.
struct RemoveEvent {
  std::string name;
};

struct ScenarioEvent {
  double at_s = 0.0;
  std::variant<WalkEvent, MotionEvent, WalkToEvent, HeadEvent, CommandEvent, StopEvent, ReleaseEvent,
               EmergencyStopEvent, ManualJointEvent, PushEvent, MainControllerSilentFault,
               MessageControllerSilentFault, LoseFramesFault, DisturbBusFault, JamFault, BusOffFault,
               JointRestartsFault, ForeignFrameFault, PluginFault, SensorFault, CameraFault,
               MissesFramesFault, BabbleFault, BatchFault, SupplySagsFault, JointDiesFault, SpawnEvent,
               MoveEvent, RemoveEvent>
      action;
  bool asked = false;  // a user command that comes as people's do: through the queue, at a millisecond's edge
};

// Of a map with `at_s` and one action. Throws input::InputError with file, line, field, value and rule.
[[nodiscard]] ScenarioEvent read_event(const input::YamlValue& value, const urdf::RobotModel& robot);
// Of a map of the action alone, as programs give it; `source` is what complaints call the text. At 0 s.
[[nodiscard]] ScenarioEvent parse_action(const std::string& text, const std::filesystem::path& source,
                                         const urdf::RobotModel& robot);
// The action as a scenario file has it, `key: value`: read again, it is the same to the bit.
[[nodiscard]] std::string action_text(const ScenarioEvent& event, const urdf::RobotModel& robot);

}  // namespace gaitway::simulator
