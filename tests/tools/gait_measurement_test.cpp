// The gait measurement: its trials, what it keeps, and the command as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/measure/gait_measurement.hpp"
#include "tools/measure/rise_motions.hpp"
#include "tools/measure/trial_run.hpp"
#include "tools/measure/trial_store.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

const TrialRobot& robot() {
  static const TrialRobot it{
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22"),
      core::read_configuration(std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml"),
      {GAITWAY_PLUGIN_DIR}};
  return it;
}

Trial standing(std::uint64_t seed, double seconds) {
  Trial trial;
  trial.seed = seed;
  trial.seconds = seconds;
  return trial;
}

Trial pushed_ahead(double impulse_Ns) {
  Trial trial = standing(1, 2.5);
  trial.push = TrialPush{0.5, 0.0, impulse_Ns};
  return trial;
}

TEST(GaitTrial, a_slight_push_leaves_the_feet_in_place_and_a_violent_one_fells) {
  const TrialOutcome slight = run_trial(robot(), pushed_ahead(0.3));
  EXPECT_FALSE(slight.fell);
  EXPECT_LT(slight.foot_moved_m, 0.005);
  EXPECT_LT(slight.foot_lifted_m, 0.002);
  const TrialOutcome violent = run_trial(robot(), pushed_ahead(12.0));
  EXPECT_TRUE(violent.fell);
  EXPECT_GT(violent.ended_s, 0.5);
  EXPECT_LT(violent.ended_s, 2.5);
  EXPECT_GT(violent.foot_lifted_m, 0.005);
}

// Pushes at two instants of a walk, from several sides; one of them fells the robot.
std::vector<Trial> pushed_walks() {
  std::vector<Trial> trials;
  for (const double at_s : {1.831, 2.0}) {
    for (const double direction_rad : {0.0, 2.0, 4.0}) {
      Trial trial = standing(3, at_s + 1.0);
      trial.commands.push_back({0.5, {0.2, 0.0, 0.0}});
      trial.steady_from_s = 1.0;
      trial.push = TrialPush{at_s, direction_rad, direction_rad == 4.0 ? 9.0 : 1.0};
      trials.push_back(trial);
    }
  }
  return trials;
}

TEST(TrialSeries, shares_the_walk_before_the_pushes_without_any_difference) {
  std::vector<Trial> trials = pushed_walks();
  std::rotate(trials.begin(), trials.begin() + 2, trials.end());  // back to the earlier instant at the end
  trials.push_back(standing(3, 0.3));
  std::size_t next = 0;
  std::set<bool> falls;
  run_trials(robot(), trials, [&](std::size_t trial, const TrialOutcome& outcome) {
    EXPECT_EQ(trial, next++);
    EXPECT_EQ(to_json(outcome), to_json(run_trial(robot(), trials[trial]))) << "trial " << trial;
    falls.insert(outcome.fell);
    return true;
  });
  EXPECT_EQ(next, trials.size());
  EXPECT_EQ(falls.size(), 2U) << "some fall, some do not";
}

TEST(TrialSeries, ends_when_it_is_told_to) {
  std::size_t played = 0;
  run_trials(robot(), pushed_walks(), [&](std::size_t, const TrialOutcome&) { return ++played < 2; });
  EXPECT_EQ(played, 2U);
}

TEST(GaitTrial, a_fall_is_told_well_before_the_impact_and_soft_joints_take_the_edge_off_it) {
  Trial trial = pushed_ahead(7.0);
  trial.push->direction_rad = 0.5 * std::numbers::pi;  // ahead, a bow decides how hard it falls
  trial.watches_fall = true;
  std::array<std::vector<double>, 2> hardest_force_N;  // of soft and of stiff joints, one for each seed
  for (trial.seed = 1; trial.seed <= 9; ++trial.seed) {
    std::array<double, 2> told_s{};
    for (const std::size_t stiff : {0U, 1U}) {
      trial.stiff_in_fall = stiff != 0;
      const TrialOutcome outcome = run_trial(robot(), trial);
      ASSERT_TRUE(outcome.fell);
      ASSERT_TRUE(outcome.fall && outcome.fall->told_s && outcome.fall->impact_s);
      EXPECT_GE(outcome.fall->lead_s().value(), 0.2);
      EXPECT_GT(*outcome.fall->told_s, 0.5) << "after the push began";
      told_s[stiff] = *outcome.fall->told_s;
      hardest_force_N[stiff].push_back(outcome.fall->hardest_force_N);
    }
    EXPECT_EQ(told_s[0], told_s[1]);
  }
  // How a body folds is chance: one fall in some is harder with soft joints.
  for (auto& forces : hardest_force_N) std::sort(forces.begin(), forces.end());
  EXPECT_LT(hardest_force_N[0][4], hardest_force_N[1][4]) << "median";
}

TEST(GaitTrial, a_push_that_the_robot_stands_is_no_fall) {
  Trial trial = pushed_ahead(1.5);
  trial.watches_fall = true;
  const TrialOutcome outcome = run_trial(robot(), trial);
  ASSERT_FALSE(outcome.fell);
  EXPECT_FALSE(outcome.fall->told_s);
  EXPECT_FALSE(outcome.fall->impact_s);
  EXPECT_FALSE(outcome.fall->lead_s());
}

TEST(GaitTrial, a_robot_that_fell_rises_by_the_motion_that_it_is_told_to_play) {
  Trial trial = pushed_ahead(7.0);
  trial.rise = TrialRise{3.5, "get_up_front"};
  trial.seconds = 15.0;
  const TrialOutcome risen = run_trial(robot(), trial);
  EXPECT_TRUE(risen.fell);
  ASSERT_TRUE(risen.stands_since_s);
  EXPECT_GT(*risen.stands_since_s, 6.0);
  EXPECT_LT(*risen.stands_since_s, 14.0);
  trial.rise->motion = "stay_there";
  const TrialOutcome lying = run_trial(robot(), trial);
  EXPECT_TRUE(lying.fell);
  EXPECT_FALSE(lying.stands_since_s);
}

TEST(GaitTrial, speed_heading_and_zmp_of_a_walk) {
  Trial trial = standing(2, 9.0);
  trial.commands.push_back({1.0, {0.15, 0.0, 0.0}});
  trial.steady_from_s = 4.0;
  const TrialOutcome outcome = run_trial(robot(), trial);
  ASSERT_FALSE(outcome.fell);
  EXPECT_NEAR(outcome.mean_velocity.x(), 0.15, 0.03);
  EXPECT_NEAR(outcome.mean_velocity.y(), 0.0, 0.03);
  EXPECT_LT(std::abs(outcome.heading_drift_rad), 0.3);
  EXPECT_NE(outcome.heading_drift_rad, 0.0);
  EXPECT_EQ(outcome.heading_deg.size(), 8U) << "once a second from the first step on";
  ASSERT_TRUE(outcome.zmp_error_rms_m.has_value());
  EXPECT_GT(*outcome.zmp_error_rms_m, 1e-5);
  EXPECT_LT(*outcome.zmp_error_rms_m, 0.01);
}

TEST(GaitTrial, comes_back_from_its_json_as_it_was) {
  TrialOutcome outcome;
  outcome.fell = true;
  outcome.ended_s = 0.1 + 0.2;
  outcome.mean_velocity = {0.1, -0.2, 1.0 / 3.0};
  outcome.heading_deg = {0.5F, -1.25F};
  outcome.zmp_error_rms_m = 1e-3;
  outcome.foot_moved_m = 0.02;
  outcome.stands_since_s = 0.7;
  outcome.fall =
      FallOutcome{.told_s = 0.1, .impact_s = 0.3, .hardest_force_N = 500.0, .trunk_speed_m_per_s = 1.0 / 3.0};
  const auto json = nlohmann::ordered_json::parse(to_json(outcome).dump());
  EXPECT_EQ(to_json(outcome_from_json(json)), to_json(outcome));
  EXPECT_EQ(outcome_from_json(json).ended_s, outcome.ended_s);
}

class GaitMeasurementTest : public ::testing::Test {
 protected:
  GaitMeasurementTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("gaitway_gait_measurement_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~GaitMeasurementTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ifstream in(file(name));
    return {std::istreambuf_iterator<char>(in), {}};
  }

  // Pushes that grow, two to a seed; the levels are impulses.
  static GaitRow push_row() {
    GaitRow row;
    row.name = "pushes";
    row.measure = "pushes";
    row.unit = "N·s";
    row.floor = 0.3;
    row.aim = 12.0;
    row.levels = {0.3, 12.0, 15.0};
    row.trials = [](std::uint64_t seed, double level) {
      std::vector<Trial> trials(2, standing(seed, 1.6));
      trials[0].push = TrialPush{0.2, 0.0, level};
      trials[1].push = TrialPush{0.2, 1.0, level};
      return trials;
    };
    row.passes = [](const TrialOutcome& outcome, const Trial&, double) { return !outcome.fell; };
    row.picture = GaitRow::Picture::pushes;
    return row;
  }
  GaitMeasurement measure(const std::string& name, int jobs, std::uint64_t fingerprint = 1) {
    TrialStore store(file(name), fingerprint);
    return measure_gait(robot(), {push_row()}, store,
                        {.seeds = 3, .first_seed = 4, .jobs = jobs, .progress = {}});
  }
  static std::string report(const GaitMeasurement& measurement) {
    return gait_json({}, measurement).dump() + gait_page({}, measurement);
  }

  std::filesystem::path folder_;
};

TEST_F(GaitMeasurementTest, searches_the_limit_and_ends_a_seed_with_its_first_failure) {
  const GaitMeasurement measurement = measure("trials.jsonl", 1);
  const RowResult& row = measurement.rows.front();
  EXPECT_TRUE(row.floor_holds());
  EXPECT_EQ(row.limit, 0.3);
  ASSERT_EQ(row.levels.size(), 2U);
  EXPECT_EQ(row.levels[0].seeds.size(), 3U);
  // The first seed decides that 12 N·s are too much, and its first push that the second need not be tried.
  ASSERT_EQ(row.levels[1].seeds.size(), 1U);
  EXPECT_EQ(row.levels[1].seeds[0].trials.size(), 1U);
  EXPECT_EQ(measurement.trials_run, 3 * 2 + 1);
}

TEST_F(GaitMeasurementTest, tells_the_share_of_the_seeds_that_pass) {
  GaitRow row;
  row.name = row.measure = "stands";
  row.unit = "% of the seeds";
  row.shown_scale = 100.0;
  row.floor = 0.5;
  row.aim = 1.0;
  row.trials = [](std::uint64_t seed, double) { return std::vector<Trial>{standing(seed, 0.05)}; };
  row.passes = [](const TrialOutcome&, const Trial& trial, double) { return trial.seed != 5; };
  TrialStore store(file("trials.jsonl"), 1);
  const GaitMeasurement measurement =
      measure_gait(robot(), {row}, store, {.seeds = 4, .first_seed = 4, .jobs = 2, .progress = {}});
  EXPECT_TRUE(measurement.rows.front().floor_holds());
  EXPECT_EQ(measurement.rows.front().limit, 0.75);
  EXPECT_THAT(gait_markdown({}, measurement),
              HasSubstr("| stands | 50 % of the seeds | 3 of 4 | 100 % of the seeds | 75 % of the seeds |"));
  EXPECT_THAT(gait_page({}, measurement), HasSubstr("Seeds that fail: 5<"));
  EXPECT_EQ(gait_json({}, measurement)["rows"][0]["levels"][0]["seeds"][1]["failed"]["seed"], 5);
}

TEST_F(GaitMeasurementTest, gives_the_same_with_many_jobs_as_with_one) {
  EXPECT_EQ(report(measure("one.jsonl", 1)), report(measure("many.jsonl", 4)));
}

TEST_F(GaitMeasurementTest, runs_nothing_again_and_goes_on_where_it_was_interrupted) {
  const GaitMeasurement first = measure("trials.jsonl", 4);
  const GaitMeasurement second = measure("trials.jsonl", 4);
  EXPECT_EQ(second.trials_run, 0U);
  EXPECT_EQ(report(second), report(first));

  // Three lines and a piece of the fourth are left.
  std::string text = text_of("trials.jsonl");
  std::size_t end = 0;
  for (int line = 0; line < 3; ++line) {
    end = text.find('\n', end) + 1;
  }
  std::ofstream(file("trials.jsonl")) << text.substr(0, end + 20);
  const GaitMeasurement resumed = measure("trials.jsonl", 1);
  EXPECT_LE(resumed.trials_run, first.trials_run - 3);
  EXPECT_GT(resumed.trials_run, 0U);
  EXPECT_EQ(report(resumed), report(first));
  EXPECT_EQ(measure("trials.jsonl", 1).trials_run, 0U) << "the piece must not spoil the line after it";
}

TEST_F(GaitMeasurementTest, forgets_what_another_robot_did) {
  measure("trials.jsonl", 2, 1);
  EXPECT_GT(measure("trials.jsonl", 2, 2).trials_run, 0U);
}

TEST_F(GaitMeasurementTest, fingerprint_follows_configuration_and_description) {
  EXPECT_EQ(fingerprint_of(robot()), fingerprint_of(robot()));
  TrialRobot other = robot();
  std::filesystem::copy_file(other.plugins.file, file("walk.yaml"));
  other.plugins.file = file("walk.yaml");
  EXPECT_EQ(fingerprint_of(robot()), fingerprint_of(other)) << "the place is no part of it";
  std::ofstream(file("walk.yaml"), std::ios::app) << "    parameters: {}\n";
  EXPECT_NE(fingerprint_of(robot()), fingerprint_of(other));
}

TEST_F(GaitMeasurementTest, fingerprint_follows_what_the_robot_can_play) {
  std::filesystem::copy(robot().model.directory, file("robot"), std::filesystem::copy_options::recursive);
  TrialRobot other = robot();
  other.model.directory = file("robot");
  const std::uint64_t before = fingerprint_of(other);
  std::ofstream(file("robot") / "motions" / "wave.motion") << "prepared";
  EXPECT_NE(fingerprint_of(other), before);
}

TEST_F(GaitMeasurementTest, keeps_the_plugins_that_it_began_with) {
  TrialRobot pinned = robot();
  std::filesystem::create_directories(file("build"));
  const std::filesystem::path built = file("build") / "libgaitway_plugin_zmp.so";
  std::filesystem::copy_file(std::filesystem::path(GAITWAY_PLUGIN_DIR) / built.filename(), built);
  pinned.plugin_path = {file("build"), GAITWAY_PLUGIN_DIR};
  pin_plugins(pinned.plugins, pinned.plugin_path, file("plugins"));
  EXPECT_EQ(fingerprint_of(pinned), fingerprint_of(robot())) << "the same content";
  std::ofstream(built) << "half a library";
  std::ofstream(file("plugins") / "libold_0123.so") << "of an earlier measurement";
  remove_other_plugins(pinned.plugins, file("plugins"));
  EXPECT_FALSE(std::filesystem::exists(file("plugins") / "libold_0123.so"));
  const Trial trial = standing(1, 0.1);
  EXPECT_EQ(to_json(run_trial(pinned, trial)), to_json(run_trial(robot(), trial)));
}

TEST_F(GaitMeasurementTest, leaves_no_empty_folder_where_nothing_is_pinned) {
  TrialRobot lost = robot();
  lost.plugins.plugins.back().library = "libgaitway_plugin_nowhere.so";
  EXPECT_THROW(pin_plugins(lost.plugins, lost.plugin_path, file("plugins")), core::PluginError);
  lost.plugins.plugins.clear();
  pin_plugins(lost.plugins, lost.plugin_path, file("plugins"));
  remove_other_plugins(lost.plugins, file("plugins"));
  EXPECT_FALSE(std::filesystem::exists(file("plugins")));
}

TEST_F(GaitMeasurementTest, refuses_a_line_that_is_no_outcome_and_a_file_that_is_in_use) {
  std::ofstream(file("trials.jsonl")) << "{\"key\":\"1\"}\n";
  try {
    const TrialStore store(file("trials.jsonl"), 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("trials.jsonl:1: no outcome"));
  }
  const TrialStore first(file("used.jsonl"), 1);
  EXPECT_THROW(TrialStore(file("used.jsonl"), 1), std::invalid_argument);
}

TEST_F(GaitMeasurementTest, hands_a_failure_of_a_trial_on) {
  TrialRobot broken = robot();
  broken.plugins.plugins.front().library = "libnot_there.so";
  TrialStore store(file("trials.jsonl"), 1);
  EXPECT_THROW(
      measure_gait(broken, {push_row()}, store, {.seeds = 3, .first_seed = 1, .jobs = 3, .progress = {}}),
      std::runtime_error);
}

class MeasureCommand : public GaitMeasurementTest {
 protected:
  // Returns the exit code; what was printed is in `said` and `complaint`.
  int gaitway(const std::string& arguments) {
    const std::string line = std::string(GAITWAY_COMMAND) + " measure gait --out '" + file("out").string() +
                             "' " + arguments + " >'" + file("said").string() + "' 2>'" +
                             file("complaint").string() + "'";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  void expect_refused(const std::string& arguments, const std::string& part) {
    EXPECT_EQ(gaitway(arguments), 1) << arguments;
    EXPECT_THAT(text_of("complaint"), HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(file("out")));
  }
};

TEST_F(MeasureCommand, refuses_bad_input_before_anything_moves) {
  expect_refused("--seeds 0", "--seeds 0: must lie between 1 and");
  expect_refused("--jobs -1", "--jobs -1: must lie between 1 and");
  expect_refused("--rows straight,push_sideways", "no row 'push_sideways'");
  expect_refused("--config nowhere.yaml", "nowhere.yaml");
  expect_refused("--robot nowhere", "nowhere");
  expect_refused("--on local --jobs 2", "--jobs excludes --on");
  expect_refused("--store here", "--store: is for trials that run by --on");
  expect_refused("--on local --patience nan", "--patience nan");
}

TEST_F(MeasureCommand,
       refuses_rows_whose_robots_cannot_play_what_they_get_up_by_and_leaves_out_those_that_nobody_named) {
  std::filesystem::copy(robot().model.directory, file("robot"), std::filesystem::copy_options::recursive);
  const std::string folder = file("robot").string();
  expect_refused("--rows get_up_back --robot '" + folder + "'",
                 "get_up_back: what the robot would get up by is not prepared");
  EXPECT_THAT(text_of("complaint"), HasSubstr("gaitway motion prepare get_up_back --robot " + folder));

  std::vector<GaitRow> rows = gait_table({.step_time_s = 0.4, .quick = true});
  const std::size_t all = rows.size();
  TrialRobot other = robot();
  EXPECT_EQ(without_rise_motions(rows, other), "") << "prepared with the build";
  other.model.directory = folder;
  EXPECT_THAT(without_rise_motions(rows, other), HasSubstr("get_up_front, get_up_back: "));
  EXPECT_EQ(rows.size(), all - 2);
}

TEST_F(MeasureCommand, measures_a_row_writes_its_table_and_is_instant_the_second_time) {
  const std::string arguments = "--quick --seeds 1 --rows push_front --jobs 2";
  const int code = gaitway(arguments);
  const auto json = nlohmann::json::parse(text_of("out/gait.json"));
  EXPECT_EQ(code, json.at("floors_hold").get<bool>() ? 0 : 3) << text_of("complaint");
  ASSERT_EQ(json.at("rows").size(), 1U);
  EXPECT_EQ(json.at("rows")[0].at("name"), "push_front");
  EXPECT_FALSE(json.at("rows")[0].at("levels").empty());
  EXPECT_THAT(text_of("out/gait.md"), HasSubstr("| standing push to the front, feet in place | 2.2 N·s |"));
  EXPECT_THAT(text_of("out/gait.html"), HasSubstr("<svg"));
  EXPECT_THAT(text_of("said"), testing::Not(HasSubstr("\n0 trials run")));

  const std::string page = text_of("out/gait.html");
  EXPECT_EQ(gaitway(arguments), code);
  EXPECT_THAT(text_of("said"), HasSubstr("\n0 trials run"));
  EXPECT_EQ(text_of("out/gait.html"), page);
}

}  // namespace
}  // namespace gaitway::tools
