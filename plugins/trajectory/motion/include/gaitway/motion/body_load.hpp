// What one instant of a motion asks of motors and ground, from three postures in a row.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/whole_body_dynamics.hpp"

namespace gaitway::motion {

struct BodyPosture {
  Eigen::VectorXd joint_rad;
  Eigen::Isometry3d pelvis = Eigen::Isometry3d::Identity();
};

struct BodyLoad {
  Eigen::VectorXd speed_rad_per_s, acceleration_rad_per_s2;
  // From here on only where the robot stands on flat feet.
  Eigen::VectorXd torque_Nm;
  Eigen::Vector2d zmp_m = Eigen::Vector2d::Zero();
  double normal_force_N = 0.0;
  double friction_ratio = 0.0;  // tangential over normal force
};

class BodyLoadCalculator {
 public:
  explicit BodyLoadCalculator(const urdf::RobotModel& robot);

  // The postures are `interval_s` apart; the load is that of the middle one. Soles [Side] in the motion's
  // frame.
  const BodyLoad& compute(const std::array<BodyPosture, 3>& posture, double interval_s, Contact contact,
                          const std::array<Eigen::Isometry3d, 2>& sole);

  [[nodiscard]] double weight_N() const noexcept { return dynamics_.weight_N(); }

 private:
  void stand(const std::array<BodyPosture, 3>& posture, double interval_s, Contact contact,
             const std::array<Eigen::Isometry3d, 2>& sole);

  std::array<urdf::Foot, 2> feet_;
  WholeBodyDynamics dynamics_;
  BodyMotion motion_;
  BodyLoad load_;
};

}  // namespace gaitway::motion
