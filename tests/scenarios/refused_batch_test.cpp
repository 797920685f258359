// A batch that is refused is not refused for ever: what follows goes on from where the joints hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/event_log.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

// Walks with a balance feedback that is mistaken.
core::Configuration mistaken(const std::vector<std::pair<std::string, std::string>>& parameters) {
  core::Configuration plugins =
      core::read_configuration(std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml");
  for (core::PluginEntry& entry : plugins.plugins) {
    if (entry.name != "stability") continue;
    entry.library = GAITWAY_SABOTEURS "/mistaken_stability.so";
    for (const auto& [name, value] : parameters) entry.parameters.push_back({name, value, 1});
  }
  return plugins;
}

std::string told(SimulatedRun& run) {
  std::string all;
  const core::EventLog& log = run.cosimulation.main_controller().events();
  for (std::uint64_t i = log.first(); i < log.total(); ++i) {
    all += std::to_string(log[i].stamp_ns / 1000000) + " " + std::string(log[i].text()) + "\n";
  }
  return all;
}

// The safe tail takes back a bow that a wrong DCM has caused, and goes on causing.
TEST(RefusedBatch, TheRobotWalksAfterABowThatTheSafeTailTookBack) {
  SimulatedRun run(1, mistaken({{"mistaken_at", "2 s"}, {"mistaken_for", "100 s"}, {"dcm_error", "0.05 m"}}));
  run.play(
      {.seconds = 16.0, .events = {{4.0, simulator::MainControllerSilentFault{3.0}}, walk_at(9.0, 0.15)}});
  EXPECT_FALSE(run.metrics().fell) << told(run);
  EXPECT_GT(run.metrics().distance_m(), 0.6) << told(run);
}

// Joints that hold a bow of 0.6 rad are up to 0.74 rad from where the next plan begins.
TEST(RefusedBatch, TheRobotWalksAfterItsJointsWereHeldInABow) {
  SimulatedRun run(1, mistaken({{"mistaken_at", "2 s"}, {"mistaken_for", "3 s"}, {"dcm_error", "0.05 m"}}));
  run.play({.seconds = 16.0,
            .events = {{4.0, simulator::EmergencyStopEvent{false}},
                       {6.0, simulator::ReleaseEvent{}},
                       walk_at(9.0, 0.15)}});
  EXPECT_FALSE(run.metrics().fell) << told(run);
  EXPECT_GT(run.metrics().distance_m(), 0.6) << told(run);
  EXPECT_THAT(told(run), testing::HasSubstr("does not begin where the joints are held"));
  EXPECT_EQ(run.cosimulation.main_controller().statistics().refused_locally, 0U) << told(run);
}

}  // namespace
}  // namespace gaitway::scenarios
