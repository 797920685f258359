// From what a motion's keys say to whole postures.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <stdexcept>
#include <vector>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_limits.hpp"

namespace gaitway::motion {

// Why a motion cannot be played: names file, line and key, or joint and time, with value, limit and remedy.
class MotionError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct KeyPosture {
  Eigen::VectorXd joint_rad;
  // As StanceMap has it; none where the robot does not stand on flat feet.
  std::optional<Eigen::VectorXd> stance;
};

// The posture that the motion starts from, and one for each key (not for the first if the motion starts
// there). Throws MotionError where a key is out of reach or limits, out of balance, or moves a foot that it
// stands on.
[[nodiscard]] std::vector<KeyPosture> key_postures(const urdf::RobotModel& robot, const Motion& motion,
                                                   const MotionLimits& limits);

}  // namespace gaitway::motion
