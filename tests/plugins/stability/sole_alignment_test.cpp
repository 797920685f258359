// Which way a sole turns for its centre of pressure, and when nothing is learned.
#include "gaitway/stability/sole_alignment.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using test::kDefaults;

Estimate standing() {
  Estimate estimate{};
  estimate.foot_force[0] = estimate.foot_force[1] = 33.0;
  return estimate;
}

void learn(SoleAlignment& soles, const Estimate& estimate, int ticks) {
  for (int i = 0; i < ticks; ++i) soles.learn(estimate);
}

// How far each sole has turned about the base's axes by the trims, rad.
std::array<Eigen::Vector3d, 2> turned(const urdf::RobotModel& model, const TrimCommand& trim) {
  std::vector<double> posture;
  for (const urdf::Joint& joint : model.joints) posture.push_back(joint.home_rad);
  urdf::ForwardKinematics kinematics(model);
  kinematics.compute(posture);
  std::array<Eigen::Vector3d, 2> turn;
  for (const urdf::Side side : urdf::kSides) {
    const auto i = static_cast<std::size_t>(side);
    kinematics.compute(posture);
    const Eigen::Matrix3d before = kinematics.sole_pose(side).linear();
    std::vector<double> trimmed = posture;
    for (std::size_t j = 0; j < posture.size(); ++j) {
      if (model.joints[j].trim_channel >= 0) trimmed[j] += trim.angle[model.joints[j].trim_channel];
    }
    kinematics.compute(trimmed);
    const Eigen::AngleAxisd difference(kinematics.sole_pose(side).linear() * before.transpose());
    turn[i] = difference.angle() * difference.axis();
  }
  return turn;
}

class SoleTurns : public ::testing::TestWithParam<bool> {
 protected:
  const urdf::RobotModel model = GetParam() ? test::robot_with_flipped_axes() : test::humanoid();
  SoleAlignment soles{model, kDefaults};
  TrimCommand trim{};
};

TEST_P(SoleTurns, ThePressedEdgeGoesUp) {
  Estimate estimate = standing();
  estimate.foot_zmp[0][1] = 0.010;  // on its left edge
  estimate.foot_zmp[1][0] = 0.020;  // on its toes, against the other foot
  learn(soles, estimate, 10);
  soles.add_to(trim);
  const auto turn = turned(model, trim);
  EXPECT_NEAR(turn[0].x(), 0.003, 1e-5);  // 3 rad/(m s) for 0.1 s: about x, the left edge goes up
  EXPECT_NEAR(turn[1].x(), 0.0, 1e-5);
  EXPECT_NEAR(turn[1].y(), -0.003, 1e-5);  // about -y, the toes go up; by half of the difference
  EXPECT_NEAR(turn[0].y(), 0.003, 1e-5);
}
INSTANTIATE_TEST_SUITE_P(AxesBothWays, SoleTurns, ::testing::Bool());

TEST(SoleAlignment, LeavesToTheBodyHowFarAheadItsWeightIs) {
  SoleAlignment soles(test::humanoid(), kDefaults);
  Estimate estimate = standing();
  estimate.foot_zmp[0][0] = estimate.foot_zmp[1][0] = 0.03;
  learn(soles, estimate, 100);
  EXPECT_EQ(soles.pitch_rad(0), 0.0);
}

TEST(SoleAlignment, LearnsNothingFromAFootThatBearsLittle) {
  const auto learned = [](const Estimate& estimate) {
    SoleAlignment soles(test::humanoid(), kDefaults);
    learn(soles, estimate, 100);
    return std::abs(soles.roll_rad(0)) + std::abs(soles.roll_rad(1)) + std::abs(soles.pitch_rad(0));
  };
  Estimate calm = standing();
  calm.foot_zmp[0][0] = calm.foot_zmp[0][1] = 0.01;
  EXPECT_GT(learned(calm), 0.01);
  Estimate on_one_foot = calm;
  on_one_foot.foot_force[1] = 5.0;
  EXPECT_EQ(learned(on_one_foot), 0.0);
  Estimate in_the_air = calm;
  in_the_air.foot_force[0] = in_the_air.foot_force[1] = 0.0;
  EXPECT_EQ(learned(in_the_air), 0.0);
  Estimate broken = calm;
  broken.foot_zmp[1][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(learned(broken), 0.0);
}

TEST(SoleAlignment, StaysWithinItsLimitAndTheTrims) {
  const BalanceParameters parameters;
  SoleAlignment soles(test::humanoid(), parameters);
  Estimate estimate = standing();
  estimate.foot_zmp[0][1] = 0.04;
  learn(soles, estimate, 1000);
  EXPECT_EQ(soles.roll_rad(0), parameters.sole_limit_rad);
  TrimCommand trim{};
  for (double& angle : trim.angle) angle = 0.10;
  soles.add_to(trim);
  for (const double angle : trim.angle) EXPECT_LE(std::abs(angle), parameters.trim_limit_rad);
}

TEST(SoleAlignment, IsOffWithoutGain) {
  BalanceParameters parameters;
  parameters.sole_gain_rad_per_m_s = 0.0;
  SoleAlignment soles(test::humanoid(), parameters);
  Estimate estimate = standing();
  estimate.foot_zmp[0][1] = 0.04;
  learn(soles, estimate, 100);
  EXPECT_EQ(soles.roll_rad(0), 0.0);
}

}  // namespace
}  // namespace gaitway::stability
