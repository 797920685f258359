// What each joint of the whole body does, told by its axis and its place in the kinematic tree at the home
// posture, never by its name or number: legs as LegJoints has them, arms, waist and neck.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

enum class BodyPart : std::uint8_t { left_leg, right_leg, left_arm, right_arm, waist, neck };
enum class JointPlace : std::uint8_t { hip, knee, ankle, shoulder, elbow, wrist, waist, neck };
enum class Turn : std::uint8_t { roll, pitch, yaw };  // about the base's axis x, y, z, which lies nearest

struct JointRole {
  BodyPart part = BodyPart::neck;
  JointPlace place = JointPlace::neck;
  Turn turn = Turn::yaw;
  int nth = 0;  // of several of this kind, from the base outwards

  bool operator==(const JointRole&) const = default;
};

[[nodiscard]] std::string describe(const JointRole& role);  // "left shoulder pitch", "left knee"
[[nodiscard]] constexpr bool is_leg(BodyPart part) noexcept {
  return part == BodyPart::left_leg || part == BodyPart::right_leg;
}
[[nodiscard]] constexpr bool is_arm(BodyPart part) noexcept {
  return part == BodyPart::left_arm || part == BodyPart::right_arm;
}

// Of a robot with both legs. What hangs off the body's middle plane and is no leg is that side's arm; where
// several do, the heaviest. A joint in the middle from which arms, or else the IMU, hang is of the waist, any
// other of the neck. The elbow is the first joint that bends the arm from a quarter of its length on.
class BodyJoints {
 public:
  // `home`: at the home posture. Throws std::invalid_argument, as LegJoints does, that says what a leg lacks.
  BodyJoints(const RobotModel& model, const ForwardKinematics& home);

  [[nodiscard]] const JointRole& role(int joint) const noexcept {
    return roles_[static_cast<std::size_t>(joint)];
  }
  // How far the limb is turned about the base's axis, rad, where the joint is at that angle and all before it
  // at home: 0 for an arm that hangs down straight, a straight leg on a level sole, and at home for any joint
  // that turns no limb ahead or aside. In these angles bodies compare whose zeros were chosen otherwise.
  [[nodiscard]] double limb_rad(int joint, double joint_rad) const noexcept {
    const AtHome& home = at_home_[static_cast<std::size_t>(joint)];
    return home.limb_rad + home.sign * (joint_rad - home.joint_rad);
  }
  [[nodiscard]] double joint_rad(int joint, double limb_rad) const noexcept {
    const AtHome& home = at_home_[static_cast<std::size_t>(joint)];
    return home.joint_rad + home.sign * (limb_rad - home.limb_rad);
  }
  [[nodiscard]] double limb_at_home_rad(int joint) const noexcept {
    return at_home_[static_cast<std::size_t>(joint)].limb_rad;
  }
  [[nodiscard]] std::optional<int> find(const JointRole& role) const noexcept;
  // Of an arm the joints from the shoulder to the hand, without what branches off; empty: there is none.
  [[nodiscard]] const std::vector<int>& arm(Side side) const noexcept { return arms_[index_of(side)]; }
  // The joint that does the same on the other side; in the middle the joint itself. Nothing: there is none.
  [[nodiscard]] std::optional<int> mirrored(int joint) const noexcept;

 private:
  void add_legs(const RobotModel& model, const ForwardKinematics& home);
  void add_arms(const RobotModel& model, const ForwardKinematics& home);
  void add_middle(const RobotModel& model);
  void add_axes(const RobotModel& model, const ForwardKinematics& home);
  void add_limbs(const RobotModel& model, const ForwardKinematics& home);

  struct AtHome {
    double sign = 1.0;  // 1: a positive angle turns with the base's axis; -1: against it
    double joint_rad = 0.0, limb_rad = 0.0;
  };

  std::vector<JointRole> roles_;
  std::vector<AtHome> at_home_;
  std::vector<bool> known_;  // its part
  std::array<std::vector<int>, 2> arms_;
};

// An angle of one side's joint as the other side's joint has it in the mirror image of the posture.
struct MirroredAngle {
  double sign = 1.0, offset_rad = 0.0;

  [[nodiscard]] double of(double angle_rad) const noexcept { return sign * angle_rad + offset_rad; }
};

// Nothing: at home their axes are no mirror images of each other, by more than 0.5 deg. A joint of the middle
// is its own image.
[[nodiscard]] std::optional<MirroredAngle> mirror_angle(const RobotModel& model,
                                                        const ForwardKinematics& home, int joint,
                                                        int mirrored) noexcept;

}  // namespace gaitway::urdf
