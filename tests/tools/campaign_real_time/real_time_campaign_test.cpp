// The campaign in real time as its user meets it: a robot comes up, walks, has its faults, and walks again.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

TEST(RealTimeCampaign, PlaysRowsAndGoesOnWhereItWas) {
  const process::PrivateFolder folder("gaitway_campaign_test");
  const std::string command = std::string(GAITWAY_COMMAND) + " campaign --real-time --trials 1 --out " +
                              folder.path().string() + " --rows message_controller_killed";
  const test::CommandRun one = test::run_command(command);
  ASSERT_EQ(one.code, 0) << one.all();
  const auto row = nlohmann::json::parse(test::text_of(folder.path() / "real_time.json"))["rows"][0];
  EXPECT_EQ(row["falls"], 0);
  EXPECT_EQ(row["walked_again"], 1);
  // What else this computer does must not decide here: the figures are in docs/faults.md.
  EXPECT_LT(row["commandable_s"]["largest_s"], 5.0);
  EXPECT_LT(row["parts_s"]["largest_s"], 5.0);
  const test::CommandRun again = test::run_command(command);
  EXPECT_EQ(again.code, 0) << again.all();
  EXPECT_THAT(again.said, HasSubstr("0 trials played, 1 known from"));
}

TEST(RealTimeCampaign, APluginThatCrashesIsReplacedAndTheRobotWalksOn) {
  const process::PrivateFolder folder("gaitway_campaign_test");
  const test::CommandRun run =
      test::run_command(std::string(GAITWAY_COMMAND) + " campaign --real-time --trials 1 --out " +
                        folder.path().string() + " --rows plugin_segv");
  ASSERT_EQ(run.code, 0) << run.all();
  const auto row = nlohmann::json::parse(test::text_of(folder.path() / "real_time.json"))["rows"][0];
  EXPECT_EQ(row["falls"], 0);
  EXPECT_THAT(run.said, HasSubstr("plug-in faults")) << "it has crashed";
}

TEST(RealTimeCampaign, RefusesWhatDoesNotGoTogetherBeforeAnythingMoves) {
  const auto complaint_of = [](const std::string& options) {
    const test::CommandRun run = test::run_command(std::string(GAITWAY_COMMAND) + " campaign " + options);
    EXPECT_EQ(run.code, 1) << options << run.all();
    return run.complaint;
  };
  EXPECT_THAT(complaint_of("--real-time --instants 3"), HasSubstr("--real-time: goes with none of"));
  EXPECT_THAT(complaint_of("--trials 3"), HasSubstr("--trials: goes with --real-time"));
  EXPECT_THAT(complaint_of("--real-time --rows jam"),
              HasSubstr("--rows jam: there is no such row of real time"));
  const test::CommandRun list =
      test::run_command(std::string(GAITWAY_COMMAND) + " campaign --real-time --list");
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.said, HasSubstr("message_controller_stopped_5s"));
}

}  // namespace
}  // namespace gaitway::tools
