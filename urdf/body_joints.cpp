// Legs by LegJoints; the rest of the tree by which side of the middle plane a joint hangs on.
#include "gaitway/urdf/body_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::urdf {
namespace {

constexpr double kOffMiddle = 0.03;        // of the hip height: a joint so far aside is not in the middle
constexpr double kElbowFrom = 0.25;        // of the arm's length
constexpr double kSamePlace = 0.05;        // likewise
constexpr double kUpperArm = 0.5;          // of the way from the first shoulder joint to the elbow
constexpr double kTwistCosine = 0.8;       // of axis and limb: a joint that twists the limb bends nothing
constexpr double kMirrorCosine = 0.99996;  // of 0.5 deg

std::size_t place_of(int index) noexcept {
  return static_cast<std::size_t>(index);
}

const Joint& joint_of(const RobotModel& model, int joint) noexcept {
  return model.joints[place_of(joint)];
}

// The joint that carries the joint's parent link; -1: the base does.
int joint_before(const RobotModel& model, int joint) noexcept {
  return model.links[place_of(joint_of(model, joint).parent_link)].parent_joint;
}

// Of the links that hang on each joint.
std::vector<double> carried_masses_kg(const RobotModel& model) {
  std::vector<double> carried(model.joints.size(), 0.0);
  for (std::size_t j = model.joints.size(); j-- > 0;) {
    carried[j] += model.links[place_of(model.joints[j].child_link)].mass_kg;
    const int before = joint_before(model, static_cast<int>(j));
    if (before >= 0) carried[place_of(before)] += carried[j];
  }
  return carried;
}

// From `joint` outwards, where it branches along what weighs most.
std::vector<int> limb_from(const RobotModel& model, int joint, const std::vector<double>& carried_kg) {
  std::vector<int> limb;
  for (int next = joint; next >= 0;) {
    limb.push_back(next);
    const int here = next;
    next = -1;
    for (int j = here + 1; j < static_cast<int>(model.joints.size()); ++j) {
      const bool hangs = joint_before(model, j) == here;
      if (hangs && (next < 0 || carried_kg[place_of(j)] > carried_kg[place_of(next)])) next = j;
    }
  }
  return limb;
}

// The first joint that bends the limb from a quarter of its length on; its length ends at the last link's
// CoM.
std::size_t elbow_of(const RobotModel& model, const ForwardKinematics& home, const std::vector<int>& limb) {
  std::vector<Eigen::Vector3d> place_m;
  for (const int joint : limb) place_m.push_back(home.link_position_m(joint_of(model, joint).child_link));
  const int last = joint_of(model, limb.back()).child_link;
  place_m.push_back(home.link_pose(last) * model.links[place_of(last)].com_m);
  std::vector<double> at_m{0.0};
  for (std::size_t i = 1; i < place_m.size(); ++i) {
    at_m.push_back(at_m.back() + (place_m[i] - place_m[i - 1]).norm());
  }
  // Whether the joint turns about the straight line to a place of the limb: the nearest that is not its own.
  const auto twists = [&](std::size_t at, int step) {
    for (int i = static_cast<int>(at) + step; i >= 0 && i < static_cast<int>(place_m.size()); i += step) {
      const Eigen::Vector3d way_m = place_m[place_of(i)] - place_m[at];
      if (way_m.norm() < kSamePlace * at_m.back()) continue;
      return std::abs(home.joint_axis(model, limb[at]).dot(way_m)) > kTwistCosine * way_m.norm();
    }
    return false;
  };
  for (std::size_t i = 1; i < limb.size(); ++i) {
    if (at_m[i] >= kElbowFrom * at_m.back() && !twists(i, 1) && !twists(i, -1)) return i;
  }
  return limb.size();
}

// Of a limb that hangs down: by what rotation about the base's y axis, after one about its x axis, it got
// there.
double pitch_of(const Eigen::Vector3d& limb) noexcept {
  return std::atan2(-limb.x(), -limb.z());
}
double roll_of(const Eigen::Vector3d& limb) noexcept {
  return std::asin(std::clamp(limb.y() / limb.norm(), -1.0, 1.0));
}

// From one part of a limb to the next, about the axis of the joint between them, taken with the base's y
// axis.
double bend_rad(const Eigen::Vector3d& axis, const Eigen::Vector3d& upper,
                const Eigen::Vector3d& lower) noexcept {
  const Eigen::Vector3d about = axis.y() < 0.0 ? Eigen::Vector3d(-axis) : axis;
  const Eigen::Vector3d from = upper - about * about.dot(upper), to = lower - about * about.dot(lower);
  return std::atan2(about.dot(from.cross(to)), from.dot(to));
}

// The centre of mass of all that the joint carries, base frame.
Eigen::Vector3d carried_com_m(const RobotModel& model, const ForwardKinematics& home, int joint) {
  double mass_kg = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  std::vector<bool> carried(model.links.size(), false);
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    carried[i] =
        link.parent_joint == joint || carried[place_of(joint_of(model, link.parent_joint).parent_link)];
    if (!carried[i]) continue;
    mass_kg += link.mass_kg;
    moment += link.mass_kg * (home.link_pose(static_cast<int>(i)) * link.com_m);
  }
  return moment / mass_kg;
}

