// The rules that the parameters of the balance feedback keep.
#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {
namespace {

constexpr double kMostGain = 2.0, kMostRateGain_s = 1.0;

}  // namespace

std::vector<NumberParameter> BalanceParameters::numbers() {
  return {
      {ankle_pitch.angle_rad_per_rad, "ankle_pitch", "rad/rad", 0.0, kMostGain},
      {ankle_pitch.rate_rad_per_rad_per_s, "ankle_pitch_rate", "s", 0.0, kMostRateGain_s},
      {ankle_roll.angle_rad_per_rad, "ankle_roll", "rad/rad", 0.0, kMostGain},
      {ankle_roll.rate_rad_per_rad_per_s, "ankle_roll_rate", "s", 0.0, kMostRateGain_s},
      {hip_pitch.angle_rad_per_rad, "hip_pitch", "rad/rad", 0.0, kMostGain},
      {hip_pitch.rate_rad_per_rad_per_s, "hip_pitch_rate", "s", 0.0, kMostRateGain_s},
      {hip_roll.angle_rad_per_rad, "hip_roll", "rad/rad", 0.0, kMostGain},
      {hip_roll.rate_rad_per_rad_per_s, "hip_roll_rate", "s", 0.0, kMostRateGain_s},
      {attitude_reference_rad[0], "roll_reference", "rad", -0.3, 0.3},
      {attitude_reference_rad[1], "pitch_reference", "rad", -0.3, 0.3},
      {trim_limit_rad, "trim_limit", "rad", 0.0, 0.5},
      {ramp_s, "ramp", "s", 0.01, 5.0},
      {standing_after_s, "standing_after", "s", 0.0, 5.0},
      {fallen_at_rad, "fallen_at", "rad", 0.1, 1.5},
      {airborne_after_s, "airborne_after", "s", 0.0, 5.0},
      {estimate_lifetime_s, "estimate_lifetime", "s", 0.02, 1.0},
      {fall.lying, "fall_softness", "1", 0.0, 1.0},
      {fall.posture, "fall_posture_softness", "1", 0.0, 1.0},
      {fall.wait_s, "fall_posture_wait", "s", 0.0, 0.2},
      {heading_gain_per_s, "heading_gain", "1/s", 0.0, 5.0},
      {heading_limit_rad_per_s, "heading_limit", "rad/s", 0.0, 1.0},
      {heading_filter_s, "heading_filter", "s", 0.0, 5.0},
      {speed_filter_s, "speed_filter", "s", 0.0, 20.0},
      {speed_limit_m_per_s, "speed_limit", "m/s", 0.0, 0.5},
      {lean_gain_per_s, "lean_gain", "1/s", 0.0, 5.0},
      {walking_lean_gain_per_s, "walking_lean_gain", "1/s", 0.0, 5.0},
      {lean_limit_rad, "lean_limit", "rad", 0.0, 0.3},
      {centring_gain_per_s, "centring_gain", "1/s", 0.0, 5.0},
      {centring_limit_m, "centring_limit", "m", 0.0, 0.05},
      {sole_gain_rad_per_m_s, "sole_gain", "rad/(m*s)", 0.0, 20.0},
      {sole_limit_rad, "sole_limit", "rad", 0.0, 0.2},
      {calm_damping, "calm_damping", "1", 0.0, 1.0},
      {bow_beyond_m, "bow_beyond", "m", 0.0, 1.0},
      {bow_gain_rad_per_m, "bow_gain", "rad/m", 0.0, 500.0},
      {bow_limit_rad, "bow_limit", "rad", 0.0, 0.6},
      {bow_speed_rad_per_s, "bow_speed", "rad/s", 0.1, 6.0},
      {bow_return_rad_per_s, "bow_return", "rad/s", 0.05, 5.0},
      {bow_damping, "bow_damping", "1", 0.0, 1.0},
  };
}

void BalanceParameters::validate() const {
  // A copy, since it gives access to the numbers themselves.
  BalanceParameters copy = *this;
  require_in_range(copy.numbers());
}

}  // namespace gaitway::stability
