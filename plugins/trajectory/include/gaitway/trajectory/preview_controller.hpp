// Preview control of the cart-table model: CoM motion whose ZMP follows a reference that is known some time
// ahead.
#pragma once

#include <Eigen/Core>

namespace gaitway::trajectory {

// Reference ZMP by points; row 0 is now, and after the last valid row it stays constant.
struct ZmpReference {
  static constexpr int kCapacity = 512;
  Eigen::Matrix<double, kCapacity, 2> point;  // m; columns x, y
  int count = 0;
};

// State of the cart, both axes.
struct Cart {
  Eigen::Matrix<double, 3, 2> motion =
      Eigen::Matrix<double, 3, 2>::Zero();                    // rows: m, m/s, m/s²; columns x, y
  Eigen::RowVector2d error_sum = Eigen::RowVector2d::Zero();  // of ZMP − reference, m
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.motion, self.error_sum);
  }
};

struct PreviewParameters {
  double com_height_m = 0.378;
  double period_s = 0.010;
  int points = 160;               // of preview
  double zmp_error_weight = 1.0;  // Q of the ZMP error
  double jerk_weight = 1e-6;      // R of the jerk
};

// Kajita et al., "Biped walking pattern generation by using preview control of zero-moment point", ICRA 2003,
// with the servo form of Katayama et al. 1985: u = −Gi Σe − Gx x − Σ Gp(j) p_ref(k+j). The gains of
// everything beyond the preview are lumped into the last one, which is exact for a reference that stays
// constant there and makes the controller independent of where the origin lies.
class PreviewController {
 public:
  // Solves the discrete Riccati equation; allocates. Throws std::invalid_argument for parameters without a
  // solution.
  explicit PreviewController(const PreviewParameters& parameters);

  // Advances the cart by one period. reference.point.row(index) is the reference of the cart's present
  // instant. No allocation; about 0.1 µs for 160 points.
  void step(Cart& cart, const ZmpReference& reference, int index) const noexcept;

  // ZMP of the cart-table model: c − (z/g)·c̈.
  [[nodiscard]] Eigen::RowVector2d zmp(const Cart& cart) const noexcept {
    return cart.motion.row(0) - height_over_gravity_s2_ * cart.motion.row(2);
  }

  [[nodiscard]] const Eigen::RowVector3d& state_gain() const noexcept { return state_gain_; }
  [[nodiscard]] const Eigen::VectorXd& preview_gain() const noexcept {
    return preview_gain_;
  }  // [j−1], j = 1..points

 private:
  double height_over_gravity_s2_;
  Eigen::Matrix3d transition_;
  Eigen::Vector3d input_;
  double integral_gain_ = 0.0;
  Eigen::RowVector3d state_gain_ = Eigen::RowVector3d::Zero();
  Eigen::VectorXd preview_gain_;
  Eigen::VectorXd remaining_gain_;  // [j]: sum of preview_gain_[j..end]; one entry longer, the last is zero
};

}  // namespace gaitway::trajectory
