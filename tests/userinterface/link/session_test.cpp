// Beginning, ending and refusing sessions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "link_pair.hpp"

namespace gaitway::link::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Session, OpensWithinTwoHelloPeriods) {
  LinkPair link;
  EXPECT_FALSE(link.open());
  link.run(100 * kMs);
  EXPECT_TRUE(link.open());
  EXPECT_EQ(link.module->session().tag(), link.controller->session().tag());
}

TEST(Session, StaysOpenWhileNothingIsSaid) {
  LinkPair link;
  link.run(10'000 * kMs);
  EXPECT_TRUE(link.open());
  EXPECT_EQ(link.module->session().count(), 1U);
  EXPECT_EQ(link.controller->session().count(), 1U);
}

TEST(Session, EndsAtBothEndsWhenOneDirectionIsCut) {
  LinkPair link;
  link.run(100 * kMs);
  link.wire.cut_to_right(true);
  link.run(260 * kMs);
  EXPECT_FALSE(link.controller->session().open());
  EXPECT_EQ(link.controller->session().why(), SessionEnd::silence);
  link.run(40 * kMs);
  EXPECT_FALSE(link.module->session().open());
  EXPECT_EQ(link.module->session().why(), SessionEnd::peer_anew);
  link.wire.cut_to_right(false);
  link.run(200 * kMs);
  EXPECT_TRUE(link.open());
}

TEST(Session, OfOneRunIsNotThatOfTheNext) {
  LinkPair link;
  link.run(100 * kMs);
  const std::uint32_t before = link.module->session().tag();
  link.restart_controller();
  link.run(100 * kMs);
  ASSERT_TRUE(link.open());
  EXPECT_NE(link.module->session().tag(), before);
  EXPECT_EQ(link.module->session().count(), 2U);
}

TEST(Session, TagsOfConsecutiveSessionsDiffer) {
  LinkPair link;
  std::uint32_t before = 0;
  for (int i = 0; i < 20; ++i) {
    link.run(200 * kMs);
    ASSERT_TRUE(link.open());
    EXPECT_NE(link.module->session().tag(), before);
    before = link.module->session().tag();
    link.module->cut(link.now_ns);
  }
}

TEST(Session, LeavesOutFramesOfAnotherOne) {
  LinkPair link;
  link.run(100 * kMs);
  const std::array<std::uint8_t, 12> order{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F};  // never expires
  for (const std::uint32_t other : {1U, 0U}) {
    std::array<std::uint8_t, kMostContentBytes> content{};
    std::array<std::uint8_t, kMostFrameBytes> wire{};
    const std::size_t size =
        encode(Part{.message = 1, .payload = order}, link.module->session().tag() + other, content);
    link.controller->on_bytes(Bytes(wire).first(encode_frame(Bytes(content).first(size), wire)),
                              link.robot_ns());
    EXPECT_EQ(link.controller->next_order(link.robot_ns()).has_value(), other == 0);
  }
  EXPECT_EQ(link.controller->statistics().strangers, 1U);
}

// Two ends that are connected directly, byte by byte.
template <class Left, class Right>
void exchange(Left& left, Right& right, std::int64_t until_ns) {
  for (std::int64_t now_ns = 0; now_ns < until_ns; now_ns += kMs) {
    for (Bytes bytes; !(bytes = left.pending(now_ns)).empty(); left.taken(bytes.size()))
      right.on_bytes(bytes, now_ns);
    for (Bytes bytes; !(bytes = right.pending(now_ns)).empty(); right.taken(bytes.size()))
      left.on_bytes(bytes, now_ns);
  }
}

TEST(Session, IsRefusedToOneOfTheSameRole) {
  ModuleEnd first(module_identity(1), kChannels, {}), second(module_identity(2), kChannels, {});
  exchange(first, second, 200 * kMs);
  EXPECT_EQ(first.session().why(), SessionEnd::wrong_role);
  EXPECT_THAT(first.session().description(),
              AllOf(HasSubstr("both modules"), HasSubstr("connect one module to one controller")));
}

TEST(Session, IsRefusedToOneWithAnotherTable) {
  LinkIdentity other = controller_identity(2);
  other.table_hash = 5;
  ModuleEnd module(module_identity(1), kChannels, {});
  ControllerEnd controller(other, kChannels, {});
  exchange(module, controller, 200 * kMs);
  EXPECT_EQ(module.session().why(), SessionEnd::wrong_table);
  EXPECT_EQ(controller.session().why(), SessionEnd::wrong_table);
  EXPECT_THAT(module.session().description(),
              AllOf(HasSubstr("'main_controller', has 00000005"), HasSubstr("67617901"),
                    HasSubstr("install the same version of Gaitway on both sides")));
}

TEST(Session, IsRefusedToOneOfAnotherRobotAndBothSayWhich) {
  LinkIdentity ours = module_identity(1), theirs = controller_identity(2);
  ours.robot_hash = 0xA;
  theirs.robot_hash = 0xB;
  ModuleEnd module(ours, kChannels, {});
  ControllerEnd controller(theirs, kChannels, {});
  exchange(module, controller, 200 * kMs);
  EXPECT_EQ(module.session().why(), SessionEnd::wrong_robot);
  EXPECT_EQ(controller.session().why(), SessionEnd::wrong_robot);
  EXPECT_THAT(module.session().description(),
              AllOf(HasSubstr("'user_interface' has the robot's description 0000000a"),
                    HasSubstr("'main_controller', has 0000000b"),
                    HasSubstr("give both the same robot.urdf and robot.yaml")));
  EXPECT_THAT(controller.session().description(),
              HasSubstr("'main_controller' has the robot's description 0000000b"));
  module.cut(200 * kMs);
  EXPECT_EQ(module.session().why(), SessionEnd::wrong_robot) << "why it was cut off is still known";
}

TEST(Session, TellsOfAnotherCalibrationAndGoesOn) {
  LinkIdentity theirs = controller_identity(2);
  theirs.calibration_hash = 0xC;
  ModuleEnd module(module_identity(1), kChannels, {});
  ControllerEnd controller(theirs, kChannels, {});
  exchange(module, controller, 200 * kMs);
  ASSERT_TRUE(module.session().open());
  EXPECT_EQ(module.session().peer_calibration_hash(), 0xCU);
}

TEST(Session, IsRefusedToAnotherVersion) {
  ModuleEnd module(module_identity(1), kChannels, {});
  // Whatever a hello of that version says behind its number.
  const std::array<std::uint8_t, 10> content{
      static_cast<std::uint8_t>(FrameKind::hello), 0, 0, 0, 0, 99, 0, 1, 2, 3};
  std::array<std::uint8_t, kMostFrameBytes> wire{};
  module.on_bytes(Bytes(wire).first(encode_frame(content, wire)), 0);
  EXPECT_EQ(module.session().why(), SessionEnd::wrong_version);
  EXPECT_THAT(module.session().description(),
              AllOf(HasSubstr("version 99 of the link's protocol"), HasSubstr("'user_interface' version 2"),
                    HasSubstr("install the same version of Gaitway on both sides")));
}

TEST(Session, TwoThatDisagreeDoNotFillTheCarrier) {
  ModuleEnd first(module_identity(1), kChannels, {}), second(module_identity(2), kChannels, {});
  exchange(first, second, 1000 * kMs);
  EXPECT_LE(first.statistics().sent_frames, 41U);  // each half period at most
}

TEST(Session, SettingsThatCannotWorkAreRefusedByName) {
  LinkSettings settings;
  settings.silence_ns = settings.status_period_ns;
  EXPECT_THROW(ModuleEnd(module_identity(1), kChannels, settings), std::invalid_argument);
  settings = {};
  settings.fragment_bytes = kMostFragmentBytes + 1;
  EXPECT_THROW(ModuleEnd(module_identity(1), kChannels, settings), std::invalid_argument);
  EXPECT_THROW(ModuleEnd(module_identity(0), kChannels, {}), std::invalid_argument);
}

// The robot's clock stands still, or goes slower: the link goes on, and orders are judged by it.
TEST(Session, GoesOnWhileTheRobotsClockStandsStill) {
  ModuleEnd module(module_identity(1), kChannels, {});
  ControllerEnd controller(controller_identity(2), kChannels, {});
  SimulatedWire wire(0, 4096, 1);
  constexpr std::int64_t kRobot_ns = 5'000 * kMs;
  std::int64_t now_ns = 0;
  const auto run = [&](std::int64_t duration_ns) {
    for (const std::int64_t end_ns = now_ns + duration_ns; now_ns < end_ns;) {
      now_ns += kMs;
      wire.advance(now_ns);
      pump(module, wire.left(), now_ns);
      controller.set_robot_time(kRobot_ns, now_ns);
      pump(controller, wire.right(), now_ns);
    }
  };
  run(3'000 * kMs);
  ASSERT_TRUE(module.session().open());
  EXPECT_EQ(module.session().count(), 1U);
  EXPECT_EQ(module.robot_clock_ns(), kRobot_ns) << "it is told as it is";
  ASSERT_EQ(module.submit(1, bytes_of("go"), kRobot_ns + 200 * kMs, now_ns).refusal, Refusal::none);
  run(20 * kMs);
  controller.set_robot_time(kRobot_ns + 201 * kMs, now_ns);
  EXPECT_FALSE(controller.next_order(now_ns)) << "late by the robot's clock, though not by the link's";
  EXPECT_EQ(controller.late_orders(), 1U);
}

}  // namespace
}  // namespace gaitway::link::test
