// Reads postures strictly, or finds for a body's joints what they do in one.
#include "gaitway/trajectory/fall_posture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/trajectory/posture_angles.hpp"
#include "gaitway/urdf/body_joints.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kStays = std::numeric_limits<double>::quiet_NaN();
constexpr double kFromStop_rad = 0.01;
// Angles of limbs (urdf::BodyJoints) on the side that it falls to, ahead and back on both, and on the other
// one, as the left side counts them; in the middle as in a fall to the left. What a search found for
// humanoid22 (docs/gait.md), to 5 deg.
struct LimbAngle {
  urdf::JointPlace place;
  urdf::Turn turn;
  double near_deg, far_deg;
};
using Place = urdf::JointPlace;
using urdf::Turn;

constexpr std::array kAhead{
    LimbAngle{Place::hip, Turn::pitch, -20, -20},   LimbAngle{Place::hip, Turn::roll, 0, 0},
    LimbAngle{Place::knee, Turn::pitch, 60, 60},    LimbAngle{Place::ankle, Turn::pitch, -20, -20},
    LimbAngle{Place::waist, Turn::pitch, 0, 0},     LimbAngle{Place::shoulder, Turn::pitch, -90, -90},
    LimbAngle{Place::shoulder, Turn::roll, 55, 55}, LimbAngle{Place::elbow, Turn::pitch, -30, -30}};
constexpr std::array kBack{
    LimbAngle{Place::hip, Turn::pitch, -25, -25},   LimbAngle{Place::hip, Turn::roll, 0, 0},
    LimbAngle{Place::knee, Turn::pitch, 95, 95},    LimbAngle{Place::ankle, Turn::pitch, -10, -10},
    LimbAngle{Place::waist, Turn::pitch, 30, 30},   LimbAngle{Place::shoulder, Turn::pitch, 60, 60},
    LimbAngle{Place::shoulder, Turn::roll, 30, 30}, LimbAngle{Place::elbow, Turn::pitch, -60, -60}};
constexpr std::array kSide{
    LimbAngle{Place::hip, Turn::pitch, -20, -50},       LimbAngle{Place::hip, Turn::roll, 0, 50},
    LimbAngle{Place::knee, Turn::pitch, 60, 60},        LimbAngle{Place::ankle, Turn::pitch, -20, -30},
    LimbAngle{Place::waist, Turn::yaw, 60, 60},         LimbAngle{Place::waist, Turn::pitch, 0, 0},
    LimbAngle{Place::shoulder, Turn::pitch, -90, -100}, LimbAngle{Place::shoulder, Turn::roll, 15, -10},
    LimbAngle{Place::elbow, Turn::pitch, -35, -115}};

double within_stops(const urdf::Joint& joint, double angle_rad) noexcept {
  return std::max(joint.lower_rad + kFromStop_rad, std::min(joint.upper_rad - kFromStop_rad, angle_rad));
}

PostureAngles angles_of(const urdf::RobotModel& robot, const std::vector<JointAngle>& named) {
  PostureAngles all(robot.joints.size(), kStays);
  for (const JointAngle& angle : named) {
    const auto joint = static_cast<std::size_t>(angle.joint);
    all[joint] = within_stops(robot.joints[joint], angle.angle_rad);
  }
  return all;
}

std::vector<JointAngle> mirror_image(PostureReader& reader, const std::vector<JointAngle>& side,
                                     const input::YamlValue& said, std::string_view missing) {
  try {
    return reader.mirrored(side);
  } catch (const std::invalid_argument& error) {
    said.refuse(error.what(), fmt::format("Give the posture '{}', too.", missing));
  }
}

// What the body lacks is left out.
PostureAngles limbs_at(const urdf::RobotModel& robot, const urdf::BodyJoints& body,
                       std::span<const LimbAngle> limbs, urdf::Side near) {
  using urdf::BodyPart;
  PostureAngles all(robot.joints.size(), kStays);
  for (const LimbAngle& limb : limbs) {
    const bool of_leg = limb.place < Place::shoulder;
    const double image = limb.turn == Turn::pitch ? 1.0 : -1.0;  // of the left side's angle on the right one
    const auto set = [&](BodyPart part, double limb_deg) {
      const auto joint = body.find({part, limb.place, limb.turn, 0});
      if (!joint) return;
      const auto at = static_cast<std::size_t>(*joint);
      all[at] = within_stops(robot.joints[at], body.joint_rad(*joint, limb_deg * facts::kRadPerDegree));
    };
    const bool left_is_near = near == urdf::Side::left;
    if (limb.place == Place::waist) {
      set(BodyPart::waist, (left_is_near ? 1.0 : image) * limb.near_deg);
      continue;
    }
    set(of_leg ? BodyPart::left_leg : BodyPart::left_arm, left_is_near ? limb.near_deg : limb.far_deg);
    set(of_leg ? BodyPart::right_leg : BodyPart::right_arm,
        image * (left_is_near ? limb.far_deg : limb.near_deg));
  }
  return all;
}

}  // namespace

std::optional<FallPostures> fall_postures_of(const urdf::RobotModel& robot) {
  const std::filesystem::path path = robot.directory / kFallPostureFile;
  if (!std::filesystem::exists(path)) return own_postures(robot);
  constexpr std::array<std::string_view, 4> kDirections{"ahead", "left", "back", "right"};
  constexpr std::array<std::string_view, 2> kFields{"joints", "symmetric"};
  const input::YamlValue file = input::YamlValue::read(path);
  file.require_map(kDirections);
  PostureReader reader(robot);
  const auto read = [&](std::string_view direction) {
    const input::YamlValue posture = file.at(direction);
    posture.require_map(kFields);
    return reader.read(posture);
  };
  const std::vector<JointAngle> ahead = read("ahead"), back = read("back");
  std::vector<JointAngle> left, right;
  if (file.find("left") || !file.find("right")) left = read("left");
  if (file.find("right")) {
    right = read("right");
  } else {
    right = mirror_image(reader, left, file.at("left"), "right");
  }
  if (!file.find("left")) left = mirror_image(reader, right, file.at("right"), "left");
  return FallPostures{angles_of(robot, ahead), angles_of(robot, left), angles_of(robot, back),
                      angles_of(robot, right)};
}

std::optional<FallPostures> own_postures(const urdf::RobotModel& robot) {
  const urdf::BodyJoints body(robot, urdf::ForwardKinematics(robot));
  if (body.arm(urdf::Side::left).empty() || body.arm(urdf::Side::right).empty()) return std::nullopt;
  return FallPostures{
      limbs_at(robot, body, kAhead, urdf::Side::left), limbs_at(robot, body, kSide, urdf::Side::left),
      limbs_at(robot, body, kBack, urdf::Side::left), limbs_at(robot, body, kSide, urdf::Side::right)};
}

}  // namespace gaitway::trajectory
