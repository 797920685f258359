// Averages what all sensors say while the robot stands in one pose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {

// Mean of many samples, and its deviation from the means of some blocks of them: neighbouring samples may be
// alike.
class BlockMean {
 public:
  explicit BlockMean(int samples);

  void add(double sample);
  [[nodiscard]] double mean() const;
  [[nodiscard]] double deviation() const;

 private:
  static constexpr int kBlocks = 10;
  int block_size_, count_ = 0;
  std::array<double, kBlocks> sums_{};
  std::array<int, kBlocks> sizes_{};
};

class StandingReading {
 public:
  // `samples`: how many will be taken; at least 10.
  StandingReading(std::size_t joints, int samples);

  // Encoders without calibration; specific force and inclination (roll, pitch) of the trunk; [Side][cell].
  void take(std::span<const double> joint_rad, const Eigen::Vector3d& specific_force_m_per_s2,
            const Eigen::Vector2d& inclination_rad, const std::array<std::array<double, kCells>, 2>& force_N);
  // Name, feet and placement are left as they are in a new one.
  [[nodiscard]] StandingMeasurement result() const;

 private:
  std::size_t joints_;
  std::vector<BlockMean> channels_;
};

}  // namespace gaitway::calibration
