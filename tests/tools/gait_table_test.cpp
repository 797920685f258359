// The gait table: its rows' trials and floors, the search of a limit, and when seeds hold a level.
#include "tools/measure/gait_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/trajectory/gait_parameters.hpp"
#include "tools/measure/gait_measurement.hpp"
#include "tools/measure/level_search.hpp"

namespace gaitway::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Plays a search against a limit; returns the levels that it tried.
std::vector<double> levels_tried(LevelSearch& search, double true_limit) {
  std::vector<double> tried;
  while (const auto level = search.next()) {
    tried.push_back(search.levels()[*level]);
    search.judged(tried.back() <= true_limit);
  }
  return tried;
}

TEST(LevelSearch, goes_up_from_a_floor_that_holds_until_a_level_fails) {
  LevelSearch search({1, 2, 3, 4, 5}, 1);
  EXPECT_THAT(levels_tried(search, 3.5), ElementsAre(2, 3, 4));
  EXPECT_EQ(search.limit(), 3.0);
  EXPECT_FALSE(search.open_ended());
}

TEST(LevelSearch, goes_down_from_a_floor_that_fails_until_a_level_holds) {
  LevelSearch search({1, 2, 3, 4, 5}, 3);
  EXPECT_THAT(levels_tried(search, 2.0), ElementsAre(4, 3, 2));
  EXPECT_EQ(search.limit(), 2.0);
}

TEST(LevelSearch, says_when_nothing_and_when_everything_holds) {
  LevelSearch weak({1, 2, 3}, 1);
  EXPECT_THAT(levels_tried(weak, 0.5), ElementsAre(2, 1));
  EXPECT_EQ(weak.limit(), std::nullopt);
  LevelSearch strong({1, 2, 3}, 1);
  EXPECT_THAT(levels_tried(strong, 9.0), ElementsAre(2, 3));
  EXPECT_EQ(strong.limit(), 3.0);
  EXPECT_TRUE(strong.open_ended());
}

TEST(LevelSearch, refuses_levels_that_do_not_ascend_and_a_floor_that_is_none) {
  EXPECT_THROW(LevelSearch({1, 1, 2}, 0), std::invalid_argument);
  EXPECT_THROW(LevelSearch({1, 2}, 2), std::invalid_argument);
}

TEST(LevelTally, nineteen_of_twenty_hold_and_eighteen_do_not) {
  for (const int failures : {0, 1, 2}) {
    LevelTally tally(20, true);
    for (int seed = 0; seed < 20; ++seed) {
      EXPECT_FALSE(tally.decided());
      tally.note(seed, seed >= failures);
    }
    EXPECT_TRUE(tally.decided());
    EXPECT_EQ(tally.holds(), failures <= 1) << failures;
    EXPECT_EQ(tally.passed(), 20 - failures);
  }
  EXPECT_EQ(allowed_failures(10), 0);
}

TEST(LevelTally, is_given_up_by_the_seeds_own_order_whatever_ends_first) {
  LevelTally tally(20, false);
  tally.note(7, false);
  tally.note(3, false);
  EXPECT_FALSE(tally.decided()) << "seeds 0 to 2 may have failed before";
  for (const int seed : {2, 1, 0, 4, 5}) {
    tally.note(seed, true);
  }
  EXPECT_FALSE(tally.decided());
  tally.note(6, true);
  EXPECT_TRUE(tally.decided());
  EXPECT_FALSE(tally.holds());
  tally.note(9, false);
  EXPECT_EQ(tally.judged(), 8);
  EXPECT_EQ(tally.passed(), 6);
}

