// `gaitway motion adapt` as a user meets it: a motion of one robot that another one plays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "command_run.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::tools {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

using test::text_of;

class MotionAdapt : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return robot_.folder() / name; }
  int run(const std::string& arguments) {
    const test::CommandRun run = test::run_command(std::string(GAITWAY_COMMAND) + " " + arguments +
                                                   " --robot '" + robot_.folder().string() + "'");
    said_ = run.said;
    complaint_ = run.complaint;
    return run.code;
  }

  test::RobotVariant robot_;
  std::string said_, complaint_;
};

TEST_F(MotionAdapt, GivesTheRobotAMotionThatItPlays) {
  robot_.scale(0.7);
  robot_.rename();
  std::ofstream(file("show.yaml")) << "seconds: 4\nevents:\n  - {at_s: 1.0, motion: wave}\n";
  const std::string show = "run --quiet --no-pictures --scenario '" + file("show.yaml").string() +
                           "' --out '" + file("out").string() + "'";
  EXPECT_EQ(run(show), 1) << "it has none";
  EXPECT_THAT(complaint_, HasSubstr("there is no motion 'wave'"));
  ASSERT_EQ(run("motion adapt wave"), 0) << complaint_;
  EXPECT_THAT(said_, AllOf(HasSubstr("lengths times 0.7"), HasSubstr("planned within all limits")));
  EXPECT_THAT(text_of(file("motions/wave.yaml")),
              AllOf(HasSubstr("# Adapted from humanoid22's wave"), HasSubstr("hctip_redluohs_tfel: "),
                    HasSubstr("name: raise")));
  EXPECT_EQ(run(show), 0) << complaint_;
  EXPECT_EQ(run("motion list"), 0);
  EXPECT_THAT(said_, HasSubstr("Waves with the left hand"));
}

TEST_F(MotionAdapt, SaysByNameWhatDoesNotGoAndWritesNothing) {
  robot_.remove_arms();
  EXPECT_EQ(run("motion adapt wave"), 1);
  EXPECT_THAT(complaint_, AllOf(HasSubstr("'left_shoulder_pitch'"), HasSubstr("has no left shoulder pitch")));
  EXPECT_FALSE(std::filesystem::exists(file("motions")));
  EXPECT_EQ(run("motion adapt jump"), 1);
  EXPECT_THAT(complaint_, HasSubstr("there is no such motion"));
}

TEST_F(MotionAdapt, ReplacesNothingUnlessItIsForced) {
  ASSERT_EQ(run("motion adapt bow"), 0) << complaint_;
  const std::string adapted = text_of(file("motions/bow.yaml")), table = text_of(file("motions/bow.motion"));
  std::ofstream(file("motions/bow.yaml")) << adapted << "# a word of mine\n";
  EXPECT_EQ(run("motion adapt bow"), 1);
  EXPECT_THAT(complaint_,
              AllOf(HasSubstr("motions/bow.yaml: is there already"), HasSubstr("--force to replace it")));
  EXPECT_EQ(text_of(file("motions/bow.yaml")), adapted + "# a word of mine\n");
  EXPECT_EQ(text_of(file("motions/bow.motion")), table);
  std::filesystem::remove(file("motions/bow.yaml"));
  EXPECT_EQ(run("motion adapt bow"), 1) << "what the robot plays is not replaced, either";
  EXPECT_THAT(complaint_, HasSubstr("motions/bow.motion: is there already"));
  EXPECT_EQ(run("motion adapt bow --force"), 0) << complaint_;
  EXPECT_EQ(text_of(file("motions/bow.yaml")), adapted);
}

TEST_F(MotionAdapt, LeavesTorqueToTheBalance) {
  robot_.scale(1.4);
  ASSERT_EQ(run("motion adapt squat"), 0) << complaint_;
  EXPECT_THAT(text_of(file("motions/squat.yaml")), HasSubstr("torque_share: 0.57"));
  EXPECT_EQ(run("motion check squat"), 0) << "planned in the same way: " << complaint_;
}

TEST_F(MotionAdapt, SaysThatNothingIsChanged) {
  ASSERT_EQ(run("motion adapt bow"), 0) << complaint_;
  EXPECT_THAT(said_, AllOf(HasSubstr("Changed: nothing\n"), Not(HasSubstr("nothing else"))));
}

TEST_F(MotionAdapt, NamesTheMotionAndItsRobotAndNoFileThatIsNotThere) {
  robot_.limit_torque(0.4);
  EXPECT_EQ(run("motion adapt squat"), 1);
  EXPECT_THAT(complaint_, AllOf(HasSubstr("'squat' on the robot '"), Not(HasSubstr(".yaml"))));
}

TEST(MotionHelp, GivesExamplesAndExitCodesAndNoDefaultOfWhatIsRequired) {
  for (const std::string part : {"list", "show", "plan", "check", "draw", "prepare", "adapt"}) {
    const test::CommandRun help =
        test::run_command(std::string(GAITWAY_COMMAND) + " motion " + part + " --help");
    EXPECT_THAT(help.said,
                AllOf(HasSubstr("Example"), HasSubstr("gaitway motion " + part), HasSubstr("Exit code: 0 ")))
        << part;
    EXPECT_THAT(help.said, Not(ContainsRegex("=[^ ]+ REQUIRED"))) << part;
  }
}

}  // namespace
}  // namespace gaitway::tools
