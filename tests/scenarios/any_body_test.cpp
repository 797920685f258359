// Bodies that nobody tuned a number for walk through the whole chain: of other sizes, with hips and ankles
// whose joints come in another order. Their planner knows them only roughly (mismatch 1).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <variant>

#include "robots/robot_variants.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using gaitway::test::kAnkle;
using gaitway::test::kHip;
using gaitway::test::kHipOrders;
using gaitway::test::RobotVariant;

// At Froude's number of 0.15 m/s with humanoid22.
void expect_walk(const RobotVariant& variant, std::uint64_t seed) {
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const double speed_m_per_s = 0.15 * robot.body_scale().factor("m/s");
  auto run = SimulatedRun::of_robot(seed, robot);
  run.play({.seconds = 10.0, .events = {walk_at(1.0, speed_m_per_s)}});
  EXPECT_FALSE(run.metrics().fell) << "at " << run.metrics().fell_at_s << " s, seed " << seed;
  EXPECT_NEAR(run.metrics().mean_speed_m_per_s(), speed_m_per_s, 0.15 * speed_m_per_s) << "seed " << seed;
  EXPECT_EQ(run.cosimulation.message_controller().state().refused, 0U);
}

class BodiesOfOtherSizes : public ::testing::TestWithParam<double> {};

TEST_P(BodiesOfOtherSizes, Walk) {
  RobotVariant variant;
  variant.scale(GetParam());
  for (int seed = 1; seed <= seeds(3); ++seed) expect_walk(variant, static_cast<std::uint64_t>(seed));
}
INSTANTIATE_TEST_SUITE_P(From3To107kg, BodiesOfOtherSizes, ::testing::Values(0.5, 0.7, 1.4, 2.0, 2.5));

// Three quarters of what the default gait of this body asks of the knees: it takes slower and lower steps.
TEST(SlowMotors, WalkWithoutARefusedBatch) {
  RobotVariant variant;
  variant.scale(0.23 / 0.36);
  variant.limit_speed(4.8);
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  for (int seed = 1; seed <= seeds(3); ++seed) {
    auto run = SimulatedRun::of_robot(static_cast<std::uint64_t>(seed), robot);
    run.play({.seconds = 20.0, .events = {walk_at(1.0, 0.1)}});
    EXPECT_FALSE(run.metrics().fell) << "seed " << seed;
    EXPECT_NEAR(run.metrics().mean_speed_m_per_s(), 0.1, 0.01) << "seed " << seed;
    const auto here = run.cosimulation.main_controller().statistics().refused_locally;
    EXPECT_EQ(here + run.cosimulation.message_controller().state().refused, 0U) << "seed " << seed;
  }
}

class HipOrders : public ::testing::TestWithParam<std::size_t> {};

TEST_P(HipOrders, Walk) {
  RobotVariant variant;
  variant.reorder(kHip, kHipOrders.at(GetParam()));
  expect_walk(variant, 1);
}
INSTANTIATE_TEST_SUITE_P(All, HipOrders, ::testing::Range(std::size_t{0}, kHipOrders.size()));

// Hips whose axes have no common point: the yaw axis behind the others, the roll axis below the pitch axis.
TEST(OffsetHips, Walk) {
  RobotVariant variant;
  variant.move_axis("hip_yaw", {-0.03, 0.0, 0.0});
  variant.move_axis("hip_roll", {0.0, 0.0, -0.02});
  expect_walk(variant, 1);
}

TEST(OffsetHips, PitchFirstWithAnklesThatRollFirstWalk) {
  RobotVariant variant;
  variant.reorder(kHip, {2, 1, 0});
  variant.reorder(kAnkle, {1, 0});
  variant.move_axis("hip_roll", {0.0, 0.01, -0.02});
  variant.move_axis("hip_pitch", {-0.03, 0.0, -0.05});  // the third joint, which yaws
  variant.move_axis("ankle_pitch", {0.0, 0.0, 0.015});  // the fifth, which rolls
  expect_walk(variant, 1);
}

TEST(AnkleOrder, RollBeforePitchWalks) {
  RobotVariant variant;
  variant.reorder(kAnkle, {1, 0});
  expect_walk(variant, 1);
}

TEST(OtherNames, WalkAndArePushedByAShippedScenario) {
  RobotVariant variant;
  variant.rename();
  expect_walk(variant, 1);
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const simulator::Scenario pushes = simulator::load_scenario(
      std::filesystem::path(GAITWAY_SOURCE_DIR) / "tools/scenarios/push.yaml", robot);
  int on_trunk = 0;
  for (const simulator::ScenarioEvent& event : pushes.events) {
    const auto* const push = std::get_if<simulator::PushEvent>(&event.action);
    if (push != nullptr) on_trunk += push->body == RobotVariant::renamed("trunk") ? 1 : 0;
  }
  EXPECT_EQ(on_trunk, 3) << "the link that bears the IMU";
}

}  // namespace
}  // namespace gaitway::scenarios
