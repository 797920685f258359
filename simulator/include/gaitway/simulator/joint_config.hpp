// From the robot model to what each local controller is configured with.
#pragma once

#include "gaitway/localcontroller/joint_controller.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

// Configuration of the local controller of joint `joint` (index into RobotModel::joints), standing at home.
localcontroller::JointConfig joint_config(const urdf::RobotModel& robot, int joint);

}  // namespace gaitway::simulator
