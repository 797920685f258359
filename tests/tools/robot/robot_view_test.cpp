// What is told of a robot from beside it: whether it may be commanded, and why not.
#include "tools/robot/keeper/robot_view.hpp"

#include <gmock/gmock.h>

#include <cstring>

#include "gaitway/msgclient/memory_block_thread.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::int64_t kMillisecond = 1'000'000;

class RobotViewTest : public testing::Test {
 protected:
  RobotViewTest() {
    network.cycle = 7;
    network.accepted_sequence = 8;
    tell(now_ns);
    EXPECT_TRUE(view.look());
  }
  // As a message controller with answering joints tells it at that time.
  void tell(std::int64_t at_ns) {
    network.stamp_ns = joints.stamp_ns = at_ns;
    network_writer.publish(network, at_ns);
    joints_writer.publish(joints, at_ns);
    health_writer.publish(health, at_ns);
    block.beat(at_ns);
  }
  [[nodiscard]] std::string why(std::uint32_t mode) {
    network.mode = mode;
    tell(now_ns);
    return view.why_not_commanded(now_ns);
  }

  process::PrivateFolder folder{"gaitway_view"};
  std::int64_t now_ns = process::monotonic_ns();
  msgclient::MemoryBlock block;
  msgclient::Client message_controller = block.local_client("message_controller");
  msgclient::Client arbiter = block.local_client("arbiter");
  msgclient::Writer<NetworkState> network_writer = message_controller.write<NetworkState>("network_state");
  msgclient::Writer<NetworkHealth> health_writer = message_controller.write<NetworkHealth>("network_health");
  msgclient::Writer<JointStates> joints_writer = message_controller.write<JointStates>("joint_states");
  msgclient::Writer<CommandState> command_writer = arbiter.write<CommandState>("command_state");
  NetworkState network{};
  NetworkHealth health{};
  JointStates joints{};
  msgclient::MemoryBlockThread server{block, folder.path() / "memory.sock"};
  RobotView view{folder.path() / "memory.sock"};
};

TEST_F(RobotViewTest, SaysWhatKeepsTheRobotFromBeingCommanded) {
  EXPECT_EQ(why(network_state::mode::batches), "");
  EXPECT_TRUE(view.may_be_commanded(now_ns));
  EXPECT_THAT(why(network_state::mode::safe_tail), HasSubstr("finishes its step"));
  EXPECT_THAT(why(network_state::mode::holding), HasSubstr("waits for the main controller's next batch"));
  EXPECT_THAT(why(network_state::mode::emergency_stop), StartsWith("an emergency stop is in force"));
  network.accepted_sequence = 6;
  EXPECT_THAT(why(network_state::mode::batches), HasSubstr("has not come in time"));
  network.accepted_sequence = 0;
  EXPECT_THAT(why(network_state::mode::holding), HasSubstr("just been started"));
  EXPECT_FALSE(view.may_be_commanded(now_ns));
}

// Whoever was killed beats no more, and is not believed for as long as its last state would be fresh.
TEST_F(RobotViewTest, AMessageControllerThatDoesNotBeatIsNotBelieved) {
  EXPECT_TRUE(view.may_be_commanded(now_ns + 24 * kMillisecond));
  EXPECT_EQ(view.why_not_commanded(now_ns + 26 * kMillisecond),
            "its message controller has been silent for 26 ms");
  block.beat(now_ns + 60 * kMillisecond);
  EXPECT_THAT(view.why_not_commanded(now_ns + 60 * kMillisecond), HasSubstr("does not tell what it does"));
}

TEST_F(RobotViewTest, JointsWithoutPowerAndABusThatIsGoneAreToldApart) {
  const auto why_silent = [&] {
    tell(now_ns);
    const std::int64_t later_ns = now_ns + 200 * kMillisecond;
    network.stamp_ns = later_ns;
    network_writer.publish(network, later_ns);
    block.beat(later_ns);
    return view.why_not_commanded(later_ns);
  };
  EXPECT_EQ(why_silent(), "the joints have not answered for 200 ms: is their power on?");
  health.bus_state = 3;
  EXPECT_EQ(why_silent(), "the joints have not answered for 200 ms: the bus is gone");
}

TEST_F(RobotViewTest, SaysWhoCommands) {
  EXPECT_EQ(view.who_commands(now_ns), "") << "nobody has said so yet";
  CommandState state{};
  state.since_ns = now_ns - 3'200 * kMillisecond;
  std::memcpy(state.text, "a person commands", sizeof "a person commands");
  command_writer.publish(state, now_ns);
  EXPECT_EQ(view.who_commands(now_ns), "a person commands, for 3.2 s");
}

TEST(RobotView, WithoutAMemoryBlockItSaysSo) {
  RobotView view("/nowhere/memory.sock");
  EXPECT_FALSE(view.look());
  EXPECT_EQ(view.why_not_commanded(1), "its message controller is not there");
}

}  // namespace
}  // namespace gaitway::tools
