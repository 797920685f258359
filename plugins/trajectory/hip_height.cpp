// A quintic to each new goal.
#include "gaitway/trajectory/hip_height.hpp"

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

void HipHeight::aim(double goal_m, int points) noexcept {
  goal_m_ = goal_m;
  path_ = Quintic(now_, {goal_m}, points * facts::kSlot_s);
  gone_points_ = 0;
  path_points_ = points;
}

void HipHeight::advance() noexcept {
  if (now_.position == goal_m_) return;
  ++gone_points_;
  now_ = gone_points_ < path_points_ ? path_.at(gone_points_ * facts::kSlot_s) : MotionState{goal_m_};
}

}  // namespace gaitway::trajectory
