// One row of gains for each support and channel, whose signs come from the joints' axes; law, hips' share,
// fading.
#include "gaitway/stability/trim_feedback.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

std::array<float, 4> row_of(const JointGain& gain, double about_roll, double about_pitch) {
  return {static_cast<float>(gain.angle_rad_per_rad * about_roll),
          static_cast<float>(gain.angle_rad_per_rad * about_pitch),
          static_cast<float>(gain.rate_rad_per_rad_per_s * about_roll),
          static_cast<float>(gain.rate_rad_per_rad_per_s * about_pitch)};
}

}  // namespace

TrimJoint trim_joint(const urdf::RobotModel& model, const urdf::ForwardKinematics& home, int index) {
  const urdf::Joint& joint = model.joints[static_cast<std::size_t>(index)];
  return {joint.trim_channel < kTrimChannels ? joint.trim_channel : -1, home.joint_axis(model, index)};
}

TrimGainMatrix::TrimGainMatrix(const urdf::RobotModel& model) {
  int channels = 0;
  for (const urdf::Joint& joint : model.joints) channels = std::max(channels, joint.trim_channel + 1);
  channel_count_ = static_cast<std::uint32_t>(std::min(channels, kTrimChannels));

  const urdf::ForwardKinematics home(model);
  for (const urdf::Side side : urdf::kSides) {
    const urdf::LegJoints leg(model, home, side);
    const auto add = [&](urdf::LegJoint which, const JointGain BalanceParameters::*gain, bool turns_pitch,
                         bool is_hip) {
      const auto [channel, axis] = trim_joint(model, home, leg[which]);
      if (channel < 0) return;
      rows_[static_cast<std::size_t>(channel)] = {gain, urdf::index_of(side), is_hip,
                                                  turns_pitch ? 0.0 : axis.x(), turns_pitch ? axis.y() : 0.0};
    };
    add(urdf::LegJoint::ankle_pitch, &BalanceParameters::ankle_pitch, true, false);
    add(urdf::LegJoint::ankle_roll, &BalanceParameters::ankle_roll, false, false);
    add(urdf::LegJoint::hip_pitch, &BalanceParameters::hip_pitch, true, true);
    add(urdf::LegJoint::hip_roll, &BalanceParameters::hip_roll, false, true);
  }
}

msgclient::TrimGains TrimGainMatrix::gains(const BalanceParameters& parameters) const noexcept {
  msgclient::TrimGains gains{};
  gains.channel_count = channel_count_;
  gains.attitude_reference = {static_cast<float>(parameters.attitude_reference_rad[0]),
                              static_cast<float>(parameters.attitude_reference_rad[1])};
  for (std::size_t channel = 0; channel < rows_.size(); ++channel) {
    const Row& row = rows_[channel];
    if (row.gain == nullptr) continue;
    gains.gain[kBothFeet][channel] = row_of(parameters.*row.gain, row.about_roll, row.about_pitch);
    // Support 0 is the left leg's, 1 the right one's.
    if (!row.is_hip) gains.gain[row.side][channel] = gains.gain[kBothFeet][channel];
  }
  return gains;
}

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
