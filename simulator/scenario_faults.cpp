// Reads a scenario's faults: of the bus, of joints, of sensors, of plug-ins.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/input/complaint.hpp"
#include "scenario_reading.hpp"

namespace gaitway::simulator {

using input::YamlValue;

// One of the robot's names.
std::string read_name(const YamlValue& value, const urdf::RobotModel& robot, const char* what,
                      const std::vector<std::string>& known) {
  const std::string name = value.text();
  if (std::ranges::find(known, name) == known.end()) {
    value.refuse(fmt::format("the robot '{}' has no such {}", robot.name, what), input::suggest(name, known));
  }
  return name;
}

std::string read_node(const YamlValue& value, const urdf::RobotModel& robot, bool or_message_controller) {
  std::vector<std::string> known;
  std::ranges::transform(robot.joints, std::back_inserter(known),
                         [](const urdf::Joint& joint) { return joint.name; });
  if (or_message_controller) {
    known.emplace_back("message_controller");
  }
  return read_name(value, robot, "node", known);
}

void require_true(const YamlValue& value) {
  if (value.text() != "true") {
    value.refuse("must be true", "Leave the event out if it shall not happen");
  }
}

namespace {

PluginFault read_plugin_fault(const YamlValue& value) {
  using Kind = core::PluginFaultKind;
  constexpr std::array<std::string_view, 5> kKeys{"kind", "plugin", "how", "duration_s", "cost_s"};
  value.require_map(kKeys);
  PluginFault fault;
  fault.plugin = value.at("plugin").text();
  const YamlValue how = value.at("how");
  const auto found = std::ranges::find_if(core::kPluginFaultNames,
                                          [&](const auto& entry) { return entry.first == how.text(); });
  if (found == core::kPluginFaultNames.end()) {
    how.refuse("must be throws, not_a_number, jumps or overruns", "Choose one of them.");
  }
  fault.how = found->second;
  if (const auto duration = value.find("duration_s")) {
    fault.duration_s = duration->number(kEventDuration);
  }
  if (const auto cost = value.find("cost_s")) {
    if (fault.how != Kind::overruns) {
      cost->refuse("belongs to a step that overruns", "Leave it out");
    }
    fault.cost_s = cost->number({1e-6, 10.0, "s"});
  }
  return fault;
}

SensorFault read_sensor_fault(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 4>{"kind", "sensor", "how", "duration_s"});
  std::vector<std::string> known{std::string(kImuSensor), std::string(kFootSensors[0]),
                                 std::string(kFootSensors[1])};
  std::ranges::transform(robot.joints, std::back_inserter(known), &urdf::Joint::name);
  SensorFault fault;
  fault.sensor = read_name(value.at("sensor"), robot, "sensor", known);
  const YamlValue how = value.at("how");
  const auto found =
      std::ranges::find_if(kSensorFaultNames, [&](const auto& entry) { return entry.first == how.text(); });
  if (found == kSensorFaultNames.end()) {
    how.refuse("must be freezes, reads_zero, noisy, biased or exchanged", "Choose one of them.");
  }
  fault.how = found->second;
  const std::string other = counterpart_of(fault.sensor);
  if (fault.how == SensorFault::How::exchanged && fault.sensor != kImuSensor &&
      std::ranges::find(known, other) == known.end()) {
    how.refuse(fmt::format("'{}' has no counterpart to be exchanged with", fault.sensor),
               "Choose a sensor that left and right have.");
  }
  if (const auto duration = value.find("duration_s")) fault.duration_s = duration->number(kEventDuration);
  return fault;
}

template <class Names>
auto read_choice(const YamlValue& value, const Names& names) {
  const std::string text = value.text();
  const auto found = std::ranges::find_if(names, [&](const auto& entry) { return entry.first == text; });
  if (found == std::end(names)) {
    std::vector<std::string> known;
    for (const auto& entry : names) known.emplace_back(entry.first);
    value.refuse(
        fmt::format("must be {} or {}", fmt::join(known.begin(), known.end() - 1, ", "), known.back()),
        input::suggest(text, known));
  }
  return found->second;
}

// What belongs to one way of failing only.
std::optional<YamlValue> find_of(const YamlValue& value, std::string_view key, const CameraFault& fault,
                                 CameraFault::How how) {
  const auto found = value.find(key);
  if (found && fault.how != how) {
    const auto* const name =
        std::ranges::find(kCameraFaultNames, how, [](const auto& entry) { return entry.second; });
    found->refuse(fmt::format("belongs to a camera that is {}", name->first), "Leave it out");
  }
  return found;
}

CameraFault read_camera_fault(const YamlValue& value) {
  using How = CameraFault::How;
  value.require_map(
      std::array<std::string_view, 7>{"kind", "camera", "how", "duration_s", "turn_deg", "share", "later_s"});
  CameraFault fault;
  fault.how = read_choice(value.at("how"), kCameraFaultNames);
  if (const auto camera = value.find("camera")) {
    fault.camera = read_choice(*camera, kCameraNames);
    const bool of_the_pair =
        fault.how == How::exchanged || fault.how == How::dropped || fault.how == How::late;
    if (of_the_pair && fault.camera != CameraFault::Camera::both) {
      camera->refuse("happens to both cameras", "Leave it out");
    }
  }
  if (const auto turn = find_of(value, "turn_deg", fault, How::turned)) {
    fault.turn_deg = Eigen::Vector3d(turn->numbers<3>({-20.0, 20.0, "deg"}).data());
  }
  if (const auto share = find_of(value, "share", fault, How::dropped))
    fault.share = share->number({0.0, 1.0, ""});
  if (const auto later = find_of(value, "later_s", fault, How::late)) {
    fault.later_s = later->number({0.001, 10.0, "s"});
  }
  if (const auto duration = value.find("duration_s")) fault.duration_s = duration->number(kEventDuration);
  return fault;
}

DisturbBusFault read_disturbance(const YamlValue& value) {
  constexpr std::array<std::string_view, 5> kKeys{"kind", "corruption", "omission", "duplicate",
                                                  "duration_s"};
  value.require_map(kKeys);
  DisturbBusFault fault{.duration_s = value.at("duration_s").number(kEventDuration)};
  const std::array<std::pair<std::string_view, double*>, 3> probabilities{
      {{"corruption", &fault.corruption}, {"omission", &fault.omission}, {"duplicate", &fault.duplicate}}};
  for (const auto& [key, target] : probabilities) {
    if (const auto probability = value.find(key)) {
      *target = probability->number({0.0, 1.0, ""});
    }
  }
  return fault;
}

JamFault read_jam(const YamlValue& value) {
  constexpr std::array<std::string_view, 3> kKeys{"kind", "duration_s", "stuck"};
  value.require_map(kKeys);
  JamFault fault{.duration_s = value.at("duration_s").number({1e-5, 10.0, "s"})};
  if (const auto stuck = value.find("stuck")) {
    require_true(*stuck);
    fault.stuck = true;
  }
  return fault;
}

can::Frame read_frame(const YamlValue& value) {
  can::Frame frame;
  for (const auto& [key, target] :
       {std::pair{"extended", &frame.extended}, std::pair{"remote", &frame.remote}}) {
    if (const auto flag = value.find(key)) {
      require_true(*flag);
      *target = true;
    }
  }
  frame.id = static_cast<std::uint32_t>(value.at("id").integer(
      0, static_cast<int>(frame.extended ? can::kLargestExtendedId : can::kLargestId)));
  if (const auto data = value.find("data")) {
    const std::vector<YamlValue> bytes = data->items();
    if (bytes.size() > frame.data.size()) {
      data->refuse("a frame has at most 8 bytes", "Leave some out");
    }
    for (const YamlValue& byte : bytes) {
      frame.data[frame.size++] = static_cast<std::uint8_t>(byte.integer(0, 255));
    }
  }
  return frame;
}

ForeignFrameFault read_foreign_frame(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 5>{"kind", "id", "data", "extended", "remote"});
  return {read_frame(value)};
}

