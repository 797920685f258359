// The gait of one robot: what the pattern takes from its description, and whether its legs reach every
// footstep.
#pragma once

#include <array>

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// The gait that suits a robot before anybody has configured one: the defaults scaled to its body (BodyScale),
// with CoM height and place, hip height, foot spacing and sole of its standing posture (all joints at
// home_rad), so that the nominal stand of the plans is the posture that the joints hold. The ZMP is put below
// the middle of the sole. Steps are at most as long and wide as the legs reach (require_reachable), and as
// low, slow and short as the motors of the legs need it (fastest_joint, leg_torques). With its reasons:
// choose_gait(). Some milliseconds, a few hundred for slow motors.
[[nodiscard]] GaitParameters gait_of(const urdf::RobotModel& robot);

// Whether a robot with `parameters` stands as one with `described` does: CoM, hips and feet.
[[nodiscard]] bool stands_as_described(const GaitParameters& parameters,
                                       const GaitParameters& described) noexcept;

// The part of a leg that reaches for a footstep: from the hip pitch axis over the knee to the ankle pitch
// axis. Lengths in m; measured in the zero posture.
struct LegReach {
  double hip_forward_m = 0.0;          // of the hip ahead of the CoM in the standing posture
  double hip_left_m = 0.0;             // of the hip beside the middle between the soles, positive to the left
  double ankle_height_m = 0.0;         // above the sole
  double ankle_forward_m = 0.0;        // ahead of the sole's origin
  double ankle_left_m = 0.0;           // beside the sole's origin
  double longest_m = 0.0;              // hip to ankle, the knee as straight as its limits let it be
  double shortest_m = 0.0;             // the knee as bent as its limits let it be
  double thigh_m = 0.0, shin_m = 0.0;  // square to the knee's axis
  double aside_m = 0.0;                // of the ankle from the hip, along the knee's axis
};

[[nodiscard]] std::array<LegReach, 2> leg_reach(const urdf::RobotModel& robot);  // [Side]
// The longest distance from hip to ankle that a plan may ask for: the rest is for balance feedback and the
// way of the CoM.
[[nodiscard]] double usable_reach_m(const urdf::RobotModel& robot, const LegReach& leg);

// Largest distance of hip and ankle in double support over the corners of the footstep limits, m: the feet
// stand (forward, spacing, turn) apart, the base turned half-way, the CoM between them as far from one foot
// as the cart-table's steady walk has it.
[[nodiscard]] double farthest_hip_to_ankle_m(const GaitParameters& parameters, const LegReach& leg,
                                             double step_forward_m, double foot_spacing_m);

// Throws std::invalid_argument naming parameter, value, rule ("footstep unreachable: ...") and remedy if a
// leg is too short for the farthest footstep, or cannot be folded for the highest lift. Keeps
// usable_reach_m().
void require_reachable(const GaitParameters& parameters, const urdf::RobotModel& robot);

// Throws std::invalid_argument naming parameter, joint, limit and remedy if short steps, a twentieth of the
// hip height or the longest if that is less, turn hip pitch, knee or ankle pitch of a leg beyond one of its
// limits or faster than it turns. Some milliseconds.
void require_room_for_steps(const GaitParameters& parameters, const urdf::RobotModel& robot);

// All that a robot must be able to do with parameters that are valid, before anything moves: reach the
// footsteps, have room and speed for short steps, stand on one leg. Throws std::invalid_argument.
void require_walkable(const GaitParameters& parameters, const urdf::RobotModel& robot);

}  // namespace gaitway::trajectory
