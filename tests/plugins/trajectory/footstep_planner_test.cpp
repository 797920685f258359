// Footsteps keep their named limits, and the velocity its slope.
#include "gaitway/trajectory/footstep_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gaitway::trajectory {
namespace {

class Footsteps : public ::testing::Test {
 protected:
  GaitParameters parameters;
  FootstepPlanner planner{parameters};
  StepLimit applied = StepLimit::none;
};

TEST_F(Footsteps, ForwardStepLandsAheadAtNominalSpacing) {
  const Pose2 foot = planner.landing({}, Side::left, {0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.0, 0.0}, applied);
  EXPECT_NEAR(foot.x_m, 0.2 * parameters.step_time_s, 1e-12);
  EXPECT_NEAR(foot.y_m, 0.10, 1e-12);
  EXPECT_EQ(applied, StepLimit::none);
}

TEST_F(Footsteps, OnlyTheOuterFootMovesSideways) {
  const Velocity2 left{0.0, 0.05, 0.0};
  EXPECT_NEAR(planner.landing({}, Side::left, left, left, {0.0, 0.0}, applied).y_m,
              0.10 + 2.0 * 0.05 * parameters.step_time_s, 1e-12);
  EXPECT_NEAR(planner.landing({}, Side::right, left, left, {0.0, 0.0}, applied).y_m, -0.10, 1e-12);
}

TEST_F(Footsteps, LimitIsNamed) {
  const Pose2 far = planner.landing({}, Side::right, {}, {}, {0.5, 0.0}, applied);
  EXPECT_NEAR(far.x_m, parameters.max_step_forward_m, 1e-12);
  EXPECT_EQ(applied, StepLimit::length);
  applied = StepLimit::none;
  EXPECT_NEAR(planner.landing({}, Side::right, {}, {}, {0.0, -0.5}, applied).y_m,
              -parameters.max_foot_spacing_m, 1e-12);
  EXPECT_EQ(applied, StepLimit::spacing);
  applied = StepLimit::none;
  EXPECT_NEAR(planner.landing({}, Side::right, {}, {}, {0.0, 0.5}, applied).y_m, -0.093, 1e-12);
  EXPECT_EQ(applied, StepLimit::sole_gap);
  applied = StepLimit::none;
  EXPECT_NEAR(planner.landing({}, Side::left, {0.0, 0.0, 2.0}, {0.0, 0.0, 2.0}, {0.0, 0.0}, applied).yaw_rad,
              parameters.max_step_turn_rad, 1e-12);
  EXPECT_TRUE(has(applied, StepLimit::turn));
}

// Where the toes turn in, that foot steps further out, and the other one as much: else it would drift
// outwards.
TEST_F(Footsteps, AWalkThatTurnsKeepsToItsArc) {
  constexpr int kSteps = 60;
  for (const double turn_rad_per_s : {-1.5, -0.6, 0.6, 1.5}) {
    const Velocity2 velocity{0.25, 0.0, turn_rad_per_s};
    Pose2 stance;
    std::vector<Pose2> middles;
    for (int step = 1; step <= kSteps; ++step) {
      const Side swing = step % 2 == 0 ? Side::left : Side::right;
      const Pose2 foot = planner.landing(stance, swing, velocity, velocity, {0.0, 0.0}, applied);
      middles.push_back({0.5 * (stance.x_m + foot.x_m), 0.5 * (stance.y_m + foot.y_m),
                         0.5 * (stance.yaw_rad + foot.yaw_rad)});
      stance = foot;
    }
    Eigen::Vector2d way = Eigen::Vector2d::Zero();  // of two steps, along the heading between them
    for (std::size_t i = 2; i < kSteps; ++i)
      way += Pose2{middles[i - 2].x_m, middles[i - 2].y_m, middles[i - 1].yaw_rad}
                 .relative_of(middles[i])
                 .position() /
             (kSteps - 2);
    EXPECT_NEAR(way.x(), 2.0 * parameters.step_time_s * 0.25, 0.012) << turn_rad_per_s;
    EXPECT_NEAR(way.y(), 0.0, 1e-6) << turn_rad_per_s;
    EXPECT_FALSE(has(applied, StepLimit::sole_gap)) << turn_rad_per_s;
  }
}

TEST_F(Footsteps, APushBringsTheFeetNoFurtherApartThanItMayOrThanTheyWouldBeAnyway) {
  const auto spacing = [&](const Velocity2& velocity, double to_the_side_m) {
    return planner.adjusted_landing({}, Side::left, velocity, velocity, {0.0, to_the_side_m}).y_m;
  };
  const Velocity2 in_place{}, side_step{0.0, 0.15, 0.0};
  EXPECT_NEAR(spacing(in_place, 0.01), parameters.foot_spacing_m + 0.01, 1e-12);
  EXPECT_NEAR(spacing(in_place, 0.5), parameters.adjust_spacing_m, 1e-12);
  const double wide = parameters.foot_spacing_m + 2.0 * 0.15 * parameters.step_time_s;
  ASSERT_GT(wide, parameters.adjust_spacing_m);
  EXPECT_NEAR(spacing(side_step, 0.5), wide, 1e-12);
  EXPECT_NEAR(spacing(side_step, -0.01), wide - 0.01, 1e-12);
}

TEST_F(Footsteps, TurnedFootStaysClearOfTheStanceFoot) {
  for (const Side swing : {Side::left, Side::right}) {
    for (int percent = -50; percent <= 50; percent += 5) {
      const double turn = percent * 0.01;
      const double side = sign_of(swing);
      const double y = side * planner.least_spacing_m(swing, turn);
      double innermost = 1.0;
      for (const double x : {0.0775, -0.0575}) {
        for (const double w : {0.0425, -0.0425}) {
          innermost = std::min(innermost, side * (y + std::sin(turn) * x + std::cos(turn) * w));
        }
      }
      EXPECT_NEAR(innermost, 0.0425 + parameters.min_sole_gap_m, 1e-12);
    }
  }
}

TEST_F(Footsteps, SpeedIsScaledOntoTheEllipsoidWithItsDirectionKept) {
  parameters.forward_acceleration_m_per_s2 = parameters.lateral_acceleration_m_per_s2 = 10.0;
  parameters.turn_acceleration_rad_per_s2 = 50.0;
  const FootstepPlanner quick{parameters};
  const Velocity2 v = quick.next_velocity({}, {-1.0, 0.2, 0.4}, applied);
  EXPECT_EQ(applied, StepLimit::speed);
  EXPECT_NEAR(v.left_m_per_s / v.forward_m_per_s, -0.2, 1e-12);
  EXPECT_NEAR(v.turn_rad_per_s / v.forward_m_per_s, -0.4, 1e-12);
  EXPECT_NEAR(
      std::hypot(v.forward_m_per_s / quick.max_forward_m_per_s(true),
                 v.left_m_per_s / quick.max_left_m_per_s(), v.turn_rad_per_s / quick.max_turn_rad_per_s()),
      1.0, 1e-12);
}

TEST_F(Footsteps, VelocityChangesByTheAccelerationOfOneStep) {
  const Velocity2 v = planner.next_velocity({}, {0.2, 0.0, -0.44}, applied);
  EXPECT_NEAR(v.forward_m_per_s, 0.25 * parameters.step_time_s, 1e-12);
  EXPECT_NEAR(v.turn_rad_per_s, -1.0 * parameters.step_time_s, 1e-12);
  EXPECT_EQ(applied, StepLimit::acceleration);
}

TEST_F(Footsteps, BesideIsMutual) {
  const Pose2 stance{1.0, 2.0, 0.5};
  const Pose2 foot = planner.beside(stance, Side::left);
  EXPECT_TRUE(planner.is_beside(stance, Side::left, foot));
  EXPECT_TRUE(planner.is_beside(foot, Side::right, stance));
  EXPECT_FALSE(planner.is_beside(stance, Side::right, foot));
}

TEST(Pose, ComposeAndRelativeAreInverse) {
  const Pose2 a{1.0, -2.0, 0.7}, b{0.3, 0.4, -0.2};
  const Pose2 back = a.relative_of(a.compose(b));
  EXPECT_NEAR(back.x_m, b.x_m, 1e-12);
  EXPECT_NEAR(back.y_m, b.y_m, 1e-12);
  EXPECT_NEAR(back.yaw_rad, b.yaw_rad, 1e-12);
}

}  // namespace
}  // namespace gaitway::trajectory
