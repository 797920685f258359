// What is estimated of a robot that lies, from synthetic sensors.
#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/zmp/state_estimator.hpp"
#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::humanoid;

// On its back, toes up: while a foot rocks, its x axis passes the vertical, and the level frame turns about
// by most of half a turn within a tick or two. The robot itself hardly moves.
TEST(LyingEstimate, VelocityIsThatOfTheBodyThoughTheFrameFlips) {
  const Eigen::Matrix3d on_its_back =
      Eigen::AngleAxisd(-M_PI / 2.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto& leg = humanoid().legs[0].joints;
  const auto ankle_pitch = static_cast<std::size_t>(leg[4]), ankle_roll = static_cast<std::size_t>(leg[5]);
  urdf::ForwardKinematics kinematics(humanoid());
  const auto com_from_sole = [&](const std::vector<double>& posture) -> Eigen::Vector3d {
    kinematics.compute(posture);
    return on_its_back * (kinematics.com_m() - kinematics.sole_pose(urdf::Side::left).translation());
  };
  StateEstimator estimator(humanoid(), EstimatorParameters{});
  test::Sensors sensors;
  sensors.imu.inclination[1] = -M_PI / 2.0 + 0.02;
  sensors.imu.acceleration[0] = test::kGravity_m_per_s2;
  sensors.imu.acceleration[2] = 0.0;
  Estimate estimate{};
  std::vector<double> posture = test::home_posture(humanoid());
  Eigen::Vector3d last = com_from_sole(posture);
  double largest_turn_rad = 0.0;
  constexpr int kTicks = 400, kSettle = 50;  // that nothing bears the robot is a free fall at first
  for (int i = 0; i < kTicks; ++i) {
    const double phase = 2.0 * M_PI * 0.5 * i * 0.01;
    posture[ankle_pitch] = humanoid().joints[ankle_pitch].home_rad + 0.1 * std::sin(phase);
    posture[ankle_roll] = 0.01 * std::cos(phase);
    sensors.set_posture(posture);
    sensors.stamp((i + 1) * test::kTick_ns);
    const Eigen::Vector2d before(estimate.com);
    ASSERT_TRUE(
        estimator.update((i + 1) * test::kTick_ns, sensors.joints, sensors.forces, sensors.imu, estimate));
    const Eigen::Vector3d now = com_from_sole(posture);
    const Eigen::Vector3d velocity = (now - last) / 0.01;
    last = now;
    if (i < kSettle) continue;
    const Eigen::Vector2d after(estimate.com);
    largest_turn_rad = std::max(largest_turn_rad, std::acos(before.normalized().dot(after.normalized())));
    EXPECT_NEAR(Eigen::Vector3d(estimate.com_velocity).norm(), velocity.norm(), 0.05) << "tick " << i;
  }
  EXPECT_GT(largest_turn_rad, 0.5) << "the frame did not flip: this showed nothing";
}

}  // namespace
}  // namespace gaitway::zmp
