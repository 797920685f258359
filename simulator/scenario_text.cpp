// What happens in a scenario, as its file has it: numbers in the shortest form that reads back the same.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "gaitway/simulator/scenario_event.hpp"

namespace gaitway::simulator {
namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string list(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string frame_text(const can::Frame& frame) {
  std::string bytes;
  for (std::size_t i = 0; i < frame.size; ++i)
    bytes += fmt::format("{}{}", i == 0 ? "" : ", ", frame.data[i]);
  return fmt::format("id: {}, data: [{}]{}{}", frame.id, bytes, frame.extended ? ", extended: true" : "",
                     frame.remote ? ", remote: true" : "");
}

struct ActionText {
  const urdf::RobotModel& robot;

  std::string operator()(const WalkEvent& walk) const {
    return walk.walk ? fmt::format("walk: [{}, {}, {}]", walk.velocity_m_per_s.x(), walk.velocity_m_per_s.y(),
                                   walk.turn_rate_rad_per_s)
                     : "stand: true";
  }
  std::string operator()(const MotionEvent& motion) const {
    return motion.name.empty() ? "leave_motion: true" : "motion: " + quoted(motion.name);
  }
  std::string operator()(const WalkToEvent& way) const {
    return way.goal ? fmt::format("walk_to: {{x_m: {}, y_m: {}, yaw_rad: {}}}", (*way.goal)[0],
                                  (*way.goal)[1], (*way.goal)[2])
                    : "leave_way: true";
  }
  std::string operator()(const HeadEvent& head) const {
    constexpr std::string_view kModes[] = {"ahead", "direction", "point", "scan",
                                           "hold"};  // as HeadEvent::Mode
    return fmt::format(
        "head: {{look: {}, yaw_rad: {}, pitch_rad: {}, extent_rad: {}, period_s: {}, speed_rad_per_s: {}{}}}",
        kModes[static_cast<std::size_t>(head.mode)], head.direction_rad[0], head.direction_rad[1],
        head.extent_rad, head.period_s, head.speed_rad_per_s,
        head.mode == HeadEvent::Mode::point ? ", point_m: " + list(head.point_m) : "");
  }
  std::string operator()(const CommandEvent& command) const {
    const std::string_view verb =
        std::ranges::find(kCommandVerbs, command.verb, [](const auto& entry) { return entry.second; })->first;
    return fmt::format("command: {}", verb);
  }
  std::string operator()(const StopEvent&) const { return "stop: true"; }
  std::string operator()(const EmergencyStopEvent& stop) const {
    return fmt::format("emergency_stop: {}", stop.soft ? "soft" : "hold");
  }
  std::string operator()(const ReleaseEvent&) const { return "release: true"; }
  std::string operator()(const ManualJointEvent& move) const {
    return fmt::format("move_joint: {{joint: {}, position_rad: {}, duration_slots: {}}}",
                       robot.joints[static_cast<std::size_t>(move.joint)].name, move.position_rad,
                       move.duration_slots);
  }
  std::string operator()(const PushEvent& push) const {
    return fmt::format("push: {{body: {}, direction: {}, impulse_Ns: {}, duration_s: {}}}", quoted(push.body),
                       list(push.direction), push.impulse_Ns, push.duration_s);
  }
  std::string operator()(const MainControllerSilentFault& fault) const {
    return fmt::format("fault: {{kind: main_controller_silent{}}}", duration(fault.duration_s));
  }
  std::string operator()(const MessageControllerSilentFault& fault) const {
    return fmt::format("fault: {{kind: message_controller_silent{}{}}}", duration(fault.duration_s),
                       fault.restarts ? ", restarts: true" : "");
  }
  std::string operator()(const LoseFramesFault& fault) const {
    return fmt::format("fault: {{kind: lose_frames, probability: {}, duration_s: {}{}}}", fault.probability,
                       fault.duration_s,
                       fault.batch_of.empty() ? "" : ", batch_of: " + quoted(fault.batch_of));
  }
  std::string operator()(const MissesFramesFault& fault) const {
    return fmt::format("fault: {{kind: misses_frames, node: {}, duration_s: {}}}", quoted(fault.node),
                       fault.duration_s);
  }
  std::string operator()(const BabbleFault& fault) const {
    return fmt::format("fault: {{kind: babbles{}, {}, duration_s: {}}}",
                       fault.node.empty() ? "" : ", node: " + quoted(fault.node), frame_text(fault.frame),
                       fault.duration_s);
  }
  std::string operator()(const BatchFault& fault) const {
    const std::string_view how =
        std::ranges::find(kBatchFaultNames, fault.how, [](const auto& entry) { return entry.second; })->first;
    return fmt::format("fault: {{kind: batch_fails, how: {}{}}}", how,
                       fault.how == BatchFault::How::late ? fmt::format(", late_s: {}", fault.late_s) : "");
  }
  std::string operator()(const SupplySagsFault& fault) const {
    return fmt::format("fault: {{kind: supply_sags, torque_factor: {}, duration_s: {}}}", fault.torque_factor,
                       fault.duration_s);
  }
  std::string operator()(const JointDiesFault& fault) const {
    return fmt::format("fault: {{kind: joint_dies, joint: {}}}", quoted(fault.joint));
  }
  std::string operator()(const DisturbBusFault& fault) const {
    return fmt::format(
        "fault: {{kind: disturb_bus, corruption: {}, omission: {}, duplicate: {}, duration_s: {}}}",
        fault.corruption, fault.omission, fault.duplicate, fault.duration_s);
  }
  std::string operator()(const JamFault& fault) const {
    return fmt::format("fault: {{kind: jam, duration_s: {}{}}}", fault.duration_s,
                       fault.stuck ? ", stuck: true" : "");
  }
  std::string operator()(const BusOffFault& fault) const {
    return fmt::format("fault: {{kind: bus_off, node: {}}}", quoted(fault.node));
  }
  std::string operator()(const JointRestartsFault& fault) const {
    return fmt::format("fault: {{kind: joint_restarts, joint: {}, duration_s: {}}}", quoted(fault.joint),
                       fault.duration_s);
  }
  std::string operator()(const ForeignFrameFault& fault) const {
    return fmt::format("fault: {{kind: foreign_frame, {}}}", frame_text(fault.frame));
  }
  std::string operator()(const PluginFault& fault) const {
    const std::string_view how = std::ranges::find(core::kPluginFaultNames, fault.how, [](const auto& entry) {
                                   return entry.second;
                                 })->first;
    return fmt::format(
        "fault: {{kind: plugin_fails, plugin: {}, how: {}{}{}}}", quoted(fault.plugin), how,
        duration(fault.duration_s),
        fault.how == core::PluginFaultKind::overruns ? fmt::format(", cost_s: {}", fault.cost_s) : "");
  }
  std::string operator()(const SensorFault& fault) const {
    const std::string_view how = std::ranges::find(kSensorFaultNames, fault.how, [](const auto& entry) {
                                   return entry.second;
                                 })->first;
    return fmt::format("fault: {{kind: sensor_fails, sensor: {}, how: {}{}}}", quoted(fault.sensor), how,
                       duration(fault.duration_s));
  }
  std::string operator()(const CameraFault& fault) const {
    const auto name = [](const auto& names, auto value) {
      return std::ranges::find(names, value, [](const auto& entry) { return entry.second; })->first;
    };
    std::string more;
    if (fault.how == CameraFault::How::turned) more = ", turn_deg: " + list(fault.turn_deg);
    if (fault.how == CameraFault::How::dropped) more = fmt::format(", share: {}", fault.share);
    if (fault.how == CameraFault::How::late) more = fmt::format(", later_s: {}", fault.later_s);
    return fmt::format("fault: {{kind: camera_fails, camera: {}, how: {}{}{}}}",
                       name(kCameraNames, fault.camera), name(kCameraFaultNames, fault.how),
                       duration(fault.duration_s), more);
  }
  std::string operator()(const SpawnEvent& spawn) const {
    constexpr std::string_view kShapes[] = {"box", "cylinder", "sphere"};  // as Solid::Shape
    return fmt::format(
        "spawn: {{name: {}, shape: {}, size_m: {}, position_m: {}, yaw_rad: {}{}, colour: [{}, {}, {}]}}",
        quoted(spawn.name), kShapes[static_cast<std::size_t>(spawn.shape)], list(spawn.size_m),
        list(spawn.position_m), spawn.yaw_rad,
        spawn.mass_kg ? fmt::format(", mass_kg: {}", *spawn.mass_kg) : "", spawn.colour[0], spawn.colour[1],
        spawn.colour[2]);
  }
  std::string operator()(const MoveEvent& move) const {
    return fmt::format("move: {{name: {}, position_m: {}, yaw_rad: {}}}", quoted(move.name),
                       list(move.position_m), move.yaw_rad);
  }
  std::string operator()(const RemoveEvent& remove) const {
    return fmt::format("remove: {{name: {}}}", quoted(remove.name));
  }

 private:
  // 0: for ever, which the file says by leaving it out.
  static std::string duration(double duration_s) {
    return duration_s > 0.0 ? fmt::format(", duration_s: {}", duration_s) : "";
  }
};

}  // namespace

std::string action_text(const ScenarioEvent& event, const urdf::RobotModel& robot) {
  return std::visit(ActionText{robot}, event.action);
}

}  // namespace gaitway::simulator
