// The bus as it is meant to be, as a page gets it: the messages that the message controller sends by, with
// their proof.
#include "gaitway/page/bus_assets.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/can/profile.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::page {
namespace {

using can::MessageKind;
using nlohmann::json;
using ::testing::ElementsAre;

urdf::RobotModel humanoid_with(const std::string& profile = "full") {
  return msgcontroller::load_robot(std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22", profile);
}

json bus_of(const urdf::RobotModel& robot) {
  AssetTable table;
  add_bus(table, robot);
  EXPECT_TRUE(table.find("/bus.json")->wants_token);
  return json::parse(table.find("/bus.json")->body);
}

json message_of(const json& bus, const std::string& kind, int joint) {
  for (const json& message : bus["messages"]) {
    if (message["kind"] == kind && message["joint"] == joint) {
      return message;
    }
  }
  ADD_FAILURE() << "no " << kind << " of joint " << joint;
  return {};
}

TEST(BusAssets, AreTheMessagesOfTheProofInTheirOrder) {
  const urdf::RobotModel robot = humanoid_with();
  const can::Proof proof = msgcontroller::prove_network(robot);
  const json bus = bus_of(robot);
  EXPECT_EQ(bus["profile"], "full");
  EXPECT_EQ(bus["slot_us"], 10'000);
  EXPECT_EQ(bus["cycle_slots"], 8);
  EXPECT_DOUBLE_EQ(bus["load"].get<double>(), proof.load);
  EXPECT_EQ(bus["jitter_us"], 1'000);
  EXPECT_EQ(bus["jam_us"], 2'000);
  ASSERT_EQ(bus["messages"].size(), proof.messages.size());
  for (std::size_t i = 0; i < proof.messages.size(); ++i) {
    const json& message = bus["messages"][i];
    EXPECT_EQ(message["id"], proof.messages[i].id);
    EXPECT_EQ(message["bytes"], proof.messages[i].bytes);
    EXPECT_EQ(message["period_us"].get<double>() * 1e3, static_cast<double>(proof.messages[i].period_ns));
    EXPECT_EQ(message["worst_us"].get<double>() * 1e3,
              static_cast<double>(*proof.responses[i].worst_response_ns));
    EXPECT_EQ(message["transmission_us"], proof.responses[i].length_bits) << "a microsecond a bit";
  }
}

TEST(BusAssets, SayWhoseAMessageIsAndByWhatItsReleaseIsSeen) {
  const urdf::RobotModel robot = humanoid_with();
  const json bus = bus_of(robot);
  const int knee = robot.joint_index("left_knee");
  const json feedback = message_of(bus, "feedback", knee);
  EXPECT_EQ(feedback["id"], can::kFullProfile.id_of(MessageKind::feedback, robot.joints[3].node));
  EXPECT_EQ(feedback["sent_by_joint"], true);
  EXPECT_EQ(feedback["released"], "sync");
  EXPECT_EQ(feedback["on_event"], false);
  const json trajectory = message_of(bus, "trajectory", knee);
  EXPECT_THAT(trajectory["ids"], ElementsAre(0x108, 0x109));
  EXPECT_EQ(trajectory["sent_by_joint"], false);
  EXPECT_EQ(trajectory["released"], "batch");
  const json sync = message_of(bus, "SYNC", -1);
  EXPECT_EQ(sync["released"], "slot_edge");
  EXPECT_EQ(message_of(bus, "emergency stop", -1)["released"], "");
  EXPECT_EQ(message_of(bus, "emergency stop", -1)["on_event"], true);
}

TEST(BusAssets, FollowTheProfileThatIsOnTheBus) {
  const json bus = bus_of(humanoid_with("paper"));
  EXPECT_EQ(bus["profile"], "paper");
  EXPECT_EQ(bus["messages"].size(), 25U) << "as published";
  const json feedback = message_of(bus, "feedback", 0);
  EXPECT_EQ(feedback["released"], "trajectory");
  EXPECT_EQ(message_of(bus, "trajectory", 0)["released"], "cycle_edge");
}

TEST(BusAssets, AMessageWithoutABoundHasNone) {
  urdf::RobotModel robot = humanoid_with();
  while (robot.joints.size() < 64) {  // more than the bus carries
    robot.joints.push_back(robot.joints.back());
    robot.joints.back().node = static_cast<std::uint8_t>(robot.joints.size());
  }
  const json bus = bus_of(robot);
  EXPECT_TRUE(message_of(bus, "resynchronisation", 63)["worst_us"].is_null());
}

}  // namespace
}  // namespace gaitway::page