Turn turn_of(LegJoint which) noexcept {
  if (which == LegJoint::hip_yaw) return Turn::yaw;
  return which == LegJoint::hip_roll || which == LegJoint::ankle_roll ? Turn::roll : Turn::pitch;
}

JointPlace place_of(LegJoint which) noexcept {
  if (which == LegJoint::knee) return JointPlace::knee;
  return which < LegJoint::knee ? JointPlace::hip : JointPlace::ankle;
}

}  // namespace

std::string describe(const JointRole& role) {
  constexpr std::array<std::string_view, 8> kPlaces{"hip",   "knee",  "ankle", "shoulder",
                                                    "elbow", "wrist", "waist", "neck"};
  constexpr std::array<std::string_view, 3> kTurns{"roll", "pitch", "yaw"};
  std::string text;
  if (is_leg(role.part) || is_arm(role.part)) {
    text = role.part == BodyPart::left_leg || role.part == BodyPart::left_arm ? "left " : "right ";
  }
  text += kPlaces[static_cast<std::size_t>(role.place)];
  if (role.place != JointPlace::knee) text += fmt::format(" {}", kTurns[static_cast<std::size_t>(role.turn)]);
  if (role.nth > 0) text += fmt::format(" {}", role.nth + 1);
  return text;
}

BodyJoints::BodyJoints(const RobotModel& model, const ForwardKinematics& home)
    : roles_(model.joints.size()), at_home_(model.joints.size()), known_(model.joints.size(), false) {
  add_legs(model, home);
  add_arms(model, home);
  add_middle(model);
  add_axes(model, home);
  add_limbs(model, home);
}

void BodyJoints::add_legs(const RobotModel& model, const ForwardKinematics& home) {
  for (const Side side : kSides) {
    const LegJoints leg(model, home, side);
    for (int which = 0; which < 6; ++which) {
      const auto what = static_cast<LegJoint>(which);
      roles_[place_of(leg[what])] = {side == Side::left ? BodyPart::left_leg : BodyPart::right_leg,
                                     place_of(what), turn_of(what), 0};
      known_[place_of(leg[what])] = true;
    }
  }
}

