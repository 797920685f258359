// One row for each support and channel; the signs come from the joints' axes.
#include "gaitway/stability/trim_gain_matrix.hpp"

#include <algorithm>

#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::stability {
namespace {

enum LegJoint : std::size_t { hip_roll = 1, hip_pitch = 2, ankle_pitch = 4, ankle_roll = 5 };

// In base axes, at home. A joint's axis is the same in the frame of its child link.
Eigen::Vector3d axis_in_base(const urdf::ForwardKinematics& home, const urdf::Joint& joint) {
  return home.link_rotation(joint.child_link) * joint.axis;
}

std::array<float, 4> row_of(const JointGain& gain, double about_roll, double about_pitch) {
  return {static_cast<float>(gain.angle_rad_per_rad * about_roll),
          static_cast<float>(gain.angle_rad_per_rad * about_pitch),
          static_cast<float>(gain.rate_rad_per_rad_per_s * about_roll),
          static_cast<float>(gain.rate_rad_per_rad_per_s * about_pitch)};
}

}  // namespace

TrimGainMatrix::TrimGainMatrix(const urdf::RobotModel& model) {
  int channels = 0;
  for (const urdf::Joint& joint : model.joints) channels = std::max(channels, joint.trim_channel + 1);
  channel_count_ = static_cast<std::uint32_t>(std::min(channels, kTrimChannels));

  const urdf::ForwardKinematics home(model);
  const auto add = [&](std::size_t side, LegJoint which, const JointGain BalanceParameters::*gain,
                       bool turns_pitch, bool is_hip) {
    const urdf::Joint& joint = model.joints[static_cast<std::size_t>(model.legs[side].joints[which])];
    if (joint.trim_channel < 0 || joint.trim_channel >= kTrimChannels) return;
    const Eigen::Vector3d axis = axis_in_base(home, joint);
    rows_[static_cast<std::size_t>(joint.trim_channel)] = {gain, side, is_hip, turns_pitch ? 0.0 : axis.x(),
                                                           turns_pitch ? axis.y() : 0.0};
  };
  for (std::size_t side = 0; side < model.legs.size(); ++side) {
    add(side, ankle_pitch, &BalanceParameters::ankle_pitch, true, false);
    add(side, ankle_roll, &BalanceParameters::ankle_roll, false, false);
    add(side, hip_pitch, &BalanceParameters::hip_pitch, true, true);
    add(side, hip_roll, &BalanceParameters::hip_roll, false, true);
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

}  // namespace gaitway::stability
