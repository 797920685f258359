// The rules that the parameters of the balance feedback keep.
#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {
namespace {

constexpr double kMostGain = 2.0, kMostRateGain_s = 1.0;

}  // namespace

std::vector<NumberParameter> BalanceParameters::numbers() {
  return {
      {ankle_pitch.angle_rad_per_rad, "ankle_pitch", "rad/rad", 0.0, kMostGain,
       "by how much the stance ankle turns against a pitch of the trunk", kLive},
      {ankle_pitch.rate_rad_per_rad_per_s, "ankle_pitch_rate", "s", 0.0, kMostRateGain_s,
       "by how much the stance ankle turns against the trunk's pitch rate", kLive},
      {ankle_roll.angle_rad_per_rad, "ankle_roll", "rad/rad", 0.0, kMostGain,
       "by how much the stance ankle turns against a roll of the trunk", kLive},
      {ankle_roll.rate_rad_per_rad_per_s, "ankle_roll_rate", "s", 0.0, kMostRateGain_s,
       "by how much the stance ankle turns against the trunk's roll rate", kLive},
      {hip_pitch.angle_rad_per_rad, "hip_pitch", "rad/rad", 0.0, kMostGain,
       "by how much both hips turn against a pitch of the trunk while the robot stands", kLive},
      {hip_pitch.rate_rad_per_rad_per_s, "hip_pitch_rate", "s", 0.0, kMostRateGain_s,
       "by how much both hips turn against the trunk's pitch rate while the robot stands", kLive},
      {hip_roll.angle_rad_per_rad, "hip_roll", "rad/rad", 0.0, kMostGain,
       "by how much both hips turn against a roll of the trunk while the robot stands", kLive},
      {hip_roll.rate_rad_per_rad_per_s, "hip_roll_rate", "s", 0.0, kMostRateGain_s,
       "by how much both hips turn against the trunk's roll rate while the robot stands", kLive},
      {attitude_reference_rad[0], "roll_reference", "rad", -0.3, 0.3,
       "roll of the trunk that is regulated to"},
      {attitude_reference_rad[1], "pitch_reference", "rad", -0.3, 0.3,
       "pitch of the trunk that is regulated to"},
      {trim_limit_rad, "trim_limit", "rad", 0.0, 0.5,
       "largest trim of a joint, no more than the robot's own limit", kLive},
      {ramp_s, "ramp", "s", 0.01, 5.0, "in which the trims fade when the ground is gone, and come back",
       kLive},
      {standing_after_s, "standing_after", "s", 0.0, 5.0, "on both feet, after which the hips help", kLive},
      {fallen_at_rad, "fallen_at", "rad", 0.1, 1.5,
       "roll or pitch of the trunk beyond which nothing is balanced", kLive},
      {airborne_after_s, "airborne_after", "s", 0.0, 5.0,
       "without contact of any foot, after which nothing is balanced", kLive},
      {estimate_lifetime_s, "estimate_lifetime", "s", 0.02, 1.0, "age from which an estimate counts as lost",
       kLive, Scaling::none},
      {fall.lying, "fall_softness", "1", 0.0, 1.0,
       "of the joints of a robot that lies: 0 full stiffness, 1 no torque", kLive},
      {fall.posture, "fall_posture_softness", "1", 0.0, 1.0,
       "of the joints while they go into the posture of a fall", kLive},
      {fall.wait_s, "fall_posture_wait", "s", 0.0, 0.2,
       "from the recognition of a fall on, for its posture to begin", kLive},
      {heading_gain_per_s, "heading_gain", "1/s", 0.0, 5.0, "turn rate for an error of the heading", kLive},
      {heading_limit_rad_per_s, "heading_limit", "rad/s", 0.0, 1.0,
       "largest turn rate that the heading feedback adds", kLive},
      {heading_filter_s, "heading_filter", "s", 0.0, 5.0, "low-pass of the heading's error", kLive},
      {speed_filter_s, "speed_filter", "s", 0.0, 20.0, "in which the speed feedback learns; 0: none", kLive},
      {speed_limit_m_per_s, "speed_limit", "m/s", 0.0, 0.5, "largest velocity that the speed feedback adds",
       kLive},
      {lean_gain_per_s, "lean_gain", "1/s", 0.0, 5.0, "of the integrator of the lean, standing; 0: none",
       kLive},
      {walking_lean_gain_per_s, "walking_lean_gain", "1/s", 0.0, 5.0,
       "of the integrator of the lean, walking; 0: none", kLive},
      {lean_limit_rad, "lean_limit", "rad", 0.0, 0.3, "largest lean that is taken out", kLive},
      {centring_gain_per_s, "centring_gain", "1/s", 0.0, 5.0,
       "of the integrator of the standing CoM's error; 0: none", kLive},
      {centring_limit_m, "centring_limit", "m", 0.0, 0.05, "largest offset of the CoM that is learned",
       kLive},
      {centring_most_m, "centring_most", "m", 0.0, 0.05,
       "error of the CoM that is learned from at a time, at most", kLive},
      {centring_calm_m, "centring_calm", "m", 0.0, 0.2,
       "error of the DCM beyond which the body is being caught, and nothing is learned", kLive},
      {sole_gain_rad_per_m_s, "sole_gain", "rad/(m*s)", 0.0, 20.0,
       "of the integrator that turns the soles flat; 0: none", kLive},
      {sole_limit_rad, "sole_limit", "rad", 0.0, 0.2, "largest turn of a sole that is learned", kLive},
      {calm_damping, "calm_damping", "1", 0.0, 1.0, "share of the trims' pitch rate gains in a calm stand",
       kLive},
      {calm_rate_rad_per_s, "calm_rate", "rad/s", 0.0, 2.0,
       "of the trunk, from which on a stand is not calm any more", kLive},
      {bow_sway_m, "bow_sway", "m", 0.0, 0.2,
       "of the DCM beyond the CoM, of a body that sways and is not pushed", kLive},
      {bow_beyond_m, "bow_beyond", "m", 0.0, 1.0, "of the DCM from the soles' middle, where a bow begins",
       kLive},
      {bow_gain_rad_per_m, "bow_gain", "rad/m", 0.0, 500.0, "bow for what the DCM is further; 0: none",
       kLive},
      {bow_limit_rad, "bow_limit", "rad", 0.0, 0.6, "largest bow", kLive},
      {bow_speed_rad_per_s, "bow_speed", "rad/s", 0.1, 6.0, "largest rate of a bow", kLive},
      {bow_return_rad_per_s, "bow_return", "rad/s", 0.05, 5.0,
       "rate at which the trunk comes back from a bow", kLive},
      {bow_damping, "bow_damping", "1", 0.0, 1.0, "share of the trims' pitch rate gains during a bow", kLive},
  };
}

void BalanceParameters::validate() const {
  // A copy, since it gives access to the numbers themselves.
  BalanceParameters copy = *this;
  require_in_range(copy.numbers());
}

}  // namespace gaitway::stability
