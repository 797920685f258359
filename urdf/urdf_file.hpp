// robot.urdf as read and checked on its own.
#pragma once

#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "urdf_syntax.hpp"

namespace gaitway::urdf {

struct UrdfJoint {
  Joint joint;  // geometry and limits; link indices and the network's part are still empty
  std::string parent_link, child_link;
  double effort_limit_Nm = 0.0;
  int line = 0;
};

struct UrdfFile {
  std::filesystem::path file;
  std::string name;
  std::string base_link;
  std::vector<Link> links;  // in the order of their names
  std::vector<UrdfJoint> joints;
  UrdfLines lines;
};

// Throws RobotError.
[[nodiscard]] UrdfFile read_urdf_file(const std::filesystem::path& file);

}  // namespace gaitway::urdf
