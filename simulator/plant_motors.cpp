// How the plant's motors act on its joints, and what was drawn for joints and soles.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "plant_implementation.hpp"

namespace gaitway::simulator {

void Plant::Implementation::set_drawn(mjModel& target) const {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const int address = velocity_address[j];
    target.dof_frictionloss[address] *= motors.joint(j).friction_factor;
    target.dof_damping[address] *= motors.joint(j).damping_factor;
    const int play = mj_name2id(&target, mjOBJ_JOINT, (robot.joints[j].name + "_play").c_str());
    for (int end = 0; play >= 0 && end < 2; ++end) {
      target.jnt_range[2 * play + end] *= mismatch.play_factor[j];
    }
  }
  for (int geom = 0; geom < target.ngeom; ++geom) {
    for (std::size_t foot = 0; foot < foot_body.size(); ++foot) {
      if (target.geom_bodyid[geom] != foot_body[foot]) continue;
      // A contact's time constant is the mean of both sides': the sole is what differs.
      mjtNum& time_s = target.geom_solref[mjNREF * geom];
      time_s *= 2.0 * mismatch.sole_time_factor[foot] - 1.0;
    }
  }
}

void Plant::Implementation::apply_motors(std::span<const double> command_Nm) {
  if (command_Nm.size() != robot.joints.size()) {
    throw std::invalid_argument(robot.name + ": step() takes " + std::to_string(robot.joints.size()) +
                                " joint torques, not " + std::to_string(command_Nm.size()));
  }
  const double supply = sagging_steps > 0 ? supply_factor : 1.0;
  sagging_steps = std::max(0L, sagging_steps - 1);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (!std::isfinite(command_Nm[j])) {
      throw std::invalid_argument(robot.joints[j].name + ": the torque asked for is not a finite number");
    }
    motor_speed_rad_per_s[j] = data->qvel[velocity_address[j]];
  }
  motors.step(command_Nm, motor_speed_rad_per_s, conditions.body.torque_factor * supply);
  std::ranges::copy(motors.sensed_Nm(), sensors.motor_current_Nm.begin());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    // In single precision, so that a record of the torques replays to the bit.
    const double torque = static_cast<double>(static_cast<float>(motors.torque_Nm()[j]));
    sensors.motor_torque_Nm[j] = torque;
    data->qfrc_applied[velocity_address[j]] = torque;
  }
}

std::vector<JointTruth> Plant::Implementation::joint_truth() const {
  std::vector<JointTruth> truth;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const MotorModel::Joint& motor = motors.joint(j);
    truth.push_back({.torque_constant_factor = motor.torque_constant_factor,
                     .friction_factor = motor.friction_factor,
                     .damping_factor = motor.damping_factor,
                     .current_gain = motor.current_gain,
                     .current_offset_Nm = motor.current_offset_Nm,
                     .servo_stiffness_factor = servos.stiffness[j],
                     .servo_damping_factor = servos.damping[j]});
  }
  return truth;
}

}  // namespace gaitway::simulator
