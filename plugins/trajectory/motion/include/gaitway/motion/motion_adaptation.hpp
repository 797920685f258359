// One robot's key-frame motion for another body: joints matched by what they do, lengths and times scaled,
// angles taken against how the limbs hang at home.
#pragma once

#include <string>
#include <vector>

#include "gaitway/motion/motion.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::motion {

struct AdaptedMotion {
  Motion motion;                     // of the other robot's joints; its keys are of no file yet
  double length_factor = 1.0;        // hip height against hip height
  double time_factor = 1.0;          // its root
  std::vector<std::string> changes;  // what is not as in the original, and why: a line each
};

// `share`: how large the motion shall be, 0 to 1; 1: as the original. Of a motion that is on the ground it
// is 1. A joint that is missing, or an arm that hangs more than 45 deg elsewhere, is left out where the
// motion goes without it: heads always, arms and waist while feet, pelvis or legs do the motion in a stand.
// So is an angle beyond the joint's stops: the stop is taken there, else up to 10 deg beyond. Throws
// MotionError with key, joint and reason where the motion does not go so. The adapted motion of a stand may
// take 1/1.4 of the torque that others may, as a walk: the rest is the balance's (Motion::torque_share).
[[nodiscard]] AdaptedMotion adapt_motion(const urdf::RobotModel& from, const Motion& motion,
                                         const urdf::RobotModel& to, double share = 1.0);

// As parse_motion() reads it, under these lines of comment.
[[nodiscard]] std::string motion_text(const Motion& motion, const urdf::RobotModel& robot,
                                      const std::vector<std::string>& comments);

// Whether some key is on the ground, where neither balance nor torque can be planned.
[[nodiscard]] bool is_on_ground(const Motion& motion) noexcept;

}  // namespace gaitway::motion
