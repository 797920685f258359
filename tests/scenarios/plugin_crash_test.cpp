// Each plug-in, in a process of its own, takes that process down, hangs it or uses it up at a random instant
// of the walk: its fallback stands in within the same tick, the event names plug-in, cause and time, a new
// process takes its place, and the robot does not fall.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <string>
#include <tuple>

#include "fault_trial.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

constexpr std::array<const char*, 4> kPlugins{"zmp", "stability", "trajectory", "kinematics"};

core::Configuration with_saboteur(const std::string& plugin, const std::string& parameters) {
  std::string text = "plugins:\n";
  for (const std::string name : kPlugins) {
    text += "  - name: " + name + "\n";
    if (name == plugin) {
      text += fmt::format("    library: {}/{}.so\n    isolation: process\n    parameters: {{{}}}\n",
                          GAITWAY_SABOTEURS, name, parameters);
    }
  }
  return core::parse_configuration(text, "saboteur.yaml");
}

class PluginCrashes : public testing::TestWithParam<std::tuple<int, int, int>> {};

TEST_P(PluginCrashes, AtARandomInstantOfTheWalkAndTheRobotDoesNotFall) {
  const auto [plugin, way_index, trial] = GetParam();
  const Crash& way = kCrashes[static_cast<std::size_t>(way_index)];
  const std::string name = kPlugins[static_cast<std::size_t>(plugin)];
  const FaultInstant instant =
      random_fault_instant(static_cast<unsigned>(1000 * trial + 10 * plugin + way_index));
  // Every other time over and over again, so that the new processes fail as well.
  const double duration_s = trial % 2 == 0 ? instant.duration_s : 0.08;
  SimulatedRun run(static_cast<std::uint64_t>(trial),
                   with_saboteur(name, fmt::format("sabotage: {}, sabotage_at: {} s, sabotage_for: {} s",
                                                   way.name, instant.begin_s, duration_s)));
  run.play({.seconds = instant.begin_s + kWatchedAfterFault_s, .events = {walk_at(1.0, 0.15)}});
  EXPECT_FALSE(run.metrics().fell) << name << " " << way.name << " at " << instant.begin_s << " s for "
                                   << duration_s << " s, fell at " << run.metrics().fell_at_s;
  const core::EventLog& events = run.cosimulation.main_controller().events();
  ASSERT_EQ(events.first(), 0U) << "the first events are gone";
  const core::Event* const fault = first_event(events, name, core::EventKind::fault);
  const core::Event* const stands_in = first_event(events, name, core::EventKind::warning);
  ASSERT_NE(fault, nullptr);
  ASSERT_NE(stands_in, nullptr);
  EXPECT_THAT(std::string(fault->text()), testing::HasSubstr(way.cause));
  EXPECT_THAT(std::string(stands_in->text()), testing::MatchesRegex("fallback '.*' stands in"));
  EXPECT_EQ(stands_in->stamp_ns, fault->stamp_ns) << "in the same tick";
  const double late_s = static_cast<double>(fault->stamp_ns) * 1e-9 - instant.begin_s;
  EXPECT_GE(late_s, 0.0);
  EXPECT_LT(late_s, plugin < 2 ? 0.011 : 0.081) << "in its first step after that instant";
}

std::string name_of(const testing::TestParamInfo<std::tuple<int, int, int>>& info) {
  const auto [plugin, way, trial] = info.param;
  return fmt::format("{}_{}_{}", kPlugins[static_cast<std::size_t>(plugin)],
                     kCrashes[static_cast<std::size_t>(way)].name, trial);
}

INSTANTIATE_TEST_SUITE_P(RandomInstants, PluginCrashes,
                         testing::Combine(testing::Range(0, 4), testing::Range(0, 8),
                                          testing::Range(1, 1 + fault_trials(1))),
                         name_of);

}  // namespace
}  // namespace gaitway::scenarios
