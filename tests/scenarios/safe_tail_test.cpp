// Whatever becomes of the main controller, the robot ends in a stable stand.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using msgcontroller::Mode;

double speed(const SimulatedRun& run) {
  const auto velocities = run.cosimulation.plant().velocities();
  return std::hypot(velocities[0], velocities[1]);
}

class MainControllerDies : public ::testing::TestWithParam<int> {};

TEST_P(MainControllerDies, AtARandomInstantOfTheWalkAndTheRobotStands) {
  const int trial = GetParam();
  std::mt19937 random(static_cast<unsigned>(trial));
  const double instant_s = 4.0 + 0.001 * static_cast<double>(random() % 2000);
  SimulatedRun run(static_cast<std::uint64_t>(trial));
  run.play({.seconds = instant_s + 7.0,
            .events = {walk_at(1.0, 0.15), {instant_s, simulator::MainControllerSilentFault{}}}});
  EXPECT_FALSE(run.metrics().fell) << "killed at " << instant_s << " s, fell at " << run.metrics().fell_at_s;
  EXPECT_EQ(run.cosimulation.message_controller().mode(), Mode::holding);
  EXPECT_GT(run.cosimulation.message_controller().state().tail_played, 0U);
  EXPECT_EQ(run.cosimulation.message_controller().state().repaired, 0U) << "nothing was lost on the bus";
  EXPECT_LT(speed(run), 0.03);
}

INSTANTIATE_TEST_SUITE_P(FiftyInstants, MainControllerDies, ::testing::Range(1, 1 + seeds(50)));

TEST(SafeTail, TheWalkGoesOnWhenTheMainControllerIsBack) {
  SimulatedRun run(2);
  run.play(
      {.seconds = 16.0, .events = {walk_at(1.0, 0.15), {5.23, simulator::MainControllerSilentFault{3.0}}}});
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_EQ(run.cosimulation.message_controller().mode(), Mode::batches);
  EXPECT_GT(run.metrics().distance_m(), 1.0);
}

TEST(SafeTail, AUserStopPlaysItAtOnceAndTheRobotStands) {
  SimulatedRun run(3);
  run.play({.seconds = 7.0, .events = {walk_at(1.0, 0.15), {5.0, simulator::StopEvent{}}, stand_at(5.0)}});
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_GT(run.cosimulation.message_controller().state().tail_played, 0U);
  EXPECT_LT(speed(run), 0.03);
}

// A neck that is turned goes on from where the tail has left it: a batch that began elsewhere would be
// refused, for ever where nobody looks back there.
TEST(SafeTail, AfterAStopWithTheHeadTurnedTheRobotWalksAndLooksElsewhere) {
  simulator::HeadEvent aside{.mode = simulator::HeadEvent::Mode::direction};
  aside.direction_rad = {0.8, 0.2};
  SimulatedRun run(4);
  run.play({.seconds = 12.0,
            .events = {{1.0, aside},
                       walk_at(1.5, 0.1),
                       {4.0, simulator::StopEvent{}},
                       {7.0, simulator::HeadEvent{}},
                       walk_at(8.0, 0.1)}});
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_EQ(run.cosimulation.main_controller().statistics().refused_locally, 0U);
  EXPECT_EQ(run.cosimulation.message_controller().state().refused, 0U);
  EXPECT_EQ(run.cosimulation.message_controller().mode(), Mode::batches);
  Estimate estimate{};
  ASSERT_TRUE(run.cosimulation.client().read<Estimate>("estimate").read(estimate));
  EXPECT_NEAR(estimate.head[0], 0.0, 0.02);
}

TEST(SafeTail, LostFramesAreRepairedWhileTheRobotWalks) {
  SimulatedRun run(4);
  run.play({.seconds = 15.0, .events = {walk_at(1.0, 0.15), {4.0, simulator::LoseFramesFault{0.01, 10.0}}}});
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_GT(run.cosimulation.bus().statistics().lost, 100U);
  EXPECT_GT(run.cosimulation.message_controller().state().repaired, 0U);
  for (int joint = 0; joint < run.cosimulation.joints().size(); ++joint) {
    EXPECT_EQ(run.cosimulation.joints().joint(joint).reference_count(),
              run.cosimulation.message_controller().expected_count(joint))
        << "joint " << joint;
  }
}

TEST(EmergencyStop, SoftJointsLetGoAndTheRobotFalls) {
  SimulatedRun run(5);
  run.play({.seconds = 6.0, .events = {{2.0, simulator::EmergencyStopEvent{true}}}});
  EXPECT_TRUE(run.metrics().fell);
}

TEST(EmergencyStop, HoldingJointsKeepTheStandingRobotUp) {
  SimulatedRun run(5);
  run.play({.seconds = 6.0, .events = {{2.0, simulator::EmergencyStopEvent{false}}}});
  EXPECT_FALSE(run.metrics().fell);
}

}  // namespace
}  // namespace gaitway::scenarios
