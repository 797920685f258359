// The fault campaign: its rows, its trials, what it makes of their outcomes, and the command.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "command_run.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "tools/campaign/campaign.hpp"
#include "tools/campaign/endurance.hpp"
#include "tools/campaign/fault_run.hpp"
#include "tools/campaign/row_summary.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

const TrialRobot& walker() {
  static const TrialRobot it{
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22"),
      core::read_configuration(std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml"),
      {GAITWAY_PLUGIN_DIR}};
  return it;
}

FaultRow row_named(const std::string& name) {
  return chosen_fault_rows(fault_table(walker().model), {name}, {}).at(0);
}

FaultTrial trial_at(const std::string& row, double instant_s) {
  FaultTrial trial = draw_trial(row_named(row), 0, 1, 0.2);
  trial.instant_s = instant_s;
  return trial;
}

FaultOutcome alone(const FaultTrial& trial) {
  FaultOutcome only;
  run_fault_trials(walker(), {&trial, 1}, [&](std::size_t, const FaultOutcome& outcome) { only = outcome; });
  return only;
}

TEST(FaultTable, EachRowHasANameOfItsOwnAndFaultsThatAScenarioUnderstands) {
  std::set<std::string> names;
  for (const FaultRow& row : fault_table(walker().model)) {
    SCOPED_TRACE(row.name);
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_EQ(row.why.empty(),
              row.expected == FaultExpectation::survives || row.expected == FaultExpectation::reported);
    for (std::uint64_t number = 0; number < 30; ++number) {
      const auto events = events_of(draw_trial(row, number, 20, 0.2), walker().model);
      ASSERT_FALSE(events.empty());
      EXPECT_TRUE(std::ranges::is_sorted(events, {}, &simulator::ScenarioEvent::at_s));
    }
  }
  EXPECT_GT(names.size(), 50U);
}

TEST(FaultTable, ANameThatNoRowHasIsRefusedWithTheNextBest) {
  try {
    static_cast<void>(row_named("dead_kne"));
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("Did you mean 'dead_knee'?"));
  }
}

TEST(Endurance, OnlyWhatIsSurvivedAndPassesComesOneAfterTheOther) {
  std::set<std::string> names;
  for (const FaultRow& row : passing_rows(fault_table(walker().model), walker().model))
    names.insert(row.name);
  for (const char* const passing :
       {"jam", "message_controller_silent_5s", "joint_restarts_20ms", "batch_late"}) {
    EXPECT_TRUE(names.contains(passing)) << passing;
  }
  for (const char* const lasting :
       {"message_controller_dead", "plugin_throws", "imu_noisy", "dead_neck", "dead_knee"}) {
    EXPECT_FALSE(names.contains(lasting)) << lasting;
  }
}

TEST(Endurance, TheSameHoursAreTheSameWhoeverPlaysThem) {
  const std::vector<FaultRow> rows = passing_rows(fault_table(walker().model), walker().model);
  EnduranceOptions options{.hours = 0.005, .robots = 2, .jobs = 1, .mean_pause_s = 3.0, .progress = {}};
  const std::vector<EnduranceRun> once = run_endurance(walker(), rows, options);
  options.jobs = 2;
  const std::vector<EnduranceRun> again = run_endurance(walker(), rows, options);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].faults, again[i].faults);
    EXPECT_EQ(once[i].walked_m, again[i].walked_m);
    EXPECT_GT(once[i].fault_count(), 1U);
    EXPECT_GT(once[i].walked_m, 0.2);
    EXPECT_DOUBLE_EQ(once[i].played_s, 18.0);
    EXPECT_GT(once[i].memory_last_KiB, 1000U);
  }
  EXPECT_NE(once[0].faults, once[1].faults) << "each robot meets its own";
}

TEST(Endurance, AFallIsToldWithTheFaultsBeforeItAndAnotherRobotWalksOn) {
  const EnduranceOptions options{.hours = 0.005, .robots = 1, .jobs = 1, .mean_pause_s = 2.0, .progress = {}};
  const EnduranceRun run = run_endurance(walker(), {row_named("dead_knee")}, options).at(0);
  ASSERT_FALSE(run.falls.empty());
  EXPECT_EQ(run.falls.front().rows.front(), "dead_knee");
  EXPECT_DOUBLE_EQ(run.played_s, 18.0);
  EXPECT_THAT(endurance_markdown(options, {run}), HasSubstr("Robot 1 fell at "));
}