TEST(GaitTable, has_its_floors_among_its_levels_in_both_lengths) {
  for (const bool quick : {false, true}) {
    std::set<std::string> names;
    for (const GaitRow& row : gait_table({.step_time_s = 0.4, .quick = quick})) {
      EXPECT_TRUE(names.insert(row.name).second) << row.name;
      EXPECT_NE(row.trials, nullptr) << row.name;
      EXPECT_FALSE(row.trials(1, row.floor).empty()) << row.name;
      if (row.has_levels()) {
        EXPECT_EQ(std::count(row.levels.begin(), row.levels.end(), row.floor), 1) << row.name;
        EXPECT_EQ(std::count(row.levels.begin(), row.levels.end(), row.aim), 1) << row.name;
        EXPECT_GE(row.aim, row.floor) << row.name;
      } else if (row.has_figure()) {
        EXPECT_LT(row.aim, row.floor) << row.name;
      } else {
        EXPECT_LE(row.floor, row.aim) << row.name;
        EXPECT_LE(row.aim, 1.0) << row.name << ": a share";
      }
    }
  }
}

TEST(GaitTable, a_speed_is_what_the_robot_does_and_not_what_it_is_told) {
  const std::vector<std::string> name{"straight"};
  const GaitRow row = chosen_rows(gait_table({}), name).front();
  const Trial trial = row.trials(1, row.floor).front();
  EXPECT_GT(trial.commands.front().velocity.x(), row.floor);
  TrialOutcome outcome;
  outcome.mean_velocity.x() = row.floor + 1e-6;
  EXPECT_TRUE(row.passes(outcome, trial, row.floor));
  outcome.mean_velocity = {row.floor - 1e-3, 0.2, 0.1};
  EXPECT_FALSE(row.passes(outcome, trial, row.floor)) << "aside is not ahead";
}

TEST(GaitTable, pushes_come_from_all_sides_in_all_phases_of_the_step_time) {
  const std::vector<std::string> name{"push_walking"};
  const GaitRow row = chosen_rows(gait_table({.step_time_s = 0.32, .quick = false}), name).front();
  std::set<long> directions_deg, instants_ms;
  for (const Trial& trial : row.trials(5, 1.2)) {
    directions_deg.insert(std::lround(trial.push->direction_rad * 180.0 / std::numbers::pi));
    instants_ms.insert(std::lround(trial.push->at_s * 1e3));
    EXPECT_NEAR(trial.seconds, trial.push->at_s + 4.1, 1e-9);
  }
  EXPECT_THAT(directions_deg, ElementsAre(0, 45, 90, 135, 180, 225, 270, 315));
  ASSERT_EQ(instants_ms.size(), 16U);
  EXPECT_EQ(*instants_ms.rbegin() - *instants_ms.begin(), 600) << "15 sixteenths of two steps";
}

TEST(GaitTable, random_commands_stay_within_the_floors_and_change_every_one_to_four_seconds) {
  const std::vector<std::string> name{"random"};
  const GaitRow row = chosen_rows(gait_table({}), name).front();
  const std::vector<TimedVelocity> commands = row.trials(3, 5.0).front().commands;
  EXPECT_NE(row.trials(4, 5.0).front().commands[0].velocity, commands[0].velocity);
  ASSERT_GT(commands.size(), 75U);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    EXPECT_GE(commands[i].velocity.x(), -0.2);
    EXPECT_LE(commands[i].velocity.x(), 0.35);
    EXPECT_LE(std::abs(commands[i].velocity.y()), 0.08);
    EXPECT_LE(std::abs(commands[i].velocity.z()), 0.8);
    if (i > 0) {
      EXPECT_GE(commands[i].at_s - commands[i - 1].at_s, 1.0 - 1e-9);
      EXPECT_LE(commands[i].at_s - commands[i - 1].at_s, 4.0 + 1e-9);
    }
  }
}

