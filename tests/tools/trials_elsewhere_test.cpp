// Trials that another program has played: what it is asked for, what becomes of its answers, and how it ends.
// The program is a script that writes down what it is asked, and says what the test has it say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tools/measure/gait_measurement.hpp"
#include "tools/measure/trial_store.hpp"
#include "tools/measure/trials_elsewhere.hpp"

namespace gaitway::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

Trial walk_of(double seconds, std::uint64_t seed = 7) {
  Trial trial;
  trial.seed = seed;
  trial.seconds = seconds;
  return trial;
}

TrialOutcome outcome_that(bool falls) {
  TrialOutcome outcome;
  outcome.fell = falls;
  outcome.ended_s = 0.1 + 0.2;
  return outcome;
}

TEST(TrialSeriesRanges, are_pushes_that_share_their_walk_and_each_other_trial_alone) {
  std::vector<Trial> trials{walk_of(1.0), walk_of(2.0)};
  for (int i = 0; i < 20; ++i) {
    trials.push_back(walk_of(6.0));
    trials.back().push = TrialPush{2.0, 0.1 * i, 1.0};
  }
  trials.push_back(trials[2]);
  trials.back().push->at_s = 1.5;  // earlier than the one before
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  for (const TrialSeries& series : series_of(trials)) {
    ranges.emplace_back(series.first, series.count);
  }
  using Range = std::pair<std::size_t, std::size_t>;
  EXPECT_THAT(ranges, ElementsAre(Range{0, 1}, Range{1, 1}, Range{2, 16}, Range{18, 4}, Range{22, 1}));
}

class TrialsElsewhereTest : public testing::Test {
 protected:
  TrialsElsewhereTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("gaitway_trials_elsewhere_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    row_.name = row_.measure = "walks";
    row_.floor = row_.aim = 0.5;
    row_.trials = [](std::uint64_t seed, double) {
      return std::vector{walk_of(1.0, seed), walk_of(2.0, seed), walk_of(3.0, seed)};
    };
    row_.passes = [](const TrialOutcome& outcome, const Trial&, double) { return !outcome.fell; };
  }
  ~TrialsElsewhereTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

  // For each line that is asked for it says what is in the file of that number, or nothing; it ends when told
  // to.
  [[nodiscard]] std::vector<std::string> program() const {
    return {"/bin/sh", "-c",
            "n=0; while read -r line; do printf '%s\\n' \"$line\" >>'" + file("asked") +
                "'; n=$((n + 1)); if [ -f '" + folder_.string() + "'/$n ]; then cat '" + folder_.string() +
                "'/$n; fi; case $line in *closed*) exit 0;; esac; done"};
  }
  // After line `number`, the first being 1.
  void say(int number, const std::string& line) const {
    std::ofstream(file(std::to_string(number)), std::ios::app) << line << '\n';
  }
  static std::string result(int id, bool falls, bool ran = true) {
    return Json{{"id", id}, {"ran", ran}, {"outcomes", {Json(to_json(outcome_that(falls)))}}}.dump();
  }
  std::vector<Json> asked() const {
    std::vector<Json> all;
    std::ifstream in(file("asked"));
    for (std::string line; std::getline(in, line);) all.push_back(Json::parse(line));
    return all;
  }
  GaitMeasurement measure(int seeds, const std::vector<std::string>& command) {
    TrialStore store(file("trials.jsonl"), 1);
    TrialsElsewhere place(command, {"/robot", "/config.yaml", true, 0xABCULL},
                          [this](const std::string& news) { news_.push_back(news); });
    TrialRobot nobody;
    return measure_gait(nobody, {row_}, store,
                        {.seeds = seeds, .first_seed = 7, .jobs = 1, .progress = {}, .elsewhere = &place});
  }

  std::filesystem::path folder_;
  GaitRow row_;
  std::vector<std::string> news_;
};

constexpr int kSubject = 1, kHeard = 1;  // lines before and behind those that are wanted

