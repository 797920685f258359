// A joint on a board, as its interrupts call it.
#include "gaitway/firmware/joint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"

namespace gaitway::firmware {
namespace {

constexpr can::NodeId kNode = 5;
constexpr double kCount_rad = 0.001;
constexpr double kStiffness_Nm_per_rad = 100.0;

// A board whose every signal a test can set and see.
struct Board {
  static constexpr std::int64_t kTick_ns = 1000;

  [[nodiscard]] std::uint32_t ticks() const noexcept { return counter; }
  void read(localcontroller::JointSensors& into) noexcept {
    into = sensors;
    if (const std::function<void()> interrupt = std::exchange(while_reading, nullptr)) {
      interrupt();
    }
  }
  void set_torque_Nm(double torque) noexcept { torque_Nm = torque; }
  [[nodiscard]] bool transmit_busy() const noexcept { return mailbox.has_value(); }
  void transmit(const can::Frame& frame) noexcept { mailbox = frame; }
  void feed_watchdog() noexcept { ++fed; }

  std::uint32_t counter = 0;
  localcontroller::JointSensors sensors;
  std::function<void()> while_reading;  // an interrupt that comes once
  double torque_Nm = 0.0;
  std::optional<can::Frame> mailbox;
  int fed = 0;
};
static_assert(JointPort<Board>);

class JointTest : public testing::Test {
 protected:
  static localcontroller::JointConfig config() {
    localcontroller::JointConfig config;
    config.node = kNode;
    config.count_rad = kCount_rad;
    config.encoder_count_rad = 0.0001;
    config.stiffness_Nm_per_rad = kStiffness_Nm_per_rad;
    config.torque_limit_Nm = 50.0;
    config.lower_rad = -1.0;
    config.upper_rad = 1.0;
    return config;
  }
  void power_up(std::uint32_t counter = 0, std::int32_t encoder_count = 0) {
    board.counter = counter;
    board.sensors.encoder_count = encoder_count;
    joint.emplace(config(), board);
    joint->on_work();
    report = std::exchange(board.mailbox, std::nullopt);
  }
  template <class Message>
  void receive(const Message& message) {
    joint->on_frame_received(can::encode(can::kFullProfile, message));
  }
  void run(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ++ms) {
      board.counter += 1000;
      joint->on_servo_tick();
    }
  }
  std::optional<can::Feedback> sent() {
    const std::optional<can::Frame> frame = std::exchange(board.mailbox, std::nullopt);
    return frame ? can::decode_feedback(can::kFullProfile, *frame) : std::nullopt;
  }