BabbleFault read_babble(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(
      std::array<std::string_view, 7>{"kind", "node", "id", "data", "extended", "remote", "duration_s"});
  BabbleFault fault{.frame = read_frame(value), .duration_s = value.at("duration_s").number(kEventDuration)};
  if (const auto node = value.find("node")) fault.node = read_node(*node, robot, true);
  return fault;
}

MissesFramesFault read_misses_frames(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 3>{"kind", "node", "duration_s"});
  return {read_node(value.at("node"), robot, true), value.at("duration_s").number(kEventDuration)};
}

LoseFramesFault read_lose_frames(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 4>{"kind", "probability", "duration_s", "batch_of"});
  LoseFramesFault fault{.probability = value.at("probability").number({0.0, 1.0, ""}),
                        .duration_s = value.at("duration_s").number(kEventDuration)};
  if (const auto joint = value.find("batch_of")) fault.batch_of = read_node(*joint, robot, false);
  return fault;
}

BatchFault read_batch_fault(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 3>{"kind", "how", "late_s"});
  BatchFault fault{.how = read_choice(value.at("how"), kBatchFaultNames)};
  const auto late = value.find("late_s");
  if (fault.how == BatchFault::How::late) {
    fault.late_s = value.at("late_s").number({0.0001, 10.0, "s"});
  } else if (late) {
    late->refuse("belongs to a batch that is late", "Leave it out");
  }
  return fault;
}

