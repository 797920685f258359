// The swing foot starts and lands at rest, and changes its target without a jump.
#include "gaitway/trajectory/step_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gaitway::trajectory {
namespace {

constexpr double kFlatness = 0.3;

TEST(SwingFoot, LiftsAndLandsWithoutVelocityAndAcceleration) {
  constexpr double kSmall = 1e-3;
  for (const double share : {kSmall, 1.0 - kSmall}) {
    EXPECT_LT(swing_height_m(share, 0.03), 0.03 * 64.0 * std::pow(kSmall, 3));  // of third order
  }
  EXPECT_EQ(swing_height_m(0.0, 0.03), 0.0);
  EXPECT_EQ(swing_height_m(1.0, 0.03), 0.0);
  EXPECT_DOUBLE_EQ(swing_height_m(0.5, 0.03), 0.03);
}

TEST(SwingFoot, GoesFromLiftToLanding) {
  const Pose2 lift{0.1, 0.2, 0.3}, landing{0.4, -0.1, 0.5};
  const SwingFoot swing(lift, landing, 0.34, kFlatness);
  EXPECT_NEAR(swing.at(0.0).x_m, lift.x_m, 1e-12);
  EXPECT_NEAR(swing.at(0.34).y_m, landing.y_m, 1e-12);
  EXPECT_NEAR(swing.at(0.17).yaw_rad, 0.4, 1e-12);
}

TEST(SwingFoot, NewTargetChangesNeitherPositionNorVelocityNorAcceleration) {
  SwingFoot swing({}, {0.2, 0.0, 0.0}, 0.34, kFlatness);
  constexpr double t = 0.1, h = 1e-4;
  const SwingFoot before = swing;
  swing.aim({0.1, 0.05, 0.2}, t, 0.34);
  EXPECT_NEAR(swing.at(t).x_m, before.at(t).x_m, 1e-12);
  EXPECT_NEAR(swing.at(t + h).x_m, before.at(t + h).x_m, 1e-8);  // third order in h
  EXPECT_NEAR(swing.at(0.34).x_m, 0.1, 1e-12);
  EXPECT_NEAR(swing.at(0.34).yaw_rad, 0.2, 1e-12);
}

TEST(SwingFoot, AimingAtTheSameTargetChangesNothing) {
  const Pose2 landing{0.2, 0.01, 0.1};
  SwingFoot swing({}, landing, 0.34, kFlatness);
  const SwingFoot before = swing;
  swing.aim(landing, 0.08, 0.34);
  EXPECT_NEAR(swing.at(0.2).x_m, before.at(0.2).x_m, 1e-12);
  EXPECT_NEAR(swing.at(0.2).yaw_rad, before.at(0.2).yaw_rad, 1e-12);
}

TEST(SwingFoot, DoesTheRestOfItsWayInTheTimeThatIsGiven) {
  for (const double swing_s : {0.24, 0.34, 0.50}) {
    SwingFoot swing({}, {0.2, 0.0, 0.0}, 0.34, kFlatness);
    constexpr double t = 0.12, h = 1e-5;
    const double rate_per_s = (swing.share(t) - swing.share(t - h)) / h;
    swing.aim({0.2, 0.0, 0.0}, t, swing_s);
    EXPECT_NEAR(swing.share(t), t / 0.34, 1e-12);
    EXPECT_NEAR((swing.share(t + h) - swing.share(t)) / h, rate_per_s, 1e-2);
    EXPECT_NEAR(swing.share(swing_s), 1.0, 1e-12);
    EXPECT_NEAR(swing.at(swing_s).x_m, 0.2, 1e-12);
    for (double s = t; s < swing_s - 0.01; s += 0.01) EXPECT_LT(swing.share(s), swing.share(s + 0.01));
    const SwingFoot before = swing;
    swing.aim({0.2, 0.0, 0.0}, 0.15, swing_s);
    EXPECT_NEAR(swing.share(0.2), before.share(0.2), 1e-12) << "aiming again changes nothing";
  }
}

// Of a swing of 1 m in 1 s: what is fastest of it, and what is most accelerated.
struct SwingExtremes {
  double speed = 0.0, acceleration = 0.0;
};
SwingExtremes swing_extremes_of(double flatness) {
  constexpr double kStep_s = 1e-3;
  const SwingFoot swing({}, {1.0, 0.0, 0.0}, 1.0, flatness);
  SwingExtremes most;
  for (double t = 0.0; t < 1.0; t += kStep_s) {
    most.speed = std::max(most.speed, (swing.at(t + kStep_s).x_m - swing.at(t).x_m) / kStep_s);
    most.acceleration = std::max(most.acceleration, std::abs(swing.acceleration_m_per_s2(t).x()));
  }
  return most;
}

TEST(SwingFoot, AFlatterOneIsSlowerAtItsFastest) {
  EXPECT_NEAR(swing_extremes_of(0.0).speed, 1.875, 1e-3);
  EXPECT_NEAR(swing_extremes_of(0.5).speed, 0.5 * (1.875 + 1.5), 1e-3);
  EXPECT_NEAR(swing_extremes_of(1.0).speed, 1.5, 1e-3);
}

TEST(SwingFoot, HalfFlatItIsAcceleratedLess) {
  const double half = swing_extremes_of(0.5).acceleration;
  EXPECT_LT(half, swing_extremes_of(0.0).acceleration - 0.5);
  EXPECT_LT(half, swing_extremes_of(1.0).acceleration - 0.5);
}

TEST(Quintic, MeetsBothEndStates) {
  const Quintic q({1.0, 2.0, 3.0}, {-1.0, 0.5, -4.0}, 0.7);
  EXPECT_NEAR(q.at(0.0).velocity, 2.0, 1e-12);
  EXPECT_NEAR(q.at(0.0).acceleration, 3.0, 1e-12);
  EXPECT_NEAR(q.at(0.7).position, -1.0, 1e-12);
  EXPECT_NEAR(q.at(0.7).velocity, 0.5, 1e-12);
  EXPECT_NEAR(q.at(0.7).acceleration, -4.0, 1e-11);
}

}  // namespace
}  // namespace gaitway::trajectory
