// robot.urdf (urdf/robot_files.hpp). Whatever the text: it is refused with urdf::RobotError and nothing else,
// or gives a tree of links whose masses and limits are numbers.
#include "urdf/robot_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "fuzz_input.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {
namespace {

bool has_link(const urdf::UrdfFile& robot, const std::string& name) {
  return std::any_of(robot.links.begin(), robot.links.end(),
                     [&name](const urdf::Link& link) { return link.name == name; });
}

}  // namespace

void urdf_file(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  urdf::UrdfFile robot;
  try {
    robot = urdf::read_urdf_file(file.path());
  } catch (const urdf::RobotError&) {
    return;
  }
  require(has_link(robot, robot.base_link), "the base is a link");
  require(robot.links.size() == robot.joints.size() + 1, "links and joints are a tree");
  for (const urdf::Link& link : robot.links) {
    require(std::isfinite(link.mass_kg) && link.mass_kg >= 0.0 && link.com_m.allFinite() &&
                link.inertia_kg_m2.allFinite(),
            "masses are numbers");
  }
  for (const urdf::UrdfJoint& joint : robot.joints) {
    require(has_link(robot, joint.parent_link) && has_link(robot, joint.child_link), "joints connect links");
    require(std::isfinite(joint.joint.lower_rad) && joint.joint.lower_rad <= joint.joint.upper_rad,
            "limits are numbers");
    require(joint.joint.origin.matrix().allFinite() && joint.joint.axis.norm() > 0.0, "axes are directions");
  }
}

}  // namespace gaitway::fuzz
