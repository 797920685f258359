// Sensors that tell something else than what is: what the joints' controllers are given in place of the truth.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "gaitway/simulator/plant.hpp"
#include "gaitway/simulator/scenario_event.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

class SensorFaults {
 public:
  // Outlived by `robot`.
  SensorFaults(const urdf::RobotModel& robot, std::uint64_t seed);

  // From now on, with what the sensors tell now. A sensor has one fault: a newer one takes its place.
  void begin(const SensorFault& fault, const PlantSensors& now, std::int64_t now_ns);
  // What is told of `truth`; the truth itself while nothing fails.
  [[nodiscard]] const PlantSensors& told(const PlantSensors& truth, std::int64_t now_ns);

 private:
  struct Active {
    SensorFault fault;
    std::int64_t until_ns = 0;
    PlantSensors frozen;  // what it tells, where it freezes
  };
  void distort(const Active& active);
  void distort_imu(const Active& active);
  void distort_foot(const Active& active, std::size_t foot);
  void distort_encoder(const Active& active, std::size_t joint);
  [[nodiscard]] double noise(double sigma);

  const urdf::RobotModel& robot_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::vector<Active> active_;
  PlantSensors told_;
};

}  // namespace gaitway::simulator
