// What Gaitway makes of a robot: its body, the gait that is chosen for it, how fast it may go and what keeps
// it from going faster, and whether its bus is proven.
#pragma once

#include <string>
#include <vector>

#include "gaitway/trajectory/gait_choice.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

struct SpeedLimit {
  std::string direction;  // "forward", "backward", "sideways", "turn"
  std::string unit;       // "m/s", "rad/s"
  double most = 0.0;
  std::string cause;
};

struct RobotDescription {
  urdf::RobotModel robot;
  trajectory::ChosenGait gait;
  std::vector<SpeedLimit> speeds;
  std::vector<trajectory::JointTorque> torques;
  std::string gait_complaint;    // empty: the robot can walk with the chosen gait
  std::string torque_complaint;  // empty: its motors are strong enough
  std::string bus_profile;
  std::string bus_complaint;  // empty: every message keeps its deadline
};

// Throws urdf::RobotError for a robot, or a network file, that does not load.
[[nodiscard]] RobotDescription describe_robot(const urdf::RobotModel& robot);

[[nodiscard]] std::string description_text(const RobotDescription& description);
[[nodiscard]] std::string description_json(const RobotDescription& description);

}  // namespace gaitway::tools
