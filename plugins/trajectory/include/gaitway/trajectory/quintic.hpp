// A polynomial of fifth degree between two states of position, velocity and acceleration: the least-jerk
// motion.
#pragma once

#include <Eigen/Core>
#include <array>

namespace gaitway::trajectory {

// Position, velocity and acceleration of one coordinate, in its unit, 1/s and 1/s².
struct MotionState {
  double position = 0.0, velocity = 0.0, acceleration = 0.0;
};

class Quintic {
 public:
  Quintic() = default;

  // From `start` at time 0 to `end` at duration_s > 0.
  Quintic(const MotionState& start, const MotionState& end, double duration_s) noexcept
      : duration_s_(duration_s) {
    const double T = duration_s;
    const double v0 = start.velocity * T, a0 = start.acceleration * T * T;
    const double v1 = end.velocity * T, a1 = end.acceleration * T * T;
    const double d = end.position - start.position;
    coefficient_ = {start.position,
                    v0,
                    0.5 * a0,
                    10.0 * d - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
                    -15.0 * d + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
                    6.0 * d - 3.0 * (v0 + v1) - 0.5 * (a0 - a1)};
  }

  [[nodiscard]] MotionState at(double time_s) const noexcept {
    const double s = time_s / duration_s_;
    const auto& c = coefficient_;
    return {
        c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5])))),
        (c[1] + s * (2.0 * c[2] + s * (3.0 * c[3] + s * (4.0 * c[4] + s * 5.0 * c[5])))) / duration_s_,
        (2.0 * c[2] + s * (6.0 * c[3] + s * (12.0 * c[4] + s * 20.0 * c[5]))) / (duration_s_ * duration_s_)};
  }

  [[nodiscard]] double jerk(double time_s) const noexcept {
    const double s = time_s / duration_s_;
    const auto& c = coefficient_;
    return (6.0 * c[3] + s * (24.0 * c[4] + s * 60.0 * c[5])) / (duration_s_ * duration_s_ * duration_s_);
  }

 private:
  std::array<double, 6> coefficient_{};
  double duration_s_ = 1.0;
};

}  // namespace gaitway::trajectory
