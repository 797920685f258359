// Random leg postures within the limits of a test robot.
#pragma once

#include <algorithm>
#include <array>
#include <random>

#include "gaitway/kinematics/leg_geometry.hpp"
#include "gaitway/kinematics/leg_solution.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics::test {

// Postures in a band of `spread_rad` around home, within the limits, the knee at least 0.05 rad from
// straight.
class LegSampler {
 public:
  LegSampler(const urdf::RobotModel& model, urdf::Side side, double spread_rad, std::uint32_t seed)
      : model_(model), side_(side), spread_rad_(spread_rad), random_(seed), home_(home_posture(model)) {}

  std::array<double, 6> angles() {
    for (;;) {
      const std::array<double, 6> angle_rad = any_angles();
      if ((sole(angle_rad).inverse() * hip_centre(model_, side_)).z() > 0.09) return angle_rad;
    }
  }

  std::array<double, 6> any_angles() {
    const LegLimits limits = leg_limits(model_, side_);
    std::array<double, 6> angle_rad{};
    for (std::size_t i = 0; i < 6; ++i) {
      const double margin = i == 3 ? 0.05 : 0.0;
      const double lower = std::max(home_of(i) - spread_rad_, limits.lower_rad[i] + margin);
      const double upper = std::min(home_of(i) + spread_rad_, limits.upper_rad[i] - margin);
      angle_rad[i] = std::uniform_real_distribution(lower, upper)(random_);
    }
    return angle_rad;
  }

  Eigen::Isometry3d sole(const std::array<double, 6>& angle_rad) const {
    std::vector<double> all = home_;
    for (std::size_t i = 0; i < 6; ++i) all[joint(i)] = angle_rad[i];
    return sole_pose(model_, side_, all);
  }

  double home_of(std::size_t i) const { return home_[joint(i)]; }
  std::array<double, 6> home() const {
    std::array<double, 6> result{};
    for (std::size_t i = 0; i < 6; ++i) result[i] = home_of(i);
    return result;
  }

 private:
  std::size_t joint(std::size_t i) const {
    return static_cast<std::size_t>(model_.legs[static_cast<std::size_t>(side_)].joints[i]);
  }

  const urdf::RobotModel& model_;
  urdf::Side side_;
  double spread_rad_;
  std::mt19937 random_;
  std::vector<double> home_;
};

inline double largest_difference(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 6; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace gaitway::kinematics::test
