// The rules of the gait parameters.
#include "gaitway/trajectory/gait_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gaitway::trajectory {
namespace {

constexpr int kMostTailPoints = 192;     // what a plan can carry, in whole batches
constexpr int kMostPreviewPoints = 300;  // room of the reference ZMP

int whole_points(double time_s) noexcept {
  return static_cast<int>(std::lround(time_s / kPointPeriod_s));
}

void require(bool rule_holds, const char* name, double value, const char* unit, const char* rule) {
  if (!rule_holds) {
    throw std::invalid_argument(
        fmt::format("trajectory: parameter {} = {} {}: must be {}. Change it in the plug-in's configuration.",
                    name, value, unit, rule));
  }
}

void require_within(double value, double low, double high, const char* name, const char* unit) {
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(
        fmt::format("trajectory: parameter {} = {} {}: must be within [{}, {}] {}. Change it in the "
                    "plug-in's configuration.",
                    name, value, unit, low, high, unit));
  }
}

}  // namespace

int GaitParameters::step_points() const noexcept {
  return whole_points(step_time_s);
}
int GaitParameters::double_support_points() const noexcept {
  return std::max(1, whole_points(step_time_s * double_support_share));
}
int GaitParameters::lead_in_points() const noexcept {
  return whole_points(lead_in_s);
}
int GaitParameters::recover_lead_in_points() const noexcept {
  return whole_points(recover_lead_in_s);
}
int GaitParameters::recover_swing_points() const noexcept {
  return whole_points(recover_swing_s);
}
int GaitParameters::settle_points() const noexcept {
  return whole_points(settle_s);
}
int GaitParameters::preview_points() const noexcept {
  return whole_points(preview_s);
}
int GaitParameters::absorb_points() const noexcept {
  return whole_points(absorb_s);
}
double GaitParameters::hip_height_at_m(double forward_m_per_s) const noexcept {
  const double share =
      (std::abs(forward_m_per_s) - slow_speed_m_per_s) / (fast_speed_m_per_s - slow_speed_m_per_s);
  return hip_height_m - std::clamp(share, 0.0, 1.0) * (hip_height_m - fast_hip_height_m);
}
int GaitParameters::longest_tail_points() const noexcept {
  return swing_points() + step_points() + settle_points();
}

void GaitParameters::validate() const {
  require_within(com_height_m, 0.05, 2.0, "com_height", "m");
  require_within(hip_height_m, 0.05, 2.0, "hip_height", "m");
  require_within(fast_hip_height_m, 0.05, hip_height_m, "fast_hip_height", "m");
  require_within(slow_speed_m_per_s, 0.0, 2.0, "slow_speed", "m/s");
  require_within(fast_speed_m_per_s, slow_speed_m_per_s + 0.01, 3.0, "fast_speed", "m/s");
  require_within(swing_moment_s2, 0.0, 0.05, "swing_moment", "s^2");
  require_within(step_time_s, 0.20, 1.0, "step_time", "s");
  require_within(double_support_share, 0.05, 0.6, "double_support_share", "1");
  require_within(lead_in_s, 0.1, 2.0, "lead_in", "s");
  require_within(settle_s, 0.2, 1.5, "settle", "s");
  require_within(freeze_share, 0.0, 0.9, "freeze_share", "1");
  require_within(absorb_s, 0.2, 1.0, "absorb", "s");
  require_within(adjust_threshold_m, 0.0, 1.0, "adjust_threshold", "m");
  require_within(adjust_side_threshold_m, 0.0, 1.0, "adjust_side_threshold", "m");
  require_within(adjust_share, 0.0, 2.0, "adjust_share", "1");
  require_within(adjust_until_share, 0.0, 0.9, "adjust_until_share", "1");
  require_within(adjust_speed_m_per_s, 0.0, 2.0, "adjust_speed", "m/s");
  require_within(recover_beyond_m, -0.05, 1.0, "recover_beyond", "m");
  require_within(recover_lead_in_s, kPointPeriod_s, 2.0, "recover_lead_in", "s");
  require_within(recover_swing_s, 0.10, 1.0, "recover_swing", "s");
  require_within(recover_step_m, 0.0, 1.0, "recover_step", "m");
  require_within(response_lag_s, 0.0, 0.1, "response_lag", "s");
  require_within(lift_m, 0.0, 0.2, "lift", "m");
  require_within(preview_s, 0.5, kMostPreviewPoints * kPointPeriod_s, "preview", "s");
  require_within(zmp_error_weight, 1e-6, 1e6, "zmp_error_weight", "1");
  require_within(jerk_weight, 1e-12, 1.0, "jerk_weight", "1");
  require_within(sole.length_m, 0.01, 1.0, "sole_length", "m");
  require_within(sole.width_m, 0.01, 1.0, "sole_width", "m");
  require_within(min_sole_gap_m, 0.0, 0.1, "min_sole_gap", "m");
  require_within(max_step_forward_m, 0.0, 1.0, "max_step_forward", "m");
  require_within(max_step_backward_m, 0.0, 1.0, "max_step_backward", "m");
  require_within(max_step_turn_rad, 0.0, 0.7, "max_step_turn", "rad");
  require_within(forward_acceleration_m_per_s2, 1e-3, 10.0, "forward_acceleration", "m/s^2");
  require_within(lateral_acceleration_m_per_s2, 1e-3, 10.0, "lateral_acceleration", "m/s^2");
  require_within(turn_acceleration_rad_per_s2, 1e-3, 50.0, "turn_acceleration", "rad/s^2");
  require(foot_spacing_m >= sole.width_m + min_sole_gap_m, "foot_spacing", foot_spacing_m, "m",
          "at least sole_width + min_sole_gap");
  require(max_foot_spacing_m >= foot_spacing_m, "max_foot_spacing", max_foot_spacing_m, "m",
          "at least foot_spacing");
  const double ahead = sole.centre_forward_m + 0.5 * sole.length_m;
  const double behind = sole.centre_forward_m - 0.5 * sole.length_m;
  require(zmp_forward_m < ahead && zmp_forward_m > behind, "zmp_forward", zmp_forward_m, "m", "on the sole");
  require(stand_com_forward_m < ahead && stand_com_forward_m > behind, "stand_com_forward",
          stand_com_forward_m, "m", "above the soles");
  require(std::abs(zmp_inward_m) < 0.5 * sole.width_m, "zmp_inward", zmp_inward_m, "m", "on the sole");
  require(longest_tail_points() <= kMostTailPoints, "settle", settle_s, "s",
          "so short that a swing, a step and the settling take 1.92 s at most");
}

}  // namespace gaitway::trajectory
