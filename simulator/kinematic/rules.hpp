// The rules that a played trajectory is held to, row by row.
#pragma once

#include "gaitway/kinematic/play.hpp"
#include "gaitway/kinematic/self_collision.hpp"
#include "gaitway/kinematic/standing.hpp"
#include "gaitway/motion/motion_limits.hpp"

namespace gaitway::kinematic {

class RuleBook {
 public:
  // Keeps references to all of them.
  RuleBook(const urdf::RobotModel& robot, const Trajectory& trajectory, const Checks& checks, Course& course);

  void check_joints(std::size_t row);
  void check_torques(std::size_t row);
  void check_collisions(std::size_t row, const std::vector<LinkContact>& contacts);
  void check_soles(std::size_t row, const Standing& standing, const SolePoses& sole_in_base);
  void check_zmp(std::size_t row);
  [[nodiscard]] std::vector<Finding> findings() { return found_.take(); }

 private:
  void check_position(std::size_t row, std::size_t joint, double angle_rad);
  void check_speed(std::size_t row, std::size_t joint);
  void check_count_step(std::size_t row, std::size_t joint);

  const urdf::RobotModel& robot_;
  const Trajectory& trajectory_;
  const Checks& checks_;
  Course& course_;
  motion::JointLimits limits_;
  FindingList found_;
  std::array<Eigen::Isometry3d, 2> stood_;  // [Side]: where the sole began to stand
};

}  // namespace gaitway::kinematic
