// The search for a step that asks no more of joints and ground than they may bear.
#pragma once

#include <functional>
#include <string>

#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// Told after each change of a gait: why it was made.
using NoteReason = std::function<void(const std::string& reason)>;

// A tail as long as a plan carries.
void shorten_tail(GaitParameters& p);

// Arms, flatness, hips, lift and time of the step: for a usual and an everyday walk whatever it takes, for a
// fast one what costs little.
void fit_step(GaitParameters& p, const urdf::RobotModel& robot, const NoteReason& note);

// Why a walk at this velocity asks too much of a joint's speed or limits; empty: it does not.
[[nodiscard]] std::string too_much_at(const GaitParameters& p, const urdf::RobotModel& robot,
                                      const Velocity2& velocity);
// The same of a walk straight ahead, and of the ground.
[[nodiscard]] std::string too_much_ahead(const GaitParameters& p, const urdf::RobotModel& robot,
                                         double forward_m_per_s);

}  // namespace gaitway::trajectory
