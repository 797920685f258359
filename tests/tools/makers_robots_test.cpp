// Robots that other people published: brought from their URDFs by the command, without a hand, they stand,
// step and walk at Froude's number 0.02 through the whole chain, with what the planner does not know of them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "command_run.hpp"
#include "importer/maker_robots.hpp"
#include "repeats.hpp"

namespace gaitway::tools {
namespace {

int robot_command(const std::string& arguments) {
  const test::CommandRun run = test::run_command(std::string(GAITWAY_ROBOT_COMMAND) + " robot " + arguments);
  std::fputs(run.all().c_str(), stdout);
  return run.code;
}

class BroughtRobot : public ::testing::Test {
 protected:
  BroughtRobot() {
    std::string pattern = (std::filesystem::temp_directory_path() / "gaitway-brought-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~BroughtRobot() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

class MakersRobot : public BroughtRobot, public ::testing::WithParamInterface<const char*> {};

TEST_P(MakersRobot, WalksWithoutAHand) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const std::string robot = (folder_ / "robot").string();
  const std::string urdf = (*importer::test::maker_robots() / GetParam()).string();
  ASSERT_EQ(robot_command("import '" + urdf + "' --quiet --out '" + robot + "'"), 0);
  EXPECT_EQ(robot_command("check '" + robot + "' --seconds 12"), 0);
}
constexpr std::array kThatWalk{"g1_description/urdf/g1_29dof_rev_1_0.urdf",
                               "talos_data/robots/talos_full_v2.urdf",
                               "talos_data/robots/talos_reduced_box.urdf",
                               "icub_description/robots/icub_reduced.urdf",
                               "alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf",
                               "human_description/robots/human.urdf"};
INSTANTIATE_TEST_SUITE_P(Published, MakersRobot,
                         ::testing::ValuesIn(kThatWalk.begin(),
                                             kThatWalk.begin() + test::repeats(kThatWalk.size())));

// Its legs are heavy for its soles: it swings its arms against them.
TEST_F(BroughtRobot, WalksFastWithItsArms) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const std::string robot = (folder_ / "robot").string();
  const std::string urdf = (*importer::test::maker_robots() / "icub_description/robots/icub.urdf").string();
  ASSERT_EQ(robot_command("import '" + urdf + "' --quiet --out '" + robot + "'"), 0);
  EXPECT_EQ(robot_command("check '" + robot + "' --seconds 12 --speed 0.51"), 0) << "Froude's number 0.06";
}

// Its ankles turn at 2.1 rad/s: it is given slower steps, and walks as fast as these allow.
TEST_F(BroughtRobot, WithSlowMotorsWalksSlower) {
  GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS();
  const std::string robot = (folder_ / "robot").string();
  const std::string urdf = (*importer::test::maker_robots() / "romeo_description/urdf/romeo.urdf").string();
  ASSERT_EQ(robot_command("import '" + urdf + "' --quiet --out '" + robot + "'"), 0);
  EXPECT_EQ(robot_command("check '" + robot + "' --seconds 12 --speed 0.18"), 0);
  EXPECT_EQ(robot_command("check '" + robot + "' --seconds 12"), 3) << "it stays up, but cannot walk so fast";
}

}  // namespace
}  // namespace gaitway::tools