  Board board;
  std::optional<Joint<Board>> joint;
  std::optional<can::Frame> report;  // the first frame after power-up
};

TEST_F(JointTest, WakesHoldingTheAngleAtWhichItIsFound) {
  power_up(0, -4321);  // -0.4321 rad
  EXPECT_EQ(joint->controller().reference_count(), -432);
  run(5);
  EXPECT_LE(std::abs(board.torque_Nm), kStiffness_Nm_per_rad * kCount_rad / 2);
  EXPECT_EQ(joint->controller().state(), can::JointState::holding);
}

TEST_F(JointTest, SaysThatItHasStarted) {
  power_up();
  ASSERT_TRUE(report);
  const auto faults = can::decode_fault_report(can::kFullProfile, *report);
  ASSERT_TRUE(faults);
  EXPECT_EQ(faults->node, kNode);
  EXPECT_EQ(faults->faults, static_cast<int>(can::Fault::restarted));
}

TEST_F(JointTest, AnswersASyncAsSoonAsItsWorkRuns) {
  power_up();
  run(3);
  receive(can::Sync{1, 0});
  EXPECT_FALSE(board.mailbox) << "the CAN interrupt only stores";
  joint->on_work();
  const auto feedback = sent();
  ASSERT_TRUE(feedback);
  EXPECT_EQ(feedback->node, kNode);
  joint->on_work();
  EXPECT_FALSE(board.mailbox);
}

TEST_F(JointTest, WithoutItsWorkTheServoTickTakesFramesInAndAnswers) {
  power_up();
  receive(can::Sync{1, 0});
  run(1);
  EXPECT_TRUE(sent());
}

TEST_F(JointTest, AFrameInTheMailboxIsNeverOverwritten) {
  power_up();
  receive(can::Sync{1, 0});
  joint->on_work();
  ASSERT_TRUE(board.mailbox);
  const can::Frame first = *board.mailbox;
  board.sensors.encoder_count = 500;
  run(9);
  receive(can::Sync{1, 1});
  run(1);
  EXPECT_EQ(*board.mailbox, first);
  board.mailbox.reset();
  joint->on_work();  // the transmit interrupt
  const auto next = sent();
  ASSERT_TRUE(next);
  EXPECT_NE(next->position, 0);
}

// A movement of ten slots that began when its frame came in, not when the frame was taken in.
TEST_F(JointTest, TheTimeOfAFrameIsThatOfItsReception) {
  power_up(1000);
  receive(can::UserCommand{kNode, 100, 10});
  board.counter += 700;
  joint->on_servo_tick();
  EXPECT_NEAR(joint->controller().reference_rad(), 100 * kCount_rad * 0.7 / 100.0, 1e-12);
}

TEST_F(JointTest, TheCounterMayWrapAtAnyInstant) {
  for (const std::uint32_t before : {0U, 1U, 500U, 700U, 1500U}) {
    power_up(0U - before);
    receive(can::UserCommand{kNode, 100, 10});
    board.counter += 700;
    joint->on_servo_tick();
    EXPECT_NEAR(joint->controller().reference_rad(), 100 * kCount_rad * 0.7 / 100.0, 1e-12) << before;
    run(200);
    EXPECT_NEAR(joint->controller().reference_rad(), 100 * kCount_rad, 1e-12) << before;
  }
}

TEST_F(JointTest, AFrameThatInterruptsTheServoTickIsTakenInAfterIt) {
  power_up();
  run(1);
  board.while_reading = [this] {
    receive(can::EmergencyStop{can::StopMode::soft});
    board.counter += 20;  // the tick takes its time
  };
  board.sensors.encoder_count = 1000;
  run(1);
  EXPECT_LT(board.torque_Nm, -1.0) << "this step began before";
  EXPECT_EQ(joint->controller().state(), can::JointState::holding);
  joint->on_work();
  EXPECT_EQ(joint->controller().state(), can::JointState::soft);
  EXPECT_EQ(board.torque_Nm, 0.0) << "at once";
  run(1);
  EXPECT_EQ(board.torque_Nm, 0.0);
}

TEST_F(JointTest, AnEmergencyStopEndsByTheUsersOrderWhereTheJointIs) {
  power_up();
  receive(can::EmergencyStop{can::StopMode::soft});
  board.sensors.encoder_count = 2000;
  run(10);
  EXPECT_EQ(board.torque_Nm, 0.0);
  joint->reset();
  run(1);
  EXPECT_EQ(joint->controller().state(), can::JointState::holding);
  EXPECT_EQ(joint->controller().reference_count(), 200);
}

TEST_F(JointTest, FramesThatFindNoRoomAreCounted) {
  power_up();
  for (int frame = 0; frame < 40; ++frame) {
    receive(can::Heartbeat{});
  }
  EXPECT_EQ(joint->dropped_frames(), 8U);
  run(1);
  receive(can::Sync{1, 0});
  run(1);
  EXPECT_TRUE(sent());
}

TEST_F(JointTest, OnlyAServoTickThatRanToItsEndFeedsTheWatchdog) {
  power_up();
  receive(can::Sync{1, 0});
  joint->on_work();
  EXPECT_EQ(board.fed, 0);
  run(7);
  EXPECT_EQ(board.fed, 7);
}

}  // namespace
}  // namespace gaitway::firmware
