// Reads scenarios strictly: what isn't understood is refused with file, line, field, value and rule.
#include "gaitway/simulator/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/peoples_requests.hpp"

namespace gaitway::simulator {
namespace {

using input::YamlValue;
using msgcontroller::kLargestTurnRate_rad_per_s;
using msgcontroller::kLargestWalkSpeed_m_per_s;

constexpr double kLongestRun_s = 86400.0;
constexpr input::Range kDuration{0.001, kLongestRun_s, "s"};

Eigen::Vector3d three(const YamlValue& value, const input::Range& range) {
  const std::array<double, 3> numbers = value.numbers<3>(range);
  return {numbers[0], numbers[1], numbers[2]};
}

WalkEvent read_walk(const YamlValue& value) {
  const Eigen::Vector3d command =
      three(value, {-kLargestTurnRate_rad_per_s, kLargestTurnRate_rad_per_s, "m/s, m/s, rad/s"});
  if (command.head<2>().norm() > kLargestWalkSpeed_m_per_s) {
    value.refuse(fmt::format("at most {} m/s may be commanded", kLargestWalkSpeed_m_per_s),
                 "Choose a lower speed.");
  }
  return {.velocity_m_per_s = command.head<2>(), .turn_rate_rad_per_s = command.z()};
}

// One of the robot's names.
std::string read_name(const YamlValue& value, const urdf::RobotModel& robot, const char* what,
                      const std::vector<std::string>& known) {
  const std::string name = value.text();
  if (std::ranges::find(known, name) == known.end()) {
    value.refuse(fmt::format("the robot '{}' has no such {}", robot.name, what), input::suggest(name, known));
  }
  return name;
}

std::string read_body(const YamlValue& value, const urdf::RobotModel& robot) {
  std::vector<std::string> known;
  std::ranges::transform(robot.links, std::back_inserter(known),
                         [](const urdf::Link& link) { return link.name; });
  return read_name(value, robot, "link", known);
}

PushEvent read_push(const YamlValue& value, const urdf::RobotModel& robot) {
  constexpr std::array<std::string_view, 4> kKeys{"body", "direction", "impulse_Ns", "duration_s"};
  value.require_map(kKeys);
  PushEvent push;
  const auto body = value.find("body");
  push.body = body ? read_body(*body, robot) : robot.links[static_cast<std::size_t>(robot.imu.link)].name;
  push.direction = three(value.at("direction"), {-1e6, 1e6, ""});
  if (push.direction.norm() < 1e-9) {
    value.at("direction")
        .refuse("must not be zero", "Give the direction in the world frame, e.g. [0, 1, 0].");
  }
  push.impulse_Ns = value.at("impulse_Ns").number({0.0, kLargestImpulse_Ns, "N*s"});
  if (const auto duration = value.find("duration_s")) {
    push.duration_s = duration->number(kDuration);
  }
  return push;
}

PluginFault read_plugin_fault(const YamlValue& value) {
  using Kind = core::PluginFaultKind;
  constexpr std::array<std::pair<std::string_view, Kind>, 4> kHow{{{"throws", Kind::throws},
                                                                   {"not_a_number", Kind::not_a_number},
                                                                   {"jumps", Kind::jumps},
                                                                   {"overruns", Kind::overruns}}};
  constexpr std::array<std::string_view, 5> kKeys{"kind", "plugin", "how", "duration_s", "cost_s"};
  value.require_map(kKeys);
  PluginFault fault;
  fault.plugin = value.at("plugin").text();
  const YamlValue how = value.at("how");
  const auto found = std::ranges::find_if(kHow, [&](const auto& entry) { return entry.first == how.text(); });
  if (found == kHow.end()) {
    how.refuse("must be throws, not_a_number, jumps or overruns", "Choose one of them.");
  }
  fault.how = found->second;
  if (const auto duration = value.find("duration_s")) {
    fault.duration_s = duration->number(kDuration);
  }
  if (const auto cost = value.find("cost_s")) {
    if (fault.how != Kind::overruns) {
      cost->refuse("belongs to a step that overruns", "Leave it out");
    }
    fault.cost_s = cost->number({1e-6, 10.0, "s"});
  }
  return fault;
}

void require_true(const YamlValue& value) {
  if (value.text() != "true") {
    value.refuse("must be true", "Leave the event out if it shall not happen");
  }
}

DisturbBusFault read_disturbance(const YamlValue& value) {
  constexpr std::array<std::string_view, 5> kKeys{"kind", "corruption", "omission", "duplicate",
                                                  "duration_s"};
  value.require_map(kKeys);
  DisturbBusFault fault{.duration_s = value.at("duration_s").number(kDuration)};
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

std::string read_node(const YamlValue& value, const urdf::RobotModel& robot, bool or_message_controller) {
  std::vector<std::string> known;
  std::ranges::transform(robot.joints, std::back_inserter(known),
                         [](const urdf::Joint& joint) { return joint.name; });
  if (or_message_controller) {
    known.emplace_back("message_controller");
  }
  return read_name(value, robot, "node", known);
}

ForeignFrameFault read_foreign_frame(const YamlValue& value) {
  constexpr std::array<std::string_view, 5> kKeys{"kind", "id", "data", "extended", "remote"};
  value.require_map(kKeys);
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
  return {frame};
}

decltype(ScenarioEvent::action) read_fault(const YamlValue& value, const urdf::RobotModel& robot) {
  constexpr std::array<std::string_view, 3> kKeys{"kind", "duration_s", "probability"};
  const std::string kind = value.at("kind").text();
  if (kind == "plugin_fails") {
    return read_plugin_fault(value);
  }
  if (kind == "disturb_bus") {
    return read_disturbance(value);
  }
  if (kind == "jam") {
    return read_jam(value);
  }
  if (kind == "bus_off") {
    value.require_map(std::array<std::string_view, 2>{"kind", "node"});
    return BusOffFault{read_node(value.at("node"), robot, true)};
  }
  if (kind == "joint_restarts") {
    value.require_map(std::array<std::string_view, 3>{"kind", "joint", "duration_s"});
    return JointRestartsFault{read_node(value.at("joint"), robot, false),
                              value.at("duration_s").number({0.001, 60.0, "s"})};
  }
  if (kind == "foreign_frame") {
    return read_foreign_frame(value);
  }
  value.require_map(kKeys);
  const auto duration = value.find("duration_s");
  if (kind == "main_controller_silent") {
    if (const auto probability = value.find("probability")) {
      probability->refuse("does not belong to main_controller_silent", "Leave it out");
    }
    return MainControllerSilentFault{duration ? duration->number(kDuration) : 0.0};
  }
  if (kind == "lose_frames") {
    return LoseFramesFault{value.at("probability").number({0.0, 1.0, ""}),
                           value.at("duration_s").number(kDuration)};
  }
  value.at("kind").refuse(
      "must be main_controller_silent, lose_frames, disturb_bus, jam, bus_off, joint_restarts, foreign_frame "
      "or plugin_fails",
      "Choose one of them.");
}

ManualJointEvent read_move(const YamlValue& value, const urdf::RobotModel& robot) {
  value.require_map(std::array<std::string_view, 3>{"joint", "position_rad", "duration_slots"});
  constexpr int kLongest_slots = 255;
  return {robot.joint_index(read_node(value.at("joint"), robot, false)),
          value.at("position_rad").number({-7.0, 7.0, "rad"}),
          value.at("duration_slots").integer(1, kLongest_slots)};
}

// Which motions there are, the trajectory plug-in knows, and refuses the others.
MotionEvent read_motion_name(const YamlValue& value) {
  constexpr std::size_t kMostBytes = sizeof(MotionRequest::name) - 1;
  const std::string name = value.text();
  if (name.empty() || name.size() > kMostBytes) {
    value.refuse(fmt::format("the name of a motion has 1 to {} bytes", kMostBytes),
                 "`gaitway motion list` lists them.");
  }
  return {name};
}

WalkToEvent read_walk_to(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 4>{"x_m", "y_m", "yaw_deg", "yaw_rad"});
  constexpr double kFarthest_m = 1000.0;
  const input::Range place{-kFarthest_m, kFarthest_m, "m"};
  const auto exact = value.find("yaw_rad");  // as logs have it, which play again to the bit
  if (exact && value.find("yaw_deg")) exact->refuse("is there beside yaw_deg", "Leave one of them out");
  constexpr double kMostTurn_rad = 100.0;
  const double yaw_rad = exact
                             ? exact->number({-kMostTurn_rad, kMostTurn_rad, "rad"})
                             : value.at("yaw_deg").number({-360.0, 360.0, "degrees"}) * facts::kRadPerDegree;
  return {std::array{value.at("x_m").number(place), value.at("y_m").number(place), yaw_rad}};
}

ScenarioEvent read_event(const YamlValue& value, const urdf::RobotModel& robot) {
  constexpr std::array<std::string_view, 14> kKeys{
      "at_s",         "asked", "walk",           "stand",   "walk_to",    "leave_way", "motion",
      "leave_motion", "stop",  "emergency_stop", "release", "move_joint", "push",      "fault"};
  value.require_map(kKeys);
  ScenarioEvent event{.at_s = value.at("at_s").number({0.0, kLongestRun_s, "s"}), .action = StopEvent{}};
  if (const auto asked = value.find("asked")) {
    require_true(*asked);
    event.asked = true;
  }
  int actions = 0;
  for (const std::string_view key : kKeys) {
    const auto action = value.find(key);
    if (!action || key == "at_s" || key == "asked") {
      continue;
    }
    ++actions;
    if (key == "walk") {
      event.action = read_walk(*action);
    } else if (key == "stand") {
      require_true(*action);
      event.action = WalkEvent{.walk = false};
    } else if (key == "walk_to") {
      event.action = read_walk_to(*action);
    } else if (key == "leave_way") {
      require_true(*action);
      event.action = WalkToEvent{};
    } else if (key == "motion") {
      event.action = read_motion_name(*action);
    } else if (key == "leave_motion") {
      require_true(*action);
      event.action = MotionEvent{};
    } else if (key == "stop") {
      require_true(*action);
    } else if (key == "release") {
      require_true(*action);
      event.action = ReleaseEvent{};
    } else if (key == "move_joint") {
      event.action = read_move(*action, robot);
    } else if (key == "push") {
      event.action = read_push(*action, robot);
    } else if (key == "fault") {
      event.action = read_fault(*action, robot);
    } else if (key == "emergency_stop") {
      const std::string mode = action->text();
      if (mode != "hold" && mode != "soft") {
        action->refuse("must be hold or soft", "hold: the joints keep their places; soft: they let go.");
      }
      event.action = EmergencyStopEvent{mode == "soft"};
    }
  }
  if (actions != 1) {
    value.refuse(
        "an event has at_s and exactly one of walk, stand, walk_to, leave_way, motion, leave_motion, stop, "
        "emergency_stop, "
        "release, move_joint, push, "
        "fault",
        "Write one event for each action.");
  }
  return event;
}

std::optional<world::WorldChoice> read_world_choice(const YamlValue& root) {
  const auto seed = root.find("world_seed");
  const auto world = root.find("world");
  if (!world) {
    if (seed) seed->refuse("needs a world", "Add 'world: NAME', or leave it out");
    return std::nullopt;
  }
  world::WorldChoice choice{
      .name = world->text(), .random_seed = {}, .written_in = world->file(), .line = world->line()};
  if (choice.name.empty()) world->refuse("must be a file, or the name of a shipped world", "Name one");
  if (seed) {
    choice.random_seed = static_cast<std::uint64_t>(seed->integer(0, std::numeric_limits<int>::max()));
  }
  return choice;
}

}  // namespace

Scenario load_scenario(const std::filesystem::path& file, const urdf::RobotModel& robot) {
  constexpr std::array<std::string_view, 5> kKeys{"seconds", "world", "world_seed", "conditions", "events"};
  const YamlValue root = YamlValue::read(file);
  root.require_map(kKeys);
  Scenario scenario;
  scenario.seconds = root.at("seconds").number({0.001, kLongestRun_s, "s"});
  if (const auto conditions = root.find("conditions")) scenario.conditions = read_conditions(*conditions);
  scenario.world = read_world_choice(root);
  if (const auto events = root.find("events")) {
    for (const YamlValue& event : events->items()) {
      scenario.events.push_back(read_event(event, robot));
      if (scenario.events.back().at_s >= scenario.seconds) {
        event.at("at_s").refuse(
            fmt::format("must be before the end of the run at {:g} s, or it never happens", scenario.seconds),
            "Give a longer 'seconds', or remove the event");
      }
    }
  }
  std::ranges::stable_sort(scenario.events, {}, &ScenarioEvent::at_s);
  return scenario;
}

Scenario walk_scenario(double forward_m_per_s, double left_m_per_s, double turn_rate_rad_per_s,
                       double seconds) {
  constexpr double kStanding_s = 1.0;
  const Eigen::Vector2d velocity(forward_m_per_s, left_m_per_s);
  if (!(velocity.norm() <= kLargestWalkSpeed_m_per_s &&
        std::abs(turn_rate_rad_per_s) <= kLargestTurnRate_rad_per_s)) {
    throw urdf::RobotError(
        fmt::format("walk command {}, {} m/s and {} rad/s: at most {} m/s and {} rad/s may be commanded. "
                    "Choose a lower speed.",
                    forward_m_per_s, left_m_per_s, turn_rate_rad_per_s, kLargestWalkSpeed_m_per_s,
                    kLargestTurnRate_rad_per_s));
  }
  Scenario scenario{.seconds = seconds, .conditions = {}, .world = {}, .events = {}};
  scenario.events.push_back(
      {.at_s = kStanding_s,
       .action = WalkEvent{.velocity_m_per_s = velocity, .turn_rate_rad_per_s = turn_rate_rad_per_s}});
  return scenario;
}

}  // namespace gaitway::simulator
