// What the feet's force cells would say if their gains were right: gains learned while the robot moves, a
// dead cell's force from the other three.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

using CellForces = std::array<std::array<double, 4>, 2>;  // N; [Side][cell], in the order of Foot::cell_m

// A sole is a rigid plate on four equal springs: it is never warped, so front left + rear right = front right
// + rear left, whatever the load. That is one equation a foot and sample for the four gains; as the centre of
// pressure wanders ahead and aside it tells all of their ratios. The feet are told against each other by
// their common load: the weight, as the trunk's vertical acceleration makes it heavier or lighter, is the
// same whoever bears it. One Kalman filter on the eight inverse gains holds both. What neither tells is left
// out of the corrections: the scale of a foot from its plate, the scale of all from the weight; else noise in
// the readings, which are the sensitivities, would shrink it sample by sample. No ZMP depends on it.
class CellCalibration {
 public:
  static constexpr int kCells = 8;
  using PerCell = Eigen::Matrix<double, kCells, 1>;  // index: 4 * side + cell

  CellCalibration(const EstimatorParameters& parameters, double weight_N) noexcept;

  // measured: one sample. apparent_weight: vertical specific force of the trunk over g. dt_s: since the last
  // one.
  void update(const CellForces& measured_N, double apparent_weight, double dt_s) noexcept;

  [[nodiscard]] const CellForces& force_N() const noexcept { return force_N_; }
  [[nodiscard]] bool is_dead(urdf::Side side, std::size_t cell) const noexcept {
    return dead_[4 * static_cast<std::size_t>(side) + cell];
  }
  [[nodiscard]] bool any_dead() const noexcept;
  // Of the sum of all cells' forces, each times its weight: from the gains' uncertainty and the cells' noise,
  // N^2.
  [[nodiscard]] double variance_of_sum(PerCell weight) const noexcept;
  [[nodiscard]] double gain(urdf::Side side, std::size_t cell) const noexcept {
    return 1.0 / state_[4 * static_cast<Eigen::Index>(side) + static_cast<Eigen::Index>(cell)];
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.state_, self.covariance_, self.borne_, self.apparent_, self.measured_, self.force_N_,
            self.dead_, self.evidence_);
  }

 private:
  void find_dead_cells(std::size_t side) noexcept;
  void learn_from_plate(std::size_t side) noexcept;
  void learn_from_weight(double apparent_weight, double dt_s) noexcept;
  void correct(const PerCell& sensitivity, double residual, double variance) noexcept;
  [[nodiscard]] double foot_force_N(std::size_t side) const noexcept;
  [[nodiscard]] int dead_cell(std::size_t side) const noexcept;  // -1: none
  // Force on a cell, as the foot's other three tell it.
  [[nodiscard]] double from_others_N(std::size_t side, std::size_t cell) const noexcept;

  double weight_N_, cell_noise_N_, gain_deviation_, gain_lifetime_s_;
  PerCell state_ = PerCell::Ones();  // inverse gains
  Eigen::Matrix<double, kCells, kCells> covariance_ = Eigen::Matrix<double, kCells, kCells>::Zero();
  double borne_ = 0.0, apparent_ = 0.0;  // recent sums of load and apparent weight, as shares of the weight
  PerCell measured_ = PerCell::Zero();
  CellForces force_N_{};
  std::array<bool, kCells> dead_{};
  std::array<int, kCells> evidence_{};  // samples in a row that speak for a change of dead_
};

}  // namespace gaitway::zmp
