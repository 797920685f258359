// The room that a step takes, as seen from above.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gaitway/planning/limits.hpp"

namespace gaitway::planning {

// Of one of the limits' bands: the convex hull, counter-clockwise, of the body over the stance foot, between
// the feet and over the landed foot; without clearance.
[[nodiscard]] std::vector<Eigen::Vector2d> swept_body(const Limits& limits, std::size_t band,
                                                      const Pose& stance, Side stance_side,
                                                      const Pose& landing);

}  // namespace gaitway::planning
