// Ways through worlds, by the whole chain: planned as footsteps, walked as those, without touching anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>

#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
constexpr double kQuarter_rad = std::numbers::pi / 2.0;

// Plays until the way has ended, and a second longer.
nlohmann::ordered_json walk(SimulatedRun& run, simulator::Scenario scenario, double most_s = 60.0) {
  const std::vector<simulator::ScenarioEvent> events = std::move(scenario.events);
  auto event = events.begin();
  double end_s = most_s;
  while (run.time_s() < end_s && !run.metrics().fell) {
    for (; event != events.end() && event->at_s <= run.time_s() + 1e-9; ++event) run.apply(*event);
    run.cosimulation.advance_millisecond();
    if (event == events.end() && end_s == most_s && run.recorder.way().ended()) end_s = run.time_s() + 1.0;
  }
  return run.recorder.way().json();
}

// How often something of the world was. A push may make the feet brush each other.
std::ptrdiff_t things_touched(const SimulatedRun& run) {
  return std::ranges::count(run.recorder.contacts().episodes(), simulator::BodyContact::kNoLink,
                            &tools::ContactEpisode::other_link);
}

// Each with deviations of its own.
TEST(WalkTo, ThroughTheBoxesWithoutTouchingOne) {
  for (int seed = 1; seed <= seeds(20); ++seed) {
    SimulatedRun run = SimulatedRun::on_its_way(static_cast<std::uint64_t>(seed), shipped_world("boxes"));
    const auto way = walk(run, {.events = {walk_to_at(1.0, 2.3, 2.0, kQuarter_rad)}});
    EXPECT_FALSE(run.metrics().fell) << "seed " << seed;
    EXPECT_EQ(way["result"], "arrived") << "seed " << seed << ": " << way["text"];
    EXPECT_EQ(things_touched(run), 0) << "seed " << seed;
    EXPECT_GT(way["footsteps"], 25) << "seed " << seed;
    EXPECT_LT(way["placement_rms_mm"], 20.0) << "seed " << seed;
    EXPECT_LT(way["goal_error_mm"], 25.0) << "seed " << seed;
    EXPECT_LT(way["goal_error_deg"], 2.0) << "seed " << seed;
  }
}

TEST(WalkTo, IsTheSameToTheBitForOneSeed) {
  const auto digest = [] {
    SimulatedRun run = SimulatedRun::on_its_way(3, shipped_world("doorway"));
    walk(run, {.events = {walk_to_at(1.0, 0.4, 0.2, 0.5)}}, 10.0);
    return run.recorder.digest();
  };
  EXPECT_EQ(digest(), digest());
}

// 1.8 N*s at the trunk in mid-step, twice: some steps land elsewhere, and the rest is planned anew.
TEST(WalkTo, PushesOnTheWayAreGotOver) {
  for (int seed = 1; seed <= seeds(5); ++seed) {
    SimulatedRun run = SimulatedRun::on_its_way(static_cast<std::uint64_t>(seed), shipped_world("boxes"));
    const std::string trunk = humanoid22().links[static_cast<std::size_t>(humanoid22().imu.link)].name;
    const auto push = [&trunk](double at_s, const Eigen::Vector3d& direction) {
      return simulator::ScenarioEvent{
          at_s, simulator::PushEvent{.body = trunk, .direction = direction, .impulse_Ns = 1.8}};
    };
    const auto way = walk(run, {.events = {walk_to_at(1.0, 2.3, 2.0, kQuarter_rad),
                                           push(7.0, {0.0, 1.0, 0.0}), push(10.3, {1.0, -1.0, 0.0})}});
    EXPECT_FALSE(run.metrics().fell) << "seed " << seed;
    EXPECT_EQ(way["result"], "arrived") << "seed " << seed << ": " << way["text"];
    EXPECT_GT(way["replans"], 0) << "seed " << seed;
    EXPECT_EQ(things_touched(run), 0) << "seed " << seed;
    EXPECT_LT(way["goal_error_mm"], 25.0) << "seed " << seed;
  }
}

// A batch is missing, so the robot stands by its tail; nobody has stopped it.
TEST(WalkTo, AfterASafeTailItGoesOnFromTheStand) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("empty"));
  const auto way =
      walk(run, {.events = {walk_to_at(1.0, 1.0, 0.0, 0.0),
                            {4.0, simulator::PluginFault{.plugin = "kinematics", .duration_s = 0.1}}}});
  EXPECT_GT(run.cosimulation.message_controller().state().tail_played, 0U);
  EXPECT_EQ(way["result"], "arrived") << way["text"];
  EXPECT_GT(way["replans"], 0);
  EXPECT_LT(way["goal_error_mm"], 20.0);
}

