// Makes a changed reference ZMP fit the motion of the CoM that the reference before it asked for.
#pragma once

#include <Eigen/Core>

#include "gaitway/trajectory/preview_controller.hpp"

namespace gaitway::trajectory {

// Offset of the reference ZMP by points from now on, m; nothing but zeros after the last row.
struct ZmpOffset {
  static constexpr int kCapacity = 128;
  Eigen::Matrix<double, kCapacity, 2> point = Eigen::Matrix<double, kCapacity, 2>::Zero();
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.point);
  }
};

// The divergent component of the CoM's motion ξ = c + ċ/ω (Takenaka et al., IROS 2009; Englsberger et al.,
// T-RO 2015) stays bounded only when ξ(0) = ∫ ω e^{−ωs} p(s) ds for the ZMP p that follows. New footsteps
// change the right side at once and the left not at all. A tracking controller would close the gap with a
// spike of the ZMP; instead, the gap is spread over a time: p gets a trapezoidal offset whose height solves
// the equation. Without a change it is zero.
class DivergenceAbsorber {
 public:
  // duration_points: of the offset, below ZmpOffset::kCapacity, with ramps of ramp_points at both ends.
  DivergenceAbsorber(double com_height_m, int duration_points, int ramp_points);

  // Adds the offset to the reference, and to both a trapezoid so high that required_divergence(reference, 0)
  // becomes divergence_m. Returns its height, m. No allocation.
  Eigen::RowVector2d absorb(const Eigen::RowVector2d& divergence_m, ZmpReference& reference,
                            ZmpOffset& offset) const noexcept;

  // Time goes on by that many points.
  static void shift(ZmpOffset& offset, int points) noexcept;

  // ξ that the reference asks for at that row; its last row stays for ever.
  [[nodiscard]] Eigen::RowVector2d required_divergence(const ZmpReference& reference, int row) const noexcept;
  // ξ of the cart.
  [[nodiscard]] Eigen::RowVector2d divergence(const Cart& cart) const noexcept {
    return cart.motion.row(0) + cart.motion.row(1) / omega_per_s_;
  }
  [[nodiscard]] double omega_per_s() const noexcept { return omega_per_s_; }

 private:
  [[nodiscard]] double shape(int row) const noexcept;  // trapezoid of height 1

  double omega_per_s_;
  double decay_, weight_now_,
      weight_next_;  // of one point: e^{−ωT}, and how p_k and p_{k+1} count in between
  int duration_points_, ramp_points_;
  double effect_ = 0.0;  // of the shape on ξ
};

}  // namespace gaitway::trajectory
