// `gaitway robot check`: its exit code says what became of the robot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "command_run.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::tools {
namespace {

using gaitway::test::RobotVariant;
using testing::HasSubstr;

gaitway::test::CommandRun check(const std::filesystem::path& robot, const std::string& options) {
  return gaitway::test::run_command(std::string(GAITWAY_ROBOT_COMMAND) + " robot check '" + robot.string() +
                                    "' --seconds 4 " + options);
}

TEST(RobotCheck, SaysThatARobotWalks) {
  const RobotVariant humanoid22;
  const auto run = check(humanoid22.folder(), "");
  EXPECT_EQ(run.code, 0) << run.all();
  EXPECT_THAT(run.said, HasSubstr("walks: ok"));
}

TEST(RobotCheck, SaysThatAFolderIsBad) {
  const RobotVariant humanoid22;
  std::filesystem::remove(humanoid22.folder() / "robot.yaml");
  const auto run = check(humanoid22.folder(), "");
  EXPECT_EQ(run.code, 1) << run.all();
  EXPECT_THAT(run.complaint, HasSubstr("robot.yaml"));
}

// With so much that its planner does not know it cannot step.
TEST(RobotCheck, SaysThatARobotFell) {
  const RobotVariant humanoid22;
  const auto run = check(humanoid22.folder(), "--mismatch 10");
  EXPECT_EQ(run.code, 2) << run.all();
  EXPECT_THAT(run.said, HasSubstr("fell at"));
}

// It walks as fast as it can and stays up.
TEST(RobotCheck, SaysThatARobotWalksTooSlowly) {
  const RobotVariant humanoid22;
  const auto run = check(humanoid22.folder(), "--speed 1.5");
  EXPECT_EQ(run.code, 3) << run.all();
  EXPECT_THAT(run.said, testing::AllOf(HasSubstr("steps: ok, walks: no"), HasSubstr(" 0 of ")));
}

// On the spot, where any speed is enough: it is the batches that count. As planned, the ankles roll just far
// enough; what balances the robot asks for more now and then, and after each refused batch it stops for a
// while.
TEST(RobotCheck, SaysThatTooManyBatchesAreLacking) {
  RobotVariant humanoid22;
  humanoid22.narrow("ankle_roll", 0.082);
  const auto run = check(humanoid22.folder(), "--speed 0");
  EXPECT_EQ(run.code, 3) << run.all();
  EXPECT_THAT(run.said, testing::AllOf(HasSubstr("walks: no"), HasSubstr("beyond its limits"),
                                       HasSubstr("robot describe")));
}

TEST(RobotCheck, WalksBackward) {
  const RobotVariant humanoid22;
  const auto run = check(humanoid22.folder(), "--speed -0.15");
  EXPECT_EQ(run.code, 0) << run.all();
  EXPECT_THAT(run.said, HasSubstr("of -0.150 m/s"));
}

}  // namespace
}  // namespace gaitway::tools
