// Motion plans of a plain walk that starts, walks and stops, for the test robot. Smooth, not necessarily
// balanced.
#pragma once

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::kinematics::test {

class WalkingPlan {
 public:
  static constexpr double kStep_s = 0.4;
  static constexpr double kPoint_s = facts::kSlot_s;

  explicit WalkingPlan(double speed_m_per_s = 0.25, double turn_rate_rad_per_s = 0.0,
                       double hip_height_m = 0.35)
      : speed_(speed_m_per_s), turn_rate_(turn_rate_rad_per_s), hip_height_m_(hip_height_m) {}

  // The batch `sequence` of 80 ms and a tail that stops within two steps and stands.
  MotionPlan batch(std::uint32_t sequence, int tail_count = 140) const {
    MotionPlan plan{};
    plan.sequence = sequence;
    plan.tail_count = static_cast<std::uint32_t>(tail_count);
    const double start_s = (sequence - 1) * kBatchPoints * kPoint_s;
    const int stop_step = static_cast<int>((start_s + kBatchPoints * kPoint_s) / kStep_s) + 2;
    for (int i = 0; i < kBatchPoints + tail_count; ++i)
      set_point(plan, i, start_s + (i + 1) * kPoint_s, stop_step);
    return plan;
  }

 private:
  struct Pose2 {
    double x, y, yaw;
  };

  static double smooth(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
  }

  // Along a circle: where the middle of the body is after walking at full speed for `full_s` seconds.
  Pose2 body(double full_s) const {
    const double yaw = turn_rate_ * full_s;
    if (std::abs(turn_rate_) < 1e-9) return {speed_ * full_s, 0.0, 0.0};
    return {speed_ / turn_rate_ * std::sin(yaw), speed_ / turn_rate_ * (1.0 - std::cos(yaw)), yaw};
  }

  // Time at full speed that gives the same way as t seconds from a standing start; full speed after two
  // steps.
  static double started(double t) {
    return t < 2.0 * kStep_s ? t * std::max(t, 0.0) / (4.0 * kStep_s) : t - kStep_s;
  }

  // The same with a stop: it slows down over the step before stop_step and the one after.
  static double walked(double t, int stop_step) {
    const double last_s = (stop_step - 1) * kStep_s;
    if (t < last_s) return started(t);
    const double s = std::min((t - last_s) / (2.0 * kStep_s), 1.0);
    const double end_s = started(stop_step * kStep_s);
    const double slope = std::min(last_s / (2.0 * kStep_s), 1.0) * 2.0 * kStep_s;  // at last_s, per unit of s
    const double way = end_s - started(last_s);
    return started(last_s) + slope * s * (1.0 - s) * (1.0 - s) + way * s * s * (3.0 - 2.0 * s);
  }

  // Footprint of a side after its step `step` (even: left, odd: right); standing side by side before and
  // after.
  Pose2 footprint(int side, int step, int stop_step) const {
    const double full_s =
        step < 0 ? 0.0 : std::min(started((step + 1.5) * kStep_s), started(stop_step * kStep_s));
    const Pose2 middle = body(full_s);
    const double lateral = side == 0 ? 0.05 : -0.05;
    return {middle.x - lateral * std::sin(middle.yaw), middle.y + lateral * std::cos(middle.yaw), middle.yaw};
  }

  void set_point(MotionPlan& plan, int i, double t, int stop_step) const {
    const double last_s = (stop_step - 1) * kStep_s;
    const Pose2 middle = body(walked(t, stop_step));
    const double fade = smooth(t / kStep_s) * (1.0 - smooth((t - last_s) / kStep_s));
    const double sway = -0.025 * fade * std::sin(M_PI * t / kStep_s);
    plan.com[i][0] = middle.x - sway * std::sin(middle.yaw);
    plan.com[i][1] = middle.y + sway * std::cos(middle.yaw);
    plan.base_yaw[i] = middle.yaw;
    plan.hip_height[i] = hip_height_m_;
    const int step = static_cast<int>(t / kStep_s);
    const bool moving = step < stop_step;
    for (int side = 0; side < 2; ++side) set_foot(plan, i, side, t, stop_step);
    plan.support[i] = moving ? static_cast<std::uint8_t>(step % 2 == 0 ? 1 : 0) : std::uint8_t{2};
  }

  void set_foot(MotionPlan& plan, int i, int side, double t, int stop_step) const {
    int step = static_cast<int>(t / kStep_s);
    const bool swings = step < stop_step && step % 2 == side;
    if (!swings) step = step % 2 == side ? step : step - 1;
    const int last_own = (stop_step - 1) % 2 == side ? stop_step - 1 : stop_step - 2;
    step = std::min(step, last_own);
    const Pose2 to = footprint(side, step, stop_step);
    const Pose2 from = footprint(side, step - 2, stop_step);
    const double phase = swings ? std::clamp((t / kStep_s - step - 0.15) / 0.85, 0.0, 1.0) : 1.0;
    const double share = smooth(phase);
    plan.foot_position[i][side][0] = from.x + share * (to.x - from.x);
    plan.foot_position[i][side][1] = from.y + share * (to.y - from.y);
    plan.foot_position[i][side][2] = 0.03 * 64.0 * std::pow(phase * (1.0 - phase), 3);
    plan.foot_yaw[i][side] = from.yaw + share * (to.yaw - from.yaw);
  }

  double speed_, turn_rate_, hip_height_m_;
};

}  // namespace gaitway::kinematics::test