TEST(Endurance, AFallCanBePlayedAgain) {
  const EnduranceOptions options{.hours = 0.005, .robots = 1, .jobs = 1, .mean_pause_s = 2.0, .progress = {}};
  const std::vector<EnduranceRun> runs =
      run_endurance(walker(), {row_named("dead_knee"), row_named("jam")}, options);
  ASSERT_FALSE(runs.front().falls.empty());
  const EnduranceFall& fall = runs.front().falls.front();
  EXPECT_THAT(endurance_markdown(options, runs), HasSubstr("--scenario fall_1_0.yaml --seed 1"));
  EXPECT_FALSE(endurance_json(runs)[0]["falls"][0].contains("scenario")) << "it has a file of its own";
  const std::filesystem::path file = testing::TempDir() + fmt::format("gaitway_{}_fall.yaml", getpid());
  std::ofstream(file) << fall.scenario;
  const simulator::Scenario scenario = simulator::load_scenario(file, walker().model);
  std::filesystem::remove(file);
  simulator::Cosimulation run(walker().model, walk_options(walker(), fall.seed));
  const auto now_s = [&run] { return static_cast<double>(run.now_ns()) * 1e-9; };
  auto event = scenario.events.begin();
  while (!run.plant().fallen() && now_s() < scenario.seconds) {
    for (; event != scenario.events.end() && event->at_s <= now_s() + 1e-9; ++event) run.apply(*event);
    run.advance_millisecond();
  }
  EXPECT_DOUBLE_EQ(now_s(), fall.at_s) << "in the same millisecond";
}

TEST(FaultTrial, InstantsAreSpreadOverTheGaitCycleByChance) {
  constexpr int kTrials = 2000;
  std::array<int, 10> phases{};
  const FaultRow row = row_named("jam");
  for (std::uint64_t number = 0; number < kTrials; ++number) {
    const FaultTrial trial = draw_trial(row, number, 20, 0.2);
    EXPECT_EQ(describe(trial), describe(draw_trial(row, number, 20, 0.2)));
    ++phases[static_cast<std::size_t>(std::fmod(trial.instant_s, 0.8) / 0.08)];
  }
  double chi_squared = 0.0;
  for (const int count : phases) chi_squared += std::pow(count - kTrials / 10.0, 2) / (kTrials / 10.0);
  EXPECT_LT(chi_squared, 27.9) << "one in a thousand, with nine degrees of freedom";
}

TEST(FaultTrial, OutcomesAreTheSameWhoeverSharesTheWalk) {
  const std::vector<FaultTrial> trials{trial_at("dead_knee", 4.1), trial_at("dead_ankle_roll", 4.1),
                                       trial_at("dead_knee", 4.35)};
  std::size_t next = 0;
  run_fault_trials(walker(), trials, [&](std::size_t trial, const FaultOutcome& outcome) {
    EXPECT_EQ(trial, next++);
    EXPECT_EQ(to_json(outcome), to_json(alone(trials[trial]))) << "trial " << trial;
    EXPECT_EQ(to_json(fault_outcome_from_json(to_json(outcome))), to_json(outcome));
  });
  EXPECT_EQ(next, trials.size());
}

TEST(FaultTrial, ADeadKneeFellsTheRobotWhichKnowsBeforeTheImpact) {
  const FaultOutcome outcome = alone(trial_at("dead_knee", 4.1));
  ASSERT_TRUE(outcome.fell && outcome.impact_s && outcome.told_s);
  EXPECT_LT(*outcome.told_s, *outcome.impact_s);
  EXPECT_TRUE(outcome.reacted());
  ASSERT_TRUE(outcome.stop_s) << "the bus lives";
  EXPECT_LT(*outcome.stop_s, 0.01);
}

