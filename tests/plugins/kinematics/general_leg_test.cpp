// The general solver on legs that have no closed form: against forward kinematics, and against KDL.
#include "gaitway/kinematics/general_leg.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/kinematics/kdl_leg.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "leg_sampler.hpp"
#include "repeats.hpp"
#include "robots/robot_variants.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics {
namespace {

using test::closed_form_variants;
using test::general_variants;
using test::LegSampler;
using test::make_robot;
using test::offset_hip;

constexpr double kSame_rad = 1e-8;

// Calls `check` with model, side and a text for each leg of these.
template <class Check>
void for_each_leg(const std::vector<test::LegVariant>& variants, const Check& check) {
  for (std::size_t variant = 0; variant < variants.size(); ++variant) {
    const urdf::RobotModel model = make_robot(variants[variant]);
    for (const urdf::Side side : urdf::kSides) {
      SCOPED_TRACE(testing::Message()
                   << "variant " << variant << (side == urdf::Side::left ? " left" : " right"));
      check(model, side);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

// Up to 0.05 rad beside these angles, several samples' worth of walking; not through the straight knee.
std::array<double, 6> near(const std::array<double, 6>& angle_rad, std::mt19937& random) {
  std::uniform_real_distribution<double> beside(-0.05, 0.05);
  std::array<double, 6> start_rad = angle_rad;
  for (std::size_t i = 0; i < 6; ++i) start_rad[i] += (i == 3 ? 0.5 : 1.0) * beside(random);
  return start_rad;
}

// The knee's angle at which the leg is straight: one of its limits.
double straight_rad(const urdf::RobotModel& model, const LegSampler& sampler, urdf::Side side) {
  const LegLimits limits = leg_limits(model, side);
  const bool below = sampler.home_of(3) - limits.lower_rad[3] < limits.upper_rad[3] - sampler.home_of(3);
  return below ? limits.lower_rad[3] : limits.upper_rad[3];
}

// Where the leg is nearly straight, a second posture near by reaches the same pose: not here.
std::array<double, 6> bent(const urdf::RobotModel& model, LegSampler& sampler, urdf::Side side) {
  const double straight = straight_rad(model, sampler, side);
  for (;;) {
    const auto angle_rad = sampler.angles();
    if (std::abs(angle_rad[3] - straight) > 0.25) return angle_rad;
  }
}

// Tilted axes have singular postures of their own, where a few poses are reached by the other one, too.
constexpr int kOtherPostures = 5;

void expect_the_angles_from_near_by(const std::vector<test::LegVariant>& variants) {
  for_each_leg(variants, [](const urdf::RobotModel& model, urdf::Side side) {
    const GeneralLeg leg(model, side);
    LegSampler sampler(model, side, 1.2, 7);
    std::mt19937 random(3);
    int others = 0;
    for (int i = 0; i < gaitway::test::repeats(5000); ++i) {
      const auto expected = bent(model, sampler, side);
      const Eigen::Isometry3d sole = sampler.sole(expected);
      const LegSolution solution = leg.solve(sole, near(expected, random));
      ASSERT_TRUE(solution.reached()) << i << ": " << describe(solution, model, side);
      ASSERT_LT((sampler.sole(solution.angle_rad).matrix() - sole.matrix()).cwiseAbs().maxCoeff(), 1e-10);
      if (test::largest_difference(solution.angle_rad, expected) > kSame_rad) ++others;
    }
    EXPECT_LE(others, kOtherPostures);
  });
}

TEST(GeneralLeg, ReturnsTheAnglesThatMadeThePose) {
  expect_the_angles_from_near_by(general_variants());
}

TEST(GeneralLeg, ReturnsThemForLegsWithAClosedForm) {
  expect_the_angles_from_near_by(closed_form_variants());
}

TEST(GeneralLeg, ReturnsThemWithoutAPostureToStartFrom) {
  for_each_leg(general_variants(), [](const urdf::RobotModel& model, urdf::Side side) {
    const GeneralLeg leg(model, side);
    LegSampler sampler(model, side, 0.5, 5);
    for (int i = 0; i < gaitway::test::repeats(5000); ++i) {
      const auto expected = sampler.angles();
      const LegSolution solution = leg.solve(sampler.sole(expected));
      ASSERT_TRUE(solution.reached()) << i << ": " << describe(solution, model, side);
      ASSERT_LT(test::largest_difference(solution.angle_rad, expected), kSame_rad) << i;
    }
  });
}

// Wherever the start is, what is called reached is reached.
TEST(GeneralLeg, ReachesThePoseFromAFarStart) {
  for_each_leg(general_variants(), [](const urdf::RobotModel& model, urdf::Side side) {
    const GeneralLeg leg(model, side);
    LegSampler sampler(model, side, 0.5, 6), elsewhere(model, side, 2.0, 8);
    for (int i = 0; i < gaitway::test::repeats(2000); ++i) {
      const Eigen::Isometry3d sole = sampler.sole(sampler.angles());
      const LegSolution solution = leg.solve(sole, elsewhere.any_angles());
      ASSERT_TRUE(solution.reached()) << i << ": " << describe(solution, model, side);
      ASSERT_LT((sampler.sole(solution.angle_rad).matrix() - sole.matrix()).cwiseAbs().maxCoeff(), 1e-8) << i;
    }
  });
}

TEST(GeneralLeg, AgreesWithKdl) {
  for_each_leg(general_variants(), [](const urdf::RobotModel& model, urdf::Side side) {
    const GeneralLeg leg(model, side);
    KdlLeg kdl(model, side);
    LegSampler sampler(model, side, 0.8, 11);
    std::mt19937 random(4);
    for (int i = 0; i < gaitway::test::repeats(1000); ++i) {
      const auto angles = bent(model, sampler, side);
      const Eigen::Isometry3d sole = sampler.sole(angles);
      const auto start_rad = near(angles, random);
      kdl.start_from(start_rad);
      const LegSolution expected = kdl.solve(sole), solution = leg.solve(sole, start_rad);
      ASSERT_TRUE(expected.reached() && solution.reached()) << i << ": " << describe(solution, model, side);
      ASSERT_LT(test::largest_difference(solution.angle_rad, expected.angle_rad), 1e-6) << i;
    }
  });
}

TEST(GeneralLeg, ReachesPosesNearTheStraightKnee) {
  for_each_leg(general_variants(), [](const urdf::RobotModel& model, urdf::Side side) {
    const GeneralLeg leg(model, side);
    LegSampler sampler(model, side, 0.3, 2);
    const double straight = straight_rad(model, sampler, side);
    const double bend = sampler.home_of(3) > straight ? 1.0 : -1.0;
    for (int i = 0; i < 500; ++i) {
      auto angles = sampler.angles();
      angles[3] = straight + bend * 0.1 * std::pow(10.0, -0.006 * i);  // down to 0.1 mrad
      const Eigen::Isometry3d sole = sampler.sole(angles);
      auto start_rad = angles;
      start_rad[3] += bend * 0.03;
      const LegSolution solution = leg.solve(sole, start_rad);
      if (solution.status == LegStatus::joint_limit) continue;  // bent as little to the other side
      ASSERT_TRUE(solution.reached()) << i << ": " << describe(solution, model, side);
      ASSERT_LT((sampler.sole(solution.angle_rad).matrix() - sole.matrix()).cwiseAbs().maxCoeff(), 1e-8) << i;
    }
  });
}

// Both from home, the same pose that cannot be reached.
void expect_the_report_of_kdl(const urdf::RobotModel& model, urdf::Side side, const Eigen::Isometry3d& sole) {
  const GeneralLeg leg(model, side);
  KdlLeg kdl(model, side);
  const LegSolution expected = kdl.solve(sole), solution = leg.solve(sole);
  EXPECT_FALSE(expected.reached());
  EXPECT_EQ(solution.status, expected.status);
  EXPECT_EQ(solution.joint, expected.joint);
  EXPECT_NEAR(solution.excess, expected.excess, 1e-4);
}

TEST(GeneralLeg, ReportsWhatItCannotReachAsKdlDoes) {
  for_each_leg(general_variants(), [](const urdf::RobotModel& model, urdf::Side side) {
    LegSampler sampler(model, side, 0.3, 1);
    const Eigen::Isometry3d home = sampler.sole(sampler.home());
    Eigen::Isometry3d too_far = home, turned_too_far = home;
    too_far.translation().z() -= 0.08;
    expect_the_report_of_kdl(model, side, too_far);
    turned_too_far.rotate(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()));
    expect_the_report_of_kdl(model, side, turned_too_far);
  });
}

TEST(GeneralLeg, SaysByHowMuchThePoseIsMissed) {
  const urdf::RobotModel model = make_robot(offset_hip());
  const GeneralLeg leg(model, urdf::Side::left);
  LegSampler sampler(model, urdf::Side::left, 0.3, 1);
  Eigen::Isometry3d sole = sampler.sole(sampler.home());
  const double spare_m = 0.34 * (1.0 - std::cos(0.345));  // until the leg is straight
  sole.translation().z() -= spare_m + 0.03;
  const LegSolution solution = leg.solve(sole);
  EXPECT_EQ(solution.status, LegStatus::not_converged);
  EXPECT_NEAR(solution.excess, 0.03, 0.006) << "the nearest posture in position and orientation";
  EXPECT_TRUE(std::isnan(solution.angle_rad[3]));
}

TEST(GeneralLeg, NamesTheJointThatIsFarthestBeyondItsLimit) {
  const urdf::RobotModel model = make_robot(offset_hip());
  const GeneralLeg leg(model, urdf::Side::left);
  LegSampler sampler(model, urdf::Side::left, 0.3, 1);
  auto angles = sampler.home();
  angles[0] = 0.9;  // limit 0.8
  const LegSolution solution = leg.solve(sampler.sole(angles), sampler.home());
  EXPECT_EQ(solution.status, LegStatus::joint_limit);
  EXPECT_EQ(solution.joint, 0);
  EXPECT_NEAR(solution.excess, 0.1, kSame_rad);
  EXPECT_NEAR(solution.angle_rad[0], 0.9, kSame_rad) << "angles are not clamped";
}

TEST(GeneralLeg, RefusesNumbersThatAreNone) {
  const urdf::RobotModel model = make_robot(offset_hip());
  const GeneralLeg leg(model, urdf::Side::left);
  LegSampler sampler(model, urdf::Side::left, 0.3, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      Eigen::Isometry3d sole = sampler.sole(sampler.home());
      sole(row, column) = nan;
      EXPECT_FALSE(leg.solve(sole).reached()) << row << ", " << column;
      EXPECT_FALSE(leg.solve(sole, sampler.home()).reached()) << row << ", " << column;
    }
  }
  EXPECT_TRUE(leg.solve(sampler.sole(sampler.home()), {nan, nan, nan, nan, nan, nan}).reached());
}

TEST(GeneralLeg, RefusesALegWhoseJointsAreNotTheChain) {
  urdf::RobotModel model = make_robot();
  std::swap(model.legs[0].joints[1], model.legs[0].joints[2]);
  try {
    const GeneralLeg leg(model, urdf::Side::left);
    FAIL() << "a leg with swapped joints was accepted";
  } catch (const urdf::RobotError& error) {
    EXPECT_NE(std::string(error.what()).find("left_hip_pitch"), std::string::npos) << error.what();
  }
}

// The scenarios' robot with offset hips: its axes are beside each other, everything else is where it was.
TEST(GeneralLeg, SolvesHumanoid22WithHipsThatHaveNoCommonPoint) {
  gaitway::test::RobotVariant variant;
  const urdf::RobotModel before = urdf::load_robot(variant.folder());
  variant.move_axis("hip_yaw", {-0.03, 0.01, 0.0});
  variant.move_axis("hip_roll", {0.0, 0.0, -0.02});
  const urdf::RobotModel model = urdf::load_robot(variant.folder());
  for (const urdf::Side side : urdf::kSides) {
    EXPECT_FALSE(recognise_leg(model, side).geometry);
    EXPECT_LT((hip_centre(model, side) - hip_centre(before, side)).norm(), 1e-12);
    const GeneralLeg leg(model, side);
    const std::vector<double> home = test::home_posture(model);
    const Eigen::Isometry3d sole = test::sole_pose(model, side, home);
    EXPECT_TRUE(sole.isApprox(test::sole_pose(before, side, home), 1e-12));
    const LegSolution solution = leg.solve(sole);
    ASSERT_TRUE(solution.reached()) << describe(solution, model, side);
    const int knee = model.legs[urdf::index_of(side)].joints[3];
    EXPECT_NEAR(solution.angle_rad[3], home[static_cast<std::size_t>(knee)], kSame_rad);
  }
  EXPECT_LT((urdf::ForwardKinematics(model).com_m() - urdf::ForwardKinematics(before).com_m()).norm(), 1e-12);
}

}  // namespace
}  // namespace gaitway::kinematics
