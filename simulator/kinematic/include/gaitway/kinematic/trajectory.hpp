// What the robot without dynamics plays: rows of joint angles, a time slot apart, and whatever else their
// source knows.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/motion.hpp"

namespace gaitway::kinematic {

// Where a zero moment point (ZMP) comes from.
enum class ZmpSource : std::uint8_t {
  planned,     // the cart-table model's: the planner's own, or made from the CoM where the source has none
  all_masses,  // of all links as they move: the ground's wrench by inverse dynamics
  cells,       // estimated from the feet's force sensors
  solver,      // centre of pressure of the physics engine's contacts
};
inline constexpr std::array kZmpSources{ZmpSource::planned, ZmpSource::all_masses, ZmpSource::cells,
                                        ZmpSource::solver};
[[nodiscard]] constexpr std::size_t index_of(ZmpSource source) noexcept {
  return static_cast<std::size_t>(source);
}
[[nodiscard]] std::string_view name_of(ZmpSource source) noexcept;

using ZmpRows = std::vector<Eigen::Vector2d>;  // one a row, or none at all; NaN: not known there

struct Trajectory {
  std::string name;  // of the file, or what was asked for
  std::string kind;  // of source, for people: "motion file"
  std::size_t joint_count = 0;
  double start_s = 0.0;  // of the first row, on the source's own clock
  // Rows of joint_count angles, in the order of RobotModel::joints: how the joints move.
  std::vector<double> joint_rad = {};
  // What the servos are given, rows alike; empty: the same, or not known.
  std::vector<double> reference_rad = {};
  // What stands in each row; empty: the soles' heights say.
  std::vector<motion::Contact> contact = {};
  // Pose of the base above a floor at z = 0; empty: what stands, stands still and flat.
  std::vector<Eigen::Isometry3d> base = {};
  std::array<ZmpRows, kZmpSources.size()> zmp = {};  // [ZmpSource], in the base's frame of reference
  // Derivatives are those of a parabola through so many rows on either side. 1: central differences, for
  // what was computed; more for what was measured or rounded to counts.
  int half_window = 1;
  double rounding_counts = 0.0;  // by how much an angle may be off for the way it was written down
  bool measured = false;         // joint_rad is what encoders said
  // By how much soles and ZMPs may be off, since the robot is not quite as it is described: added to what the
  // rules allow.
  double place_error_m = 0.0;
  // joint_rad leads the joints by what the load takes: soles and ZMPs made of it are told, not judged.
  bool leads_joints = false;
  // reference_rad, or joint_rad where there is none, are points as batches carry them over the wire.
  bool points_of_wire = false;
  std::vector<std::string> notes = {};  // what its reader had to do without

  [[nodiscard]] std::size_t rows() const noexcept {
    return joint_count == 0 ? 0 : joint_rad.size() / joint_count;
  }
  [[nodiscard]] std::span<const double> row(std::size_t index) const noexcept {
    return std::span(joint_rad).subspan(index * joint_count, joint_count);
  }
  [[nodiscard]] std::span<const double> reference(std::size_t index) const noexcept {
    return reference_rad.empty() ? row(index)
                                 : std::span(reference_rad).subspan(index * joint_count, joint_count);
  }
  [[nodiscard]] double time_s(std::size_t index) const noexcept {
    return start_s + static_cast<double>(index) * facts::kSlot_s;
  }
};

}  // namespace gaitway::kinematic
