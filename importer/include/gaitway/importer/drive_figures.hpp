// What a joint's motor and servo can do: what the URDF says of it, the rest estimated from the body.
#pragma once

#include <string>
#include <vector>

#include "gaitway/importer/body_plan.hpp"
#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {

struct DriveFigures {
  double reference_speed_rad_per_s = 0.0;  // that the wire carries and the motor reaches
  double motor_speed_rad_per_s = 0.0;
  double torque_Nm = 0.0;
  double stiffness_Nm_per_rad = 0.0, damping_Nms_per_rad = 0.0;  // of the servo
  double armature_kg_m2 = 0.0, motor_damping_Nms_per_rad = 0.0, friction_Nm = 0.0;
  double count_deg = 0.0;            // on the wire
  std::vector<std::string> guessed;  // names of what the URDF does not say: "speed", "torque"
};

// For each joint of `robot`. Servo, rotor and friction are those of humanoid22 in units of the body (mass m,
// hip height L, gravity g, omega = sqrt(g / L)): stiffness 12.4 m g L, damping 0.86 m g L / omega, armature
// 0.011 m L^2, motor damping 0.032 m g L / omega, friction 0.004 m g L; less where the motor is weaker than
// a leg's and carries little.
[[nodiscard]] std::vector<DriveFigures> drive_figures(const MakerRobot& robot, const BodyPlan& plan,
                                                      double hip_height_m);

[[nodiscard]] double total_mass_kg(const MakerRobot& robot) noexcept;

}  // namespace gaitway::importer
