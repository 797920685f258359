// Missions run by the whole chain: falls, getting up, giving up, persons who take over.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "behaviour_run.hpp"

namespace gaitway::scenarios {
namespace {

using testing::Contains;
using testing::HasSubstr;
namespace states = behaviour_state::state;
namespace commanders = command_state::commander;

struct Push {
  const char* name;
  std::array<double, 3> direction;
};
class FelledRobot : public testing::TestWithParam<std::tuple<int, int>> {};
constexpr std::array<Push, 4> kPushes{
    {{"ahead", {1, 0, 0}}, {"back", {-1, 0, 0}}, {"left", {0, 1, 0}}, {"right", {0, -1, 0}}}};

TEST_P(FelledRobot, GetsUp) {
  const auto [push, seed] = GetParam();
  BehaviourRun run({.seed = static_cast<std::uint64_t>(seed), .mission = "stand_up_after_falls"});
  run.advance_until(1.0);
  const auto& d = kPushes[static_cast<std::size_t>(push)].direction;
  run.push({d[0], d[1], d[2]});
  ASSERT_TRUE(run.advance_until([&] { return run.fall() != estimate::fall::upright; }, 2.0));
  EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 30.0)) << run.said();
  run.advance_until(run.time_s() + 3.0);
  EXPECT_TRUE(run.stands()) << run.said();
  EXPECT_EQ(run.state().state, states::runs);
  for (const auto& line : run.lines()) std::printf("  %s\n", line.c_str());
  for (const auto& m : run.commands.motions()) std::printf("  %.2f %s\n", m.at_s, m.name.c_str());
  std::printf("time %.2f\n", run.time_s());
}
INSTANTIATE_TEST_SUITE_P(Pushes, FelledRobot, testing::Combine(testing::Range(0, 4), testing::Range(1, 2)));

}  // namespace
}  // namespace gaitway::scenarios