TEST(GaitTable, fells_a_robot_onto_either_side_at_any_instant_and_gives_it_time_to_rise) {
  for (const auto& [name, direction_rad] :
       {std::pair{"get_up_front", 0.0}, {"get_up_back", std::numbers::pi}}) {
    const std::vector<std::string> names{name};
    const GaitRow row = chosen_rows(gait_table({}), names).front();
    std::set<double> instants_s;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const std::vector<Trial> trials = row.trials(seed, row.floor);
      ASSERT_EQ(trials.size(), 1U);
      const Trial& trial = trials.front();
      EXPECT_NEAR(trial.push->direction_rad, direction_rad, 0.35) << "roughly ahead or back";
      EXPECT_EQ(trial.rise->motion, name);
      EXPECT_GT(trial.rise->at_s, trial.push->at_s + 2.0) << "it must lie still";
      EXPECT_NEAR(trial.seconds, trial.rise->at_s + 15.0, 1e-9);
      instants_s.insert(trial.push->at_s);
    }
    EXPECT_GT(instants_s.size(), 15U);
  }
}

TEST(GaitTable, a_robot_has_risen_that_lay_and_stands_in_time) {
  const std::vector<std::string> name{"get_up_back"};
  const GaitRow row = chosen_rows(gait_table({}), name).front();
  const Trial trial = row.trials(1, row.floor).front();
  TrialOutcome outcome;
  outcome.fell = true;
  EXPECT_FALSE(row.passes(outcome, trial, row.floor)) << "it lies to the end";
  outcome.stands_since_s = trial.rise->at_s + 11.9;
  EXPECT_TRUE(row.passes(outcome, trial, row.floor));
  outcome.stands_since_s = trial.rise->at_s + 12.1;
  EXPECT_FALSE(row.passes(outcome, trial, row.floor));
  outcome.stands_since_s = 0.0;
  outcome.fell = false;
  EXPECT_FALSE(row.passes(outcome, trial, row.floor)) << "nothing was there to rise from";
}

TEST(GaitTable, its_rows_of_shares_hold_with_eighteen_of_twenty_and_the_others_with_all) {
  RowResult share;
  share.seeds = 20;
  share.row.floor = 0.9;
  RowResult levels = share;
  levels.row.levels = {0.9};
  for (const int passed : {17, 18, 19, 20}) {
    share.floor_passed = levels.floor_passed = passed;
    EXPECT_EQ(share.floor_holds(), passed >= 18) << passed;
    EXPECT_EQ(levels.floor_holds(), passed == 20) << passed;
  }
}

TEST(GaitTable, names_the_row_that_was_meant) {
  const std::vector<std::string> wrong{"strait"};
  try {
    chosen_rows(gait_table({}), wrong);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("'strait'"));
    EXPECT_THAT(error.what(), HasSubstr("'straight'"));
  }
}

std::vector<std::string> names_of(const std::vector<GaitRow>& rows) {
  std::vector<std::string> names;
  for (const GaitRow& row : rows) names.push_back(row.name);
  return names;
}

TEST(GaitTable, leaves_out_the_rows_that_it_is_told_to) {
  const std::vector<std::string> rows{"zmp", "straight", "compute"}, except{"compute", "tiles"};
  EXPECT_THAT(names_of(chosen_rows(gait_table({}), rows, except)), ElementsAre("straight", "zmp"));
  EXPECT_EQ(chosen_rows(gait_table({}), {}, except).size(), gait_table({}).size() - 2);
  EXPECT_THROW(chosen_rows(gait_table({}), except, except), std::invalid_argument) << "nothing is left";
  const std::vector<std::string> wrong{"compue"};
  EXPECT_THROW(chosen_rows(gait_table({}), {}, wrong), std::invalid_argument);
}

TEST(GaitTable, reads_the_step_time_of_the_configuration) {
  const char* const text = "plugins: [{name: trajectory, parameters: {step_time: 0.28 s}}]";
  EXPECT_EQ(step_time_of(core::parse_configuration(text, "walk.yaml")), 0.28);
  EXPECT_EQ(step_time_of(core::parse_configuration("plugins: [{name: trajectory}]", "walk.yaml")),
            trajectory::GaitParameters{}.step_time_s);
}

}  // namespace
}  // namespace gaitway::tools
