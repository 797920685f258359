// What the feet bear, told by accelerometer and legs alone.
#include "gaitway/zmp/foot_load_model.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::humanoid;
using test::weight_N;
using urdf::Side;

class FootLoadModelTest : public ::testing::Test {
 protected:
  // Stands so with the trunk upright for a while, feeling this.
  void feel(const std::vector<double>& posture, const Eigen::Vector3d& specific_force) {
    kinematics_.update(posture, Attitude{});
    for (int i = 0; i < 50; ++i) model_.update(kinematics_, specific_force, 0.01);
  }
  [[nodiscard]] double force_N(std::size_t foot) const {
    return std::accumulate(model_.force_N()[foot].begin(), model_.force_N()[foot].end(), 0.0);
  }
  [[nodiscard]] Eigen::Vector2d place_m(std::size_t foot) const {
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (std::size_t cell = 0; cell < 4; ++cell) {
      moment += model_.force_N()[foot][cell] * humanoid().feet[foot].cell_m[cell];
    }
    return moment / force_N(foot);
  }
  // One knee more bent, so that its sole is level and higher.
  static std::vector<double> lifted(Side side, double knee_rad) {
    std::vector<double> posture = test::home_posture(humanoid());
    const auto& leg = humanoid().legs[urdf::index_of(side)].joints;
    posture[static_cast<std::size_t>(leg[2])] -= 0.5 * knee_rad;
    posture[static_cast<std::size_t>(leg[3])] += knee_rad;
    posture[static_cast<std::size_t>(leg[4])] -= 0.5 * knee_rad;
    return posture;
  }

  const Eigen::Vector3d at_rest_{0.0, 0.0, test::kGravity_m_per_s2};
  SupportKinematics kinematics_{humanoid()};
  FootLoadModel model_{humanoid()};
};

TEST_F(FootLoadModelTest, AtRestBothFeetBearHalfTheWeightUnderTheCom) {
  feel(test::home_posture(humanoid()), at_rest_);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    EXPECT_NEAR(force_N(foot), 0.5 * weight_N(), 0.01 * weight_N());
    EXPECT_NEAR(place_m(foot).x(), kinematics_.com_m(Side::left).x(), 0.001);
  }
}

TEST_F(FootLoadModelTest, AnAccelerationMovesThePressureAgainstIt) {
  const double height_m = kinematics_.com_m(Side::left).z();
  feel(test::home_posture(humanoid()), at_rest_ + Eigen::Vector3d(0.5, 0.0, 0.0));
  EXPECT_NEAR(place_m(0).x(), kinematics_.com_m(Side::left).x() - height_m * 0.5 / test::kGravity_m_per_s2,
              0.001);
  feel(test::home_posture(humanoid()), at_rest_ + Eigen::Vector3d(0.0, 0.5, 0.0));
  EXPECT_GT(force_N(1), 0.6 * weight_N()) << "to the left: the right foot bears more";
  feel(test::home_posture(humanoid()), 1.2 * at_rest_);
  EXPECT_NEAR(force_N(0) + force_N(1), 1.2 * weight_N(), 1e-6);
}

TEST_F(FootLoadModelTest, AFootThatIsClearlyHigherBearsNothing) {
  feel(lifted(Side::left, 0.3), at_rest_);
  EXPECT_EQ(force_N(0), 0.0);
  EXPECT_NEAR(force_N(1), weight_N(), 0.01 * weight_N());
  feel(lifted(Side::right, 0.3), at_rest_);
  EXPECT_EQ(force_N(1), 0.0);
}

TEST_F(FootLoadModelTest, APressureBeyondTheSolesStaysOnTheirEdge) {
  feel(test::home_posture(humanoid()), at_rest_ + Eigen::Vector3d(-5.0, 0.0, 0.0));
  EXPECT_NEAR(place_m(0).x(), 0.01 + 0.5 * 0.135, 1e-9);
}

TEST_F(FootLoadModelTest, WhatFallsFreelyBearsNothing) {
  feel(test::home_posture(humanoid()), Eigen::Vector3d(0.0, 0.0, 0.1));
  EXPECT_EQ(force_N(0) + force_N(1), 0.0);
}

}  // namespace
}  // namespace gaitway::zmp
