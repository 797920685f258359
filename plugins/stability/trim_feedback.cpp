// Law, hips' share, fading.
#include "gaitway/stability/trim_feedback.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {

TrimFeedback::TrimFeedback(const urdf::RobotModel& model, const BalanceParameters& parameters)
    : parameters_(parameters), robot_limit_rad_(model.trim.limit_rad), matrix_(model) {}

double TrimFeedback::limit_rad() const noexcept {
  return std::min(parameters_.trim_limit_rad, robot_limit_rad_);
}

double TrimFeedback::ramp_step() const noexcept {
  return facts::kSlot_s / parameters_.ramp_s;
}

void TrimFeedback::update_hip_share(bool both_feet) noexcept {
  standing_s_ = both_feet ? standing_s_ + facts::kSlot_s : 0.0;
  const double step = standing_s_ > parameters_.standing_after_s ? ramp_step() : -ramp_step();
  hip_share_ = std::clamp(hip_share_ + step, 0.0, 1.0);
}

void TrimFeedback::update(const std::optional<msgclient::TrunkMotion>& motion, std::size_t support,
                          TrimCommand& command) noexcept {
  const bool both_feet = support == kBothFeet;
  update_hip_share(motion && both_feet);
  share_ = std::clamp(share_ + (motion ? ramp_step() : -ramp_step()), 0.0, 1.0);
  const msgclient::TrimGains gains = matrix_.gains(parameters_);
  if (motion) {
    law_rad_ = msgclient::trim_angles(gains, static_cast<int>(support), *motion, limit_rad());
    for (std::size_t c = 0; c < law_rad_.size(); ++c) {
      if (matrix_.is_hip(c)) law_rad_[c] *= hip_share_;
    }
  }
  command.channel_count = gains.channel_count;
  for (std::size_t c = 0; c < law_rad_.size(); ++c) command.angle[c] = share_ * law_rad_[c];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    command.attitude_reference[axis] = static_cast<double>(gains.attitude_reference[axis]);
  }
  for (std::size_t s = 0; s < gains.gain.size(); ++s) {
    for (std::size_t c = 0; c < law_rad_.size(); ++c) {
      for (std::size_t k = 0; k < 4; ++k) command.gain[s][c][k] = static_cast<double>(gains.gain[s][c][k]);
    }
  }
}

}  // namespace gaitway::stability
