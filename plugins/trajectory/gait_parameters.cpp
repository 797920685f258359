// The rules of the gait parameters.
#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {
namespace {

constexpr int kMostPreviewPoints = 300;  // room of the reference ZMP

}  // namespace

double GaitParameters::hip_height_at_m(double forward_m_per_s) const noexcept {
  const double share =
      (std::abs(forward_m_per_s) - slow_speed_m_per_s) / (fast_speed_m_per_s - slow_speed_m_per_s);
  return hip_height_m - std::clamp(share, 0.0, 1.0) * (hip_height_m - fast_hip_height_m);
}

std::array<NumberParameter, GaitParameters::kNumbers> GaitParameters::numbers() {
  return {{
      {com_height_m, "com_height", "m", 0.05, 2.0, "of the CoM above the ground in the stand"},
      {hip_height_m, "hip_height", "m", 0.05, 2.0,
       "of the hip axes above the ground, standing and walking slowly"},
      {stand_com_forward_m, "stand_com_forward", "m", -0.5, 0.5,
       "of the standing CoM ahead of the soles' origins"},
      {foot_spacing_m, "foot_spacing", "m", 0.01, 1.0, "lateral distance of the soles' origins"},
      {step_time_s, "step_time", "s", 0.20, 1.0, "of a step, double support and swing"},
      {double_support_share, "double_support_share", "1", 0.05, 0.6, "of the step time"},
      {lead_in_s, "lead_in", "s", 0.1, 2.0, "first weight shift, from the command to the first lift"},
      {settle_s, "settle", "s", 0.2, 1.5, "from the last touch-down to rest"},
      {freeze_share, "freeze_share", "1", 0.0, 0.9, "of the swing, from which a commanded footstep is fixed"},
      {absorb_s, "absorb", "s", 0.2, 1.0, "over which the ZMP absorbs a change of footsteps"},
      {lift_m, "lift", "m", 0.0, 0.2, "highest point of the swing foot's sole"},
      {swing_flatness, "swing_flatness", "1", 0.0, 1.0,
       "share of a cubic in the swing foot's way: slower at its fastest, quicker to start"},
      {toe_up_rad_per_m, "toe_up", "rad/m", 0.0, 100.0,
       "by which the swing foot's toes are up, for each metre of its height"},
      {adjust_threshold_m, "adjust_threshold", "m", 0.0, 1.0,
       "deviation of the DCM ahead or back, below which no step is adjusted", kLive},
      {adjust_side_threshold_m, "adjust_side_threshold", "m", 0.0, 1.0,
       "deviation of the DCM to either side, below which no step is adjusted", kLive},
      {adjust_share, "adjust_share", "1", 0.0, 2.0, "of the full step adjustment; 0: none", kLive},
      {adjust_until_share, "adjust_until_share", "1", 0.0, 0.9,
       "of the swing, from which nothing moves the footstep any more", kLive},
      {adjust_speed_m_per_s, "adjust_speed", "m/s", 0.0, 2.0,
       "at which a landing may be moved ahead or back, times what remains of the swing", kLive},
      {adjust_side_speed_m_per_s, "adjust_side_speed", "m/s", 0.0, 2.0,
       "at which a landing may be moved to either side, times what remains of the swing", kLive},
      {adjust_spacing_m, "adjust_spacing", "m", 0.01, 1.0, "widest distance of the feet in an adjusted step"},
      {adjust_time_cost_m_per_s, "adjust_time_cost", "m/s", 0.0, 1000.0,
       "of landing sooner or later, against moving the landing", kLive},
      {adjust_shortest_swing_s, "adjust_shortest_swing", "s", 0.10, 1.0,
       "time of a whole swing at its fastest"},
      {adjust_longest_swing_s, "adjust_longest_swing", "s", 0.10, 1.0,
       "time of a whole swing at its slowest"},
      {recover_ahead_m, "recover_ahead", "m", -0.05, 1.0,
       "of the DCM before the toes, from where a standing robot steps", kLive},
      {recover_behind_m, "recover_behind", "m", -0.05, 1.0,
       "of the DCM behind the heels, from where a standing robot steps", kLive},
      {recover_bow_ahead_m_per_rad, "recover_bow_ahead", "m/rad", 0.0, 1.0,
       "less than that before the toes, for what the trunk bows", kLive},
      {recover_bow_behind_m_per_rad, "recover_bow_behind", "m/rad", 0.0, 1.0,
       "less than that behind the heels, for what the trunk bows", kLive},
      {recover_lead_in_s, "recover_lead_in", "s", facts::kSlot_s, 2.0, "from then to the lift"},
      {recover_swing_s, "recover_swing", "s", 0.10, 1.0, "of the recovery's first step"},
      {recover_step_m, "recover_step", "m", 0.0, 1.0, "longest first step of a recovery"},
      {recover_crouch, "recover_crouch", "1", 0.0, 1.0,
       "by which the hips come down, as a share of how far the foot lands from under them"},
      {hips_in_bow_m_per_rad, "hips_in_bow", "m/rad", 0.0, 1.0,
       "by which a bow leaves the hips behind the CoM"},
      {response_lag_s, "response_lag", "s", 0.0, 0.1, "of the body behind its plan", false, Scaling::none},
      {zmp_forward_m, "zmp_forward", "m", -0.5, 0.5, "reference ZMP ahead of the sole's origin"},
      {zmp_inward_m, "zmp_inward", "m", -0.5, 0.5, "reference ZMP towards the other foot"},
      {fast_hip_height_m, "fast_hip_height", "m", 0.05, 2.0,
       "of the hip axes above the ground in a fast walk"},
      {slow_speed_m_per_s, "slow_speed", "m/s", 0.0, 2.0, "up to which the hips stay at hip_height"},
      {fast_speed_m_per_s, "fast_speed", "m/s", 0.01, 3.0, "from which on they are at fast_hip_height"},
      {swing_moment_s2, "swing_moment", "s^2", 0.0, 0.05,
       "shift of the ZMP for the swing foot's acceleration; 0: not reckoned with"},
      {arm_swing_rad_per_m, "arm_swing", "rad/m", 0.0, 100.0,
       "of both arms against the legs, for each metre by which the feet are apart"},
      {max_step_forward_m, "max_step_forward", "m", 0.0, 1.0, "longest step ahead"},
      {max_step_backward_m, "max_step_backward", "m", 0.0, 1.0, "longest step back"},
      {max_foot_spacing_m, "max_foot_spacing", "m", 0.01, 1.0,
       "widest lateral distance of the soles' origins"},
      {min_sole_gap_m, "min_sole_gap", "m", 0.0, 0.1, "least clear distance of the soles when a foot lands"},
      {max_step_turn_rad, "max_step_turn", "rad", 0.0, 0.7, "largest turn of a step"},
      {forward_acceleration_m_per_s2, "forward_acceleration", "m/s^2", 1e-3, 10.0,
       "largest change of the forward velocity", kLive},
      {lateral_acceleration_m_per_s2, "lateral_acceleration", "m/s^2", 1e-3, 10.0,
       "largest change of the lateral velocity", kLive},
      {turn_acceleration_rad_per_s2, "turn_acceleration", "rad/s^2", 1e-3, 50.0,
       "largest change of the turn rate", kLive},
      {preview_s, "preview", "s", 0.5, kMostPreviewPoints * facts::kSlot_s,
       "how far ahead the preview control looks"},
      {zmp_error_weight, "zmp_error_weight", "1", 1e-6, 1e6, "of the ZMP's error in the preview control"},
      {jerk_weight, "jerk_weight", "s^6", 1e-12, 1.0, "of the CoM's jerk in the preview control"},
  }};
}

