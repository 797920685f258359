// What the robot must be able to do on flat ground with a body that its planner knows only roughly (mismatch
// 1).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "repeats.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using simulator::Scenario;

class WalkingSeeds : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] std::uint64_t seed() const { return static_cast<std::uint64_t>(GetParam()); }
};

class StraightWalk : public WalkingSeeds {};
class StopsTurnsAndSideSteps : public WalkingSeeds {};

TEST_P(StraightWalk, SixtySecondsAtTheCommandedSpeed) {
  SimulatedRun run(seed());
  run.play({.seconds = 61.0, .events = {walk_at(1.0, 0.15)}});
  EXPECT_FALSE(run.metrics().fell) << "at " << run.metrics().fell_at_s << " s";
  EXPECT_NEAR(run.metrics().mean_speed_m_per_s(), 0.15, 0.015);
  EXPECT_EQ(run.cosimulation.message_controller().state().late, 0U);
  EXPECT_EQ(run.cosimulation.message_controller().state().refused, 0U);
}

TEST_P(StopsTurnsAndSideSteps, StopsAndStands) {
  SimulatedRun run(seed());
  run.play({.seconds = 14.0, .events = {walk_at(1.0, 0.15), stand_at(5.0 + 0.13 * GetParam())}});
  ASSERT_FALSE(run.metrics().fell);
  const auto& velocities = run.cosimulation.plant().velocities();
  EXPECT_LT(std::hypot(velocities[0], velocities[1]), 0.02) << "it stands";
}

TEST_P(StopsTurnsAndSideSteps, TurnsOnTheSpotToTheLeft) {
  SimulatedRun run(seed());
  run.play({.seconds = 16.0, .events = {walk_at(1.0, 0.0, 0.0, 0.3)}});
  ASSERT_FALSE(run.metrics().fell);
  EXPECT_NEAR(run.metrics().end_yaw_rad - run.metrics().start_yaw_rad, 0.3 * 15.0, 0.15 * 0.3 * 15.0);
}

TEST_P(StopsTurnsAndSideSteps, TurnsOnTheSpotToTheRight) {
  SimulatedRun run(seed());
  run.play({.seconds = 16.0, .events = {walk_at(1.0, 0.0, 0.0, -0.3)}});
  ASSERT_FALSE(run.metrics().fell);
  EXPECT_NEAR(run.metrics().end_yaw_rad - run.metrics().start_yaw_rad, -0.3 * 15.0, 0.15 * 0.3 * 15.0);
}

TEST_P(StopsTurnsAndSideSteps, SideSteps) {
  SimulatedRun run(seed());
  run.play({.seconds = 16.0, .events = {walk_at(1.0, 0.0, GetParam() % 2 == 0 ? 0.05 : -0.05)}});
  ASSERT_FALSE(run.metrics().fell);
  EXPECT_NEAR(std::abs(run.metrics().mean_side_speed_m_per_s()), 0.05, 0.01);
}

// Nobody tells the robot of the slope.
TEST(UnpreparedSlope, IsStoodAndWalkedOnInAnyDirection) {
  const double slope_rad = 6.0 * std::numbers::pi / 180.0;
  for (int k = 0; k < test::repeats(8); ++k) {
    const double uphill_rad = k * std::numbers::pi / 4.0;
    simulator::GroundConditions ground;
    ground.slope_rad = slope_rad * Eigen::Vector2d(std::cos(uphill_rad), std::sin(uphill_rad));
    auto run = SimulatedRun::on_ground(static_cast<std::uint64_t>(k + 1), ground);
    run.play({.seconds = 8.0, .events = {walk_at(1.0, 0.15)}});
    EXPECT_FALSE(run.metrics().fell) << "uphill towards " << 45 * k << " degrees";
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, StraightWalk, ::testing::Range(1, 1 + seeds(20)));
INSTANTIATE_TEST_SUITE_P(Seeds, StopsTurnsAndSideSteps, ::testing::Range(1, 1 + seeds(10)));

}  // namespace
}  // namespace gaitway::scenarios
