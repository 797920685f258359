// The balance feedback of a body: scaled, but for what its hips may answer to the trunk's rate.
#include "gaitway/stability/body_balance.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "robots/robot_variants.hpp"
#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

double hip_rate_s(const urdf::RobotModel& robot) {
  return balance_of(robot).hip_pitch.rate_rad_per_rad_per_s;
}
// Of all that the hips carry: every link that no leg moves.
urdf::RobotModel with_trunk(double share) {
  urdf::RobotModel robot = test::humanoid();
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const bool in_leg = std::ranges::any_of(robot.legs, [&](const urdf::Leg& leg) {
      return std::ranges::any_of(leg.joints, [&](int joint) {
        return robot.joints[static_cast<std::size_t>(joint)].child_link == static_cast<int>(i);
      });
    });
    if (in_leg) continue;
    robot.links[i].mass_kg *= share;
    robot.links[i].inertia_kg_m2 *= share;
  }
  return robot;
}

TEST(BalanceOf, Humanoid22HasTheDefaults) {
  BalanceParameters here = balance_of(test::humanoid()), defaults;
  const auto numbers = here.numbers(), expected = defaults.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_NEAR(numbers[i].value, expected[i].value, 1e-12 + 1e-6 * expected[i].value) << numbers[i].name;
  }
}

TEST(BalanceOf, HipsOfALargeBodyAnswerTheRateNoLaterThanThoseOfASmallOne) {
  gaitway::test::RobotVariant variant;
  variant.scale(2.0);
  const BalanceParameters large = balance_of(urdf::load_robot(variant.folder()));
  EXPECT_GT(large.ankle_pitch.rate_rad_per_rad_per_s,
            1.3 * test::kDefaults.ankle_pitch.rate_rad_per_rad_per_s);
  EXPECT_LE(large.hip_pitch.rate_rad_per_rad_per_s, test::kDefaults.hip_pitch.rate_rad_per_rad_per_s);
}

TEST(BalanceOf, HipsAnswerTheRateOfALightTrunkLess) {
  const double half_s = hip_rate_s(with_trunk(0.5)), tenth_s = hip_rate_s(with_trunk(0.1));
  EXPECT_LT(half_s, 0.9 * hip_rate_s(test::humanoid()));
  EXPECT_LT(tenth_s, 0.9 * half_s);
  EXPECT_GT(tenth_s, 0.0);
}

TEST(BalanceOf, StrongServosCountAsALightTrunk) {
  urdf::RobotModel strong = test::humanoid();
  for (urdf::Joint& joint : strong.joints) joint.servo.damping_Nms_per_rad *= 2.0;
  EXPECT_NEAR(hip_rate_s(strong), hip_rate_s(with_trunk(0.5)), 0.1 * hip_rate_s(strong));
}

}  // namespace
}  // namespace gaitway::stability
