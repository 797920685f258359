// Which links of the robot run into each other in a posture.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/kinematic/convex_shape.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematic {

struct LinkContact {
  int one = 0, other = 0;  // indices into RobotModel::links, one < other
  double depth_m = 0.0;
};

// Collision shapes against each other, but for those of links that are neighbours (one hangs on the other by
// at most two joints, or no third link with a shape is between them) or are in one another at the home
// posture already.
class SelfCollision {
 public:
  // Throws urdf::RobotError when a mesh cannot be read.
  explicit SelfCollision(const urdf::RobotModel& robot);

  // At the posture that `kinematics` has computed: the deepest place of each pair. Holds until the next call.
  const std::vector<LinkContact>& find(const urdf::ForwardKinematics& kinematics);

  // Pairs of links that are looked at, and those that are not since they overlap at home.
  [[nodiscard]] std::size_t pairs() const noexcept { return pairs_.size(); }
  [[nodiscard]] const std::vector<std::pair<int, int>>& overlapping_at_home() const noexcept {
    return at_home_;
  }

 private:
  struct Body {
    int link;
    std::vector<ConvexShape> shapes;
    std::vector<Eigen::Isometry3d> in_link;  // of each shape
    std::vector<Eigen::Isometry3d> poses;    // of each shape, as placed last
  };
  void place(const urdf::ForwardKinematics& kinematics) noexcept;
  [[nodiscard]] static double depth_m(const Body& one, const Body& other);

  std::vector<Body> bodies_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // indices into bodies_
  std::vector<std::pair<int, int>> at_home_;
  std::vector<LinkContact> found_;
};

}  // namespace gaitway::kinematic