TEST(FaultTrial, AJamIsWalkedThroughAndAStopInALongOneDoesNotReachTheBus) {
  FaultTrial jam = trial_at("jam", 4.1);
  jam.actions = {{0.0, "fault: {kind: jam, duration_s: 0.003}"}};
  const FaultOutcome through = alone(jam);
  EXPECT_FALSE(through.fell);
  EXPECT_TRUE(through.walked_on);
  EXPECT_EQ(through.lost.wrong_joints, 0);
  EXPECT_TRUE(through.stop_s);
  jam.actions = {{0.0, "fault: {kind: jam, duration_s: 0.3}"}};
  EXPECT_FALSE(alone(jam).stop_s);
}

TEST(FaultTrial, AMainControllerThatIsSilentForAWhileStandsAndWalksAgain) {
  FaultTrial silent = trial_at("main_controller_returns", 4.1);
  silent.actions = {{0.0, "fault: {kind: main_controller_silent, duration_s: 0.2}"}};
  const FaultOutcome outcome = alone(silent);
  EXPECT_FALSE(outcome.fell);
  EXPECT_FALSE(outcome.walked_on);
  EXPECT_GT(outcome.lost.tail_played, 0U);
  ASSERT_TRUE(outcome.stands_s && outcome.walks_s);
  EXPECT_LT(*outcome.stands_s, *outcome.walks_s);
}

// Whoever plays it with `gaitway run` sees the same.
// The joints' references are told from their torques, and joints that were left alone are compliant.
TEST(FaultTrial, AMessageControllerThatRestartsFindsEachJointWhereItIs) {
  for (const double instant_s : {5.13, 6.42}) {
    const FaultOutcome outcome = alone(trial_at("message_controller_restarts", instant_s));
    EXPECT_FALSE(outcome.fell);
    EXPECT_LT(outcome.stands_s.value_or(10.0), 1.0);
    EXPECT_EQ(outcome.lost.wrong_joints, 0);
  }
}

TEST(FaultTrial, ItsScenarioFallsInTheSameMillisecond) {
  const FaultTrial trial = trial_at("dead_knee", 4.1);
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "fault_trial.yaml";
  std::ofstream(file) << scenario_text(trial);
  const simulator::Scenario scenario = simulator::load_scenario(file, walker().model);
  simulator::CosimulationOptions options;
  options.plant.seed = trial.seed;
  options.main_controller.configuration = walker().plugins.file;
  options.main_controller.plugin_path = walker().plugin_path;
  simulator::Cosimulation run(walker().model, options);
  std::size_t next = 0;
  while (!run.plant().fallen() && run.plant().time_s() < 8.0) {
    const double now_s = static_cast<double>(run.now_ns()) * 1e-9;
    for (; scenario.events[next].at_s <= now_s + 1e-9; ++next) run.apply(scenario.events[next]);
    run.advance_millisecond();
  }
  EXPECT_NEAR(run.plant().time_s() - trial.instant_s, alone(trial).fell_s.value(), 1e-6);
}

CampaignRow row_with(FaultExpectation expected, std::vector<FaultOutcome> outcomes) {
  CampaignRow row;
  row.row.expected = expected;
  for (FaultOutcome& outcome : outcomes) row.trials.push_back({{}, outcome});
  return row;
}

TEST(CampaignRow, HoldsAsItsExpectationHasIt) {
  FaultOutcome stays, knew, did_not_know;
  knew.fell = did_not_know.fell = true;
  knew.impact_s = did_not_know.impact_s = 1.0;
  knew.told_s = 0.7;
  did_not_know.told_s = 1.1;
  FaultOutcome bends = knew;  // without an impact
  bends.impact_s.reset();
  bends.fell_s = 0.9;
  EXPECT_TRUE(bends.reacted());
  EXPECT_TRUE(row_with(FaultExpectation::survives, {stays, stays}).holds());
  EXPECT_FALSE(row_with(FaultExpectation::survives, {stays, knew}).holds());
  EXPECT_TRUE(row_with(FaultExpectation::physics, {stays, knew}).holds());
  EXPECT_FALSE(row_with(FaultExpectation::physics, {knew, did_not_know}).holds());
  EXPECT_TRUE(row_with(FaultExpectation::not_yet, {did_not_know}).holds());
}

