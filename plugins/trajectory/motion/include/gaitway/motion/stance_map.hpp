// The coordinates in which a standing motion is planned, and the area under the soles that stand.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "gaitway/geometry/convex_hull.hpp"
#include "gaitway/kinematics/leg_solver.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::motion {

// Rotation of roll, pitch and yaw, Rz(yaw) Ry(pitch) Rx(roll), and back (pitch within ±90°).
[[nodiscard]] Eigen::Matrix3d rotation_of(const Eigen::Vector3d& attitude_rad);
[[nodiscard]] Eigen::Vector3d attitude_of(const Eigen::Matrix3d& rotation);

// Coordinates, in this order: pelvis x y z roll pitch yaw, left sole and right sole the same, the other
// joints. Frame: on the ground in the middle between the soles of the standing posture, x forward, z up.
class StanceMap {
 public:
  static constexpr Eigen::Index kPoseSize = 6;
  static constexpr Eigen::Index kPelvis = 0;
  static constexpr std::array<Eigen::Index, 2> kSole{6, 12};  // [Side]
  static constexpr Eigen::Index kOthers = 18;

  explicit StanceMap(const urdf::RobotModel& robot);

  [[nodiscard]] Eigen::Index size() const noexcept {
    return kOthers + static_cast<Eigen::Index>(others_.size());
  }
  [[nodiscard]] const std::vector<int>& other_joints() const noexcept { return others_; }

  // All joints' angles, and by how much a leg does not reach its foot, in m (0 if both do; the angles of one
  // that does not are left as they were).
  double joints(const Eigen::VectorXd& coordinates, Eigen::VectorXd& joint_rad);

  [[nodiscard]] Eigen::VectorXd coordinates(const Eigen::Isometry3d& pelvis,
                                            const std::array<Eigen::Isometry3d, 2>& sole,
                                            const Eigen::VectorXd& joint_rad) const;

 private:
  std::array<urdf::Leg, 2> legs_;
  std::array<kinematics::LegSolver, 2> solvers_;
  std::vector<int> others_;
};

// The pose in the six coordinates that begin at `first`.
[[nodiscard]] Eigen::Isometry3d pose_at(const Eigen::VectorXd& coordinates, Eigen::Index first);

// The area between and under the soles that stand, within which the ZMP must stay.
// On the ground; empty where nothing stands.
using SupportArea = geometry::ConvexHull<>;
[[nodiscard]] SupportArea support_area(const urdf::RobotModel& robot, Contact contact,
                                       const std::array<Eigen::Isometry3d, 2>& sole);

// Middle of the sole rectangle on the ground.
[[nodiscard]] Eigen::Vector2d sole_centre(const urdf::Foot& foot, const Eigen::Isometry3d& sole);

}  // namespace gaitway::motion
