// Where every link, the soles and the whole body's centre of mass are, for given joint angles: one pass over
// the tree.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// All results are in the base frame (links[0]) and hold until the next compute(). After construction nothing
// allocates. Not thread-safe; one object a thread. Keeps no reference to the model.
class ForwardKinematics {
 public:
  explicit ForwardKinematics(const RobotModel& model);  // at the home posture

  // position_rad: one angle for each joint, in the model's order; size must be the number of joints.
  void compute(std::span<const double> position_rad) noexcept;

  [[nodiscard]] const Eigen::Matrix3d& link_rotation(int link) const noexcept {  // link to base
    return poses_[static_cast<std::size_t>(link)].rotation;
  }
  [[nodiscard]] const Eigen::Vector3d& link_position_m(int link) const noexcept {
    return poses_[static_cast<std::size_t>(link)].position_m;
  }
  [[nodiscard]] Eigen::Isometry3d link_pose(int link) const noexcept;
  // Unit vector, base frame. A joint's axis is the same in the frame of its child link, through whose origin
  // it goes.
  [[nodiscard]] Eigen::Vector3d joint_axis(const RobotModel& model, int joint) const noexcept {
    const Joint& turned = model.joints[static_cast<std::size_t>(joint)];
    return link_rotation(turned.child_link) * turned.axis;
  }
  [[nodiscard]] Eigen::Isometry3d sole_pose(Side side) const noexcept;
  [[nodiscard]] const Eigen::Vector3d& com_m() const noexcept { return com_m_; }  // of the whole body

 private:
  struct Pose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  };
  enum class AxisKind : std::uint8_t { x, y, z, general };
  struct Step {  // from a parent link over a joint to its child; the child's index is the step's plus one
    std::size_t parent = 0;
    AxisKind axis_kind = AxisKind::general;
    bool turned_origin = false;  // origin_rotation is not the identity
    Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d origin_rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double sign = 1.0;                                  // of the axis, where it is x, y or z
    Eigen::Vector3d share_m = Eigen::Vector3d::Zero();  // child's CoM times its share of the whole mass
    double share = 0.0;                                 // child's share of the whole mass
  };

  static void turn(Eigen::Matrix3d& rotation, const Step& step, double angle_rad) noexcept;

  std::vector<Step> steps_;
  std::vector<Pose> poses_;
  Eigen::Vector3d base_share_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d com_m_ = Eigen::Vector3d::Zero();
  std::array<std::size_t, 2> foot_link_{};
  std::array<Eigen::Isometry3d, 2> sole_{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
};

// Of the whole body's CoM above the soles, at the home posture. Throws std::invalid_argument if it is not
// above them.
[[nodiscard]] double home_com_height_m(const RobotModel& model);

}  // namespace gaitway::urdf
