// Whether a joint plan may be handed over: every point of batch and safe tail against the robot's limits and
// the wire's.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::core {

enum class JointPlanRule : std::uint8_t {
  none,            // fine
  joint_count,     // not the robot's number of joints
  tail_count,      // more points than a plan holds
  support,         // neither left, right nor both
  finite,          // not a number, or infinite
  position_limit,  // outside the joint's limits
  continuity,      // the first point is further from the joint's reference than a time slot allows
  velocity_limit,  // the change in one time slot needs more than the joint's velocity limit
  count_range      // the change in one time slot does not fit the signed byte of a trajectory frame
};

struct JointPlanVerdict {
  JointPlanRule rule = JointPlanRule::none;  // that the first bad point breaks
  int joint = -1;
  int point = -1;       // 0..7: batch; from 8 on: safe tail
  double value = 0.0;   // what was found: rad, rad/s, counts or a number
  double lowest = 0.0;  // what is allowed
  double highest = 0.0;
  std::uint64_t refused_points = 0;  // of all joints that break a rule

  [[nodiscard]] bool accepted() const noexcept { return rule == JointPlanRule::none; }
};

class JointPlanCheck {
 public:
  explicit JointPlanCheck(const urdf::RobotModel& robot);

  // `start_rad`: reference of each joint where the batch begins; empty: not known, then the first point's
  // change is not checked. Rounding to the wire's counts is allowed for: a change may exceed the velocity
  // limit by one count. For the cycle: no allocation, at most kMaxPoints x joints comparisons.
  [[nodiscard]] JointPlanVerdict check(const JointPlan& plan,
                                       std::span<const double> start_rad) const noexcept;

  // One line for people: joint, point, value, rule. Writes at most `to.size()` characters and returns what
  // was written. For the cycle, too.
  std::string_view describe(const JointPlanVerdict& verdict, std::span<char> to) const noexcept;

 private:
  struct Limits {
    std::string name;
    double lower_rad = 0.0;
    double upper_rad = 0.0;
    double velocity_rad_per_s = 0.0;
    double count_rad = 0.0;
  };
  [[nodiscard]] JointPlanVerdict check_step(std::size_t joint, int point, double from_rad,
                                            double to_rad) const noexcept;

  std::vector<Limits> joints_;
};

}  // namespace gaitway::core
