// What an inverse kinematics of one leg answers: six joint angles, or why there are none and by how much.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// A joint may lie this far beyond its limit before it counts as violated: far below a count on the wire.
inline constexpr double kLimitTolerance_rad = 1e-6;

enum class LegStatus : std::uint8_t {
  reached,
  over_stretched,  // the foot is too far from the hip; excess in m
  over_folded,     // the foot is too close to the hip; excess in m
  joint_limit,     // reached, but a joint lies beyond its limit; excess in rad
  not_converged,   // the general solver found no posture; excess is the position error left, in m
};

struct LegSolution {
  // hip yaw, hip roll, hip pitch, knee, ankle pitch, ankle roll. Not clamped. NaN unless reached or
  // joint_limit.
  std::array<double, 6> angle_rad{};
  LegStatus status = LegStatus::reached;
  int joint = -1;       // joint_limit: which of the six lies farthest beyond its limit
  double excess = 0.0;  // by how much; unit as the status says

  [[nodiscard]] bool reached() const noexcept { return status == LegStatus::reached; }
};

// A solution without angles.
[[nodiscard]] LegSolution unreachable(LegStatus status, double excess) noexcept;

struct LegLimits {
  std::array<double, 6> lower_rad{};
  std::array<double, 6> upper_rad{};
};
[[nodiscard]] LegLimits leg_limits(const urdf::RobotModel& model, urdf::Side side);

// Marks the solution as joint_limit if an angle lies beyond its limit or is not a number.
void check_limits(const LegLimits& limits, LegSolution& solution) noexcept;

// The failure in words, e.g. "the leg is over-stretched by 12.3 mm". Allocates: not for the fault-free path.
[[nodiscard]] std::string describe(const LegSolution& solution, const urdf::RobotModel& model,
                                   urdf::Side side);

}  // namespace gaitway::kinematics
