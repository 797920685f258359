// Each plug-in fails in each way at a random instant of the walk: its fallback stands in within the same
// tick, the event names plug-in, cause and time, and the robot does not fall.
#include <gmock/gmock.h>

#include <array>
#include <string>
#include <tuple>

#include "fault_trial.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using core::PluginFaultKind;

constexpr std::array<const char*, 4> kFaultPlugins{"zmp", "stability", "trajectory", "kinematics"};
struct FaultWay {
  PluginFaultKind how;
  const char* name;
  const char* cause;  // part of the event's text
};
constexpr std::array<FaultWay, 4> kFaultWays{{{PluginFaultKind::throws, "throws", "threw"},
                                              {PluginFaultKind::not_a_number, "not_a_number", "finite"},
                                              {PluginFaultKind::jumps, "jumps", ""},
                                              {PluginFaultKind::overruns, "overruns", "budget"}}};
// Every plug-in in every way; the trials take turns at them.
class PluginFails : public ::testing::TestWithParam<std::tuple<int, int, int>> {};

TEST_P(PluginFails, AtARandomInstantOfTheWalkAndTheRobotDoesNotFall) {
  const auto [plugin, way_index, trial] = GetParam();
  const FaultWay& way = kFaultWays[static_cast<std::size_t>(way_index)];
  const std::string name = kFaultPlugins[static_cast<std::size_t>(plugin)];
  const FaultInstant instant =
      random_fault_instant(static_cast<unsigned>(1000 * trial + 10 * plugin + way_index));
  const double instant_s = instant.begin_s;
  const double duration_s = trial % 2 == 0 ? 0.0 : instant.duration_s;  // half of them for ever
  SimulatedRun run(static_cast<std::uint64_t>(trial));
  run.play({.seconds = instant_s + kWatchedAfterFault_s,
            .events = {walk_at(1.0, 0.15),
                       {instant_s, simulator::PluginFault{name, way.how, duration_s, 0.006}}}});
  EXPECT_FALSE(run.metrics().fell) << name << " " << way.name << " at " << instant_s << " s for "
                                   << duration_s << " s (0: ever), fell at " << run.metrics().fell_at_s;
  const core::EventLog& events = run.cosimulation.main_controller().events();
  // What kinematics publishes is checked as a whole, beyond its step.
  const bool refused =
      name == "kinematics" && (way.how == PluginFaultKind::not_a_number || way.how == PluginFaultKind::jumps);
  const core::Event* const event = refused ? first_event(events, "main_controller", core::EventKind::refusal)
                                           : first_event(events, name, core::EventKind::fault);
  if (duration_s == 0.0) {
    ASSERT_NE(event, nullptr);
  }
  if (event != nullptr && events.first() == 0) {
    EXPECT_THAT(std::string(event->text()), testing::HasSubstr(way.cause));
    EXPECT_GE(static_cast<double>(event->stamp_ns) * 1e-9, instant_s - 0.001);
    EXPECT_LT(static_cast<double>(event->stamp_ns) * 1e-9, instant_s + 0.1);
  }
}

std::string name_of_fault(const testing::TestParamInfo<std::tuple<int, int, int>>& info) {
  const auto [plugin, way, trial] = info.param;
  return std::string(kFaultPlugins[static_cast<std::size_t>(plugin)]) + "_" +
         kFaultWays[static_cast<std::size_t>(way)].name + "_" + std::to_string(trial);
}

INSTANTIATE_TEST_SUITE_P(RandomInstants, PluginFails,
                         ::testing::Combine(::testing::Range(0, 4), ::testing::Range(0, 4),
                                            ::testing::Range(1, 1 + fault_trials(2))),
                         name_of_fault);

}  // namespace
}  // namespace gaitway::scenarios
