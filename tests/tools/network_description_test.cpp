// The description of the network: complete, readable for bus tools, and what is checked in is what the tables
// say.
#include "tools/bus/network_description.hpp"

#include <gmock/gmock.h>

#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "gaitway/can/messages.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;
using testing::ElementsAre;
using testing::HasSubstr;

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(std::string(GAITWAY_SOURCE_DIR) + "/" + file).rdbuf();
  return text.str();
}

bool is_c_identifier(const std::string& name) {
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
             std::string::npos;
}

class NetworkDescriptionTest : public testing::Test {
 protected:
  [[nodiscard]] const DescribedMessage& message(const NetworkDescription& network, std::uint32_t id) const {
    for (const DescribedMessage& one : network.messages) {
      if (one.id == id) {
        return one;
      }
    }
    throw std::runtime_error("no message with that identifier");
  }

  urdf::RobotModel robot = urdf::load_robot(std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22");
  NetworkDescription full = describe_network(robot, can::kFullProfile);
  NetworkDescription paper = describe_network(robot, can::kPaperProfile);
};

TEST_F(NetworkDescriptionTest, TheCheckedInPageIsWhatTheTablesSay) {
  EXPECT_TRUE(text_of("docs/network.md") == network_document(robot, full, paper))
      << "docs/network.md is not up to date. Run ./dev gaitway bus document --out docs/network.md";
}

TEST_F(NetworkDescriptionTest, TheCheckedInDbcFileIsWhatTheTablesSay) {
  EXPECT_TRUE(text_of("docs/gaitway.dbc") == dbc_text(full))
      << "docs/gaitway.dbc is not up to date. Run ./dev gaitway bus dbc --out docs/gaitway.dbc";
}

TEST_F(NetworkDescriptionTest, EveryFieldOfTheMessageTableHasAMeaning) {
  for (const can::MessageLayout& layout : can::kMessageLayouts) {
    EXPECT_FALSE(meaning_of(layout.kind).empty()) << layout.name;
    for (const can::FieldSpec& field : layout.fields) {
      EXPECT_NO_THROW(EXPECT_FALSE(meaning_of(layout.kind, field.name).empty())) << field.name;
      for (const NamedValue& value : values_of(layout.kind, field.name)) {
        EXPECT_LT(value.value, std::int64_t{1} << field.width) << field.name << " " << value.name;
      }
    }
  }
  EXPECT_THROW(static_cast<void>(meaning_of(MessageKind::sync, "phase")), std::logic_error);
}

TEST_F(NetworkDescriptionTest, EveryIdentifierInUseIsThereOnceAndMeansWhatTheProfileSays) {
  // 5 messages to all, 22 joints with feedback, fault report, two trajectories, resynchronisation and the
  // three parts of two tails.
  EXPECT_EQ(full.messages.size(), 5 + 22 * (5 + 6));
  EXPECT_EQ(paper.messages.size(), 25);
  for (const NetworkDescription* const network : {&full, &paper}) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < network->messages.size(); ++i) {
      const DescribedMessage& one = network->messages[i];
      EXPECT_TRUE(i == 0 || network->messages[i - 1].id < one.id);
      EXPECT_EQ(network->profile.identify(one.id),
                (can::Identified{one.kind, one.node, one.toggle, one.part}));
      EXPECT_TRUE(names.insert(one.name).second) << one.name;
      EXPECT_TRUE(is_c_identifier(one.name)) << one.name;
      std::set<std::string> signals;
      for (const DescribedSignal& signal : one.signals) {
        EXPECT_TRUE(is_c_identifier(signal.name)) << signal.name;
        EXPECT_TRUE(signals.insert(signal.name).second) << signal.name;
      }
    }
  }
}

TEST_F(NetworkDescriptionTest, AJointsFeedbackHasItsSensorsInTheirUnits) {
  const DescribedMessage& ankle = message(full, can::kFullProfile.id_of(MessageKind::feedback, 5));
  EXPECT_EQ(ankle.name, "feedback_left_ankle_pitch");
  EXPECT_EQ(ankle.sender, "left_ankle_pitch");
  EXPECT_THAT(ankle.receivers, ElementsAre("message_controller"));
  const DescribedSignal& position = ankle.signals.front();
  EXPECT_DOUBLE_EQ(position.factor * 65536.0, 360.0);
  EXPECT_EQ(position.unit, "deg");
  EXPECT_NEAR(position.lowest, -1.3 * 180.0 / 3.14159265358979, 1e-6);
  const DescribedSignal& cell = ankle.signals[6];
  EXPECT_EQ(cell.name, "left_cell_front_left");
  EXPECT_DOUBLE_EQ(cell.factor, 0.01);
  EXPECT_EQ(cell.unit, "N");
}

TEST_F(NetworkDescriptionTest, CountsAreInTheJointsOwnSize) {
  robot.joints[3].count_rad *= 2.0;
  const NetworkDescription changed = describe_network(robot, can::kFullProfile);
  const auto delta = [&](can::NodeId node) {
    return message(changed, can::kFullProfile.id_of(MessageKind::trajectory, node, true)).signals[0].factor;
  };
  EXPECT_NEAR(delta(3), 0.05, 1e-12);
  EXPECT_NEAR(delta(4), 0.1, 1e-12);
}

TEST_F(NetworkDescriptionTest, NamesThatAreNoCIdentifiersAreMadeOnesAndStayApart) {
  robot.joints[0].name = "1st joint";
  robot.joints[1].name = "hip-roll";
  robot.joints[2].name = "hip roll";
  const NetworkDescription changed = describe_network(robot, can::kFullProfile);
  EXPECT_EQ(changed.nodes[0].name, "_1st_joint");
  EXPECT_EQ(changed.nodes[1].name, "hip_roll");
  EXPECT_EQ(changed.nodes[2].name, "hip_roll_2");
}

TEST_F(NetworkDescriptionTest, LongNamesAreCutInTheDbcFileAndStandWholeInTheirAttribute) {
  const std::string text = dbc_text(full);
  EXPECT_THAT(text, HasSubstr("BO_ 532 resynchronisation_right_shoulder: 8"));
  EXPECT_THAT(text, HasSubstr("BO_ 533 resynchronisation_right_should_2: 8"));
  EXPECT_THAT(text,
              HasSubstr("\"SystemMessageLongSymbol\" BO_ 533 \"resynchronisation_right_shoulder_roll\";"));
  std::istringstream lines(text);
  for (std::string word, name; lines >> word;) {
    if (word == "BO_" && lines >> word >> name && name.back() == ':') {
      EXPECT_LE(name.size() - 1, 32) << name;
    }
  }
}

TEST_F(NetworkDescriptionTest, TheProfileOfTheNetworkFileIsFollowedDownToAnIdentifier) {
  robot.network.messages.push_back({.message = "sync", .id = 0x30, .period_s = {}, .deadline_s = {}});
  const std::string text = dbc_text(describe_network(robot, msgcontroller::network_profile(robot)));
  EXPECT_THAT(text, HasSubstr("BO_ 48 SYNC: 4"));
  EXPECT_THAT(text, testing::Not(HasSubstr("BO_ 8 ")));
}

}  // namespace
}  // namespace gaitway::tools
