// A key-frame motion as its file describes it, and the reading of such files: postures to pass through, and
// what stands on the ground meanwhile.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/trajectory/motion_table.hpp"
#include "gaitway/trajectory/posture_angles.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::motion {

// What is on the ground on the way to a key and while it is held.
enum class Contact : std::uint8_t {
  both,
  left,
  right,
  none,  // anything else than flat feet, such as lying: neither balance nor torque can be checked
};
inline constexpr std::array<std::string_view, 4> kContactNames{"both", "left", "right", "none"};

[[nodiscard]] constexpr std::string_view name_of(Contact contact) noexcept {
  return kContactNames[static_cast<std::size_t>(contact)];
}
[[nodiscard]] constexpr bool stands_on(Contact contact, urdf::Side side) noexcept {
  return contact == Contact::both || contact == (side == urdf::Side::left ? Contact::left : Contact::right);
}

using trajectory::JointAngle;

// Above what the centre of mass shall be.
enum class Over : std::uint8_t { both, left, right };

// Where the pelvis shall be; what is left open stays as it was at the key before.
struct PelvisWish {
  std::optional<double> hip_height_m;                 // of the middle between the hips above the ground
  std::array<std::optional<double>, 3> attitude_rad;  // roll, pitch, yaw
  std::optional<Over> over;                           // the CoM above the middle of these soles …
  std::array<std::optional<double>, 2> com_offset_m;  // … and this much further forward, left
};

// Where a lifted foot shall be, from its place in the standing posture.
struct FootWish {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();    // forward, left, up
  Eigen::Vector3d attitude_rad = Eigen::Vector3d::Zero();  // roll, pitch, yaw
};

struct Key {
  std::string name;
  std::string where;       // file, line and name, for complaints
  bool from_home = false;  // what is not said is as in the standing posture, not as at the key before
  Contact contact = Contact::both;
  double hold_s = 0.0;
  double min_time_s = 0.0;  // from the key before
  std::vector<JointAngle> joints;
  std::optional<PelvisWish> pelvis;
  std::array<std::optional<FootWish>, 2> foot;  // [Side]
};

struct Motion {
  std::string name;
  std::string description;
  // A motion starts in the standing posture; with this, in that of the first key (which takes no time then).
  bool starts_at_first_key = false;
  // Of the motors' torque, what the motion itself may take at most; not said: MotionLimits::torque_share.
  std::optional<double> torque_share;
  std::optional<trajectory::LyingSide> lies_on;  // there, on which side; not said: any
  std::vector<Key> keys;
};

// Reads motions from YAML files, strictly.
// Throws urdf::RobotError with file, line, field, value, rule and remedy.
[[nodiscard]] Motion read_motion(const std::filesystem::path& file, const urdf::RobotModel& robot);

// The same of a text; `file` is what complaints call it.
[[nodiscard]] Motion parse_motion(const std::string& text, const std::filesystem::path& file,
                                  const urdf::RobotModel& robot);

// The motions of a folder: its *.yaml files, in the order of their names. Throws
// urdf::RobotError if it is none.
[[nodiscard]] std::vector<std::filesystem::path> motion_files(const std::filesystem::path& folder);

}  // namespace gaitway::motion
