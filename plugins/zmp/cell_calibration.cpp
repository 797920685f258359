// Dead cells first, then the gains from plate and weight, then the forces.
#include "gaitway/zmp/cell_calibration.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::zmp {
namespace {

constexpr std::array<double, 4> kWarp{1.0, -1.0, -1.0,
                                      1.0};  // front left, front right, rear left, rear right
constexpr double kTaughtShare = 0.15;        // of the weight on a foot, from which it teaches
constexpr double kDeadShare = 0.08;          // of the weight, that a cell which says nothing should bear
constexpr double kSilent = 5.0;              // times the noise: no more than this is nothing
constexpr double kRevivedShare = 0.5;        // of what it should bear: such a cell is alive
constexpr int kEvidence_samples = 10;
constexpr double kGate = 5.0;          // deviations: what is further off is a fault, not a gain
constexpr double kUnevenness = 0.002;  // of a foot's force: springs that are not quite equal
// Of the weight, one sample: limbs that are accelerated otherwise than the trunk. It is alike from one sample
// to the next, so it is taken for larger than it is.
constexpr double kWeightNoise = 0.3;
constexpr double kScaleTime_s = 10.0;   // in which load and apparent weight are averaged
constexpr double kLeastApparent = 0.1;  // of that average: before, it says nothing
constexpr double kGroundedShare = 0.5;  // of the weight on the feet, from which they tell it

}  // namespace

CellCalibration::CellCalibration(const EstimatorParameters& parameters, double weight_N) noexcept
    : weight_N_(weight_N),
      cell_noise_N_(parameters.cell_noise_N),
      gain_deviation_(parameters.cell_gain_deviation),
      gain_lifetime_s_(parameters.cell_gain_lifetime_s) {
  covariance_.diagonal().setConstant(Eigen::numext::abs2(gain_deviation_));
}

void CellCalibration::update(const CellForces& measured_N, double apparent_weight, double dt_s) noexcept {
  for (std::size_t side = 0; side < measured_N.size(); ++side) {
    for (std::size_t cell = 0; cell < 4; ++cell) {
      measured_[static_cast<Eigen::Index>(4 * side + cell)] = measured_N[side][cell];
    }
  }
  // A gain wanders, so that what was learned long ago counts less: a first-order Gauss-Markov process
  // about 1.
  const double forgotten = dt_s / gain_lifetime_s_;
  state_.array() += forgotten * (1.0 - state_.array());
  covariance_ *= 1.0 - 2.0 * forgotten;
  covariance_.diagonal().array() += 2.0 * forgotten * Eigen::numext::abs2(gain_deviation_);
  for (std::size_t side = 0; side < measured_N.size(); ++side) {
    find_dead_cells(side);
    learn_from_plate(side);
  }
  learn_from_weight(apparent_weight, dt_s);
  for (std::size_t side = 0; side < force_N_.size(); ++side) {
    for (std::size_t cell = 0; cell < 4; ++cell) {
      const std::size_t i = 4 * side + cell;
      const auto at = static_cast<Eigen::Index>(i);
      force_N_[side][cell] = dead_[i] ? from_others_N(side, cell) : state_[at] * measured_[at];
    }
  }
}

double CellCalibration::from_others_N(std::size_t side, std::size_t cell) const noexcept {
  double sum = 0.0;
  for (std::size_t other = 0; other < 4; ++other) {
    const auto at = static_cast<Eigen::Index>(4 * side + other);
    if (other != cell) sum += kWarp[other] * state_[at] * measured_[at];
  }
  return -kWarp[cell] * sum;
}

int CellCalibration::dead_cell(std::size_t side) const noexcept {
  for (int cell = 0; cell < 4; ++cell) {
    if (dead_[4 * side + static_cast<std::size_t>(cell)]) return cell;
  }
  return -1;
}

bool CellCalibration::any_dead() const noexcept {
  return std::ranges::any_of(dead_, [](bool dead) { return dead; });
}

