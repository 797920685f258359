// What a motion asks of motors and ground, instant by instant, and how far references must lead compliant
// servos.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_plan.hpp"
#include "gaitway/motion/whole_body_dynamics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

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
  // The same of a motion whose derivatives are known. Contact::none: torque and ground stay as they were.
  const BodyLoad& compute(const BodyMotion& motion, Contact contact,
                          const std::array<Eigen::Isometry3d, 2>& sole);

  [[nodiscard]] double weight_N() const noexcept { return dynamics_.weight_N(); }

 private:
  void stand(Contact contact, const std::array<Eigen::Isometry3d, 2>& sole);

  std::array<urdf::Foot, 2> feet_;
  WholeBodyDynamics dynamics_;
  BodyMotion motion_;
  BodyLoad load_;
};

// What a planned motion asks of motors and ground, point by point, from the points alone.
class PlanLoads {
 public:
  // Keeps references to both.
  PlanLoads(const urdf::RobotModel& robot, const MotionPlan& plan)
      : plan_(plan), kinematics_(robot), loads_(robot) {}

  // Holds until the next call.
  const BodyLoad& at(std::size_t point);
  // [Side], of the point last asked for, where the robot stands.
  [[nodiscard]] const std::array<Eigen::Isometry3d, 2>& soles() const noexcept { return soles_; }
  [[nodiscard]] double weight_N() const noexcept { return loads_.weight_N(); }

 private:
  [[nodiscard]] BodyPosture posture(std::size_t at, std::size_t point) const;

  const MotionPlan& plan_;
  urdf::ForwardKinematics kinematics_;
  BodyLoadCalculator loads_;
  std::array<Eigen::Isometry3d, 2> soles_{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
};

// The references with which compliant servos move as planned.
// A servo gives a torque only by lagging behind its reference. So that the joint and not the reference is
// where the plan wants it, the reference leads by what the planned torque takes, beyond what standing at home
// takes: rows as the plan's, equal to them where the robot stands at home, and where its contact is none.
[[nodiscard]] std::vector<double> leading_references(const urdf::RobotModel& robot, const MotionPlan& plan);

}  // namespace gaitway::motion
