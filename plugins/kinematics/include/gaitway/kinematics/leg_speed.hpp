// The legs' references keep within the joints' speed limits: what asks a little more follows a little later.
#pragma once

#include <array>

#include "gaitway/kinematics/whole_body_placement.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// A fast step that the balance makes faster asks a knee or hip for more than it can for some points in the
// middle of its swing. Refused, the batch would cost the walk; followed later, the foot is some millimetres
// behind in the air, and there again when it lands.
class LegSpeed {
 public:
  // A joint that would be further behind than this is left as it was asked: such a batch is to be refused.
  static constexpr double kMostBehind_rad = 0.12;

  explicit LegSpeed(const urdf::RobotModel& model);

  // points: of the plan, tail included. start_rad: references of the point before the first one; nullptr: not
  // known.
  void keep(JointPlan& joint_plan, int points, const LegAngles* start_rad) const noexcept;

  // References of a point, of the legs alone.
  [[nodiscard]] LegAngles references_rad(const JointPlan& joint_plan, int point) const noexcept;

 private:
  struct Joint {
    int index = 0;          // in the model's order
    double most_rad = 0.0;  // from one point to the next
  };

  // Of all points, of what they ask.
  [[nodiscard]] static double farthest_behind_rad(const JointPlan& joint_plan, int points, const Joint& joint,
                                                  double reference_rad) noexcept;
  static void follow(JointPlan& joint_plan, int points, const Joint& joint, double reference_rad) noexcept;

  std::array<std::array<Joint, 6>, 2> joints_{};  // [Side]
};

}  // namespace gaitway::kinematics
