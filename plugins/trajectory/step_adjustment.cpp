// Closed forms, each axis for itself, and a search over the few instants of landing.
#include "gaitway/trajectory/step_adjustment.hpp"

#include <cmath>
#include <limits>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

// Of a metre by which the DCM is still off at the landing, against a metre by which the landing moves: the
// next step has to answer it, grown.
constexpr double kLeftCost = 3.0;

}  // namespace

StepAdjustment::StepAdjustment(const GaitParameters& parameters, double omega_per_s) noexcept
    : threshold_m_(parameters.adjust_threshold_m, parameters.adjust_side_threshold_m),
      swing_speed_m_per_s_(parameters.adjust_speed_m_per_s, parameters.adjust_side_speed_m_per_s),
      share_(parameters.adjust_share),
      time_cost_m_per_s_(parameters.adjust_time_cost_m_per_s),
      omega_per_s_(omega_per_s),
      half_double_support_s_(0.5 * parameters.double_support_points() * facts::kSlot_s) {}

// The ZMP moves to the new foot in the middle of the double support that follows the landing.
double StepAdjustment::decay(double landing_s) const noexcept {
  return std::exp(-omega_per_s_ * (landing_s + half_double_support_s_));
}

Eigen::Vector2d StepAdjustment::excess_m(const Eigen::Vector2d& deviation_m) const noexcept {
  if (share_ <= 0.0) return Eigen::Vector2d::Zero();
  return deviation_m - deviation_m.cwiseMax(-threshold_m_).cwiseMin(threshold_m_);
}

StepAnswer StepAdjustment::answer(const Eigen::Vector2d& excess_m, const StepInFlight& step) const noexcept {
  const Eigen::Vector2d wanted = share_ * excess_m;
  const double planned_decay = std::exp(-omega_per_s_ * step.points * facts::kSlot_s);
  StepAnswer best{.points = step.points};
  double least = std::numeric_limits<double>::infinity();
  // Ahead and back the place alone does better: nothing keeps the feet from where the body falls to.
  const bool place_alone = wanted.y() == 0.0;
  const int fewest = place_alone ? step.points : step.fewest_points;
  const int most = place_alone ? step.points : step.most_points;
  for (int points = fewest; points <= most; ++points) {
    const double landing_s = points * facts::kSlot_s;
    const double change_s = landing_s - step.points * facts::kSlot_s;
    const Eigen::Vector2d by_time = (std::exp(-omega_per_s_ * landing_s) - planned_decay) * step.landing_dcm;
    const Eigen::Vector2d most_m = swing_speed_m_per_s_ * (step.swing_points * facts::kSlot_s + change_s);
    const Eigen::Vector2d shift = full_shift_m(wanted - by_time, landing_s)
                                      .cwiseMax(-most_m)
                                      .cwiseMin(most_m)
                                      .cwiseMax(step.lowest_shift)
                                      .cwiseMin(step.highest_shift);
    const Eigen::Vector2d answered = by_time + answered_m(shift, landing_s);
    const Eigen::Vector2d left = full_shift_m(wanted - answered, landing_s);
    const double time_cost = time_cost_m_per_s_ * change_s;
    const double cost =
        kLeftCost * kLeftCost * left.squaredNorm() + shift.squaredNorm() + time_cost * time_cost;
    if (cost < least) {
      least = cost;
      best = {points, shift, answered};
    }
  }
  return best;
}

}  // namespace gaitway::trajectory
