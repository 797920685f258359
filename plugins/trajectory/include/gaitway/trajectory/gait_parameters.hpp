// Every number of the walking pattern, with its unit, and the rules that these numbers must keep.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "gaitway/facts/facts.hpp"
#include "gaitway/plugin/number_parameter.hpp"

namespace gaitway::trajectory {

// The rectangle of a sole, in the sole frame (origin below the ankle, x forward, y left).
struct Sole {
  double length_m = 0.135;
  double width_m = 0.085;
  double centre_forward_m = 0.010;  // of the rectangle, ahead of the origin
};

struct GaitParameters {
  static constexpr int kMostTailPoints = 192;  // what a plan can carry, in whole batches

  // The robot in its standing posture.
  double com_height_m = 0.378;         // of the CoM above the ground: the height of the cart's table
  double hip_height_m = 0.360;         // of the hip axes above the ground, while standing and walking slowly
  double stand_com_forward_m = 0.010;  // CoM of the nominal stand ahead of the line between the sole origins
  double foot_spacing_m = 0.100;       // lateral distance of the sole origins
  Sole sole;

  // Timing. All are rounded to whole points of 10 ms.
  double step_time_s = 0.32;
  double double_support_share = 0.10;  // of the step time
  double lead_in_s = 0.60;             // first weight shift, from the start command to the first lift
  double settle_s = 0.60;              // from the last touch-down to rest
  double freeze_share = 0.30;          // of the swing: from here on a footstep is fixed

  double absorb_s = 0.40;  // over which the ZMP absorbs a change of footsteps

  // Step adjustment, by what the estimated DCM deviates from the planned one (StepAdjustment).
  double adjust_threshold_m = 0.030;       // ahead and back: below it, nothing is done
  double adjust_side_threshold_m = 0.025;  // to either side
  double adjust_share = 0.7;               // of the full adjustment; 0: off
  double adjust_until_share = 0.75;        // of the swing: from here on not even this moves the footstep
  double adjust_speed_m_per_s = 0.25;      // at which the landing may move ahead and back, times what is left
                                           // of the swing
  double adjust_side_speed_m_per_s = 0.40;  // and to either side
  double adjust_spacing_m = 0.160;  // no further apart than this does a push bring the feet: else the knees
                                    // would have to be too fast
  double adjust_time_cost_m_per_s = 0.2;  // of landing sooner or later, against moving the landing
  double adjust_shortest_swing_s = 0.22;  // how fast and how slowly the foot may do what is left of a swing,
  double adjust_longest_swing_s = 0.40;   // as the time that a whole swing would take so

  // A standing robot that is pushed off its feet steps after itself.
  double recover_ahead_m = 0.02;               // of the DCM before the toes, or
  double recover_behind_m = 0.008;             // behind the heels: what a bow can still catch
  double recover_bow_ahead_m_per_rad = 0.015;  // less than that, for what the trunk has already bowed
  double recover_bow_behind_m_per_rad = 0.035;
  double recover_lead_in_s = 0.02;  // from then to the lift
  double recover_swing_s = 0.23;    // of the first step; the others are those of a walk in place
  double recover_step_m = 0.12;     // longest first step ahead or back
  // The hips come down by this share of how far the foot is to land from under them: near the straight knee
  // no joint is quick enough.
  double recover_crouch = 0.28;
  // By how far a bow leaves the hips behind the CoM: humanoid22's masses and lengths make it so.
  double hips_in_bow_m_per_rad = 0.10;

  double response_lag_s = 0.020;  // of the body behind its plan: servos and sensors

  // Shape of a step.
  double lift_m = 0.030;        // highest point of the swing foot's sole
  double swing_flatness = 0.0;  // SwingFoot
  // By which its toes are up, for each metre of its height: a hip that is too slow for a fast swing lags, the
  // whole leg turns with it, and the toes would meet the ground first.
  double toe_up_rad_per_m = 0.0;
  double zmp_forward_m = 0.010;  // reference ZMP ahead of the sole's origin
  double zmp_inward_m = 0.010;   // and towards the other foot

  // A fast walk goes with lower hips: the knees turn more slowly. The hip height falls linearly with the
  // speed.
  double fast_hip_height_m = 0.335;
  double slow_speed_m_per_s = 0.20;  // up to here the hips stay at hip_height
  double fast_speed_m_per_s = 0.40;  // from here on they are at fast_hip_height

  // The leg in the air shifts the ZMP by this times its foot's acceleration: (sum of each link's mass x its
  // share of the foot's motion x its depth below the CoM) / weight. From the robot's masses; 0: not reckoned
  // with.
  double swing_moment_s2 = 0.0042;

  // The arms go back and ahead against the legs, so that these do not twist the stance foot on the ground:
  // for each metre by which the feet are apart.
  double arm_swing_rad_per_m = 0.0;

  // Limits of a footstep against its stance foot.
  double max_step_forward_m = 0.150;  // 0.47 m/s at 0.32 s a step: the joints' speed allows little more
  double max_step_backward_m = 0.100;
  double max_foot_spacing_m = 0.200;
  double min_sole_gap_m = 0.008;  // clear distance between the soles' rectangles when a foot lands
  double max_step_turn_rad = 0.50;

  // Change of the walking velocity from step to step.
  double forward_acceleration_m_per_s2 = 0.25;
  double lateral_acceleration_m_per_s2 = 0.10;
  double turn_acceleration_rad_per_s2 = 1.0;

  // Preview control.
  double preview_s = 1.6;
  double zmp_error_weight = 1.0;
  double jerk_weight = 1e-6;

  [[nodiscard]] int step_points() const noexcept { return whole_points(step_time_s); }
  [[nodiscard]] int double_support_points() const noexcept {
    return std::max(1, whole_points(step_time_s * double_support_share));
  }
  [[nodiscard]] int swing_points() const noexcept { return step_points() - double_support_points(); }
  [[nodiscard]] int lead_in_points() const noexcept { return whole_points(lead_in_s); }
  [[nodiscard]] int recover_lead_in_points() const noexcept { return whole_points(recover_lead_in_s); }
  [[nodiscard]] int recover_swing_points() const noexcept { return whole_points(recover_swing_s); }
  [[nodiscard]] int settle_points() const noexcept { return whole_points(settle_s); }
  [[nodiscard]] int preview_points() const noexcept { return whole_points(preview_s); }
  [[nodiscard]] int absorb_points() const noexcept { return whole_points(absorb_s); }
  // Of the hip axes above the ground at a speed forward or backward.
  [[nodiscard]] double hip_height_at_m(double forward_m_per_s) const noexcept;
  // Of how far ahead or back the first step of a recovery is to go, what it may.
  [[nodiscard]] double limit_recovery_m(double ahead_m) const noexcept {
    return std::clamp(ahead_m, -recover_step_m, recover_step_m);
  }
  // Points of the longest safe tail: a swing just begun, the closing step, the settling.
  [[nodiscard]] int longest_tail_points() const noexcept {
    return swing_points() + step_points() + settle_points();
  }

  // As the configuration has them; all but the sole, which is the robot's.
  static constexpr std::size_t kNumbers = 51;
  [[nodiscard]] std::array<NumberParameter, kNumbers> numbers();
  // The live numbers of `changed`; the others stay as they are. No allocation.
  void tune(GaitParameters changed) noexcept;

  // Throws std::invalid_argument naming the parameter, its value, the rule and the remedy.
  void validate() const;

 private:
  static int whole_points(double time_s) noexcept {
    return static_cast<int>(std::lround(time_s / facts::kSlot_s));
  }
};

}  // namespace gaitway::trajectory
