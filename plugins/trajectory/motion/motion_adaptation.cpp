// Finds for every angle the joint that does the same, and what that angle is there.
#include "gaitway/motion/motion_adaptation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/motion_limits.hpp"
#include "gaitway/motion/motion_path.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/urdf/body_joints.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::motion {
namespace {

using facts::kDegreePerRad;
using facts::kRadPerDegree;
using urdf::BodyPart;
using urdf::JointRole;

// The balance needs the rest, as in a walk: another body is not the one whose squat was tried.
constexpr MotionLimits kLimits{.torque_share =
                                   MotionLimits{}.torque_share / trajectory::JointTorque::kWalking};
constexpr double kMostBeyondStop_rad = 10.0 * kRadPerDegree;
constexpr double kMostHeldElsewhere_rad = 45.0 * kRadPerDegree;
constexpr double kRounding_rad = 0.01 * kRadPerDegree;  // of an angle in a file

// A body with its joints' roles.
class Body {
 public:
  explicit Body(const urdf::RobotModel& robot)
      : robot_(robot), joints_(robot, urdf::ForwardKinematics(robot)) {}

  [[nodiscard]] const urdf::RobotModel& robot() const noexcept { return robot_; }
  [[nodiscard]] const urdf::BodyJoints& joints() const noexcept { return joints_; }
  [[nodiscard]] const urdf::Joint& joint(int index) const noexcept {
    return robot_.joints[static_cast<std::size_t>(index)];
  }

 private:
  const urdf::RobotModel& robot_;
  urdf::BodyJoints joints_;
};

class Adaptation {
 public:
  Adaptation(const Body& from, const Body& to, const Motion& original, double share)
      : from_(from), to_(to), original_(original), share_(is_on_ground(original) ? 1.0 : share) {
    adapted_.length_factor = to.robot().hip_height_m / from.robot().hip_height_m;
    adapted_.time_factor = std::sqrt(adapted_.length_factor);
    whole_body_ = std::ranges::any_of(
        original.keys, [](const Key& key) { return key.pelvis || key.foot[0] || key.foot[1]; });
  }

  AdaptedMotion adapt() {
    adapted_.motion = original_;
    if (!is_on_ground(original_)) adapted_.motion.torque_share = limits_of(original_, kLimits).torque_share;
    for (Key& key : adapted_.motion.keys) {
      key.hold_s *= adapted_.time_factor;
      key.min_time_s *= adapted_.time_factor;
      if (key.pelvis) scale(*key.pelvis);
      for (std::optional<FootWish>& foot : key.foot) {
        if (!foot) continue;
        foot->position_m *= share_ * adapted_.length_factor;
        foot->attitude_rad *= share_;
      }
      std::vector<JointAngle> angles;
      for (const JointAngle& angle : key.joints) {
        if (const auto found = adapt(key, angle)) angles.push_back(*found);
      }
      key.joints = std::move(angles);
    }
    return std::move(adapted_);
  }

 private:
  void scale(PelvisWish& pelvis) const {
    if (pelvis.hip_height_m) {
      const double as_original_m = adapted_.length_factor * *pelvis.hip_height_m;
      pelvis.hip_height_m = as_original_m + (1.0 - share_) * (to_.robot().hip_height_m - as_original_m);
    }
    for (auto& angle_rad : pelvis.attitude_rad) {
      if (angle_rad) *angle_rad *= share_;
    }
    for (auto& offset_m : pelvis.com_offset_m) {
      if (offset_m) *offset_m *= share_ * adapted_.length_factor;
    }
  }

  // Whether the motion goes without what this part of the body does.
  [[nodiscard]] bool is_help(BodyPart part) const {
    return part == BodyPart::neck || (!urdf::is_leg(part) && whole_body_ && !is_on_ground(original_));
  }

