// The profile that a robot's network file makes, and whether its bus can be proven.
#include "gaitway/msgcontroller/network_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gaitway::msgcontroller {
namespace {

using can::MessageKind;
using ::testing::HasSubstr;

class NetworkProof : public ::testing::Test {
 protected:
  urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");

  std::string refusal() {
    try {
      static_cast<void>(network_profile(robot));
    } catch (const urdf::RobotError& error) {
      return error.what();
    }
    return "no error";
  }
  static urdf::MessageSetting with_id(const std::string& message, int id) {
    return {.message = message, .line = 7, .id = id, .period_s = {}, .deadline_s = {}};
  }
};

TEST_F(NetworkProof, TheShippedRobotIsProvenInBothProfiles) {
  EXPECT_EQ(complaint_about_network(robot), "");
  robot.network.profile = "paper";
  EXPECT_EQ(complaint_about_network(robot), "");
}

TEST_F(NetworkProof, TailsHaveAsManyPartsAsTheStepsOfTheBodyTakeAndTheBusCanCarry) {
  EXPECT_EQ(network_profile(robot).tail_parts, 3);
  EXPECT_EQ(note_on_tails(robot), "");
  robot.network.tail_parts = 2;
  EXPECT_EQ(network_profile(robot).tail_parts, 2);
  EXPECT_EQ(note_on_tails(robot), "");
  robot.network.tail_parts = 0;
  EXPECT_FALSE(network_profile(robot).has(MessageKind::tail));
  EXPECT_EQ(note_on_tails(robot), "");
}

TEST_F(NetworkProof, ABusThatHasNoRoomForTailsCarriesLessOfThemAndSaysSo) {
  robot.network.messages.push_back(
      {.message = "tail", .line = 7, .id = {}, .period_s = {}, .deadline_s = 0.045});
  EXPECT_EQ(network_profile(robot).tail_parts, 2);
  EXPECT_EQ(complaint_about_network(robot), "");
  EXPECT_THAT(note_on_tails(robot),
              HasSubstr("more than 2 of the 3 frames that a joint needs to end a step by itself"));
}

TEST_F(NetworkProof, ABusThatCannotBeProvenIsNamedWithTheMessageAndByHowMuch) {
  robot.network.messages.push_back(
      {.message = "trajectory", .line = 7, .id = {}, .period_s = {}, .deadline_s = 0.005});
  const std::string complaint = complaint_about_network(robot);
  EXPECT_THAT(complaint, HasSubstr("'trajectory 1'"));
  EXPECT_THAT(complaint, HasSubstr("ms after its deadline of 5.000 ms"));
  EXPECT_THAT(complaint, HasSubstr("--accept-unproven"));
}

TEST_F(NetworkProof, ABatchMayBeHandedOverAsLateAsItsFramesNeed) {
  const std::int64_t lead_ns = hand_over_lead_ns(robot);
  EXPECT_EQ(lead_ns, 8'000'000);
  robot.network.profile = "paper";
  EXPECT_LT(hand_over_lead_ns(robot), lead_ns) << "twelve joints, and trajectories come first";
}

TEST_F(NetworkProof, MessagesMayHaveOtherIdentifiersPeriodsAndDeadlines) {
  robot.network.messages.push_back(with_id("feedback", 0x500));
  robot.network.messages.push_back(
      {.message = "fault_report", .line = 8, .id = {}, .period_s = 0.5, .deadline_s = 0.1});
  const can::Profile profile = network_profile(robot);
  EXPECT_EQ(profile.id_of(MessageKind::feedback, 3), 0x503U);
  EXPECT_EQ(profile.row(MessageKind::fault_report).period_ns, 500'000'000);
  EXPECT_EQ(profile.row(MessageKind::fault_report).deadline_ns, 100'000'000);
}

TEST_F(NetworkProof, RefusesWhatMakesNoProfileAndNamesIt) {
  robot.network.profile = "ful";
  robot.network.line = 62;
  EXPECT_THAT(refusal(),
              HasSubstr("robot.yaml:62: network.profile: there is no profile 'ful'. Did you mean"));
  robot.network.profile = "full";
  robot.network.messages = {with_id("feedbak", 5)};
  EXPECT_THAT(refusal(), HasSubstr("robot.yaml:7: network.messages.feedbak: the profile 'full' has no such"));
  robot.network.messages = {with_id("feedback", 0x7F0)};
  EXPECT_THAT(refusal(), HasSubstr("there are 11 bits"));
  robot.network.messages = {with_id("trajectory", 0x40)};
  EXPECT_THAT(refusal(), HasSubstr("would belong to"));
  robot.network.messages = {{.message = "sync", .line = 7, .id = {}, .period_s = 0.02, .deadline_s = {}}};
  EXPECT_THAT(refusal(), HasSubstr("comes with the time slots"));
  robot.network.profile = "paper";
  robot.network.messages = {with_id("trim", 5)};
  EXPECT_THAT(refusal(), HasSubstr("the profile 'paper' has no such message"));
}

}  // namespace
}  // namespace gaitway::msgcontroller