TEST(WalkTo, APersonsStopEndsTheWayForGood) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("empty"));
  const auto way = walk(
      run, {.events = {walk_to_at(1.0, 2.0, 0.0, 0.0), {4.0, simulator::StopEvent{}}, stand_at(12.0)}}, 12.0);
  EXPECT_EQ(way["result"], "cancelled");
  EXPECT_EQ(way["text"], "somebody stopped the robot");
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_LT(run.cosimulation.plant().truth().com_m.x(), 1.0) << "it stands where it was stopped";
}

TEST(WalkTo, LeavingTheWayHasTheRobotStand) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("empty"));
  const auto way =
      walk(run, {.events = {walk_to_at(1.0, 2.0, 0.0, 0.0), {4.0, simulator::WalkToEvent{}}}}, 10.0);
  EXPECT_EQ(way["result"], "cancelled");
  const double x_m = run.cosimulation.plant().truth().com_m.x();
  EXPECT_GT(x_m, 0.3);
  EXPECT_LT(x_m, 1.0);
}

simulator::ScenarioEvent box_appears(double at_s, double x_m, double y_m, double width_m) {
  simulator::SpawnEvent box;
  box.name = "box";
  box.size_m = {width_m, width_m, 0.2};
  box.position_m = {x_m, y_m, 0.1};
  return {at_s, box};
}

// Nothing stood there when the way was planned.
TEST(WalkTo, AroundWhatAppearsOnTheWay) {
  for (int seed = 1; seed <= seeds(10); ++seed) {
    SimulatedRun run = SimulatedRun::on_its_way(static_cast<std::uint64_t>(seed), shipped_world("empty"));
    const auto way =
        walk(run, {.events = {walk_to_at(1.0, 2.0, 0.0, 0.0), box_appears(5.0, 1.2, 0.05, 0.25)}});
    EXPECT_FALSE(run.metrics().fell) << "seed " << seed;
    EXPECT_EQ(way["result"], "arrived") << "seed " << seed << ": " << way["text"];
    EXPECT_GT(way["replans"], 0) << "seed " << seed;
    EXPECT_EQ(things_touched(run), 0) << "seed " << seed;
    EXPECT_LT(way["goal_error_mm"], 20.0) << "seed " << seed;
  }
}

TEST(WalkTo, WhereTheGoalIsBuiltOverTheRobotStandsAndSaysWhy) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("empty"));
  const auto way =
      walk(run, {.events = {walk_to_at(1.0, 2.0, 0.0, 0.0), box_appears(5.0, 2.0, 0.0, 0.4), stand_at(20.0)}},
           20.0);
  EXPECT_EQ(way["result"], "failed");
  EXPECT_THAT(way["text"].get<std::string>(), HasSubstr("goal"));
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_EQ(things_touched(run), 0);
  EXPECT_LT(run.cosimulation.plant().truth().com_m.x(), 1.7);
}

TEST(WalkTo, AVelocityTakesTheRobotAway) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("empty"));
  const auto way =
      walk(run, {.events = {walk_to_at(1.0, 2.0, 0.0, 0.0), walk_at(4.0, -0.1), stand_at(8.0)}}, 12.0);
  EXPECT_EQ(way["result"], "cancelled");
  EXPECT_EQ(way["text"], "somebody walks the robot by velocities");
  EXPECT_FALSE(run.metrics().fell);
}

TEST(WalkTo, WithoutAnythingThatSeesItTheRobotKnowsNoBetterThanItsFeet) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("empty"), false);
  const auto way = walk(run, {.events = {walk_to_at(1.0, 1.0, 0.0, 0.0)}});
  EXPECT_EQ(way["result"], "arrived");
  EXPECT_LT(way["goal_error_mm"], 60.0);
  EXPECT_EQ(things_touched(run), 0);
}

TEST(WalkTo, WhatIsInTheWayAtTheGoalIsToldAndTheRobotStands) {
  SimulatedRun run = SimulatedRun::on_its_way(1, shipped_world("boxes"));
  const auto way = walk(run, {.events = {walk_to_at(1.0, 2.5, 2.5, 0.0)}}, 5.0);
  EXPECT_EQ(way["result"], "refused");
  EXPECT_THAT(way["text"].get<std::string>(), StartsWith("goal_in_obstacle: the goal (2.50, 2.50) m"));
  EXPECT_EQ(way["footsteps"], 0);
  EXPECT_THAT(run.recorder.way().missing(), HasSubstr("the way was refused"));
}

}  // namespace
}  // namespace gaitway::scenarios
