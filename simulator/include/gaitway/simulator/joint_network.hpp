// All local controllers of the simulated robot: each with its own drifting clock, its encoder and sensor
// channels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/station_transmitter.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

// Configuration of the local controller of joint `joint` (index into RobotModel::joints), standing at home,
// as it is described.
localcontroller::JointConfig joint_config(const urdf::RobotModel& robot, int joint);

class JointNetwork {
 public:
  // Clock drifts are drawn from the seed, uniform within ±`largest_drift_ppm`, and so are the servos' gains,
  // which differ from the description's by `mismatch` times what drives of one kind differ by
  // (BodyTruth::joints of a plant of the same seed and mismatch tells them).
  JointNetwork(const urdf::RobotModel& robot, std::uint64_t seed, double largest_drift_ppm,
               double mismatch = 0.0);

  // One servo period of every joint at the true time `now_ns`; the torques are in torque_Nm() afterwards.
  void step(std::int64_t now_ns, const PlantSensors& plant) noexcept;
  // What the electronics of one joint read from the plant.
  [[nodiscard]] localcontroller::JointSensors sensors(int joint, const PlantSensors& plant) const noexcept;
  // A frame from the bus reaches one joint.
  void on_frame(int joint, const can::Frame& frame, std::int64_t now_ns) noexcept;
  // Without power a joint hears, says and does nothing.
  void power_off(int joint) noexcept;
  // With power it holds where its encoder, an absolute one, says that it is.
  void power_on(int joint, const PlantSensors& sensors) noexcept;
  // Keeps a joint's most urgent frame in its station's transmit buffer; a feedback frame does not wait behind
  // its own fault report.
  void offer(int joint, can::StationTransmitter& transmitter, can::SimulatedBus& bus,
             std::int64_t now_ns) noexcept;
  // The next frame that a joint has to send; false when there is none.
  bool take_frame(int joint, can::Frame& frame) noexcept;

  [[nodiscard]] std::span<const double> torque_Nm() const noexcept { return torque_Nm_; }
  [[nodiscard]] localcontroller::JointController& joint(int index) noexcept {
    return joints_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const localcontroller::JointController& joint(int index) const noexcept {
    return joints_[static_cast<std::size_t>(index)];
  }
  // What its electronics was configured with; its gains are the true ones.
  [[nodiscard]] const localcontroller::JointConfig& config(int index) const noexcept {
    return configs_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] int size() const noexcept { return static_cast<int>(joints_.size()); }
  // The joint's own clock at a true time.
  [[nodiscard]] std::int64_t local_time_ns(int joint, std::int64_t now_ns) const noexcept;

 private:
  std::vector<localcontroller::JointConfig> configs_;
  std::vector<bool> powered_;
  std::vector<std::array<urdf::SensorChannel, 2>> channels_;
  std::vector<localcontroller::JointController> joints_;
  std::vector<double> clock_rate_;
  std::vector<double> torque_Nm_;
};

}  // namespace gaitway::simulator
