// Splines through the keys, whatever their durations and velocities there.
#include "gaitway/motion/motion_path.hpp"

#include <gtest/gtest.h>

#include <random>

#include "motion_fixture.hpp"

namespace gaitway::motion {
namespace {

// The wave with random durations, and random velocities and accelerations where it may have any.
MotionPath random_path(std::mt19937& random) {
  const Motion motion = shipped("wave");
  MotionPath path = first_path(humanoid22(), motion, key_postures(humanoid22(), motion, {}), {});
  std::uniform_real_distribution<double> spread(-1.0, 1.0);
  for (Segment& segment : path.segments) segment.duration_s *= 1.0 + 0.5 * spread(random);
  for (Knot& knot : path.knots) {
    for (const Eigen::Index i : knot.moving) {
      knot.velocity[i] = spread(random);
      knot.acceleration[i] = 10.0 * spread(random);
    }
  }
  return path;
}

TEST(MotionPath, IsContinuousToTheAccelerationAndRestsAtItsEnds) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const MotionPath path = random_path(random);
    EXPECT_TRUE(path.knots.front().moving.empty());
    EXPECT_TRUE(path.knots.back().moving.empty());
    EXPECT_FALSE(path.knots[2].moving.empty());
    for (std::size_t i = 0; i + 1 < path.segments.size(); ++i) {
      const auto before = polynomials(path.segments[i], path.knots[i], path.knots[i + 1]);
      const auto after = polynomials(path.segments[i + 1], path.knots[i + 1], path.knots[i + 2]);
      for (std::size_t c = 0; c < before.size(); ++c) {
        const trajectory::MotionState end = before[c].at(path.segments[i].duration_s),
                                      start = after[c].at(0.0);
        EXPECT_NEAR(end.position, start.position, 1e-12);
        EXPECT_NEAR(end.velocity, start.velocity, 1e-9);
        EXPECT_NEAR(end.acceleration, start.acceleration, 1e-7);
      }
    }
  }
}

TEST(MotionPath, IsTheSameCurveWhenStretched) {
  std::mt19937 random(2);
  const MotionPath path = random_path(random);
  MotionPath slow = path;
  slow.stretch(1.7);
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const auto quick = polynomials(path.segments[i], path.knots[i], path.knots[i + 1]);
    const auto slower = polynomials(slow.segments[i], slow.knots[i], slow.knots[i + 1]);
    for (std::size_t c = 0; c < quick.size(); ++c) {
      const double time_s = 0.3 * path.segments[i].duration_s;
      EXPECT_NEAR(slower[c].at(1.7 * time_s).position, quick[c].at(time_s).position, 1e-12);
      EXPECT_NEAR(slower[c].at(1.7 * time_s).velocity * 1.7, quick[c].at(time_s).velocity, 1e-9);
    }
  }
}

TEST(MotionPath, JerkIsTheChangeOfAcceleration) {
  const trajectory::Quintic quintic({0.1, 0.5, -2.0}, {0.4, -0.3, 3.0}, 0.7);
  constexpr double kStep_s = 1e-5;
  for (const double time_s : {0.1, 0.35, 0.6}) {
    const double change =
        quintic.at(time_s + kStep_s).acceleration - quintic.at(time_s - kStep_s).acceleration;
    EXPECT_NEAR(quintic.jerk(time_s), change / (2.0 * kStep_s), 1e-5);
  }
}

}  // namespace
}  // namespace gaitway::motion
