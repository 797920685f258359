// One mean a channel, in the order in which they are taken.
#include "tools/calibrate/standing_measurement.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::calibration {
namespace {

constexpr std::size_t kOtherChannels = 3 + 2 + 2 * kCells;

}  // namespace

BlockMean::BlockMean(int samples) : block_size_(std::max(1, samples / kBlocks)) {}

void BlockMean::add(double sample) {
  const auto block = static_cast<std::size_t>(std::min(count_++ / block_size_, kBlocks - 1));
  sums_[block] += sample;
  ++sizes_[block];
}

double BlockMean::mean() const {
  double sum = 0.0;
  for (const double block : sums_) sum += block;
  return sum / count_;
}

double BlockMean::deviation() const {
  double squares = 0.0;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const double off = sums_[i] / sizes_[i] - mean();
    squares += off * off;
  }
  return std::sqrt(squares / (kBlocks - 1) / kBlocks);
}

StandingReading::StandingReading(std::size_t joints, int samples)
    : joints_(joints), channels_(joints + kOtherChannels, BlockMean(samples)) {}

void StandingReading::take(std::span<const double> joint_rad, const Eigen::Vector3d& specific_force_m_per_s2,
                           const Eigen::Vector2d& inclination_rad,
                           const std::array<std::array<double, kCells>, 2>& force_N) {
  auto next = channels_.begin();
  for (const double value : joint_rad) (next++)->add(value);
  for (const double value : specific_force_m_per_s2) (next++)->add(value);
  for (const double value : inclination_rad) (next++)->add(value);
  for (const auto& foot : force_N) {
    for (const double value : foot) (next++)->add(value);
  }
}

StandingMeasurement StandingReading::result() const {
  StandingMeasurement result;
  auto next = channels_.begin();
  for (std::size_t j = 0; j < joints_; ++j) result.joint_rad.push_back((next++)->mean());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    result.specific_force_m_per_s2[axis] = next->mean();
    result.specific_force_deviation_m_per_s2[axis] = (next++)->deviation();
  }
  result.inclination_rad.emplace();
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    (*result.inclination_rad)[axis] = next->mean();
    result.inclination_deviation_rad[axis] = (next++)->deviation();
  }
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      result.force_N[side][cell] = next->mean();
      result.force_deviation_N[side][cell] = (next++)->deviation();
    }
  }
  return result;
}

}  // namespace gaitway::calibration
