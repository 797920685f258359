// Each point with its two neighbours.
#include "gaitway/motion/plan_loads.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::motion {

// Where only one of two neighbours stands, the robot rests, so that its pelvis is that of the other.
BodyPosture PlanLoads::posture(std::size_t at, std::size_t point) const {
  const std::span<const double> angles = plan_.point(at);
  return {Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size())),
          plan_.pelvis[plan_.contact[at] == Contact::none ? point : at]};
}

const BodyLoad& PlanLoads::at(std::size_t point) {
  const std::size_t before = point == 0 ? 0 : point - 1;
  const std::size_t after = std::min(point + 1, plan_.point_count() - 1);
  if (plan_.contact[point] != Contact::none) {
    kinematics_.compute(plan_.point(point));
    for (const urdf::Side side : urdf::kSides) {
      soles_[static_cast<std::size_t>(side)] = plan_.pelvis[point] * kinematics_.sole_pose(side);
    }
  }
  return loads_.compute({posture(before, point), posture(point, point), posture(after, point)},
                        facts::kSlot_s, plan_.contact[point], soles_);
}

}  // namespace gaitway::motion
