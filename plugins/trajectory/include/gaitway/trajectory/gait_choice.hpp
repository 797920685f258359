// The gait that is chosen for a robot, and why each number of it is not that of the scaled default.
#pragma once

#include <string>
#include <vector>

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// A number of the gait that something of the robot has changed.
struct GaitChoice {
  std::string parameter, unit;        // as the configuration has them: "step_time", "s"
  double scaled = 0.0, chosen = 0.0;  // the default that is scaled to the body, and what became of it
  std::vector<std::string> reasons;   // in the order in which they changed it
};

struct ChosenGait {
  GaitParameters parameters;
  std::vector<GaitChoice> choices;

  // nullptr: it is the scaled default.
  [[nodiscard]] const GaitChoice* choice(const std::string& parameter) const noexcept;
};

// What gait_of() does, with its reasons.
[[nodiscard]] ChosenGait choose_gait(const urdf::RobotModel& robot);

}  // namespace gaitway::trajectory
