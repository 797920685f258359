// Gains by the discrete Riccati equation, and the step of the preview controller.
#include "gaitway/trajectory/preview_controller.hpp"

#include <algorithm>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

// The cart-table with the ZMP error as first state: x̃ = (e, Δc, Δċ, Δc̈), input Δjerk.
struct AugmentedModel {
  Eigen::Matrix4d transition;
  Eigen::Vector4d input;
};

AugmentedModel augment(const Eigen::Matrix3d& A, const Eigen::Vector3d& b, const Eigen::RowVector3d& c) {
  AugmentedModel model;
  model.transition.setZero();
  model.transition(0, 0) = 1.0;
  model.transition.block<1, 3>(0, 1) = c * A;
  model.transition.block<3, 3>(1, 1) = A;
  model.input << (c * b).value(), b;
  return model;
}

// P of P = Q + ÃᵀPÃ − ÃᵀPb̃ (R + b̃ᵀPb̃)⁻¹ b̃ᵀPÃ, by iterating it from P = Q.
Eigen::Matrix4d solve_riccati(const AugmentedModel& model, double error_weight, double jerk_weight) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = error_weight;
  Eigen::Matrix4d P = Q;
  constexpr int kMostIterations = 20000;
  for (int i = 0; i < kMostIterations; ++i) {
    const Eigen::RowVector4d bPA = model.input.transpose() * P * model.transition;
    const double s = jerk_weight + model.input.dot(P * model.input);
    Eigen::Matrix4d next =
        Q + model.transition.transpose() * P * model.transition - bPA.transpose() * bPA / s;
    next = (0.5 * (next + next.transpose())).eval();
    const double change = (next - P).cwiseAbs().maxCoeff();
    P = next;
    if (change <= 1e-12 * P.cwiseAbs().maxCoeff()) return P;
  }
  throw std::invalid_argument(
      "trajectory: the Riccati equation of the preview controller does not converge; "
      "check com_height, zmp_error_weight and jerk_weight.");
}

}  // namespace

PreviewController::PreviewController(const PreviewParameters& parameters)
    : height_over_gravity_s2_(parameters.com_height_m / facts::kGravity_m_per_s2),
      preview_gain_(parameters.points),
      remaining_gain_(parameters.points + 1) {
  if (parameters.points < 1 || parameters.points >= ZmpReference::kCapacity) {
    throw std::invalid_argument(
        "trajectory: preview points must be within [1, 511]; change the parameter preview.");
  }
  const double T = parameters.period_s;
  transition_ << 1.0, T, 0.5 * T * T, 0.0, 1.0, T, 0.0, 0.0, 1.0;
  input_ << T * T * T / 6.0, 0.5 * T * T, T;
  const Eigen::RowVector3d output(1.0, 0.0, -height_over_gravity_s2_);

  const AugmentedModel model = augment(transition_, input_, output);
  const Eigen::Matrix4d P = solve_riccati(model, parameters.zmp_error_weight, parameters.jerk_weight);
  const double s = parameters.jerk_weight + model.input.dot(P * model.input);
  const Eigen::RowVector4d gain = model.input.transpose() * P * model.transition / s;
  integral_gain_ = gain(0);
  state_gain_ = gain.tail<3>();

  const Eigen::Matrix4d closed_transposed = (model.transition - model.input * gain).transpose();
  Eigen::Vector4d x = -closed_transposed * P.col(0);
  preview_gain_(0) = -integral_gain_;
  for (Eigen::Index j = 1; j < preview_gain_.size(); ++j) {
    preview_gain_(j) = model.input.dot(x) / s;
    x = closed_transposed * x;
  }
  // At rest on a constant reference the input vanishes: Gx(0) + Σ Gp = 0 over the infinite preview.
  preview_gain_(preview_gain_.size() - 1) -= state_gain_(0) + preview_gain_.sum();

  remaining_gain_(parameters.points) = 0.0;
  for (Eigen::Index j = parameters.points - 1; j >= 0; --j) {
    remaining_gain_(j) = remaining_gain_(j + 1) + preview_gain_(j);
  }
}

void PreviewController::step(Cart& cart, const ZmpReference& reference, int index) const noexcept {
  const int last = reference.count - 1;
  const Eigen::RowVector2d present = reference.point.row(std::min(index, last));
  cart.error_sum += zmp(cart) - present;
  // Rows index+1 .. last vary; all beyond is the last row.
  const Eigen::Index varying = std::clamp<Eigen::Index>(last - index, 0, preview_gain_.size());
  const double rest = remaining_gain_(varying);
  Eigen::RowVector2d jerk = -integral_gain_ * cart.error_sum - state_gain_ * cart.motion;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    jerk(axis) -= rest * reference.point(last, axis);
    if (varying > 0) {
      jerk(axis) -= preview_gain_.head(varying).dot(reference.point.col(axis).segment(index + 1, varying));
    }
  }
  const Eigen::Matrix<double, 3, 2> next = transition_ * cart.motion + input_ * jerk;
  cart.motion = next;
}

}  // namespace gaitway::trajectory
