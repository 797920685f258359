// Which links of the simulated robot never touch each other. All others do, with their collision shapes.
#pragma once

#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

struct LinkPair {
  int one = 0, other = 0;  // indices in RobotModel::links, one < other
  bool operator==(const LinkPair&) const = default;
};

// So many joints apart in the tree, or fewer: where a limb bends its shapes overlap, and those of a joint
// whose axes cross lie in one another.
inline constexpr int kNeighbourJoints = 3;
[[nodiscard]] int joints_between(const urdf::RobotModel& robot, LinkPair pair);
// Of links that have shapes.
[[nodiscard]] std::vector<LinkPair> neighbouring_links(const urdf::RobotModel& robot);

// Pairs that are no neighbours, but touch in the home posture already, as in descriptions whose shapes are
// coarse: they are left out, or the robot would push itself apart. In rising order. Builds a physics model;
// throws std::runtime_error where MuJoCo refuses the robot.
[[nodiscard]] std::vector<LinkPair> links_touching_at_home(const urdf::RobotModel& robot);

}  // namespace gaitway::simulator