  std::optional<JointAngle> adapt(const Key& key, const JointAngle& angle) {
    const JointRole& role = from_.joints().role(angle.joint);
    const std::string what =
        fmt::format("key '{}' turns the {} ('{}' of {}) to {:.1f} deg", key.name, urdf::describe(role),
                    from_.joint(angle.joint).name, from_.robot().name, angle.angle_rad * kDegreePerRad);
    const std::optional<int> joint = to_.joints().find(role);
    if (!joint) {
      return leave_out(role, what,
                       fmt::format("the robot '{}' has no {}", to_.robot().name, urdf::describe(role)));
    }
    const double from_home_rad = from_.joints().limb_at_home_rad(angle.joint),
                 to_home_rad = to_.joints().limb_at_home_rad(*joint);
    if (role.place == urdf::JointPlace::shoulder &&
        std::abs(to_home_rad - from_home_rad) > kMostHeldElsewhere_rad) {
      return leave_out(
          role, what,
          fmt::format("'{}' of the robot '{}' holds the limb at {:.0f} deg at home, and not at {:.0f}",
                      to_.joint(*joint).name, to_.robot().name, to_home_rad * kDegreePerRad,
                      from_home_rad * kDegreePerRad));
    }
    const urdf::Joint& is = to_.joint(*joint);
    const double as_original_rad =
        to_.joints().joint_rad(*joint, from_.joints().limb_rad(angle.joint, angle.angle_rad));
    const double wanted_rad = is.home_rad + share_ * (as_original_rad - is.home_rad);
    return JointAngle{*joint, within_stops(role, is, wanted_rad, what)};
  }

  std::optional<JointAngle> leave_out(const JointRole& role, const std::string& what,
                                      const std::string& why) {
    if (!is_help(role.part)) {
      throw MotionError(
          fmt::format("motion '{}': {}, but {}. The motion does not go without: choose another one, or write "
                      "one for this robot",
                      original_.name, what, why));
    }
    note(fmt::format("{}: left out, since {}", urdf::describe(role), why));
    return std::nullopt;
  }

  double within_stops(const JointRole& role, const urdf::Joint& joint, double wanted_rad,
                      const std::string& what) {
    const double margin_rad = MotionLimits{}.joint_margin_rad + kRounding_rad;
    const double kept_rad =
        std::max(joint.lower_rad + margin_rad, std::min(joint.upper_rad - margin_rad, wanted_rad));
    const double beyond_rad = std::abs(wanted_rad - kept_rad);
    if (beyond_rad < kRounding_rad) return kept_rad;
    const std::string stops = fmt::format("'{}' would be at {:.1f} deg, and it turns from {:.1f} to {:.1f}",
                                          joint.name, wanted_rad * kDegreePerRad,
                                          joint.lower_rad * kDegreePerRad, joint.upper_rad * kDegreePerRad);
    if (beyond_rad > kMostBeyondStop_rad && !is_help(role.part)) {
      throw MotionError(
          fmt::format("motion '{}': {}; on the robot '{}' {} deg. That is more than 10 deg beyond: choose "
                      "another motion, or "
                      "write one for this robot",
                      original_.name, what, to_.robot().name, stops));
    }
    note(fmt::format("{}: {}; {:.1f} deg taken", what, stops, kept_rad * kDegreePerRad));
    return kept_rad;
  }

  void note(std::string text) {
    if (std::ranges::find(adapted_.changes, text) == adapted_.changes.end())
      adapted_.changes.push_back(std::move(text));
  }

  const Body& from_;
  const Body& to_;
  const Motion& original_;
  double share_;
  bool whole_body_ = false;  // feet or pelvis are told where to be
  AdaptedMotion adapted_;
};

}  // namespace

bool is_on_ground(const Motion& motion) noexcept {
  return std::ranges::any_of(motion.keys, [](const Key& key) { return key.contact == Contact::none; });
}

AdaptedMotion adapt_motion(const urdf::RobotModel& from, const Motion& motion, const urdf::RobotModel& to,
                           double share) {
  const Body source(from), target(to);
  return Adaptation(source, target, motion, share).adapt();
}

}  // namespace gaitway::motion
