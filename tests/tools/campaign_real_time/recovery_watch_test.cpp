// What the campaign in real time makes of what it sees: in made-up time.
#include "tools/campaign/real_time/recovery_watch.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tools/campaign/real_time/real_time_row.hpp"
#include "tools/campaign/real_time/real_time_summary.hpp"
#include "tools/campaign/real_time/sabotage_order.hpp"

namespace gaitway::tools {
namespace {

constexpr std::int64_t kMs_ns = 1'000'000;
constexpr double kSpeed_m_per_s = 0.2;

// A robot as it is seen each 10 ms.
class SeenRobot {
 public:
  void see(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) {
      now_ns += 10 * kMs_ns;
      x_m += speed_m_per_s * 0.01;
      sight.at_ns = now_ns;
      if (is_told) sight.place = RobotSight::Place{now_ns, x_m, 0.0};
      if (is_told) sight.walk_order_ns = now_ns;
      if (is_supervised) sight.told_ns = now_ns;
      watch.look(sight);
    }
  }
  static RobotSight good() {
    RobotSight sight;
    sight.is_commandable = sight.all_parts_work = true;
    sight.counts = RobotSight::Counts{};
    sight.plugin_faults = 0;
    return sight;
  }

  std::int64_t now_ns = 1'000'000 * kMs_ns;
  double x_m = 0.0, speed_m_per_s = kSpeed_m_per_s;
  bool is_told = true, is_supervised = true;
  RobotSight sight = good();
  RecoveryWatch watch{kSpeed_m_per_s};
};

TEST(RecoveryWatch, ARobotThatWalksOnHasLostNothing) {
  SeenRobot robot;
  robot.see(0.5);
  EXPECT_FALSE(robot.watch.walks()) << "for too short a time";
  robot.see(1.0);
  EXPECT_TRUE(robot.watch.walks());
  robot.watch.on_fault(robot.now_ns);
  robot.see(3.0);
  const RealTimeOutcome outcome = robot.watch.outcome();
  EXPECT_TRUE(outcome.is_well());
  EXPECT_TRUE(outcome.walked_on);
  EXPECT_FALSE(outcome.was_interrupted);
  EXPECT_EQ(outcome.commandable_s, 0.0);
  EXPECT_EQ(outcome.walks_s, 0.0);
  EXPECT_NEAR(*outcome.order_s, 0.01, 1e-6);
  EXPECT_GE(robot.watch.well_ns(robot.now_ns), 2900 * kMs_ns);
}

TEST(RecoveryWatch, TellsWhenAMessageControllerThatWasKilledIsBackAndWhenItWalks) {
  SeenRobot robot;
  robot.sight.counts->late = 40;
  robot.sight.restarts = 7;
  robot.see(1.5);
  robot.watch.on_fault(robot.now_ns);
  robot.is_told = false;
  robot.sight.is_commandable = robot.sight.all_parts_work = false;
  robot.sight.counts.reset();
  robot.sight.walk_order_ns.reset();
  robot.see(0.4);
  EXPECT_FALSE(robot.watch.outcome().is_well());
  robot.is_told = robot.sight.is_commandable = robot.sight.all_parts_work = true;
  robot.sight.counts = RobotSight::Counts{.late = 2, .tail_played = 5};  // of a new one
  robot.sight.restarts = 8;
  robot.speed_m_per_s = 0.0;
  robot.x_m = 30.0;  // and in a new frame
  robot.see(0.5);
  EXPECT_FALSE(robot.watch.walks()) << "a new frame is no way";
  robot.speed_m_per_s = kSpeed_m_per_s;
  robot.see(1.2);
  const RealTimeOutcome outcome = robot.watch.outcome();
  EXPECT_TRUE(outcome.is_well());
  EXPECT_TRUE(outcome.was_interrupted);
  EXPECT_FALSE(outcome.walked_on);
  EXPECT_NEAR(*outcome.commandable_s, 0.41, 1e-6);
  EXPECT_NEAR(*outcome.order_s, 0.41, 1e-6);
  EXPECT_NEAR(*outcome.parts_s, 0.41, 1e-6);
  EXPECT_GT(*outcome.walks_s, 1.3) << "half of the way of a second";
  EXPECT_LT(*outcome.walks_s, 1.6);
  EXPECT_EQ(outcome.lost.batches, 2U) << "those of before do not count";
  EXPECT_EQ(outcome.lost.tail_cycles, 5U);
  EXPECT_EQ(outcome.lost.restarts, 1U);
}

TEST(RecoveryWatch, WhatTheSupervisorSaidBeforeTheFaultSaysNothingOfIt) {
  SeenRobot robot;
  robot.see(1.5);
  robot.is_supervised = false;
  robot.watch.on_fault(robot.now_ns);
  robot.see(1.0);
  EXPECT_FALSE(robot.watch.outcome().parts_s);
  robot.is_supervised = true;
  robot.see(0.1);
  EXPECT_NEAR(*robot.watch.outcome().parts_s, 1.01, 1e-6);
}

TEST(RecoveryWatch, WhatIsLostAgainIsNotBack) {
  SeenRobot robot;
  robot.see(1.5);
  robot.watch.on_fault(robot.now_ns);
  robot.see(1.0);
  robot.sight.is_commandable = false;
  robot.sight.all_parts_work = false;
  robot.see(0.2);
  const RealTimeOutcome outcome = robot.watch.outcome();
  EXPECT_FALSE(outcome.commandable_s);
  EXPECT_FALSE(outcome.parts_s);
  EXPECT_EQ(robot.watch.well_ns(robot.now_ns), 0);
}

TEST(RecoveryWatch, ATrunkThatLeansForLongIsAFallAndAStumbleIsNone) {
  SeenRobot robot;
  robot.see(1.5);
  robot.watch.on_fault(robot.now_ns);
  robot.sight.lean_rad = 1.2;
  robot.see(0.2);
  robot.sight.lean_rad = 0.1;
  robot.see(1.0);
  EXPECT_FALSE(robot.watch.has_fallen());
  robot.sight.lean_rad = 1.2;
  robot.see(0.5);
  ASSERT_TRUE(robot.watch.has_fallen());
  EXPECT_NEAR(*robot.watch.outcome().fell_s, 1.2, 0.02);
  EXPECT_FALSE(robot.watch.outcome().is_well());
}

TEST(RecoveryWatch, AStopIsTimedFromItsAskingAlsoByAMessageControllerThatIsNew) {
  SeenRobot robot;
  robot.sight.counts->stops = 3;
  robot.see(1.5);
  robot.watch.on_fault(robot.now_ns);
  robot.see(0.1);
  robot.watch.on_stop_asked(robot.now_ns);
  robot.see(0.05);
  EXPECT_FALSE(robot.watch.has_stopped());
  robot.sight.counts->stops = 0;
  robot.see(0.05);
  EXPECT_FALSE(robot.watch.has_stopped()) << "a new one has obeyed none so far";
  robot.sight.counts->stops = 1;
  robot.see(0.05);
  EXPECT_NEAR(*robot.watch.outcome().stop_s, 0.11, 1e-6);
}

TEST(RealTimeTrial, ItsInstantIsDrawnFromRowAndNumberAndASecondOneIsStopped) {
  const RealTimeTrial trial = draw_real_time_trial("main_controller_killed", 4, 0.2);
  EXPECT_EQ(trial.instant_s, draw_real_time_trial("main_controller_killed", 4, 0.2).instant_s);
  EXPECT_NE(trial.instant_s, draw_real_time_trial("main_controller_killed", 6, 0.2).instant_s);
  EXPECT_NE(trial.instant_s, draw_real_time_trial("user_interface_killed", 4, 0.2).instant_s);
  int stopped = 0;
  double least_s = 1e9, most_s = 0.0;
  for (std::uint64_t number = 0; number < 100; ++number) {
    const RealTimeTrial one = draw_real_time_trial("plugin_fork", number, 0.2);
    stopped += one.is_stopped ? 1 : 0;
    least_s = std::min(least_s, one.instant_s);
    most_s = std::max(most_s, one.instant_s);
  }
  EXPECT_EQ(stopped, 50);
  EXPECT_GT(most_s - least_s, 1.28) << "each phase of both steps may be met";
}

TEST(RealTimeTrial, AnOutcomeOutlivesItsJson) {
  RealTimeOutcome outcome;
  outcome.seed = 3;
  outcome.was_interrupted = true;
  outcome.commandable_s = 0.31;
  outcome.walks_s = 2.5;
  outcome.parts_s = 0.4;
  outcome.stop_s = 0.2;
  outcome.lost = {.batches = 1, .restarts = 2};
  outcome.note = "told";
  const auto json = to_json(outcome);
  EXPECT_EQ(to_json(real_time_outcome_from_json(json)), json);
  EXPECT_TRUE(json["order_s"].is_null());
  auto less = json;
  less.erase("walks_s");
  EXPECT_THROW(static_cast<void>(real_time_outcome_from_json(less)), nlohmann::json::exception);
}

TEST(RealTimeTable, EachRowHasANameOfItsOwnAndSomethingThatHappens) {
  const std::vector<RealTimeRow> table = real_time_table();
  for (const RealTimeRow& row : table) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(std::ranges::count(table, row.name, &RealTimeRow::name), 1);
    EXPECT_TRUE(row.begin || row.prepare);
    EXPECT_FALSE(row.what.empty());
  }
  EXPECT_EQ(chosen_real_time_rows(table, {"clock_back_1h"}, {}).size(), 1U);
  EXPECT_EQ(chosen_real_time_rows(table, {}, {"clock_back_1h"}).size(), table.size() - 1);
  EXPECT_THROW(static_cast<void>(chosen_real_time_rows(table, {"clock"}, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(chosen_real_time_rows(table, {"clock_back_1h"}, {"clock_back_1h"})),
               std::invalid_argument);
}

TEST(RealTimeSummary, CountsFallsAndWhatDidNotComeBack) {
  RealTimeRowResult row{.row = real_time_table().front(), .outcomes = {}};
  RealTimeOutcome well;
  well.was_interrupted = true;
  well.commandable_s = well.parts_s = 0.3;
  well.order_s = 0.4;
  well.walks_s = 2.0;
  row.outcomes = {well, well, well, well};
  row.outcomes[1].stop_s = 0.2;
  row.outcomes[2].fell = true;
  row.outcomes[2].walks_s.reset();
  row.outcomes[3].parts_s.reset();
  const RealTimeSummary summary = summary_of(row);
  EXPECT_EQ(summary.falls, 1U);
  EXPECT_EQ(summary.walked_again, 3U);
  EXPECT_EQ(summary.stopped, 2U);
  EXPECT_EQ(summary.stop.count, 1U);
  EXPECT_EQ(summary.parts.count, 3U);
  EXPECT_NEAR(summary.most_falls_share, 0.751, 0.001) << "Clopper and Pearson, one of four";
  RealTimeCampaign campaign;
  campaign.rows = {row};
  const std::string text = real_time_markdown({"a robot", 0.2}, campaign);
  EXPECT_THAT(text, testing::HasSubstr("| 4 | 1 (≤ 75 %) |"));
  EXPECT_THAT(text, testing::HasSubstr("3 of 4: 0.30, 0.30"));
  EXPECT_THAT(text, testing::HasSubstr("1 of 2: 0.20, 0.20"));
  EXPECT_THAT(text, testing::HasSubstr("1 of 4 trials fell; in 2 all came back"));
}

TEST(SabotageOrder, IsDueOnceAndNotAgainForWhoeverTakesThePlace) {
  constexpr std::int64_t kAt_ns = 123'456 * kMs_ns;
  const std::int64_t order = sabotage_order("loop", kAt_ns);
  EXPECT_EQ(sabotage_of(order), "loop");
  EXPECT_FALSE(is_due(order, kAt_ns - kMs_ns));
  EXPECT_TRUE(is_due(order, kAt_ns));
  EXPECT_TRUE(is_due(order, kAt_ns + 10 * kMs_ns));
  EXPECT_FALSE(is_due(order, kAt_ns + 40 * kMs_ns)) << "a lost process is replaced after 40 ms";
  EXPECT_FALSE(is_due(0, kAt_ns));
  EXPECT_THROW(static_cast<void>(sabotage_order("nothing", kAt_ns)), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::tools
