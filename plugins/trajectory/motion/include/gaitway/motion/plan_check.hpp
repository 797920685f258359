// Checks a planned motion at every point, from the points alone: whatever made them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gaitway/motion/motion_limits.hpp"
#include "gaitway/motion/motion_plan.hpp"

namespace gaitway::motion {

enum class LimitKind : std::uint8_t {
  position,
  speed,
  acceleration,
  torque,
  zmp,
  friction,
  weight,
  foot_place,
};

// How near the motion comes to a limit: the worst point.
struct LimitUse {
  LimitKind kind = LimitKind::position;
  std::string what;  // the joint, or what else is limited
  std::string unit;
  double time_s = 0.0;
  double value = 0.0, limit = 0.0;  // in the unit
  double excess = -1e9;             // in the unit; > 0: the limit does not hold
};

struct PlanReport {
  std::vector<LimitUse> uses;  // one for each kind that could be checked

  [[nodiscard]] const LimitUse* broken() const noexcept;  // the first limit that does not hold, or none
};

[[nodiscard]] std::string_view name_of(LimitKind kind) noexcept;
// E.g. "left_knee: torque 9.1 N·m at 1.23 s, limit 6.4 N·m".
[[nodiscard]] std::string describe(const LimitUse& use);

[[nodiscard]] PlanReport check_plan(const urdf::RobotModel& robot, const MotionPlan& plan,
                                    const MotionLimits& limits);

}  // namespace gaitway::motion
