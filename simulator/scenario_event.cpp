// Reads what happens in a scenario strictly: what isn't understood is refused with file, line, field, value
// and rule.
#include "gaitway/simulator/scenario_event.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "scenario_reading.hpp"

namespace gaitway::simulator {
namespace {

using input::YamlValue;
using msgcontroller::kLargestTurnRate_rad_per_s;
using msgcontroller::kLargestWalkSpeed_m_per_s;

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
    push.duration_s = duration->number(kEventDuration);
  }
  return push;
}

ManualJointEvent read_joint_move(const YamlValue& value, const urdf::RobotModel& robot) {
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

// As logs have it, which play again to the bit, or in degrees: `pitch_rad` or `pitch_deg`. 0: it is not
// there.
double read_angle(const YamlValue& map, const std::string& name, double most_rad, double most_deg) {
  const auto exact = map.find(name + "_rad");
  const auto degrees = map.find(name + "_deg");
  if (exact && degrees) exact->refuse("is there beside " + name + "_deg", "Leave one of them out");
  if (exact) return exact->number({-most_rad, most_rad, "rad"});
  return degrees ? degrees->number({-most_deg, most_deg, "degrees"}) * facts::kRadPerDegree : 0.0;
}

double read_yaw(const YamlValue& value) {
  return read_angle(value, "yaw", 100.0, 360.0);
}

WalkToEvent read_walk_to(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 4>{"x_m", "y_m", "yaw_deg", "yaw_rad"});
  constexpr double kFarthest_m = 1000.0;
  const input::Range place{-kFarthest_m, kFarthest_m, "m"};
  if (!value.find("yaw_deg") && !value.find("yaw_rad")) static_cast<void>(value.at("yaw_deg"));
  return {std::array{value.at("x_m").number(place), value.at("y_m").number(place), read_yaw(value)}};
}

Eigen::Vector3d read_place(const YamlValue& value) {
  return three(value, {-world::kFarthest_m, world::kFarthest_m, "m"});
}

HeadEvent read_head(const YamlValue& value) {
  using Mode = HeadEvent::Mode;
  constexpr std::array<std::string_view, 10> kKeys{"look",      "yaw_deg",        "yaw_rad",    "pitch_deg",
                                                   "pitch_rad", "extent_deg",     "extent_rad", "period_s",
                                                   "point_m",   "speed_rad_per_s"};
  constexpr std::array<std::pair<std::string_view, Mode>, 5> kModes{{{"ahead", Mode::ahead},
                                                                     {"direction", Mode::direction},
                                                                     {"point", Mode::point},
                                                                     {"scan", Mode::scan},
                                                                     {"hold", Mode::hold}}};
  constexpr double kMost_rad = 3.0, kMost_deg = 170.0, kLongest_s = 600.0, kFastest_rad_per_s = 100.0;
  value.require_map(kKeys);
  HeadEvent head;
  const YamlValue look = value.at("look");
  const auto found =
      std::ranges::find_if(kModes, [&](const auto& entry) { return entry.first == look.text(); });
  if (found == kModes.end()) {
    look.refuse("must be ahead, direction, point, scan or hold", "Choose one of them");
  }
  head.mode = found->second;
  head.direction_rad = {read_angle(value, "yaw", kMost_rad, kMost_deg),
                        read_angle(value, "pitch", kMost_rad, kMost_deg)};
  head.extent_rad = read_angle(value, "extent", kMost_rad, kMost_deg);
  if (head.extent_rad < 0.0 || (head.mode == Mode::scan && head.extent_rad == 0.0)) {
    value.refuse("a scan goes to both sides by extent_deg, above 0", "Give one, e.g. extent_deg: 60");
  }
  if (const auto period = value.find("period_s")) head.period_s = period->number({0.0, kLongest_s, "s"});
  if (head.mode == Mode::point) head.point_m = read_place(value.at("point_m"));
  if (const auto speed = value.find("speed_rad_per_s")) {
    head.speed_rad_per_s = speed->number({0.0, kFastest_rad_per_s, "rad/s"});
  }
  return head;
}

CommandEvent read_command(const YamlValue& value) {
  const auto found =
      std::ranges::find_if(kCommandVerbs, [&](const auto& entry) { return entry.first == value.text(); });
  if (found == kCommandVerbs.end()) {
    value.refuse("must be take, let_go or is_lost", "let_go: the behaviour may command again");
  }
  return {found->second};
}

std::string read_solid_name(const YamlValue& value) {
  constexpr std::size_t kMostBytes = 47;
  const std::string name = value.text();
  const bool printable = std::ranges::all_of(name, [](char c) { return c >= ' ' && c < '\x7f'; });
  if (name.empty() || name.size() > kMostBytes || !printable) {
    value.refuse(fmt::format("a name has 1 to {} printable characters", kMostBytes), "Choose another one");
  }
  return name;
}

