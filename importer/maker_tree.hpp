// From the elements of a maker's URDF to its tree of links.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {

struct WrittenJoint {
  MakerJoint joint;  // link indices are still empty
  std::string parent, child;
  // Pose of the child in the parent link's frame, where nothing turns.
  std::optional<Eigen::Isometry3d> rigid;
  bool carries_root = false;  // floating or planar: what carries it must be a root without mass
};

// What stands in the file, in its order.
struct WrittenRobot {
  std::filesystem::path file;
  int line = 0;
  std::string name;
  std::vector<MakerLink> links;
  std::vector<WrittenJoint> joints;
  std::vector<std::string> notes;
};

// One tree, rigid joints merged. Refuses names taken twice, joints between links that are not there, loops,
// and what is no root or has two parents.
[[nodiscard]] MakerRobot tree_of(WrittenRobot written);

// joints[i] carries links[i + 1]. Links whose joint has a rigid pose become one with the links that carry
// them.
[[nodiscard]] MakerRobot merge_rigid(MakerRobot robot,
                                     const std::vector<std::optional<Eigen::Isometry3d>>& rigid);

// `part`, which lies at `pose` in `whole`, becomes a piece of it, with all that it holds.
void merge_link(MakerLink& whole, MakerLink part, const Eigen::Isometry3d& pose);

}  // namespace gaitway::importer
