// What a run says of itself: stayed up is not enough where the robot did not do what it was asked.
#include "tools/run/run_metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;
using Verdict = RunOutcome::Verdict;

constexpr BatchCount kAllWell{.handed_over = 250, .refused = 0};
constexpr double kRun_s = 20.0;

RunMetrics walked(double done_m, double commanded_m) {
  RunMetrics metrics;
  metrics.way_m = {.commanded = commanded_m, .due = 0.9 * commanded_m, .done = done_m};
  return metrics;
}

TEST(RunOutcome, AWalkThatWasWalkedIsDone) {
  const RunOutcome outcome = outcome_of(walked(2.7, 2.85), kAllWell, kRun_s);
  EXPECT_EQ(exit_code(outcome.verdict), kExitFine);
  EXPECT_EQ(outcome.text, "stayed up, walked 2.70 m of the commanded 2.85 m");
}

TEST(RunOutcome, AWalkThatWasNotWalkedIsNotDone) {
  const RunOutcome outcome = outcome_of(walked(0.03, 3.0), {.handed_over = 110, .refused = 127}, kRun_s);
  EXPECT_EQ(outcome.verdict, Verdict::not_done);
  EXPECT_EQ(exit_code(outcome.verdict), kExitNotDone);
  EXPECT_THAT(outcome.text, HasSubstr("0.03 m of the commanded 3.00 m"));
  EXPECT_THAT(outcome.text, HasSubstr("refused batches: 127 of 237"));
}

TEST(RunOutcome, ATurnCountsAsAWayDoes) {
  RunMetrics metrics;
  metrics.turn_rad = {.commanded = 2.0, .due = 1.6, .done = 0.1};
  EXPECT_THAT(outcome_of(metrics, kAllWell, kRun_s).text,
              HasSubstr("turned 0.10 rad of the commanded 2.00 rad"));
  metrics.turn_rad.done = 1.8;
  EXPECT_EQ(outcome_of(metrics, kAllWell, kRun_s).verdict, Verdict::done);
}

TEST(RunOutcome, AShortStartTellsNothing) {
  RunMetrics metrics;
  metrics.way_m = {.commanded = 0.3, .due = 0.0, .done = 0.02};
  EXPECT_EQ(outcome_of(metrics, kAllWell, 3.0).verdict, Verdict::done);
}

TEST(RunOutcome, ARobotWithoutBatchesOnlyStood) {
  const RunOutcome outcome = outcome_of(RunMetrics(), {}, kRun_s);
  EXPECT_EQ(exit_code(outcome.verdict), kExitNotDone);
  EXPECT_THAT(outcome.text, HasSubstr("no plug-in gave a batch"));
}

TEST(RunOutcome, OneRefusedBatchIsToldAndAllowed) {
  const RunOutcome outcome = outcome_of(walked(2.7, 2.85), {.handed_over = 249, .refused = 1}, kRun_s);
  EXPECT_EQ(outcome.verdict, Verdict::done);
  EXPECT_THAT(outcome.text, HasSubstr("refused batches: 1 of 250"));
}

TEST(RunOutcome, ARunThatIsStoppedMayHaveTheBatchesRefusedThatWereOnTheirWay) {
  constexpr double kStoppedAfter_s = 0.3;
  const auto verdict = [](const BatchCount& batches) {
    return outcome_of({}, batches, kStoppedAfter_s).verdict;
  };
  EXPECT_EQ(verdict({.handed_over = 3, .refused = 2, .refused_by_a_stop = 2}), Verdict::done);
  EXPECT_EQ(verdict({.handed_over = 3, .refused = 2, .refused_by_a_stop = 1}), Verdict::not_done);
  EXPECT_EQ(verdict({.handed_over = 3, .refused = 1}), Verdict::not_done);
  EXPECT_EQ(outcome_of({}, {.handed_over = 0, .refused = 1}, kStoppedAfter_s).verdict, Verdict::not_done);
}

TEST(RunOutcome, AFallIsAFallWhateverElse) {
  RunMetrics metrics = walked(0.0, 3.0);
  metrics.fell = true;
  metrics.fell_at_s = 4.5;
  const RunOutcome outcome = outcome_of(metrics, {}, kRun_s);
  EXPECT_EQ(exit_code(outcome.verdict), kExitFell);
  EXPECT_EQ(outcome.text, "FELL at 4.50 s");
}

MissionEnd patrol() {
  return {.name = "Patrol", .endless = true};
}
const RunOutcome kStayedUp{.verdict = Verdict::done, .text = "stayed up"};

TEST(RunOutcome, AMissionWithoutAnEndIsDoneWhileItGoesOn) {
  const RunOutcome outcome = outcome_of(patrol(), kStayedUp);
  EXPECT_EQ(outcome.verdict, Verdict::done);
  EXPECT_EQ(outcome.text, "stayed up, mission 'Patrol' goes on");
  MissionEnd felled = patrol();
  felled.falls = 1;
  EXPECT_EQ(outcome_of(felled, kStayedUp).text,
            "is on its feet at the end, fell 1 time, mission 'Patrol' goes on");
}

TEST(RunOutcome, AMissionWithoutAnEndThatFailsHasFailed) {
  MissionEnd mission = patrol();
  mission.state = MissionEnd::State::failed;
  mission.reason = "WalkTo: there is no navigation";
  const RunOutcome outcome = outcome_of(mission, kStayedUp);
  EXPECT_EQ(outcome.verdict, Verdict::not_done);
  EXPECT_THAT(outcome.text, HasSubstr("WalkTo: there is no navigation"));
}

// A robot that is served waits for people most of the time.
TEST(RunOutcome, WhatBecomesOfPeoplesMissionsIsNoVerdict) {
  MissionEnd mission = patrol();
  mission.is_of_people = mission.waits = true;
  EXPECT_EQ(outcome_of(mission, kStayedUp).verdict, Verdict::done);
  EXPECT_EQ(outcome_of(mission, kStayedUp).text, "stayed up, mission 'Patrol' waits");
  mission.waits = mission.endless = false;
  mission.state = MissionEnd::State::failed;
  EXPECT_EQ(outcome_of(mission, kStayedUp).verdict, Verdict::done);
  mission.state = MissionEnd::State::runs;
  mission.silent_since_s = 3.0;
  EXPECT_EQ(outcome_of(mission, kStayedUp).verdict, Verdict::done);
}

TEST(RunOutcome, AMissionThatWaitsOrIsSilentAtTheEndIsNotDone) {
  MissionEnd waits = patrol();
  waits.waits = true;
  EXPECT_EQ(outcome_of(waits, kStayedUp).verdict, Verdict::not_done);
  MissionEnd silent = patrol();
  silent.silent_since_s = 5.0;
  const RunOutcome outcome = outcome_of(silent, kStayedUp);
  EXPECT_EQ(outcome.verdict, Verdict::not_done);
  EXPECT_THAT(outcome.text, HasSubstr("SILENT at 5.00 s"));
}

}  // namespace
}  // namespace gaitway::tools
