// The simulated motors as such parts are: with a torque constant that nobody knows exactly, gears that lose
// torque, windings that get hot, one supply that sags under them, and sensors of their current.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

// By what a motor with gear and drive differs from an ideal one, at a mismatch of 1.
struct MotorDeviations {
  double torque_constant = 0.10;   // ± uniform: tolerance of magnets and windings in data sheets
  double gear_loss = 0.10;         // of the torque: three planetary stages of 0.965 have 0.9 together
  double friction_octaves = 1.0;   // ± uniform, of dry and of viscous friction: grease, preload, temperature
  double derating_depth = 0.4;     // what a hot drive takes away of the torque limit
  double supply_sag = 0.10;        // of the supply's voltage, at the reference power
  double current_gain = 0.05;      // ± uniform: shunt and amplifier
  double current_offset = 0.0125;  // σ, of the torque limit: 0.1 of humanoid22's 8 N·m
  double current_noise = 0.0125;   // σ of one sample, of the torque limit; of the robot's noise, not drawn
  double servo_common = 0.15;      // ± uniform: one series of drives has one error of its gains...
  double servo_individual = 0.05;  // ± uniform: ...and each drive a little of its own
};
inline constexpr MotorDeviations kMotorDeviations{};

// What is the same for all motors. The heat's unit is what the continuous torque leads to in the end.
struct MotorConstants {
  // Servos of this size give half of what they have for as long as one likes. A walking knee of humanoid22
  // needs 2.4 of its 8 N·m (RMS): it settles at a heat of (2.4 / 4)² = 0.36, so that no walk takes torque
  // away.
  double continuous_share = 0.5;  // of the torque limit
  // Of the winding with its housing. From cold, the full torque is there for 17 s.
  double thermal_time_s = 60.0;
  double derating_begins = 1.0, derating_ends = 1.3;  // heat; linear in between
  // Of the supply: a battery's leads and the drives' capacitors. Slower than a step, so no loop is algebraic.
  double supply_time_s = 0.005;
  // At the reference power all motors of the legs give this share of their torque at this share of their
  // speed.
  double reference_share = 0.5;
};
inline constexpr MotorConstants kMotorConstants{};

// Factors on each servo's described gains.
struct ServoFactors {
  std::vector<double> stiffness, damping;
};
// Stiffness and damping differ by the same rules and apart from each other. No damping is more than a bare
// rotor bears: the servo takes less than half of its speed in a servo period, or as the description has it.
[[nodiscard]] ServoFactors draw_servo_factors(const urdf::RobotModel& robot, std::uint64_t seed,
                                              double mismatch);

class MotorModel {
 public:
  // `mismatch` scales all deviations; at 0 the motors give what is asked up to their limits of torque and
  // speed, and the sensors tell it. `current_noise`: the sensors scatter.
  MotorModel(const urdf::RobotModel& robot, std::uint64_t seed, double mismatch, bool current_noise);

  // One physics step: what each motor gives of the torque that it is asked for, at its joint's speed.
  // `torque_factor`: of all torque limits. No allocation.
  void step(std::span<const double> asked_Nm, std::span<const double> speed_rad_per_s,
            double torque_factor) noexcept;

  // At the joint, gear included, its friction not.
  [[nodiscard]] std::span<const double> torque_Nm() const noexcept { return torque_Nm_; }
  // What the sensors say of the motors' currents, in torque by the nominal torque constant.
  [[nodiscard]] std::span<const double> sensed_Nm() const noexcept { return sensed_Nm_; }

  struct Joint {
    double torque_limit_Nm = 0.0, speed_limit_rad_per_s = 0.0;
    double torque_constant_factor = 1.0;
    double friction_factor = 1.0, damping_factor = 1.0;  // of dry and of viscous friction
    double current_gain = 1.0, current_offset_Nm = 0.0;
    double gear_speed_rad_per_s = 0.0;  // well above it the gear's loss is whole
  };
  [[nodiscard]] const Joint& joint(std::size_t index) const noexcept { return joints_[index]; }
  [[nodiscard]] double heat(std::size_t joint) const noexcept { return heat_[joint]; }
  // Of the supply, 1 without load.
  [[nodiscard]] double voltage() const noexcept { return voltage_; }
  // Electrical, of all motors, at which the supply sags by its reference.
  [[nodiscard]] double reference_power_W() const noexcept { return reference_power_W_; }

 private:
  void draw(const urdf::RobotModel& robot, facts::RandomStream& random, double mismatch);
  [[nodiscard]] double current_torque_Nm(std::size_t joint, double asked_Nm, double speed_rad_per_s,
                                         double torque_factor) const noexcept;
  [[nodiscard]] double after_gear_Nm(const Joint& joint, double torque_Nm,
                                     double speed_rad_per_s) const noexcept;

  std::vector<Joint> joints_;
  facts::RandomStream noise_random_;
  bool current_noise_;
  double gear_loss_, derating_depth_, supply_sag_;
  double heat_blend_, supply_blend_;  // of a step
  double reference_power_W_ = 0.0;
  double voltage_ = 1.0;
  std::vector<double> heat_, torque_Nm_, sensed_Nm_;
};

}  // namespace gaitway::simulator
