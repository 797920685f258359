// `gaitway robot describe` as a user meets it: what it says of humanoid22, and of robots that lack something.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "command_run.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::tools {
namespace {

using gaitway::test::RobotVariant;
using testing::HasSubstr;
using testing::Not;

using gaitway::test::CommandRun;

CommandRun describe(const std::filesystem::path& robot, const std::string& options = "") {
  return gaitway::test::run_command(std::string(GAITWAY_ROBOT_COMMAND) + " robot describe '" +
                                    robot.string() + "' " + options);
}

nlohmann::json speed_of(const nlohmann::json& told, const std::string& direction) {
  for (const auto& speed : told.at("speeds")) {
    if (speed.at("direction") == direction) return speed;
  }
  return {};
}
nlohmann::json gait_of(const nlohmann::json& told, const std::string& parameter) {
  for (const auto& line : told.at("gait")) {
    if (line.at("parameter") == parameter) return line;
  }
  return {};
}

TEST(RobotDescribe, SaysWhatHumanoid22IsAndHowFastItMayGo) {
  const RobotVariant humanoid22;
  const CommandRun run = describe(humanoid22.folder());
  EXPECT_EQ(run.code, 0) << run.all();
  EXPECT_THAT(run.all(), HasSubstr("6.84 kg, hips 0.36 m above the ground, 22 joints"));
  EXPECT_THAT(run.all(), HasSubstr("soles: 0.135 m x 0.085 m"));
  EXPECT_THAT(run.all(), HasSubstr("left_knee"));
  EXPECT_THAT(run.all(), HasSubstr("bus: profile full, proven"));
  EXPECT_THAT(run.all(), Not(HasSubstr("cannot walk")));
  const auto told = nlohmann::json::parse(describe(humanoid22.folder(), "--json").all());
  EXPECT_NEAR(speed_of(told, "forward").at("most").get<double>(), 0.15 / 0.32, 1e-9);
  EXPECT_NEAR(speed_of(told, "backward").at("most").get<double>(), 0.10 / 0.32, 1e-9);
  EXPECT_NEAR(speed_of(told, "turn").at("most").get<double>(), 0.5 / 0.32, 1e-9);
  EXPECT_THAT(speed_of(told, "forward").at("cause").get<std::string>(), HasSubstr("the default gait"));
  EXPECT_EQ(gait_of(told, "step_time").at("chosen"), gait_of(told, "step_time").at("scaled"));
}

TEST(RobotDescribe, NamesTheKneesThatSlowDownARobotWithSlowMotors) {
  RobotVariant slow;
  slow.scale(0.23 / 0.36);
  slow.limit_speed(4.8);
  const auto told = nlohmann::json::parse(describe(slow.folder(), "--json").all());
  const auto lift = gait_of(told, "lift");
  EXPECT_LT(lift.at("chosen").get<double>(), 0.8 * lift.at("scaled").get<double>());
  EXPECT_THAT(lift.at("reason").get<std::string>(), HasSubstr("speed: the knee turns at 4.8 rad/s at most"));
  EXPECT_THAT(speed_of(told, "forward").at("cause").get<std::string>(),
              HasSubstr("the knee turns at 4.8 rad/s"));
  EXPECT_THAT(describe(slow.folder()).all(), HasSubstr("4.8 rad/s at most"));
}

// In units of weight times hip height: 0.2 walks, 0.12 falls, and with 0.08 no knee holds the robot.
TEST(RobotDescribe, NamesTheJointThatIsTooWeak) {
  constexpr double kWeightTimesHeight_Nm = 6.84 * 9.81 * 0.36;
  RobotVariant strong, weak, weakest;
  strong.limit_torque(0.20 * kWeightTimesHeight_Nm);
  EXPECT_EQ(describe(strong.folder()).code, 0) << describe(strong.folder()).all();
  weak.limit_torque(0.12 * kWeightTimesHeight_Nm);
  const CommandRun run = describe(weak.folder());
  EXPECT_EQ(run.code, 3) << run.all();
  EXPECT_THAT(run.all(), HasSubstr("cannot walk: joint '"));
  EXPECT_THAT(run.all(), HasSubstr("N*m to walk"));
  EXPECT_THAT(run.all(), HasSubstr("its motor has 2.9"));
  weakest.limit_torque(0.05 * kWeightTimesHeight_Nm);
  EXPECT_THAT(describe(weakest.folder()).all(), HasSubstr("N*m to stand on one leg, but its motor has 1.21"));
}

TEST(RobotDescribe, ARobotThatDoesNotLoadIsNamed) {
  const CommandRun run = describe("/nowhere");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.all(), HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace gaitway::tools