SpawnEvent read_spawn(const YamlValue& value) {
  using Shape = world::Solid::Shape;
  constexpr std::array<std::pair<std::string_view, Shape>, 3> kShapes{
      {{"box", Shape::box}, {"cylinder", Shape::cylinder}, {"sphere", Shape::sphere}}};
  value.require_map(std::array<std::string_view, 8>{"name", "shape", "size_m", "position_m", "yaw_deg",
                                                    "yaw_rad", "mass_kg", "colour"});
  SpawnEvent spawn;
  spawn.name = read_solid_name(value.at("name"));
  const YamlValue shape = value.at("shape");
  const auto found =
      std::ranges::find_if(kShapes, [&](const auto& entry) { return entry.first == shape.text(); });
  if (found == kShapes.end()) shape.refuse("must be box, cylinder or sphere", "Choose one of them");
  spawn.shape = found->second;
  const YamlValue size = value.at("size_m");
  spawn.size_m = three(size, {0.01, 5.0, "m"});
  const bool round = spawn.size_m.x() == spawn.size_m.y();
  if ((spawn.shape != Shape::box && !round) ||
      (spawn.shape == Shape::sphere && spawn.size_m.x() != spawn.size_m.z())) {
    size.refuse("a cylinder is as wide in x as in y, a sphere in z, too", "Give its diameter for each");
  }
  spawn.position_m = read_place(value.at("position_m"));
  spawn.yaw_rad = read_yaw(value);
  if (const auto mass = value.find("mass_kg")) spawn.mass_kg = mass->number({0.001, 1000.0, "kg"});
  if (const auto colour = value.find("colour")) spawn.colour = colour->numbers<3>({0.0, 1.0, ""});
  return spawn;
}

MoveEvent read_move(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 4>{"name", "position_m", "yaw_deg", "yaw_rad"});
  return {read_solid_name(value.at("name")), read_place(value.at("position_m")), read_yaw(value)};
}

RemoveEvent read_remove(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 1>{"name"});
  return {read_solid_name(value.at("name"))};
}

EmergencyStopEvent read_emergency_stop(const YamlValue& value) {
  const std::string mode = value.text();
  if (mode != "hold" && mode != "soft") {
    value.refuse("must be hold or soft", "hold: the joints keep their places; soft: they let go.");
  }
  return {mode == "soft"};
}

// Of an event that has nothing more to say.
template <class Event>
Action read_true(const YamlValue& value, const urdf::RobotModel&) {
  require_true(value);
  return Event{};
}
Action read_stand(const YamlValue& value, const urdf::RobotModel&) {
  require_true(value);
  return WalkEvent{.walk = false};
}
template <auto read>
Action read_plain(const YamlValue& value, const urdf::RobotModel&) {
  return read(value);
}
template <auto read>
Action read_of_robot(const YamlValue& value, const urdf::RobotModel& robot) {
  return read(value, robot);
}

struct ActionKey {
  std::string_view key;
  Action (*read)(const YamlValue& value, const urdf::RobotModel& robot);
};
constexpr std::array kActions{ActionKey{"walk", &read_plain<&read_walk>},
                              ActionKey{"stand", &read_stand},
                              ActionKey{"walk_to", &read_plain<&read_walk_to>},
                              ActionKey{"leave_way", &read_true<WalkToEvent>},
                              ActionKey{"motion", &read_plain<&read_motion_name>},
                              ActionKey{"leave_motion", &read_true<MotionEvent>},
                              ActionKey{"head", &read_plain<&read_head>},
                              ActionKey{"command", &read_plain<&read_command>},
                              ActionKey{"stop", &read_true<StopEvent>},
                              ActionKey{"emergency_stop", &read_plain<&read_emergency_stop>},
                              ActionKey{"release", &read_true<ReleaseEvent>},
                              ActionKey{"move_joint", &read_of_robot<&read_joint_move>},
                              ActionKey{"push", &read_of_robot<&read_push>},
                              ActionKey{"fault", &read_of_robot<&read_fault>},
                              ActionKey{"spawn", &read_plain<&read_spawn>},
                              ActionKey{"move", &read_plain<&read_move>},
                              ActionKey{"remove", &read_plain<&read_remove>}};

[[noreturn]] void refuse_number_of_actions(const YamlValue& value) {
  std::string all;
  for (const ActionKey& known : kActions) all += fmt::format("{}{}", all.empty() ? "" : ", ", known.key);
  value.refuse("an event has at_s and exactly one of " + all, "Write one event for each action.");
}

Action read_action(const YamlValue& value, const urdf::RobotModel& robot) {
  std::optional<Action> action;
  for (const ActionKey& known : kActions) {
    const auto found = value.find(known.key);
    if (!found) continue;
    if (action) refuse_number_of_actions(value);
    action = known.read(*found, robot);
  }
  if (!action) refuse_number_of_actions(value);
  return *action;
}

}  // namespace

std::string counterpart_of(std::string_view sensor) {
  for (const auto& [side, other] : {std::pair{"left_", "right_"}, std::pair{"right_", "left_"}}) {
    if (sensor.starts_with(side)) {
      return other + std::string(sensor.substr(std::string_view(side).size()));
    }
  }
  return {};
}

ScenarioEvent read_event(const YamlValue& value, const urdf::RobotModel& robot) {
  std::vector<std::string_view> keys{"at_s", "asked"};
  std::ranges::transform(kActions, std::back_inserter(keys), &ActionKey::key);
  value.require_map(keys);
  ScenarioEvent event{.at_s = value.at("at_s").number({0.0, kLongestRun_s, "s"}),
                      .action = read_action(value, robot)};
  if (const auto asked = value.find("asked")) {
    require_true(*asked);
    event.asked = true;
  }
  return event;
}

ScenarioEvent parse_action(const std::string& text, const std::filesystem::path& source,
                           const urdf::RobotModel& robot) {
  std::vector<std::string_view> keys;
  std::ranges::transform(kActions, std::back_inserter(keys), &ActionKey::key);
  const YamlValue value = YamlValue::parse(text, source);
  value.require_map(keys);
  return {.at_s = 0.0, .action = read_action(value, robot)};
}

}  // namespace gaitway::simulator
