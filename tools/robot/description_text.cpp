// A robot's description for people, and for programs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "gaitway/facts/facts.hpp"
#include "tools/robot/robot_description.hpp"

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

// The numbers of the gait that people ask for first; of the others those that are not the scaled default.
constexpr std::array<std::string_view, 7> kMainNumbers{
    "step_time",        "lift",         "hip_height",      "fast_hip_height",
    "max_step_forward", "foot_spacing", "max_foot_spacing"};

struct GaitLine {
  std::string parameter, unit, reason;
  double scaled = 0.0, chosen = 0.0;
};

std::vector<GaitLine> gait_lines(const RobotDescription& description) {
  trajectory::GaitParameters parameters = description.gait.parameters;
  std::vector<GaitLine> lines;
  for (const NumberParameter& number : parameters.numbers()) {
    const trajectory::GaitChoice* const choice = description.gait.choice(number.name);
    if (choice == nullptr && std::ranges::find(kMainNumbers, number.name) == kMainNumbers.end()) continue;
    GaitLine line{number.name, number.unit, "", number.value, number.value};
    if (choice != nullptr) {
      line.scaled = choice->scaled;
      line.reason = fmt::format("{}", fmt::join(choice->reasons, "; "));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string unit_text(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

double weight_N(const urdf::RobotModel& robot) {
  return robot.total_mass_kg() * facts::kGravity_m_per_s2;
}

std::string body_text(const urdf::RobotModel& robot) {
  const urdf::Foot& foot = robot.feet[0];
  std::string text = fmt::format(
      "{}: {:.4g} kg, hips {:.4g} m above the ground, {} joints\n"
      "units of its body: h = {:.4g} m, T = {:.4g} s, W = {:.4g} N\n"
      "soles: {:.4g} m x {:.4g} m\n\n"
      "{:<24}{:>5}{:>18}{:>10}{:>10}\n",
      robot.name, robot.total_mass_kg(), robot.hip_height_m, robot.joints.size(), robot.hip_height_m,
      std::sqrt(robot.hip_height_m / facts::kGravity_m_per_s2), weight_N(robot), foot.size_m.x(),
      foot.size_m.y(), "joint", "node", "from..to rad", "rad/s", "N*m");
  for (const urdf::Joint& joint : robot.joints) {
    fmt::format_to(std::back_inserter(text), "{:<24}{:>5}{:>18}{:>10.3g}{:>10.3g}\n", joint.name, joint.node,
                   fmt::format("{:.2f}..{:.2f}", joint.lower_rad, joint.upper_rad),
                   joint.velocity_limit_rad_per_s, joint.motor.torque_limit_Nm);
  }
  return text;
}

}  // namespace

std::string description_text(const RobotDescription& description) {
  const urdf::RobotModel& robot = description.robot;
  std::string text = body_text(robot);
  const auto add = std::back_inserter(text);
  fmt::format_to(add, "\n{:<24}{:>10}{:>10} {:<6}{}\n", "gait", "scaled", "chosen", "", "why");
  for (const GaitLine& line : gait_lines(description)) {
    const std::string why =
        line.reason.empty() ? "" : fmt::format("{:<6}{}", unit_text(line.unit), line.reason);
    fmt::format_to(add, "{:<24}{:>10.4g}{:>10.4g} {}\n", line.parameter, line.scaled, line.chosen,
                   why.empty() ? unit_text(line.unit) : why);
  }
  fmt::format_to(add, "\n{:<24}{:>10}{:>10}{:>10}\n", "torque [N*m]", "standing", "walking", "motor");
  for (const trajectory::JointTorque& torque : description.torques) {
    fmt::format_to(add, "{:<24}{:>10.3g}{:>10.3g}{:>10.3g}{}\n",
                   robot.joints[static_cast<std::size_t>(torque.index)].name, torque.holds_Nm,
                   torque.needs_Nm(), torque.limit_Nm,
                   !torque.holds()   ? "  too weak to stand on one leg"
                   : !torque.walks() ? "  too weak to walk"
                                     : "");
  }
  if (!description.speeds.empty())
    fmt::format_to(add, "\n{:<12}{:>10}        what limits it\n", "speed", "at most");
  for (const SpeedLimit& speed : description.speeds) {
    fmt::format_to(add, "{:<12}{:>10.3g} {:<6} {}\n", speed.direction, speed.most, speed.unit, speed.cause);
  }
  fmt::format_to(add, "\nbus: profile {}, {}\n", description.bus_profile,
                 description.bus_complaint.empty() ? "proven: every message keeps its deadline"
                                                   : description.bus_complaint);
  for (const std::string* complaint : {&description.gait_complaint, &description.torque_complaint}) {
    if (!complaint->empty()) fmt::format_to(add, "cannot walk: {}\n", *complaint);
  }
  return text;
}

std::string description_json(const RobotDescription& description) {
  const urdf::RobotModel& robot = description.robot;
  Json joints = Json::array(), gait = Json::array(), torques = Json::array(), speeds = Json::array();
  for (const urdf::Joint& joint : robot.joints) {
    joints.push_back({{"name", joint.name},
                      {"node", joint.node},
                      {"lower_rad", joint.lower_rad},
                      {"upper_rad", joint.upper_rad},
                      {"velocity_limit_rad_per_s", joint.velocity_limit_rad_per_s},
                      {"torque_limit_Nm", joint.motor.torque_limit_Nm}});
  }
  for (const GaitLine& line : gait_lines(description)) {
    gait.push_back({{"parameter", line.parameter},
                    {"unit", line.unit},
                    {"scaled", line.scaled},
                    {"chosen", line.chosen},
                    {"reason", line.reason}});
  }
  for (const trajectory::JointTorque& torque : description.torques) {
    torques.push_back({{"joint", robot.joints[static_cast<std::size_t>(torque.index)].name},
                       {"holds_Nm", torque.holds_Nm},
                       {"needs_Nm", torque.needs_Nm()},
                       {"has_Nm", torque.limit_Nm}});
  }
  for (const SpeedLimit& speed : description.speeds) {
    speeds.push_back(
        {{"direction", speed.direction}, {"most", speed.most}, {"unit", speed.unit}, {"cause", speed.cause}});
  }
  const urdf::Foot& foot = robot.feet[0];
  return Json{{"name", robot.name},
              {"mass_kg", robot.total_mass_kg()},
              {"hip_height_m", robot.hip_height_m},
              {"sole_m", {foot.size_m.x(), foot.size_m.y()}},
              {"joints", joints},
              {"gait", gait},
              {"torques", torques},
              {"speeds", speeds},
              {"bus",
               {{"profile", description.bus_profile},
                {"proven", description.bus_complaint.empty()},
                {"complaint", description.bus_complaint}}},
              {"gait_complaint", description.gait_complaint},
              {"torque_complaint", description.torque_complaint}}
      .dump(2);
}

}  // namespace gaitway::tools
