// How a motion is left before its end: from each batch's end a way to rest that keeps the limits, too.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "gaitway/motion/motion_plan.hpp"

namespace gaitway::motion {

// From the end of the batch: so many points further, then along `way`.
struct PlannedExit {
  std::size_t go_on_points = 0;
  std::optional<std::size_t> way;  // index into ExitPlan::ways; none: on to the motion's end
};

struct ExitPlan {
  std::vector<PlannedExit> exits;  // one for each batch of the motion, and one for its end
  std::vector<MotionPlan> ways;    // whole batches; only their points, without keys
};

// `plan`: whole batches after its first point. Where both feet stand, the fastest way home that the limits
// allow is looked for, from the posture and the speed of that point; the exit is the sooner of it and of
// going on to where there is one. Where nothing stands, the joints come to rest where they are. Throws
// MotionError when from some point the robot would not rest within `longest_points`.
[[nodiscard]] ExitPlan plan_exits(const urdf::RobotModel& robot, const MotionPlan& plan,
                                  const MotionLimits& limits, std::size_t batch_points,
                                  std::size_t longest_points);

}  // namespace gaitway::motion