// A cell at the edge of the support bears nothing, too, but then the other three do not say that it should.
void CellCalibration::find_dead_cells(std::size_t side) noexcept {
  const int dead = dead_cell(side);
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const std::size_t i = 4 * side + cell;
    if (dead >= 0 && static_cast<int>(cell) != dead) continue;  // two of four cannot be told
    const double reading = measured_[static_cast<Eigen::Index>(i)];
    const double due = from_others_N(side, cell);
    if (due < kDeadShare * weight_N_) continue;
    const bool speaks_for_change =
        dead_[i] ? reading > kRevivedShare * due : std::abs(reading) < kSilent * cell_noise_N_;
    evidence_[i] = speaks_for_change ? evidence_[i] + 1 : 0;
    if (evidence_[i] < kEvidence_samples) continue;
    dead_[i] = !dead_[i];
    evidence_[i] = 0;
    return;
  }
}

double CellCalibration::foot_force_N(std::size_t side) const noexcept {
  const auto first = static_cast<Eigen::Index>(4 * side);
  double force = state_.segment<4>(first).dot(measured_.segment<4>(first));
  const int dead = dead_cell(side);
  if (dead >= 0) {
    force +=
        from_others_N(side, static_cast<std::size_t>(dead)) - state_[first + dead] * measured_[first + dead];
  }
  return force;
}

void CellCalibration::learn_from_plate(std::size_t side) noexcept {
  const double force = foot_force_N(side);
  const auto first = static_cast<Eigen::Index>(4 * side);
  // A cell that says nothing may be dead and not yet found: it must not spoil the others' gains.
  const bool any_silent = measured_.segment<4>(first).cwiseAbs().minCoeff() < kSilent * cell_noise_N_;
  if (dead_cell(side) >= 0 || any_silent || force < kTaughtShare * weight_N_) return;
  PerCell sensitivity = PerCell::Zero();
  for (Eigen::Index cell = 0; cell < 4; ++cell) {
    sensitivity[first + cell] = kWarp[static_cast<std::size_t>(cell)] * measured_[first + cell];
  }
  const double warp_N = sensitivity.dot(state_);
  sensitivity.segment<4>(first).array() -= sensitivity.sum() / 4.0;
  correct(sensitivity, -warp_N,
          4.0 * Eigen::numext::abs2(cell_noise_N_) + Eigen::numext::abs2(kUnevenness * force));
}

void CellCalibration::learn_from_weight(double apparent_weight, double dt_s) noexcept {
  const double force_N = foot_force_N(0) + foot_force_N(1);
  if (!(force_N > kGroundedShare * weight_N_)) return;
  borne_ += dt_s / kScaleTime_s * (force_N / weight_N_ - borne_);
  apparent_ += dt_s / kScaleTime_s * (apparent_weight - apparent_);
  if (any_dead() || !(apparent_ > kLeastApparent)) return;
  const double expected_N = borne_ / apparent_ * apparent_weight * weight_N_;
  const PerCell sensitivity = measured_.array() - measured_.mean();
  correct(sensitivity, expected_N - force_N, Eigen::numext::abs2(kWeightNoise * weight_N_));
}

void CellCalibration::correct(const PerCell& sensitivity, double residual, double variance) noexcept {
  const PerCell spread = covariance_ * sensitivity;
  const double whole = sensitivity.dot(spread) + variance;
  if (!(whole > 0.0) || Eigen::numext::abs2(residual) > Eigen::numext::abs2(kGate) * whole) return;
  state_ += spread * (residual / whole);
  covariance_ -= spread * spread.transpose() / whole;
}

double CellCalibration::variance_of_sum(PerCell weight) const noexcept {
  for (std::size_t side = 0; side < 2; ++side) {
    const int dead = dead_cell(side);
    if (dead < 0) continue;
    const auto first = static_cast<Eigen::Index>(4 * side);
    const double of_dead = weight[first + dead] * kWarp[static_cast<std::size_t>(dead)];
    for (Eigen::Index cell = 0; cell < 4; ++cell) {
      weight[first + cell] -= of_dead * kWarp[static_cast<std::size_t>(cell)];
    }
  }
  const PerCell from_gains = weight.cwiseProduct(measured_);
  return std::max(from_gains.dot(covariance_ * from_gains), 0.0) +
         Eigen::numext::abs2(cell_noise_N_) * weight.squaredNorm();
}

}  // namespace gaitway::zmp
