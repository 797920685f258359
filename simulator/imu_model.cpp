// Draws one part's errors, and follows its pendulum.
#include "imu_model.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "gaitway/geometry/tilt.hpp"

namespace gaitway::simulator {
namespace {

constexpr std::uint64_t kPartStream = 0x696D'752D'7061'7274ULL, kWalkStream = 0x696D'752D'7761'6C6BULL;
constexpr double kSmallest = 1e-12;
constexpr double kTurn_rad = 2.0 * std::numbers::pi;

Eigen::Vector3d normal_vector(facts::RandomStream& random, double deviation) {
  Eigen::Vector3d drawn;
  for (double& value : drawn) value = deviation * random.normal();
  return drawn;
}

// Scale on the diagonal, axes that are not square beside it.
Eigen::Matrix3d sensitivity(facts::RandomStream& random, double scale, double axis_rad) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      matrix(row, column) += (row == column ? scale : axis_rad) * random.normal();
    }
  }
  return matrix;
}

Eigen::Matrix3d askew(facts::RandomStream& random, double angle_rad) {
  Eigen::Vector3d axis = normal_vector(random, 1.0);
  if (axis.norm() < kSmallest) axis = Eigen::Vector3d::UnitX();
  return Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
}

}  // namespace

ImuModel::ImuModel(std::uint64_t seed, double deviations, double step_s)
    : walk_random_(seed, kWalkStream),
      step_s_(step_s),
      walk_per_step_(deviations * ImuDeviations{}.gyro_walk_rad_per_s_rts * std::sqrt(step_s)) {
  const ImuDeviations d;
  facts::RandomStream random(seed, kPartStream);
  truth_.mounting = askew(random, deviations * d.mounting_rad);
  truth_.gyro_sensitivity = sensitivity(random, deviations * d.gyro_scale, deviations * d.gyro_axis_rad);
  for (Eigen::Index row = 0; row < 3; ++row) {
    truth_.gyro_per_acceleration_s_per_m.row(row) =
        normal_vector(random, deviations * d.gyro_per_acceleration_s_per_m).transpose();
  }
  truth_.accelerometer_sensitivity =
      sensitivity(random, deviations * d.accelerometer_scale, deviations * d.accelerometer_axis_rad);
  truth_.accelerometer_zero_m_per_s2 = normal_vector(random, deviations * d.accelerometer_zero_m_per_s2);
  truth_.inclinometer_zero_rad = normal_vector(random, deviations * d.inclinometer_zero_rad).head<2>();
  truth_.inclinometer_cross_axis = normal_vector(random, deviations * d.inclinometer_cross_axis).head<2>();
}

ImuModel::Reading ImuModel::step(const Eigen::Vector3d& turn_rad_per_s,
                                 const Eigen::Vector3d& force_m_per_s2) noexcept {
  if (walk_per_step_ > 0.0) {
    for (double& bias : walked_bias_) bias += walk_per_step_ * walk_random_.quick_normal();
  }
  // A body in free fall has no apparent gravity, and the pendulum goes on as it swings.
  const double frequency = pendulum_.natural_frequency_rad_per_s;
  const double pull = force_m_per_s2.norm() / facts::kGravity_m_per_s2;
  Eigen::Vector2d off_rad = geometry::tilt_at_rest(force_m_per_s2) - hangs_rad_;
  off_rad.x() = std::remainder(off_rad.x(), kTurn_rad);  // roll goes on over half a turn
  const Eigen::Vector2d acceleration =
      frequency * frequency * pull * off_rad - 2.0 * pendulum_.damping_ratio * frequency * swings_rad_per_s_;
  swings_rad_per_s_ += step_s_ * acceleration;
  hangs_rad_ += step_s_ * swings_rad_per_s_;
  hangs_rad_.x() = std::remainder(hangs_rad_.x(), kTurn_rad);
  const Eigen::Vector2d crossed = truth_.inclinometer_cross_axis.cwiseProduct(hangs_rad_.reverse());
  return {.angular_velocity_rad_per_s = truth_.gyro_sensitivity * turn_rad_per_s +
                                        truth_.gyro_per_acceleration_s_per_m * force_m_per_s2 + walked_bias_,
          .acceleration_m_per_s2 =
              truth_.accelerometer_sensitivity * force_m_per_s2 + truth_.accelerometer_zero_m_per_s2,
          .inclination_rad = hangs_rad_ + crossed + truth_.inclinometer_zero_rad};
}

void ImuModel::settle(const Eigen::Vector3d& force_m_per_s2) noexcept {
  hangs_rad_ = geometry::tilt_at_rest(force_m_per_s2);
  swings_rad_per_s_.setZero();
}

}  // namespace gaitway::simulator
