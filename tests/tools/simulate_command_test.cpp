// `gaitway simulate` as a user meets it: what it says of motions, points, runs and bus logs, and what it
// refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command_run.hpp"

namespace gaitway::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class SimulateCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("gaitway_simulate_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  // Made by the first test that wants them: the points of a motion, and a walk's folder.
  static std::string points() {
    const std::string file = in_folder("wave.csv");
    if (!fs::exists(file)) expect_done("motion plan wave --out '" + file + "'");
    return file;
  }
  static std::string walk() {
    const std::string folder = in_folder("run");
    if (!fs::exists(folder)) expect_done("run --quiet --no-pictures --seconds 5 --out '" + folder + "'");
    return folder;
  }
  static void expect_done(const std::string& arguments) {
    const test::CommandRun run = test::run_command(std::string(GAITWAY_COMMAND) + " " + arguments);
    EXPECT_EQ(run.code, 0) << run.all();
  }
  static std::string in_folder(const std::string& name) { return (folder_ / name).string(); }
  int simulate(const std::string& arguments) {
    const test::CommandRun run = test::run_command(std::string(GAITWAY_COMMAND) + " simulate " + arguments);
    said_ = run.said;
    complaint_ = run.complaint;
    return run.code;
  }
  [[nodiscard]] json played(std::size_t index = 0) const { return json::parse(said_).at("played").at(index); }

  // The points of `wave` with one number of one row replaced.
  static std::string changed(std::size_t row, const std::string& column, const std::string& value) {
    std::vector<std::string> lines;
    std::ifstream in(points());
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    const auto fields = [](const std::string& line) {
      std::vector<std::string> parts{""};
      for (const char c : line) {
        if (c == ',')
          parts.emplace_back();
        else
          parts.back() += c;
      }
      return parts;
    };
    const auto names = fields(lines[0]);
    std::vector<std::string> parts = fields(lines[row + 1]);
    parts.at(static_cast<std::size_t>(std::ranges::find(names, column) - names.begin())) = value;
    lines[row + 1].clear();
    for (const std::string& part : parts) lines[row + 1] += (lines[row + 1].empty() ? "" : ",") + part;
    std::ofstream out(in_folder("changed.csv"));
    for (const std::string& line : lines) out << line << "\n";
    return in_folder("changed.csv");
  }

  static fs::path folder_;
  std::string said_, complaint_;
};
fs::path SimulateCommand::folder_;

TEST_F(SimulateCommand, AShippedMotionHasNoFindings) {
  ASSERT_EQ(simulate("trajectory kick --json"), 0) << complaint_ << said_;
  const json kick = played();
  EXPECT_EQ(kick.at("kind"), "motion file");
  EXPECT_TRUE(kick.at("findings").empty());
  EXPECT_EQ(kick.at("joints").size(), 22U);
  for (const json& joint : kick.at("joints")) EXPECT_LE(joint.at("largest_step_counts"), 127);
  EXPECT_GT(kick.at("zmp").at("all_masses").at("least_margin_m"), 0.012);
  EXPECT_TRUE(kick.at("zmp").at("solver").is_null());
  ASSERT_EQ(simulate("trajectory kick"), 0);
  EXPECT_THAT(said_, AllOf(HasSubstr("findings: none"), HasSubstr("x real time"), HasSubstr("left_knee")));
}

TEST_F(SimulateCommand, AnAngleBeyondItsStopIsToldWithJointInstantValueAndRule) {
  ASSERT_EQ(simulate("trajectory '" + changed(100, "neck_pitch_rad", "2.5") + "' --json"), 3) << complaint_;
  bool told = false;
  const json changed_wave = played();
  for (const json& finding : changed_wave.at("findings")) {
    if (finding.at("rule") != "position") continue;
    told = true;
    EXPECT_EQ(finding.at("what"), "neck_pitch");
    EXPECT_DOUBLE_EQ(finding.at("at_s"), 1.0);
    EXPECT_DOUBLE_EQ(finding.at("value"), 2.5);
  }
  EXPECT_TRUE(told);
  ASSERT_EQ(simulate("trajectory '" + changed(100, "neck_pitch_rad", "2.5") + "'"), 3);
  EXPECT_THAT(said_,
              HasSubstr("neck_pitch: position 2.5 rad at 1.000 s, must lie between the joint's stops"));
}

TEST_F(SimulateCommand, AWalkThatWasRunIsPlayedFromItsFolder) {
  ASSERT_EQ(simulate("trajectory '" + walk() + "' --json"), 0) << complaint_ << said_;
  const json run = played();
  EXPECT_EQ(run.at("rows"), 500);
  EXPECT_GT(run.at("stands").size(), 8U) << "it has walked";
  for (const char* const source : {"planned", "all_masses", "cells", "solver"})
    EXPECT_GT(run.at("zmp").at(source).at("rows"), 200) << source;
  EXPECT_EQ(simulate("zmp '" + walk() + "'"), 0) << said_;
  EXPECT_THAT(said_, AllOf(HasSubstr("contact solver"), Not(HasSubstr("not known"))));
}

