// What a planned motion asks of motors and ground, point by point, from the points alone.
#pragma once

#include <array>

#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/motion_plan.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::motion {

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

}  // namespace gaitway::motion