SupplySagsFault read_supply_sags(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 3>{"kind", "torque_factor", "duration_s"});
  return {value.at("torque_factor").number({0.0, 1.0, ""}), value.at("duration_s").number(kEventDuration)};
}

BusOffFault read_bus_off(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 2>{"kind", "node"});
  return {read_node(value.at("node"), robot, true)};
}

JointRestartsFault read_joint_restarts(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 3>{"kind", "joint", "duration_s"});
  return {read_node(value.at("joint"), robot, false), value.at("duration_s").number({0.001, 60.0, "s"})};
}

JointDiesFault read_joint_dies(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 2>{"kind", "joint"});
  return {read_node(value.at("joint"), robot, false)};
}

MainControllerSilentFault read_main_controller_silent(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 2>{"kind", "duration_s"});
  const auto duration = value.find("duration_s");
  return {duration ? duration->number(kEventDuration) : 0.0};
}

MessageControllerSilentFault read_message_controller_silent(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 3>{"kind", "duration_s", "restarts"});
  const auto duration = value.find("duration_s");
  const auto restarts = value.find("restarts");
  if (restarts) {
    require_true(*restarts);
  }
  const MessageControllerSilentFault fault{duration ? duration->number(kEventDuration) : 0.0,
                                           restarts.has_value()};
  if (fault.restarts && fault.duration_s == 0.0) {
    restarts->refuse("a message controller that is silent for ever does not start again",
                     "Give duration_s: how long it is away.");
  }
  return fault;
}

template <auto read>
Action read_one(const YamlValue& value, const urdf::RobotModel& robot) {
  if constexpr (std::is_invocable_v<decltype(read), const YamlValue&, const urdf::RobotModel&>) {
    return read(value, robot);
  } else {
    return read(value);
  }
}

struct FaultKey {
  std::string_view kind;
  Action (*read)(const YamlValue&, const urdf::RobotModel&);
};
constexpr std::array kFaults{
    FaultKey{"main_controller_silent", &read_one<&read_main_controller_silent>},
    FaultKey{"message_controller_silent", &read_one<&read_message_controller_silent>},
    FaultKey{"batch_fails", &read_one<&read_batch_fault>},
    FaultKey{"lose_frames", &read_one<&read_lose_frames>},
    FaultKey{"misses_frames", &read_one<&read_misses_frames>},
    FaultKey{"disturb_bus", &read_one<&read_disturbance>},
    FaultKey{"jam", &read_one<&read_jam>},
    FaultKey{"babbles", &read_one<&read_babble>},
    FaultKey{"foreign_frame", &read_one<&read_foreign_frame>},
    FaultKey{"bus_off", &read_one<&read_bus_off>},
    FaultKey{"joint_restarts", &read_one<&read_joint_restarts>},
    FaultKey{"joint_dies", &read_one<&read_joint_dies>},
    FaultKey{"supply_sags", &read_one<&read_supply_sags>},
    FaultKey{"plugin_fails", &read_one<&read_plugin_fault>},
    FaultKey{"sensor_fails", &read_one<&read_sensor_fault>},
    FaultKey{"camera_fails", &read_one<&read_camera_fault>}};

}  // namespace

Action read_fault(const YamlValue& value, const urdf::RobotModel& robot) {
  const YamlValue kind = value.at("kind");
  const auto* const found = std::ranges::find(kFaults, kind.text(), &FaultKey::kind);
  if (found == kFaults.end()) {
    std::vector<std::string> known;
    for (const FaultKey& fault : kFaults) known.emplace_back(fault.kind);
    kind.refuse(
        fmt::format("must be {} or {}", fmt::join(known.begin(), known.end() - 1, ", "), known.back()),
        input::suggest(kind.text(), known));
  }
  return found->read(value, robot);
}

}  // namespace gaitway::simulator