TEST_F(SimulateCommand, ABusLogGivesTheReferencesOfTheRunToTheCount) {
  ASSERT_EQ(simulate("trajectory '" + walk() + "/bus.log" + "' --json"), 0) << complaint_ << said_;
  const json log = played();
  EXPECT_EQ(log.at("kind"), "bus log");
  EXPECT_NEAR(log.at("duration_s"), 4.98, 0.03);
  ASSERT_EQ(simulate("trajectory '" + walk() + "/bus.log" + "' --against '" + walk() + "' --json"), 0)
      << complaint_ << said_;
  const json compared = json::parse(said_);
  for (const json& joint : compared.at("differences"))
    EXPECT_LT(joint.at("rms_rad"), 0.03) << joint.at("name") << ": the joints follow what they were given";
}

TEST_F(SimulateCommand, APreparedMotionIsPlayed) {
  EXPECT_EQ(simulate("trajectory '" + std::string(GAITWAY_PREPARED_MOTIONS) + "/kick.motion' --json"), 0)
      << complaint_ << said_;
  EXPECT_EQ(played().at("kind"), "prepared motion");
}

TEST_F(SimulateCommand, APlannedWalkKeepsItsZmpOverTheSupport) {
  ASSERT_EQ(simulate("zmp --walk 0.15,0,0.1 --seconds 6 --json"), 0) << complaint_ << said_;
  const json zmp = played().at("zmp");
  EXPECT_EQ(zmp.at("planned").at("made_from_com"), false);
  EXPECT_GT(zmp.at("planned").at("least_margin_m"), 0.01);
  EXPECT_GT(zmp.at("all_masses").at("least_margin_m"), 0.005);
  EXPECT_GT(zmp.at("planned").at("least_at_s"), 0.5);
  EXPECT_TRUE(zmp.at("cells").is_null());
}

TEST_F(SimulateCommand, TheReportCarriesEverythingInItselfAndNothingFromElsewhere) {
  ASSERT_EQ(simulate("trajectory '" + walk() + "' --against kick --report '" + in_folder("r.html") + "'"), 0)
      << complaint_ << said_;
  const std::string page = test::text_of(in_folder("r.html"));
  EXPECT_THAT(page,
              AllOf(HasSubstr("default-src 'none'"), HasSubstr("id=\"data\""), Not(HasSubstr("http://")),
                    Not(HasSubstr("https://")), Not(HasSubstr(" src=")), Not(HasSubstr("style=\""))));
  const std::size_t begin = page.find("id=\"data\">") + 10;
  const json data = json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  ASSERT_EQ(data.at("played").size(), 2U);
  const json& course = data.at("played")[0].at("course");
  EXPECT_EQ(course.at("rows"), 500);
  EXPECT_EQ(course.at("angle").get<std::string>().size(), (500U * 22U * 4U + 2U) / 3U * 4U);
}

TEST_F(SimulateCommand, BadInputIsRefusedWithFileLineValueAndRule) {
  const auto refused = [this](const std::string& arguments, const std::vector<std::string>& parts) {
    EXPECT_EQ(simulate(arguments), 1) << arguments << said_;
    for (const std::string& part : parts) EXPECT_THAT(complaint_, HasSubstr(part)) << arguments;
  };
  refused("trajectory kcik", {"'kcik'", "no such motion", "Did you mean 'kick'?"});
  refused("trajectory /nowhere/x.csv", {"/nowhere/x.csv", "no such file"});
  refused("trajectory '" + changed(7, "left_knee_rad", "much") + "'",
          {"changed.csv:9", "left_knee_rad = much", "ust be a finite number"});
  refused("trajectory '" + changed(7, "contact", "heel") + "'", {"changed.csv:9", "contact = heel"});
  refused("trajectory '" + changed(7, "time_s", "0.08") + "'", {"changed.csv:9", "time_s = 0.08", "0.070"});
  std::ofstream(in_folder("note.txt")) << "hello\n";
  refused("trajectory '" + in_folder("note.txt") + "'", {"note.txt", "'.txt'", ".mcap"});
  std::ofstream(in_folder("short.csv")) << "time_s,contact\n0,both\n";
  refused("trajectory '" + in_folder("short.csv") + "'", {"short.csv:1", "left_hip_yaw_rad", "s missing"});
  std::ofstream(in_folder("cut.motion")) << "GM";
  refused("trajectory '" + in_folder("cut.motion") + "'", {"cut.motion", "cut off"});
  std::ofstream(in_folder("bad.log")) << "(0.000100) can0 123#00\n(0.00) can0 zz\n";
  refused("trajectory '" + in_folder("bad.log") + "'", {"bad.log"});
  refused("zmp", {"either a FILE or --walk"});
  refused("zmp kick --walk 0.1", {"either a FILE or --walk"});
  refused("zmp --walk 0.1,0,0,0", {"--walk: wants VX[,VY[,WZ]]"});
  refused("zmp --walk fast", {"--walk"});
  refused("trajectory kick --report /nowhere/r.html", {"/nowhere/r.html"});
  refused("trajectory kick --robot /nowhere", {"/nowhere"});
}

TEST_F(SimulateCommand, HelpHasExamplesAndExitCodes) {
  for (const char* const command : {"", "trajectory ", "zmp "}) {
    ASSERT_EQ(simulate(std::string(command) + "--help"), 0);
    EXPECT_THAT(said_, AllOf(HasSubstr("Examples:"), HasSubstr("Exit code:"), HasSubstr("gaitway simulate")));
  }
}

}  // namespace
}  // namespace gaitway::tools
