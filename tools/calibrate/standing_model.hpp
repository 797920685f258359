// What a robot with given deviations should measure in a pose, against what it did measure.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "tools/calibrate/calibration_settings.hpp"
#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {

// Where the right sole is from the left one, on the floor; how the floor leans; how it gives way.
struct Ground {
  Eigen::Vector3d placement = Eigen::Vector3d::Zero();  // x, y in m, yaw in rad, in the left sole's frame
  // Of its normal: towards x and y of the left sole.
  Eigen::Vector2d floor_tilt_rad = Eigen::Vector2d::Zero();
  std::array<double, 2> sole_compliance_m_per_N{};  // [Side]
};

// One pose as it would be without errors of a single measurement: each entry of `noise`, in its own standard
// deviations, is one such error. So the residuals' covariance follows from their sensitivity to it, with all
// that one error does to several of them. Not thread-safe.
class StandingModel {
 public:
  // Keeps references to all three. The robot is the described one, without calibration.
  StandingModel(const urdf::RobotModel& robot, const StandingMeasurement& measurement,
                const StandingDeviations& deviations);

  [[nodiscard]] Eigen::Index residual_count() const noexcept { return residual_count_; }
  [[nodiscard]] Eigen::Index noise_count() const noexcept { return noise_count_; }
  // Feet that may stand on an edge.
  [[nodiscard]] int feet_on_edge() const noexcept;
  [[nodiscard]] bool both_stand() const noexcept { return measurement_.stands[0] && measurement_.stands[1]; }

  // SI units. All are zero for the right deviations, ground and noise.
  [[nodiscard]] Eigen::VectorXd residuals(const RobotDeviations& robot, const Ground& ground,
                                          const Eigen::VectorXd& noise);
  // Of the residuals, from a unit covariance of the noise.
  [[nodiscard]] Eigen::MatrixXd covariance(const RobotDeviations& robot, const Ground& ground);
  // Where the feet are if the robot is as given.
  [[nodiscard]] Eigen::Vector3d placement(const RobotDeviations& robot);

 private:
  class Noise;
  struct Stance {
    std::array<Eigen::Isometry3d, 2> sole;  // in the base frame
    std::array<Eigen::Vector3d, 2> normal;  // of the floor, as each sole has it
    std::array<double, 2> sink_m{};         // of each sole's middle below the floor
    Eigen::Vector3d floor_up, up;           // the floor's normal, against gravity
  };
  [[nodiscard]] Stance stance(const RobotDeviations& robot, const Ground& ground, Noise& noise);
  void press_sole(const RobotDeviations& robot, const Ground& ground, std::size_t side, Noise& noise,
                  Stance& at) const;
  void add_trunk(const RobotDeviations& robot, const Stance& stance, Noise& noise);
  void add_feet(const Stance& stance, const Ground& ground, Noise& noise);
  void add_forces(const RobotDeviations& robot, const Stance& stance, Noise& noise);
  [[nodiscard]] Eigen::Vector3d com_m(const RobotDeviations& robot, double mass_kg) const;
  [[nodiscard]] bool on_edge(std::size_t side) const;
  void add(double residual) { residuals_[filled_++] = residual; }

  const urdf::RobotModel& robot_;
  const StandingMeasurement& measurement_;
  const StandingDeviations& deviations_;
  std::array<bool, 2> on_edge_{};
  urdf::ForwardKinematics kinematics_;
  std::vector<double> joint_rad_;
  Eigen::Index residual_count_ = 0, noise_count_ = 0;
  Eigen::VectorXd residuals_;
  Eigen::Index filled_ = 0;
};

// x, y and yaw of a pose in the plane of another's x and y.
[[nodiscard]] Eigen::Vector3d planar(const Eigen::Isometry3d& pose);

}  // namespace gaitway::calibration
