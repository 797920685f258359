// A maker's URDF (importer/maker_robot.hpp). Whatever the text: it is refused with input::InputError and
// nothing else, or gives a tree of links, parents first, whose numbers are numbers, also after all joints are
// held still.
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/importer/maker_robot.hpp"
#include "gaitway/input/complaint.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {
namespace {

void require_numbers(const importer::Surface& surface) {
  for (const Eigen::Vector3d& point : surface.point_m) {
    require(point.allFinite(), "points are numbers");
  }
  for (const std::array<int, 3>& corners : surface.triangle) {
    for (const int corner : corners) {
      require(corner >= 0 && static_cast<std::size_t>(corner) < surface.point_m.size(), "corners are points");
    }
  }
}

double checked_mass_kg(const importer::MakerRobot& robot) {
  require(robot.links.size() == robot.joints.size() + 1, "links and joints are a tree");
  double mass_kg = 0.0;
  for (const importer::MakerLink& link : robot.links) {
    require(std::isfinite(link.mass_kg) && link.mass_kg >= 0.0 && link.com_m.allFinite() &&
                link.inertia_kg_m2.allFinite(),
            "masses are numbers");
    mass_kg += link.mass_kg;
    for (const importer::VisualSurface& visual : link.visual) {
      require_numbers(visual.surface);
    }
    for (const importer::Surface& collision : link.collision) {
      require_numbers(collision);
    }
    for (const auto& [name, pose] : link.frames) {
      require(pose.matrix().allFinite(), "frames are poses");
    }
  }
  return mass_kg;
}

void require_joints(const importer::MakerRobot& robot) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const importer::MakerJoint& joint = robot.joints[i];
    require(joint.child_link == static_cast<int>(i) + 1 && joint.parent_link >= 0 &&
                joint.parent_link < joint.child_link,
            "parents come before children");
    require(joint.origin.matrix().allFinite() && std::abs(joint.axis.norm() - 1.0) < 1e-9, "axes are unit");
    require(joint.lower_rad.value_or(-1e9) <= joint.upper_rad.value_or(1e9), "limits are in order");
    require(joint.velocity_rad_per_s.value_or(1.0) > 0.0 && joint.effort_Nm.value_or(1.0) > 0.0,
            "zero is no limit");
  }
}

}  // namespace

void maker_urdf(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  importer::MakerRobot robot;
  try {
    robot = importer::read_maker_urdf(file.path(), {});
  } catch (const input::InputError&) {
    return;
  }
  const double mass_kg = checked_mass_kg(robot);
  require_joints(robot);
  const importer::MakerRobot still =
      hold_still(robot, std::vector<std::optional<double>>(robot.joints.size(), 0.5));
  require(still.links.size() == 1, "all held still is one body");
  require(std::abs(checked_mass_kg(still) - mass_kg) <= 1e-9 * mass_kg, "no mass is lost");
}

}  // namespace gaitway::fuzz