void GaitParameters::tune(GaitParameters changed) noexcept {
  const auto from = changed.numbers();
  const auto to = numbers();
  for (std::size_t i = 0; i < kNumbers; ++i) {
    if (to[i].live) to[i].value = from[i].value;
  }
}

void GaitParameters::validate() const {
  // A copy, since it gives access to the numbers themselves.
  GaitParameters copy = *this;
  require_in_range(copy.numbers());
  require_in_range(std::array{NumberParameter{copy.sole.length_m, "sole_length", "m", 0.01, 1.0},
                              NumberParameter{copy.sole.width_m, "sole_width", "m", 0.01, 1.0}});
  require_number(fast_hip_height_m <= hip_height_m, "fast_hip_height", fast_hip_height_m, "m",
                 "at most hip_height");
  require_number(fast_speed_m_per_s >= slow_speed_m_per_s + 0.01, "fast_speed", fast_speed_m_per_s, "m/s",
                 "at least 0.01 m/s above slow_speed");
  require_number(foot_spacing_m >= sole.width_m + min_sole_gap_m, "foot_spacing", foot_spacing_m, "m",
                 "at least sole_width + min_sole_gap");
  require_number(max_foot_spacing_m >= foot_spacing_m, "max_foot_spacing", max_foot_spacing_m, "m",
                 "at least foot_spacing");
  const double ahead = sole.centre_forward_m + 0.5 * sole.length_m;
  const double behind = sole.centre_forward_m - 0.5 * sole.length_m;
  require_number(zmp_forward_m < ahead && zmp_forward_m > behind, "zmp_forward", zmp_forward_m, "m",
                 "on the sole");
  require_number(stand_com_forward_m < ahead && stand_com_forward_m > behind, "stand_com_forward",
                 stand_com_forward_m, "m", "above the soles");
  require_number(std::abs(zmp_inward_m) < 0.5 * sole.width_m, "zmp_inward", zmp_inward_m, "m", "on the sole");
  require_number(longest_tail_points() <= kMostTailPoints, "settle", settle_s, "s",
                 "so short that a swing, a step and the settling take 1.92 s at most");
}

}  // namespace gaitway::trajectory
