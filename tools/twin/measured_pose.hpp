// Where a robot that is watched stands in its map: its own dead reckoning, put where its navigation says that
// it is.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/twin/robot_news.hpp"

namespace gaitway::tools {

class MeasuredPose {
 public:
  explicit MeasuredPose(const urdf::RobotModel& robot) : kinematics_(robot) {}

  void take(const MeasuredPoint& point);
  // The robot is not heard of, or has another life.
  void forget();

  // Of its base in the map, whose ground is z = 0; nothing: not known yet.
  [[nodiscard]] std::optional<Eigen::Isometry3d> base() const;
  // rad, in the model's order; empty: not known yet.
  [[nodiscard]] const std::vector<double>& joints() const noexcept { return joints_rad_; }

 private:
  [[nodiscard]] Eigen::Isometry3d middle_of_feet();  // in the robot's odometry, level

  urdf::ForwardKinematics kinematics_;
  std::vector<double> joints_rad_;
  std::optional<Eigen::Isometry3d> base_in_odometry_;
  std::optional<Eigen::Isometry3d> map_from_odometry_;  // nothing: the map begins where odometry does
};

}  // namespace gaitway::tools
