// What is what on a maker's robot: where forward is, which joints make the legs, which links are the feet.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {

struct LegChain {
  std::array<std::string, 6> joints;  // names, from the base to the foot
  std::string foot;                   // the link that the last of them carries
};

struct BodyPlan {
  // Of the base frame (x forward, y left, z up) in the root link's frame.
  Eigen::Matrix3d base_in_root = Eigen::Matrix3d::Identity();
  std::array<LegChain, 2> legs;          // left, right
  std::vector<std::string> beyond_feet;  // joints that a foot carries: toes
  std::vector<std::string> notes;        // what was found, a sentence each
};

struct PlanHints {
  std::optional<Eigen::Vector3d> forward;  // in the root link's frame, if it is known
};

// Finds two chains of six joints that go down from one link to the ground: three of a hip in any order, a
// knee, two of an ankle in either, each within 50 deg of the axis that it turns about, in the zero posture.
// Forward is away from where the knees fold the shins; if they bend both ways, where the feet point. Throws
// input::InputError that says what the robot lacks (too few joints, no ankles, more than two legs) or that
// forward isn't clear.
[[nodiscard]] BodyPlan find_body_plan(const MakerRobot& robot, const PlanHints& hints);

// The same robot with another frame for one of its links: turned by `new_in_old` about its origin.
[[nodiscard]] MakerRobot with_turned_frame(MakerRobot robot, std::size_t link,
                                           const Eigen::Matrix3d& new_in_old);

}  // namespace gaitway::importer
