// Angles strictly read: what isn't understood is refused with file, line, field, value and rule.
#include "gaitway/trajectory/posture_angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::trajectory {
namespace {

using facts::kRadPerDegree;
constexpr input::Range kPostureAngle{-180.0, 180.0, "deg"};

}  // namespace

PostureReader::PostureReader(const urdf::RobotModel& robot) : robot_(robot), home_(robot) {}

std::vector<JointAngle> PostureReader::read(const input::YamlValue& map) {
  std::vector<JointAngle> angles;
  if (const auto joints = map.find("joints")) {
    for (const auto& [name, angle] : joints->entries()) {
      const int joint = joint_named(angle, name);
      add(angle, joint, angle.number(kPostureAngle) * kRadPerDegree, angles);
    }
  }
  if (const auto both = map.find("symmetric")) {
    for (const auto& [name, angle] : both->entries()) add_both_sides(angle, name, angles);
  }
  return angles;
}

std::vector<JointAngle> PostureReader::mirrored(const std::vector<JointAngle>& angles) {
  std::vector<JointAngle> image;
  for (const JointAngle& angle : angles) {
    const std::optional<int> other = body().mirrored(angle.joint);
    const auto mirror =
        other ? urdf::mirror_angle(robot_, home_, angle.joint, *other) : std::optional<urdf::MirroredAngle>{};
    if (!mirror) {
      throw std::invalid_argument(fmt::format("the robot '{}' has no joint that is the mirror image of '{}'",
                                              robot_.name,
                                              robot_.joints[static_cast<std::size_t>(angle.joint)].name));
    }
    image.push_back({*other, mirror->of(angle.angle_rad)});
  }
  return image;
}

int PostureReader::joint_named(const input::YamlValue& value, const std::string& name) const {
  std::vector<std::string> known;
  std::ranges::transform(robot_.joints, std::back_inserter(known),
                         [](const urdf::Joint& joint) { return joint.name; });
  const auto found = std::ranges::find(known, name);
  if (found == known.end()) {
    value.refuse(fmt::format("the robot '{}' has no joint '{}'", robot_.name, name),
                 input::suggest(name, known));
  }
  return static_cast<int>(found - known.begin());
}

void PostureReader::add(const input::YamlValue& value, int joint, double angle_rad,
                        std::vector<JointAngle>& angles) const {
  const urdf::Joint& limits = robot_.joints[static_cast<std::size_t>(joint)];
  if (angle_rad < limits.lower_rad || angle_rad > limits.upper_rad) {
    value.refuse(fmt::format("{} turns from {:.1f} to {:.1f} deg", limits.name,
                             limits.lower_rad / kRadPerDegree, limits.upper_rad / kRadPerDegree),
                 "Choose an angle between these.");
  }
  if (std::ranges::any_of(angles, [&](const JointAngle& a) { return a.joint == joint; })) {
    value.refuse(fmt::format("{} has an angle in this posture already", limits.name), "Give it once.");
  }
  angles.push_back({joint, angle_rad});
}

void PostureReader::add_both_sides(const input::YamlValue& value, const std::string& name,
                                   std::vector<JointAngle>& angles) {
  const std::string full = "left_" + name;
  const bool short_name =
      std::ranges::any_of(robot_.joints, [&full](const urdf::Joint& joint) { return joint.name == full; });
  const JointAngle left{joint_named(value, short_name ? full : name),
                        value.number(kPostureAngle) * kRadPerDegree};
  const std::string& joint = robot_.joints[static_cast<std::size_t>(left.joint)].name;
  const urdf::BodyPart part = body().role(left.joint).part;
  if (part != urdf::BodyPart::left_leg && part != urdf::BodyPart::left_arm) {
    value.refuse(fmt::format("{} is of no left limb", joint),
                 "Name the left joint, or give it under joints.");
  }
  const std::optional<int> right = body().mirrored(left.joint);
  const auto mirror =
      right ? urdf::mirror_angle(robot_, home_, left.joint, *right) : std::optional<urdf::MirroredAngle>{};
  if (!mirror) {
    value.refuse(right ? fmt::format("{} and {} are no mirror images of each other", joint,
                                     robot_.joints[static_cast<std::size_t>(*right)].name)
                       : fmt::format("no joint of the right side does what {} does", joint),
                 "Name both sides under joints.");
  }
  add(value, left.joint, left.angle_rad, angles);
  add(value, *right, mirror->of(left.angle_rad), angles);
}

const urdf::BodyJoints& PostureReader::body() {
  if (!body_) body_.emplace(robot_, home_);
  return *body_;
}

}  // namespace gaitway::trajectory