void BodyJoints::add_arms(const RobotModel& model, const ForwardKinematics& home) {
  const std::vector<double> carried_kg = carried_masses_kg(model);
  const double aside_m = kOffMiddle * model.hip_height_m;
  const auto left_m = [&](int joint) { return home.link_position_m(joint_of(model, joint).child_link).y(); };
  for (const Side side : kSides) {
    const double way = side == Side::left ? 1.0 : -1.0;
    int root = -1;
    for (int j = 0; j < static_cast<int>(model.joints.size()); ++j) {
      const int before = joint_before(model, j);
      const bool leaves_middle =
          way * left_m(j) > aside_m && (before < 0 || std::abs(left_m(before)) <= aside_m);
      if (known_[place_of(j)] || !leaves_middle) continue;
      if (root < 0 || carried_kg[place_of(j)] > carried_kg[place_of(root)]) root = j;
    }
    if (root < 0) continue;
    std::vector<int>& limb = arms_[index_of(side)];
    limb = limb_from(model, root, carried_kg);
    const std::size_t elbow = elbow_of(model, home, limb);
    const BodyPart part = side == Side::left ? BodyPart::left_arm : BodyPart::right_arm;
    for (int j = root; j < static_cast<int>(model.joints.size()); ++j) {
      const int before = joint_before(model, j);
      const bool of_arm =
          j == root || (before >= 0 && known_[place_of(before)] && roles_[place_of(before)].part == part);
      if (!of_arm || known_[place_of(j)]) continue;
      const auto found = static_cast<std::size_t>(std::ranges::find(limb, j) - limb.begin());
      roles_[place_of(j)].part = part;
      roles_[place_of(j)].place = found < elbow && found < limb.size()    ? JointPlace::shoulder
                                  : found == elbow && found < limb.size() ? JointPlace::elbow
                                                                          : JointPlace::wrist;
      known_[place_of(j)] = true;
    }
  }
}

// What carries the arms, or the IMU where there are none.
void BodyJoints::add_middle(const RobotModel& model) {
  std::vector<bool> carries(model.joints.size(), false);
  const auto mark = [&](int joint) {
    for (; joint >= 0; joint = joint_before(model, joint)) carries[place_of(joint)] = true;
  };
  for (const std::vector<int>& arm : arms_) {
    if (!arm.empty()) mark(joint_before(model, arm.front()));
  }
  if (arms_[0].empty() && arms_[1].empty()) mark(model.links[place_of(model.imu.link)].parent_joint);
  for (std::size_t j = 0; j < roles_.size(); ++j) {
    if (known_[j]) continue;
    roles_[j].part = carries[j] ? BodyPart::waist : BodyPart::neck;
    roles_[j].place = carries[j] ? JointPlace::waist : JointPlace::neck;
  }
}

void BodyJoints::add_axes(const RobotModel& model, const ForwardKinematics& home) {
  for (int j = 0; j < static_cast<int>(roles_.size()); ++j) {
    JointRole& role = roles_[place_of(j)];
    const Eigen::Vector3d axis = home.joint_axis(model, j);
    Eigen::Index nearest = static_cast<Eigen::Index>(role.turn);
    if (!is_leg(role.part)) axis.cwiseAbs().maxCoeff(&nearest);
    role.turn = static_cast<Turn>(nearest);
    at_home_[place_of(j)].sign = axis[nearest] < 0.0 ? -1.0 : 1.0;
    at_home_[place_of(j)].joint_rad = joint_of(model, j).home_rad;
    for (int before = 0; before < j; ++before) {
      JointRole counted = roles_[place_of(before)];
      counted.nth = role.nth;
      if (!is_leg(role.part) && counted == role) ++role.nth;
    }
  }
}

