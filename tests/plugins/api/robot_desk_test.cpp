// The robot's side of the link by itself: what is left of a module, or of a process before this one, moves
// nothing and refuses nothing.
#include "gaitway/api/robot_desk.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "gaitway/contract/channel_table.hpp"
#include "gaitway/link/byte_order.hpp"
#include "gaitway/link/module_end.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::api {
namespace {

using facts::kMillisecond_ns;
using facts::kSecond_ns;

// A robot without anybody who obeys, and a module that says what it likes.
class RobotDeskTest : public ::testing::Test {
 protected:
  RobotDeskTest() { restart_module(11); }

  void restart_module(std::uint64_t boot) {
    module = std::make_unique<link::ModuleEnd>(
        contract::identity_of(link::Role::module, boot, "module", robot),
        contract::link_channels({robot.joints.size()}), link::LinkSettings{});
  }
  void start_desk(std::uint64_t boot) {
    client.emplace(block.local_client("api"));
    desk = std::make_unique<RobotDesk>(
        *client, robot, RobotDeskOptions{.boot = boot, .name = "robot", .narrow = false, .link = {}});
  }
  void pass(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ++ms) {
      now_ns += kMillisecond_ns;
      block.beat(now_ns);
      carry(*module, desk->end());
      desk->step(now_ns);
      carry(desk->end(), *module);
    }
  }
  void carry(link::LinkEnd& from, link::LinkEnd& to) const {
    for (link::Bytes bytes = from.pending(now_ns); !bytes.empty(); bytes = from.pending(now_ns)) {
      to.on_bytes(bytes, now_ns);
      from.taken(bytes.size());
    }
  }
  // A velocity that holds for so long, of a module that has asked for so many stops.
  void walk(std::int64_t holds_ns, std::uint32_t stops) {
    WalkCommand request{};
    request.walk = 1;
    request.velocity[0] = 0.1;
    request.valid_until_ns = holds_ns;
    std::array<std::uint8_t, link::kMostOrderBytes> room{};
    link::ByteWriter(room).put(stops);
    const contract::TopicCodec codec{.joint_count = robot.joints.size(), .exact = true};
    const std::size_t size = codec.encode(TopicType<WalkCommand>::descriptor, &request,
                                          std::span(room).subspan(contract::kStopsSeenBytes));
    const link::Submission submission =
        module->submit(static_cast<std::uint16_t>(contract::OrderKind::walk),
                       std::span(room).first(contract::kStopsSeenBytes + size), now_ns + kSecond_ns, now_ns);
    ASSERT_EQ(submission.refusal, link::Refusal::none);
    pass(5);
  }
  [[nodiscard]] bool told_to_walk() {
    WalkCommand request{};
    return requests.read(request) && request.walk != 0 && now_ns < request.valid_until_ns;
  }

  const urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  msgclient::MemoryBlock block;
  msgclient::Client looker = block.local_client("looker");
  msgclient::Reader<WalkCommand> requests = looker.read<WalkCommand>("walk_request");
  std::int64_t now_ns = kSecond_ns;
  std::optional<msgclient::Client> client;
  std::unique_ptr<RobotDesk> desk;
  std::unique_ptr<link::ModuleEnd> module;
};

TEST_F(RobotDeskTest, EndsTheWalkOfAProcessBeforeItsOwn) {
  start_desk(1);
  pass(200);
  walk(600 * kSecond_ns, 0);
  ASSERT_TRUE(told_to_walk());
  desk.reset();  // killed: it has said nothing
  ASSERT_TRUE(told_to_walk());
  start_desk(2);
  EXPECT_FALSE(told_to_walk()) << "who commanded has no link any more";
}

TEST_F(RobotDeskTest, AModuleThatWasStartedAnewKnowsOfNoStopsBefore) {
  start_desk(1);
  pass(200);
  module->stop(link::StopKind::stop);
  module->stop(link::StopKind::stop);
  pass(5);
  walk(kSecond_ns, 1);
  EXPECT_FALSE(told_to_walk()) << "it was given before the second stop";
  restart_module(12);
  pass(300);
  walk(kSecond_ns, 0);
  EXPECT_TRUE(told_to_walk()) << "it has asked for no stop";
  module->stop(link::StopKind::emergency_hold);
  pass(5);
  walk(kSecond_ns, 0);
  EXPECT_FALSE(told_to_walk());
}

}  // namespace
}  // namespace gaitway::api
