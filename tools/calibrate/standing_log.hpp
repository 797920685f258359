// Poses in which a robot stood still, found in a log of its bus: whatever it was that had it take them.
#pragma once

#include <span>
#include <stdexcept>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {

class StandingLogError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A log in order of time, of a network of the robot's profile. Each time in which all joints were still for
// `measured_s` at least, with a foot on the ground, is a pose; the end of it is measured. Both feet are in
// the same places as long as neither was off the ground.
//
// `robot`: without calibration. `zero_in_use_rad`: of each joint, what its local controller took off the
// encoder's angle when the log was taken. Throws StandingLogError when there are too few poses.
[[nodiscard]] std::vector<StandingMeasurement> standing_poses(const urdf::RobotModel& robot,
                                                              std::span<const double> zero_in_use_rad,
                                                              std::span<const can::LoggedFrame> log,
                                                              double measured_s);

}  // namespace gaitway::calibration