TEST(CampaignRow, SummaryCountsEndsAndBoundsTheShareOfFalls) {
  FaultOutcome walks, stands, falls;
  walks.walked_on = true;
  stands.stands_s = 0.5;
  falls.fell = true;
  const RowSummary summary = summary_of(row_with(FaultExpectation::survives, {walks, stands, falls, walks}));
  EXPECT_EQ(summary.ends, (std::array<std::size_t, kFaultEnds>{2, 0, 1, 0, 1}));
  EXPECT_EQ(summary.stands.count, 1U);
  const RowSummary many = summary_of(row_with(FaultExpectation::survives, std::vector(1000, walks)));
  EXPECT_NEAR(many.most_falls_share, 0.00299, 1e-5) << "1 - 0.05^(1/1000)";
  // Clopper and Pearson's table: 2 of 10.
  std::vector<FaultOutcome> ten(10, walks);
  ten[0] = ten[1] = falls;
  EXPECT_NEAR(summary_of(row_with(FaultExpectation::survives, ten)).most_falls_share, 0.5069, 1e-4);
}

TEST(FaultCampaign, GoesOnWhereItWasAndTellsTheSameWithMoreJobs) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("campaign_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto check = [](const nlohmann::ordered_json& outcome) {
    static_cast<void>(fault_outcome_from_json(outcome));
  };
  const std::vector<FaultRow> rows{row_named("dead_knee")};
  CampaignOptions options{.instants = 2, .robots = 2, .speed_m_per_s = 0.2, .jobs = 1, .progress = {}};
  {
    OutcomeStore store(folder / "trials.jsonl", 7, check);
    const Campaign first = run_campaign(walker(), rows, store, options);
    EXPECT_EQ(first.run, 2U);
  }
  options.instants = 3;
  OutcomeStore store(folder / "trials.jsonl", 7, check);
  const Campaign more = run_campaign(walker(), rows, store, options);
  EXPECT_EQ(more.run, 1U);
  EXPECT_EQ(more.known, 2U);
  options.jobs = 2;
  OutcomeStore other(folder / "others.jsonl", 7, check);
  const Campaign again = run_campaign(walker(), rows, other, options);
  EXPECT_EQ(campaign_csv(more), campaign_csv(again));
  const CampaignHead head{"humanoid22", "walk.yaml", options, false};
  EXPECT_THAT(campaign_markdown(head, more), HasSubstr("| `dead_knee`: a knee dies | 3 |"));
  EXPECT_EQ(campaign_json(head, more)["rows"][0]["trials"], 3);
  EXPECT_THAT(campaign_picture(head, more), HasSubstr("of 3 fall"));
  std::filesystem::remove_all(folder);
}

test::CommandRun campaign(const std::string& options) {
  return test::run_command(std::string(GAITWAY_COMMAND) + " campaign " + options);
}

TEST(CampaignCommand, PrintsATrialAsAScenarioAndRefusesWhatItDoesNotKnow) {
  const test::CommandRun scenario = campaign("--row dead_knee --instant 3");
  EXPECT_EQ(scenario.code, 0) << scenario.all();
  EXPECT_THAT(scenario.said, HasSubstr("fault: {kind: joint_dies"));
  EXPECT_THAT(scenario.said, HasSubstr("--seed 4"));
  const test::CommandRun wrong = campaign("--rows dead_kne");
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.complaint, HasSubstr("Did you mean 'dead_knee'?"));
  EXPECT_EQ(campaign("--row dead_knee").code, 1) << "which one?";
  EXPECT_THAT(campaign("--list").said, HasSubstr("message_controller_dead"));
}

TEST(CampaignCommand, WritesItsResultsAndEndsWellWithoutAFall) {
  const std::filesystem::path out =
      std::filesystem::path(testing::TempDir()) / ("campaign_out_" + std::to_string(getpid()));
  const test::CommandRun run =
      campaign("--rows dead_neck --instants 1 --jobs 1 --quiet --out " + out.string());
  EXPECT_EQ(run.code, 0) << run.all();
  for (const char* const file : {"campaign.md", "campaign.json", "campaign.csv", "campaign.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
  }
  std::filesystem::remove_all(out);
}

}  // namespace
}  // namespace gaitway::tools
