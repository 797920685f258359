// Measured ZMP of one foot.
#include "gaitway/zmp/foot_contact.hpp"

#include <gtest/gtest.h>

#include <random>

#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::cell_forces;
using test::humanoid;

TEST(FootPressure, KnownForcesGiveTheExactZmp) {
  const urdf::Foot& foot = humanoid().feet[0];
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d zmp(foot.cell_m[2].x() + share(random) * (foot.cell_m[0].x() - foot.cell_m[2].x()),
                              foot.cell_m[1].y() + share(random) * (foot.cell_m[0].y() - foot.cell_m[1].y()));
    const double force_N = 1.0 + 80.0 * share(random);
    const FootPressure pressure = foot_pressure(foot, cell_forces(foot, force_N, zmp), 0.5);
    EXPECT_NEAR(pressure.force_N, force_N, 1e-12);
    EXPECT_NEAR((pressure.zmp_m - zmp).norm(), 0.0, 1e-14);
  }
}

TEST(FootPressure, AllLoadOnOneCellIsThatCell) {
  const urdf::Foot& foot = humanoid().feet[1];
  for (std::size_t cell = 0; cell < 4; ++cell) {
    std::array<double, 4> force_N{};
    force_N[cell] = 30.0;
    EXPECT_EQ(foot_pressure(foot, force_N, 1.0).zmp_m, foot.cell_m[cell]);
  }
}

TEST(FootPressure, StaysWithinFiveMillimetresWithNoiseAndGainErrors) {
  const urdf::Foot& foot = humanoid().feet[0];
  std::mt19937 random(11);
  std::normal_distribution<double> noise_N(0.0, humanoid().noise.force_N), gain(1.0, 0.03);
  std::uniform_real_distribution<double> x(-0.04, 0.06), y(-0.03, 0.03);
  double squares = 0.0;
  constexpr int kRuns = 5000;
  for (int i = 0; i < kRuns; ++i) {
    const Eigen::Vector2d zmp(x(random), y(random));
    auto force_N = cell_forces(foot, 0.5 * test::weight_N(), zmp);
    for (double& force : force_N) force = gain(random) * force + noise_N(random) / std::sqrt(10.0);
    const double error_m = (foot_pressure(foot, force_N, 1.0).zmp_m - zmp).norm();
    EXPECT_LT(error_m, 0.005);
    squares += error_m * error_m;
  }
  EXPECT_LT(std::sqrt(squares / kRuns), 0.002);
}

TEST(FootPressure, SoleOnItsEdgeIsBeyondTheCells) {
  const urdf::Foot& foot = humanoid().feet[0];
  const Eigen::Vector2d toe(foot.centre_m.x() + 0.5 * foot.size_m.x(), 0.0);
  ASSERT_GT(toe.x(), foot.cell_m[0].x());
  const auto force_N = cell_forces(foot, 60.0, toe);
  ASSERT_LT(force_N[2], 0.0);
  EXPECT_NEAR((foot_pressure(foot, force_N, 1.0).zmp_m - toe).norm(), 0.0, 1e-14);
}

TEST(FootPressure, ResultNeverLeavesTheSole) {
  const urdf::Foot& foot = humanoid().feet[0];
  std::mt19937 random(13);
  std::normal_distribution<double> noise_N(0.0, 2.0);
  for (int i = 0; i < 5000; ++i) {
    std::array<double, 4> force_N{};
    for (double& force : force_N) force = noise_N(random);
    const Eigen::Vector2d from_centre = foot_pressure(foot, force_N, 0.1).zmp_m - foot.centre_m;
    EXPECT_LE(std::abs(from_centre.x()), 0.5 * foot.size_m.x() + 1e-12);
    EXPECT_LE(std::abs(from_centre.y()), 0.5 * foot.size_m.y() + 1e-12);
  }
}

TEST(FootPressure, UnloadedFootSaysItsCentre) {
  const urdf::Foot& foot = humanoid().feet[0];
  EXPECT_EQ(foot_pressure(foot, std::array<double, 4>{0.1, -0.2, 0.3, 0.0}, 1.0).zmp_m, foot.centre_m);
  EXPECT_EQ(foot_pressure(foot, std::array<double, 4>{-5.0, -5.0, 0.0, 0.0}, -20.0).zmp_m, foot.centre_m);
}

}  // namespace
}  // namespace gaitway::zmp
