// Inverse dynamics of the whole robot with a moving pelvis: recursive Newton-Euler over the robot model.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::motion {

// Everything in the motion's frame: its z axis points up.
struct BodyMotion {
  Eigen::Isometry3d pelvis = Eigen::Isometry3d::Identity();
  Eigen::Vector3d angular_velocity_rad_per_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_acceleration_rad_per_s2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_m_per_s2 = Eigen::Vector3d::Zero();  // of the pelvis frame's origin
  Eigen::VectorXd joint_rad, speed_rad_per_s, acceleration_rad_per_s2;
};

// Force, and moment about the frame's origin.
struct Wrench {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment_Nm = Eigen::Vector3d::Zero();
};

// R. Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 5 and 9. KDL's solver takes a base that stands
// still.
class WholeBodyDynamics {
 public:
  explicit WholeBodyDynamics(const urdf::RobotModel& robot);

  // What the ground must give in all, so that the robot moves like this.
  Wrench move(const BodyMotion& motion);

  // Torques of the motors for the motion last given, if the ground gives these wrenches to the feet [Side].
  // The motor also moves its own rotor and overcomes its friction.
  void torques(const std::array<Wrench, 2>& foot, Eigen::VectorXd& torque_Nm);

  [[nodiscard]] double weight_N() const noexcept { return weight_N_; }

 private:
  struct Body {
    Eigen::Matrix3d rotation;
    Eigen::Vector3d position_m, angular_velocity, angular_acceleration, acceleration;
    Wrench wrench;  // needed to move this link alone
  };
  void move_link(std::size_t link);

  std::vector<urdf::Link> links_;
  std::vector<urdf::Joint> joints_;
  std::array<int, 2> foot_link_{};
  double weight_N_ = 0.0;
  std::vector<Body> bodies_;
  std::vector<Eigen::Vector3d> axes_;  // of the joints, in the motion's frame
  std::vector<Wrench> below_;          // through each link, with all that hangs on it
  BodyMotion motion_;
};

}  // namespace gaitway::motion