// Hips, knees and ankles by thigh and shank; shoulders and elbows by upper arm and forearm.
void BodyJoints::add_limbs(const RobotModel& model, const ForwardKinematics& home) {
  const auto place_m = [&](int joint) { return home.link_position_m(joint_of(model, joint).child_link); };
  const auto set = [this](const JointRole& role, double limb_rad) {
    if (const auto joint = find(role)) at_home_[place_of(*joint)].limb_rad = limb_rad;
  };
  for (const Side side : kSides) {
    const BodyPart part = side == Side::left ? BodyPart::left_leg : BodyPart::right_leg;
    const LegJoints leg(model, home, side);
    const Eigen::Vector3d knee_m = place_m(leg[LegJoint::knee]);
    const double thigh_rad = pitch_of(knee_m - place_m(leg[LegJoint::hip_pitch]));
    const double shank_rad = pitch_of(place_m(leg[LegJoint::ankle_pitch]) - knee_m);
    set({part, JointPlace::hip, Turn::pitch, 0}, thigh_rad);
    set({part, JointPlace::knee, Turn::pitch, 0}, shank_rad - thigh_rad);
    set({part, JointPlace::ankle, Turn::pitch, 0}, -shank_rad);
  }
  // Of the shoulder's joints the last that does not lie at the elbow already, as one does that twists the arm
  // there.
  const auto upper_arm_from_m = [&](const std::vector<int>& limb, auto elbow, const Eigen::Vector3d& end_m) {
    const double long_m = (end_m - place_m(limb.front())).norm();
    auto from = elbow - 1;
    while (from != limb.begin() && (end_m - place_m(*from)).norm() < kUpperArm * long_m) --from;
    return place_m(*from);
  };
  for (const Side side : kSides) {
    const std::vector<int>& limb = arm(side);
    const auto elbow =
        std::ranges::find_if(limb, [this](int joint) { return role(joint).place == JointPlace::elbow; });
    if (elbow == limb.begin()) continue;  // there is no arm, or none of a shoulder
    const BodyPart part = role(limb.front()).part;
    const bool bends = elbow != limb.end();
    const Eigen::Vector3d end_m = bends ? place_m(*elbow) : carried_com_m(model, home, limb.back());
    const Eigen::Vector3d upper_m = end_m - upper_arm_from_m(limb, elbow, end_m);
    if (upper_m.isZero(1e-6)) continue;
    set({part, JointPlace::shoulder, Turn::pitch, 0}, pitch_of(upper_m));
    set({part, JointPlace::shoulder, Turn::roll, 0}, roll_of(upper_m));
    if (!bends) continue;
    const Eigen::Vector3d forearm_m = carried_com_m(model, home, *elbow) - place_m(*elbow);
    set({part, JointPlace::elbow, Turn::pitch, 0},
        bend_rad(home.joint_axis(model, *elbow), upper_m, forearm_m));
  }
}

std::optional<int> BodyJoints::find(const JointRole& role) const noexcept {
  const auto found = std::ranges::find(roles_, role);
  if (found == roles_.end()) return std::nullopt;
  return static_cast<int>(found - roles_.begin());
}

std::optional<int> BodyJoints::mirrored(int joint) const noexcept {
  JointRole other = role(joint);
  switch (other.part) {
    case BodyPart::left_leg:
      other.part = BodyPart::right_leg;
      break;
    case BodyPart::right_leg:
      other.part = BodyPart::left_leg;
      break;
    case BodyPart::left_arm:
      other.part = BodyPart::right_arm;
      break;
    case BodyPart::right_arm:
      other.part = BodyPart::left_arm;
      break;
    default:
      return joint;
  }
  return find(other);
}

// A mirror in the xz plane turns a rotation about (x, y, z) into one about (-x, y, -z).
std::optional<MirroredAngle> mirror_angle(const RobotModel& model, const ForwardKinematics& home, int joint,
                                          int mirrored) noexcept {
  const Eigen::Vector3d axis = home.joint_axis(model, joint);
  const double along = Eigen::Vector3d(-axis.x(), axis.y(), -axis.z()).dot(home.joint_axis(model, mirrored));
  if (std::abs(along) < kMirrorCosine) return std::nullopt;
  const double sign = along > 0.0 ? 1.0 : -1.0;
  return MirroredAngle{sign, joint_of(model, mirrored).home_rad - sign * joint_of(model, joint).home_rad};
}

}  // namespace gaitway::urdf