TEST_F(TrialsElsewhereTest, asks_for_all_at_once_and_takes_results_in_any_order) {
  for (const int id : {5, 3, 1, 6, 2, 4}) say(kSubject + 6 + kHeard, result(id, false, id != 3));
  say(2, R"({"news":"somebody is there"})");
  const GaitMeasurement measurement = measure(2, program());
  EXPECT_EQ(measurement.rows.front().floor_passed, 2);
  EXPECT_EQ(measurement.trials_run, 5U);
  EXPECT_EQ(measurement.trials_known, 1U);
  EXPECT_THAT(news_, ElementsAre("somebody is there"));
  const std::vector<Json> lines = asked();
  EXPECT_EQ(lines[0], (Json{{"robot", "/robot"},
                            {"config", "/config.yaml"},
                            {"quick", true},
                            {"fingerprint", "0000000000000abc"}}));
  EXPECT_EQ(lines[5], (Json{{"id", 5},
                            {"rank", 1},
                            {"row", "walks"},
                            {"level", 0.5},
                            {"seed", 8},
                            {"first", 1},
                            {"count", 1},
                            {"seconds", 2.0}}));
  EXPECT_EQ(lines[7], (Json{{"heard", 0}}));
  EXPECT_EQ(lines.back(), (Json{{"closed", true}}));
  EXPECT_EQ(measurement.rows.front().levels[0].seeds[1].outcomes[2].ended_s, 0.1 + 0.2);

  std::filesystem::remove(file("asked"));
  EXPECT_EQ(measure(2, program()).trials_run, 0U);
  EXPECT_EQ(asked().size(), 2U) << "all of it is known: nothing is asked for";
}

TEST_F(TrialsElsewhereTest, what_is_behind_a_failure_is_wanted_no_longer) {
  say(kSubject + 3 + kHeard, result(2, true));  // the first is still out: it may have failed, too
  say(kSubject + 3 + kHeard + 2, result(1, false));
  const GaitMeasurement measurement = measure(1, program());
  EXPECT_EQ(measurement.rows.front().floor_passed, 0);
  EXPECT_EQ(measurement.rows.front().levels[0].seeds[0].trials.size(), 2U);
  const std::vector<Json> lines = asked();
  EXPECT_EQ(lines[5], (Json{{"withdrawn", {3}}}));
  EXPECT_EQ(lines[6], (Json{{"heard", 1}}));
}

TEST_F(TrialsElsewhereTest, a_seed_may_be_done_when_another_makes_it_vain) {
  row_.levels = {0.5, 1.0};
  row_.trials = [](std::uint64_t seed, double level) { return std::vector{walk_of(level, seed)}; };
  for (const int id : {1, 2}) say(kSubject + 2 + kHeard, result(id, false));
  for (const int id : {3, 4}) say(kSubject + 2 + kHeard + 2 + kHeard, result(id, id == 3));
  const GaitMeasurement measurement = measure(2, program());
  EXPECT_EQ(measurement.rows.front().limit, 0.5);
  EXPECT_EQ(measurement.rows.front().levels[1].seeds.size(), 1U);
}

TEST_F(TrialsElsewhereTest, what_is_known_is_not_asked_for) {
  {
    TrialStore store(file("trials.jsonl"), 1);
    store.keep(walk_of(2.0), outcome_that(false));
  }
  say(kSubject + 2 + kHeard, result(1, false));
  say(kSubject + 2 + kHeard, result(2, false));
  const GaitMeasurement measurement = measure(1, program());
  EXPECT_EQ(measurement.trials_run, 2U);
  EXPECT_EQ(measurement.trials_known, 1U);
  EXPECT_EQ(asked()[2].at("first"), 2);
}

TEST_F(TrialsElsewhereTest, says_why_the_other_program_gave_up_and_ends_as_it_asks) {
  say(2, R"({"error":"no workers: nobody answers","exit_code":6})");
  try {
    measure(1, program());
    FAIL();
  } catch (const ElsewhereError& error) {
    EXPECT_STREQ(error.what(), "no workers: nobody answers");
    EXPECT_EQ(error.exit_code(), 6);
  }
}

TEST_F(TrialsElsewhereTest, believes_no_answer_that_cannot_be) {
  for (const char* const answer :
       {R"({"id":1,"ran":true,"outcomes":[]})", R"({"id":1,"ran":true,"outcomes":[null]})",
        R"({"id":1,"ran":true})", "words"}) {
    std::filesystem::remove(file("2"));
    say(2, answer);
    try {
      measure(1, program());
      ADD_FAILURE() << answer;
    } catch (const ElsewhereError& error) {
      EXPECT_EQ(error.exit_code(), 6) << answer;
    }
  }
}

TEST_F(TrialsElsewhereTest, notices_the_other_programs_end) {
  const auto complaint_of = [this](const std::string& script) {
    try {
      measure(1, {"/bin/sh", "-c", script});
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(complaint_of("read line; exit 3"), HasSubstr("/bin/sh ended with code 3"));
  EXPECT_THAT(complaint_of("kill -9 $$"), HasSubstr("/bin/sh was ended: Killed"));
  EXPECT_THAT(complaint_of("exit 0"), HasSubstr("/bin/sh has ended before all trials were played"));
  EXPECT_THAT(complaint_of("read line; echo nonsense; read line"), HasSubstr("/bin/sh says 'nonsense'"));
  EXPECT_THROW(measure(1, {"/no/such/program"}), std::system_error);
}

}  // namespace
}  // namespace gaitway::tools
