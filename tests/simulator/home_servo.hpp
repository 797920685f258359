// A servo that holds the simulated robot in its home posture, for the plant's tests.
#pragma once

#include <span>
#include <vector>

#include "gaitway/simulator/plant.hpp"

namespace gaitway::simulator {

// Each joint's own servo gains on the encoder and the true velocity.
class HomeServo {
 public:
  explicit HomeServo(const urdf::RobotModel& model) : model_(model), torque_(model.joints.size()) {}

  std::span<const double> operator()(const Plant& plant) {
    // A joint with play has two hinges, the motor's first.
    const std::size_t hinges = (plant.velocities().size() - 6) / torque_.size();
    for (std::size_t j = 0; j < torque_.size(); ++j) {
      const urdf::Joint& joint = model_.joints[j];
      const double angle = plant.sensors().encoder_count[j] * joint.encoder_count_rad;
      torque_[j] = joint.servo.stiffness_Nm_per_rad * (joint.home_rad - angle) -
                   joint.servo.damping_Nms_per_rad * plant.velocities()[6 + hinges * j];
    }
    return torque_;
  }

  void hold(Plant& plant, int steps) {
    for (int i = 0; i < steps; ++i) {
      plant.step((*this)(plant));
    }
  }

 private:
  const urdf::RobotModel& model_;
  std::vector<double> torque_;
};

// Throws the whole robot upwards at 6 m/s within 50 ms, each link in proportion to its mass.
inline void throw_up(Plant& plant, const urdf::RobotModel& model) {
  for (const urdf::Link& link : model.links) {
    plant.push(link.name, Eigen::Vector3d::UnitZ(), 6.0 * link.mass_kg, 0.05);
  }
}

inline urdf::RobotModel humanoid22() {
  return urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
}

}  // namespace gaitway::simulator
