// The whole chain in a world: where it may walk it touches nothing, and where it may not that is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "gaitway/world/world_file.hpp"
#include "simulated_run.hpp"
#include "tools/run/contact_log.hpp"

namespace gaitway::scenarios {
namespace {

world::World written(const std::string& text) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("gaitway_scenario_world_" + std::to_string(getpid()) + ".yaml");
  std::ofstream(file) << text;
  world::World world = world::read_world(file);
  std::filesystem::remove(file);
  return world;
}

// The names of what was touched.
std::vector<std::string> touched(const SimulatedRun& run) {
  std::vector<std::string> names;
  for (const tools::ContactEpisode& episode : run.recorder.contacts().episodes()) {
    names.push_back(episode.with);
  }
  return names;
}

TEST(WorldRun, TenSecondsWhereTheBoxesLeaveRoomTouchNothing) {
  for (int seed = 1; seed <= seeds(2); ++seed) {
    SimulatedRun run = SimulatedRun::in_world(static_cast<std::uint64_t>(seed), shipped_world("boxes"));
    // In a circle of 0.4 m around a place at the start's side.
    run.play({.seconds = 11.0, .events = {walk_at(1.0, 0.12, 0.0, 0.3)}});
    EXPECT_FALSE(run.metrics().fell);
    EXPECT_GT(run.metrics().way_m.done, 0.9);
    EXPECT_EQ(run.recorder.contacts().total(), 0U);
  }
}

TEST(WorldRun, WalkingIntoAWallIsTold) {
  SimulatedRun run = SimulatedRun::in_world(
      1, written("walls: [{name: north, from_m: [0.6, -1], to_m: [0.6, 1], height_m: 1}]\n"));
  run.play({.seconds = 7.0, .events = {walk_at(1.0, 0.15)}});
  ASSERT_GT(run.recorder.contacts().total(), 0U);
  const tools::ContactEpisode& first = run.recorder.contacts().episodes()[0];
  EXPECT_EQ(touched(run)[0], "north");
  EXPECT_GT(first.from_ns, 3'000'000'000) << "half a metre at 0.15 m/s";
  EXPECT_LT(first.from_ns, 6'000'000'000);
  EXPECT_GT(first.peak_N, 1.0);
}

TEST(WorldRun, AThingThatIsPushedMovesAndRunsAreTheSameToTheBit) {
  const auto play = [](std::uint64_t seed) {
    SimulatedRun run = SimulatedRun::in_world(
        seed, written("things: [{name: crate, size_m: [0.15, 0.3, 0.2], mass_kg: 0.2, friction: 0.2, "
                      "position_m: [0.5, 0]}]\n"));
    run.play({.seconds = 7.0, .events = {walk_at(1.0, 0.12)}});
    EXPECT_THAT(touched(run), testing::Contains("crate"));
    EXPECT_GT(run.cosimulation.plant().solids()[0].pose.translation().x(), 0.55);
    return run.recorder.digest();
  };
  const std::uint64_t digest = play(2);
  EXPECT_EQ(digest, play(2));
  EXPECT_NE(digest, play(3));
}

// A world adds nothing but what stands in it.
TEST(WorldRun, AnEmptyWorldIsTheEndlessFloor) {
  const simulator::Scenario walk{.seconds = 5.0, .events = {walk_at(1.0, 0.15)}};
  SimulatedRun plain(1), in_world = SimulatedRun::in_world(1, shipped_world("empty"));
  plain.play(walk);
  in_world.play(walk);
  EXPECT_EQ(plain.recorder.digest(), in_world.recorder.digest());
}

TEST(WorldRun, ClimbsTheShippedStairs) {
  SimulatedRun run = SimulatedRun::in_world(1, shipped_world("stairs"));
  run.play({.seconds = 16.0, .events = {walk_at(1.0, 0.15)}});
  EXPECT_FALSE(run.metrics().fell) << "at " << run.metrics().fell_at_s << " s";
  double highest_m = 0.0;
  for (const Eigen::Isometry3d& sole : run.cosimulation.plant().ground_contact().sole) {
    highest_m = std::max(highest_m, sole.translation().z());
  }
  EXPECT_GT(highest_m, 0.015);
}

}  // namespace
}  // namespace gaitway::scenarios
