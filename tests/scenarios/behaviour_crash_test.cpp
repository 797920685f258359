// The behaviour, in a process of its own, takes that process down, hangs it or uses it up at a random instant
// of a mission that walks and looks around: the robot stands, its head comes home, a new process begins the
// mission anew, and the robot does not fall.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string>
#include <tuple>

#include "behaviour_run.hpp"
#include "fault_trial.hpp"

namespace gaitway::scenarios {
namespace {

constexpr const char* kWalksAndLooksAround = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
  <Sleep msec="1000"/>
  <Parallel success_count="2" failure_count="1"><Walk forward="0.15 m/s"/><LookAround/></Parallel>
</Sequence></BehaviorTree></root>)";

class BehaviourCrashes : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] static BehaviourRunOptions sabotaged(const Crash& way, const FaultInstant& instant,
                                                     double duration_s, unsigned seed) {
    const std::string mission =
        fmt::format("{}walks_and_looks_{}_{}.xml", testing::TempDir(), way.name, getpid());
    std::ofstream(mission) << kWalksAndLooksAround;
    return {.seed = seed,
            .mission = mission,
            .isolation = "process",
            .library = std::string(GAITWAY_SABOTEURS) + "/behaviour.so",
            .parameters = fmt::format(", sabotage: {}, sabotage_at: {} s, sabotage_for: {} s", way.name,
                                      instant.begin_s, duration_s)};
  }
};

TEST_P(BehaviourCrashes, TheRobotStandsAndTheMissionBeginsAnew) {
  const Crash& way = kCrashes[static_cast<std::size_t>(GetParam())];
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const FaultInstant instant = random_fault_instant(10 * seed + static_cast<unsigned>(GetParam()));
    BehaviourRun run(sabotaged(way, instant, 0.08, seed));
    run.advance_until(instant.begin_s);
    ASSERT_FALSE(run.stands()) << run.said();
    run.advance_until(instant.begin_s + 8.0);
    EXPECT_FALSE(run.cosimulation.plant().fallen()) << instant.begin_s;
    const core::EventLog& events = run.cosimulation.main_controller().events();
    const core::Event* const fault = first_event(events, "behaviour", core::EventKind::fault);
    ASSERT_NE(fault, nullptr);
    EXPECT_THAT(std::string(fault->text()), testing::HasSubstr(way.cause));
    EXPECT_FALSE(run.stands()) << "it walks again";
  }
}

TEST_P(BehaviourCrashes, WhereItFailsForEverTheRobotStandsAndLooksAhead) {
  const Crash& way = kCrashes[static_cast<std::size_t>(GetParam())];
  const FaultInstant instant = random_fault_instant(static_cast<unsigned>(GetParam()));
  BehaviourRun run(sabotaged(way, instant, 1e6, 3));
  run.advance_until(instant.begin_s + 8.0);
  EXPECT_FALSE(run.cosimulation.plant().fallen()) << instant.begin_s;
  EXPECT_TRUE(run.stands()) << testing::PrintToString(run.lines());
  EXPECT_NEAR(run.head_yaw_rad(), 0.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Ways, BehaviourCrashes, testing::Range(0, 8), [](const auto& trial) {
  return std::string(kCrashes[static_cast<std::size_t>(trial.param)].name);
});

}  // namespace
}  // namespace gaitway::scenarios
