// The loop that the trims close about the pitch of a standing trunk, and the gains at which it is stable.
#pragma once

#include <Eigen/Core>

#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// A linear model at the home posture, both soles fixed: the legs' pitch joints turn in pairs, and every joint
// that is not a leg's stays where its servo holds it, like them on its spring and damper with the masses and
// rotors that it moves. Gravity is left out: what this model is for is faster. The trunk's pitch and pitch
// rate are sampled every time slot, go through the gains, and the trims go to what comes out evenly over the
// slot after the next SYNC, their rate fed forward. A light trunk on strong hips answers within one slot: too
// large a rate gain and the robot chatters.
class TrimLoop {
 public:
  explicit TrimLoop(const urdf::RobotModel& robot);

  // By how much what is slowest to fade is left after a time slot; above 1 it grows. Ankle and hip pitch
  // count.
  [[nodiscard]] double left_after_slot(const BalanceParameters& parameters) const;

 private:
  Eigen::MatrixXd before_frame_,
      after_frame_;                        // state over the parts of a slot before and after the trim frame
  Eigen::RowVectorXd pitch_, pitch_rate_;  // of the trunk, from the state
};

// The defaults scaled to the robot's body (BodyScale); the hips' rate gain about pitch less by as much as the
// TrimLoop needs to fade.
[[nodiscard]] BalanceParameters balance_of(const urdf::RobotModel& robot);

}  // namespace gaitway::stability
