// The offset that absorbs a gap of the divergent component.
#include "gaitway/trajectory/divergence_absorber.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {

// Between two points p is linear: ∫₀ᵀ ω e^{−ωs} p ds = (1 − q) p_k + ((1 − q)/(ωT) − q) (p_{k+1} − p_k), q =
// e^{−ωT}.
DivergenceAbsorber::DivergenceAbsorber(double com_height_m, int duration_points, int ramp_points)
    : omega_per_s_(std::sqrt(facts::kGravity_m_per_s2 / com_height_m)),
      decay_(std::exp(-omega_per_s_ * facts::kSlot_s)),
      weight_now_(0.0),
      weight_next_((1.0 - decay_) / (omega_per_s_ * facts::kSlot_s) - decay_),
      duration_points_(duration_points),
      ramp_points_(ramp_points) {
  weight_now_ = 1.0 - decay_ - weight_next_;
  for (int k = duration_points_; k >= 0; --k) {
    effect_ = weight_now_ * shape(k) + weight_next_ * shape(k + 1) + decay_ * effect_;
  }
}

double DivergenceAbsorber::shape(int row) const noexcept {
  const double up = static_cast<double>(row) / ramp_points_;
  const double down = static_cast<double>(duration_points_ - row) / ramp_points_;
  return std::clamp(std::min(up, down), 0.0, 1.0);
}

Eigen::RowVector2d DivergenceAbsorber::required_divergence(const ZmpReference& reference,
                                                           int row) const noexcept {
  Eigen::RowVector2d divergence = reference.point.row(reference.count - 1);
  for (int k = reference.count - 2; k >= row; --k) {
    divergence = (weight_now_ * reference.point.row(k) + weight_next_ * reference.point.row(k + 1) +
                  decay_ * divergence)
                     .eval();
  }
  return divergence;
}

Eigen::RowVector2d DivergenceAbsorber::absorb(const Eigen::RowVector2d& divergence_m, ZmpReference& reference,
                                              ZmpOffset& offset) const noexcept {
  const Eigen::Index rows =
      std::min(reference.count - 1, ZmpOffset::kCapacity);  // the last row stays as it is
  reference.point.topRows(rows) += offset.point.topRows(rows);
  const Eigen::RowVector2d height = (divergence_m - required_divergence(reference, 0)) / effect_;
  for (int k = 0; k < duration_points_; ++k) {
    const Eigen::RowVector2d added = shape(k) * height;
    offset.point.row(k) += added;
    if (k < rows) reference.point.row(k) += added;
  }
  return height;
}

void DivergenceAbsorber::shift(ZmpOffset& offset, int points) noexcept {
  const Eigen::Index kept = ZmpOffset::kCapacity - points;
  for (Eigen::Index k = 0; k < kept; ++k) offset.point.row(k) = offset.point.row(k + points);
  offset.point.bottomRows(points).setZero();
}

}  // namespace gaitway::trajectory
