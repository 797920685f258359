// Attitude of the trunk: roll and pitch against gravity from gyro and inclinometer, yaw from the gyro alone.
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace gaitway::zmp {

struct Attitude {  // R = Rz(yaw) Ry(pitch) Rx(roll), trunk to world
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;  // continuous: not wrapped

  // Trunk to the level frame that shares its heading.
  [[nodiscard]] Eigen::Matrix3d tilt() const noexcept;
};

// Complementary filter: the gyro's rates are integrated, and roll and pitch are drawn to the measured tilt
// with a time constant (R. Mahony, T. Hamel, J.-M. Pflimlin, "Nonlinear complementary filters on the special
// orthogonal group", IEEE Trans. Automatic Control 53(5), 2008; here on Euler angles, for a trunk that stays
// away from +-90 degrees of pitch).
class AttitudeFilter {
 public:
  explicit AttitudeFilter(double time_constant_s) noexcept : time_constant_s_(time_constant_s) {}

  // angular_velocity: of the trunk, in its own frame, without bias, over the last dt_s. tilt: measured roll
  // and pitch, rad; none: the gyro alone. The first measured tilt is taken as it is.
  void update(const Eigen::Vector3d& angular_velocity_rad_per_s, const std::optional<Eigen::Vector2d>& tilt,
              double dt_s) noexcept;

  // After a gap: roll and pitch start anew at the next measured tilt, yaw stays.
  void lose_tilt() noexcept { has_tilt_ = false; }

  [[nodiscard]] const Attitude& attitude() const noexcept { return attitude_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.has_tilt_, self.attitude_);
  }

 private:
  double time_constant_s_;
  bool has_tilt_ = false;
  Attitude attitude_;
};

// Roll and pitch that a specific force means, if the trunk is not accelerated; nothing if its length is
// further than `band` from gravity's.
[[nodiscard]] std::optional<Eigen::Vector2d> tilt_of_acceleration(
    const Eigen::Vector3d& specific_force_m_per_s2, double band_m_per_s2) noexcept;

}  // namespace gaitway::zmp
