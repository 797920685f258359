// The rules that the parameters of the balance feedback keep.
#include "gaitway/stability/balance_parameters.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace gaitway::stability {
namespace {

void require_range(std::string_view name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(
        fmt::format("{} is {}, but must be from {} to {}; change it in the plug-in's parameters", name, value,
                    low, high));
  }
}

void require_gain(std::string_view name, const JointGain& gain) {
  require_range(fmt::format("{} gain", name), gain.angle_rad_per_rad, 0.0, 2.0);
  require_range(fmt::format("{} rate gain", name), gain.rate_rad_per_rad_per_s, 0.0, 1.0);
}

}  // namespace

void BalanceParameters::validate() const {
  require_gain("ankle_pitch", ankle_pitch);
  require_gain("ankle_roll", ankle_roll);
  require_gain("hip_pitch", hip_pitch);
  require_gain("hip_roll", hip_roll);
  require_range("roll_reference", attitude_reference_rad[0], -0.3, 0.3);
  require_range("pitch_reference", attitude_reference_rad[1], -0.3, 0.3);
  require_range("trim_limit", trim_limit_rad, 0.0, 0.5);
  require_range("ramp", ramp_s, 0.01, 5.0);
  require_range("standing_after", standing_after_s, 0.0, 5.0);
  require_range("fallen_at", fallen_at_rad, 0.1, 1.5);
  require_range("airborne_after", airborne_after_s, 0.0, 5.0);
  require_range("estimate_lifetime", estimate_lifetime_s, 0.02, 1.0);
  require_range("fall_softness", fall_softness, 0.0, 1.0);
  require_range("heading_gain", heading_gain_per_s, 0.0, 5.0);
  require_range("heading_limit", heading_limit_rad_per_s, 0.0, 1.0);
  require_range("heading_filter", heading_filter_s, 0.0, 5.0);
  require_range("speed_filter", speed_filter_s, 0.0, 20.0);
  require_range("speed_limit", speed_limit_m_per_s, 0.0, 0.5);
  require_range("lean_gain", lean_gain_per_s, 0.0, 5.0);
  require_range("walking_lean_gain", walking_lean_gain_per_s, 0.0, 5.0);
  require_range("lean_limit", lean_limit_rad, 0.0, 0.3);
  require_range("sole_gain", sole_gain_rad_per_m_s, 0.0, 20.0);
  require_range("sole_limit", sole_limit_rad, 0.0, 0.2);
}

}  // namespace gaitway::stability
