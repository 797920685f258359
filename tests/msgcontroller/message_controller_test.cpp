// The message controller against a small bus of joints that answer: schedule, repair, resynchronisation, safe
// tail.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "gaitway/can/profile.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"
#include "gaitway/msgclient/cycle.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {
namespace {

using msgclient::kCycle_ns;
using msgclient::kMillisecond_ns;
using msgclient::kSlot_ns;
using msgclient::Verdict;

// All joints' real local controllers; every frame arrives 120 µs after the one before, unless it is dropped.
class JointsOnABus {
 public:
  explicit JointsOnABus(const urdf::RobotModel& robot) : robot_(robot) {
    for (const urdf::Joint& joint : robot.joints) {
      localcontroller::JointConfig config;
      config.node = joint.node;
      config.count_rad = joint.count_rad;
      config.encoder_count_rad = joint.encoder_count_rad;
      config.lower_rad = joint.lower_rad;
      config.upper_rad = joint.upper_rad;
      config.initial_reference_count = home_count(joint);
      joints_.emplace_back(config);
    }
  }
  static std::int32_t home_count(const urdf::Joint& joint) {
    return static_cast<std::int32_t>(std::lround(joint.home_rad / joint.count_rad));
  }

  std::function<bool(const can::Frame&)> drop = [](const can::Frame&) { return false; };
  std::map<can::MessageKind, int> sent;

  void millisecond(MessageController& controller, std::int64_t now_ns) {
    for (localcontroller::JointController& joint : joints_) {
      joint.step(now_ns, {});
    }
    controller.step(now_ns);
    std::int64_t at_ns = now_ns;
    can::Frame frame;
    bool busy = true;
    while (busy) {
      busy = false;
      while (controller.take_frame(frame)) {
        busy = true;
        at_ns += kFrame_ns;
        ++sent[can::kFullProfile.identify(frame.id)->kind];
        if (!drop(frame)) {
          for (localcontroller::JointController& joint : joints_) {
            joint.on_frame(frame, at_ns);
          }
        }
      }
      for (localcontroller::JointController& joint : joints_) {
        while (joint.take_frame(frame)) {
          busy = true;
          controller.on_frame(frame, at_ns);
        }
      }
    }
  }
  [[nodiscard]] std::int32_t count(std::size_t joint) const { return joints_[joint].reference_count(); }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }

 private:
  static constexpr std::int64_t kFrame_ns = 10'000;  // short enough that a burst fits its millisecond
  const urdf::RobotModel& robot_;
  std::vector<localcontroller::JointController> joints_;
};

class MessageControllerTest : public ::testing::Test {
 protected:
  void run_until(std::int64_t time_ns) {
    for (; now_ns_ < time_ns; now_ns_ += kMillisecond_ns) {
      bus_.millisecond(controller_, now_ns_);
      if (every_millisecond) {
        every_millisecond();
      }
    }
  }

  // A batch that moves every joint by one count a point, then a tail of `tail` points that goes on half as
  // fast.
  msgclient::HandOver batch(std::uint32_t sequence, int tail = 20) {
    msgclient::HandOver hand_over;
    hand_over.sequence = sequence;
    hand_over.joint_count = static_cast<std::uint32_t>(robot_.joints.size());
    hand_over.point_count = static_cast<std::uint32_t>(kBatchPoints + tail);
    const int batches_before = static_cast<int>(sequence) - first_sequence_;
    for (int point = 0; point < kBatchPoints + tail; ++point) {
      const int tail_point = std::max(point - kBatchPoints + 1, 0);
      const int moved = 8 * batches_before + std::min(point + 1, kBatchPoints) + tail_point / 2;
      for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
        const urdf::Joint& description = robot_.joints[static_cast<std::size_t>(joint)];
        const double angle = (JointsOnABus::home_count(description) + moved) * description.count_rad;
        hand_over.set_position(point, joint, static_cast<float>(angle));
      }
    }
    return hand_over;
  }
  // Hands over at 64 ms in the cycle before.
  msgclient::Answer hand_over(std::uint32_t sequence, int tail = 20) {
    run_until(std::int64_t{sequence} * kCycle_ns - 16 * kMillisecond_ns);
    const auto mail = std::make_unique<msgclient::HandOver>(batch(sequence, tail));
    EXPECT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    const auto answer = adapter_.host().take_answer(now_ns_);
    EXPECT_TRUE(answer.has_value());
    return answer.value_or(msgclient::Answer{.verdict = Verdict::corrupt});
  }
  // Every joint's count, from its home, is `moved`.
  void expect_moved(std::int32_t moved) {
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      EXPECT_EQ(bus_.count(joint) - JointsOnABus::home_count(robot_.joints[joint]), moved)
          << "joint " << joint;
    }
  }

  urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  msgclient::MemoryBlock block_;
  msgclient::EmiAdapter adapter_{block_};
  msgclient::Client client_ = block_.local_client("message_controller");
  MessageController controller_{robot_, client_, adapter_.message()};
  JointsOnABus bus_{robot_};
  std::int64_t now_ns_ = 0;
  int first_sequence_ = 2;
  std::function<void()> every_millisecond;
};

TEST_F(MessageControllerTest, HoldsAndSendsSyncEverySlotUntilABatchComes) {
  run_until(2 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(bus_.sent[can::MessageKind::sync], 16);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], 0);
  expect_moved(0);
}

TEST_F(MessageControllerTest, ABatchMovesEveryJointByItsCounts) {
  EXPECT_EQ(hand_over(2).verdict, Verdict::accepted);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], static_cast<int>(robot_.joints.size()));
  run_until(2 * kCycle_ns + 3 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(4);
  EXPECT_EQ(controller_.mode(), Mode::batches);
}

TEST_F(MessageControllerTest, ConsecutiveBatchesJoinWithoutAJump) {
  for (std::uint32_t sequence = 2; sequence < 8; ++sequence) {
    ASSERT_EQ(hand_over(sequence).verdict, Verdict::accepted) << sequence;
  }
  run_until(7 * kCycle_ns + 7 * kSlot_ns + 2 * kMillisecond_ns);
  expect_moved(48);
  EXPECT_EQ(controller_.state().tail_played, 0U);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
}

TEST_F(MessageControllerTest, WithoutANewBatchTheSafeTailPlaysToItsEndAndTheJointsHold) {
  hand_over(2, 20);
  run_until(3 * kCycle_ns + kSlot_ns);
  EXPECT_EQ(controller_.mode(), Mode::safe_tail);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(controller_.state().tail_played, 3U);
  expect_moved(8 + 10);
}

TEST_F(MessageControllerTest, ALostTrajectoryFrameIsSentAgainBeforeTheBatchStarts) {
  int lost = 0;
  bus_.drop = [&](const can::Frame& frame) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, frame);
    return trajectory && trajectory->node == 5 && lost++ == 0;
  };
  hand_over(2);
  run_until(2 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  EXPECT_EQ(controller_.state().repaired, 1U);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
  expect_moved(8);
}

TEST_F(MessageControllerTest, AJointThatNeverGotItsFrameIsBackWithinOneSlotOfItsFirstFeedback) {
  bus_.drop = [](const can::Frame& frame) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, frame);
    return trajectory && trajectory->node == 5;
  };
  hand_over(2);
  run_until(2 * kCycle_ns + 1 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(2);
  run_until(2 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(8);
  EXPECT_EQ(controller_.state().resynchronised, 2U) << "one frame has no room for all eight points";
  EXPECT_EQ(controller_.health().trajectories_lost, 2U) << "the frame and its repetition";
}

TEST_F(MessageControllerTest, NoJointStaysOnACountThatIsNotKnownWhateverIsLost) {
  std::uint32_t state = 1;
  bus_.drop = [&state](const can::Frame& frame) {
    state = state * 1664525U + 1013904223U;
    const auto kind = can::kFullProfile.identify(frame.id)->kind;
    const bool may_be_lost = kind == can::MessageKind::trajectory ||
                             kind == can::MessageKind::resynchronisation || kind == can::MessageKind::sync;
    return may_be_lost && (state >> 16U) % 20U == 0;
  };
  for (std::uint32_t sequence = 2; sequence < 40; ++sequence) {
    ASSERT_EQ(hand_over(sequence).verdict, Verdict::accepted) << sequence;
  }
  bus_.drop = [](const can::Frame&) { return false; };
  hand_over(40);
  hand_over(41);
  run_until(41 * kCycle_ns + 7 * kSlot_ns + 2 * kMillisecond_ns);
  expect_moved(320);
  EXPECT_GT(controller_.state().resynchronised, 0U);
}

TEST_F(MessageControllerTest, RefusesALateBatchAndSaysSo) {
  hand_over(2);
  run_until(3 * kCycle_ns - 5 * kMillisecond_ns);
  const auto mail = std::make_unique<msgclient::HandOver>(batch(3));
  adapter_.host().post(*mail, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->verdict, Verdict::late);
  EXPECT_EQ(controller_.state().late, 1U);
}

TEST_F(MessageControllerTest, RefusesABatchThatJumpsAndNamesTheJoint) {
  run_until(2 * kCycle_ns - 16 * kMillisecond_ns);
  auto mail = std::make_unique<msgclient::HandOver>(batch(2));
  mail->set_position(0, 7, mail->position_at(0, 7) + 0.5F);
  adapter_.host().post(*mail, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->verdict, Verdict::refused);
  EXPECT_EQ(answer->reason, msgclient::Reason::jump);
  EXPECT_EQ(answer->joint, 7);
  run_until(3 * kCycle_ns);
  expect_moved(0);
}

TEST_F(MessageControllerTest, ADamagedHandOverIsRefusedAndTheTailPlays) {
  hand_over(2);
  adapter_.host().faults().flip_next = msgclient::EmiFaults::Flip{msgclient::MailKind::hand_over, 100, 0x10};
  EXPECT_EQ(hand_over(3).verdict, Verdict::corrupt);
  run_until(3 * kCycle_ns + kSlot_ns);
  EXPECT_EQ(controller_.mode(), Mode::safe_tail);
}

TEST_F(MessageControllerTest, AStopPlaysTheTailAndRefusesBatchesUntilTheRobotStands) {
  hand_over(2);
  const msgclient::UserCommandMail stop{.sequence = 1, .kind = msgclient::UserCommandKind::stop};
  adapter_.host().post(stop, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  adapter_.host().take_answer(now_ns_);
  EXPECT_EQ(hand_over(3).reason, msgclient::Reason::stopping);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  first_sequence_ = 8;
  expect_moved(18);
}

TEST_F(MessageControllerTest, EmergencyStopReachesTheBusAtOnceAndEndsBatches) {
  hand_over(2);
  run_until(2 * kCycle_ns + 2 * kSlot_ns);
  const msgclient::UserCommandMail stop{.sequence = 1,
                                        .kind = msgclient::UserCommandKind::emergency_stop_hold};
  adapter_.host().post(stop, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  EXPECT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 1);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  const std::int32_t there = bus_.count(0);
  run_until(6 * kCycle_ns);
  EXPECT_EQ(bus_.count(0), there);
  EXPECT_EQ(hand_over(7).reason, msgclient::Reason::emergency_stopped);
}

TEST_F(MessageControllerTest, AManualJointCommandMovesOneJointWhileStanding) {
  run_until(kCycle_ns);
  const double target = robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad;
  const msgclient::UserCommandMail move{.sequence = 1,
                                        .kind = msgclient::UserCommandKind::manual_joint,
                                        .joint = 3,
                                        .position = static_cast<float>(target),
                                        .duration_slots = 10};
  adapter_.host().post(move, now_ns_);
  run_until(3 * kCycle_ns);
  EXPECT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  EXPECT_EQ(bus_.count(3) - JointsOnABus::home_count(robot_.joints[3]), 20);
  EXPECT_EQ(bus_.count(4), JointsOnABus::home_count(robot_.joints[4]));
  EXPECT_EQ(controller_.state().resynchronised, 0U) << "the joint's own movement is no error";
}

TEST_F(MessageControllerTest, RefusesABatchThatWouldBeginDuringAManualMovement) {
  run_until(kCycle_ns);
  const msgclient::UserCommandMail move{.sequence = 1,
                                        .kind = msgclient::UserCommandKind::manual_joint,
                                        .joint = 3,
                                        .position = static_cast<float>(robot_.joints[3].home_rad),
                                        .duration_slots = 30};
  adapter_.host().post(move, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  adapter_.host().take_answer(now_ns_);
  EXPECT_EQ(hand_over(2).reason, msgclient::Reason::moving_by_hand);
  first_sequence_ = 6;
  EXPECT_EQ(hand_over(6).verdict, Verdict::accepted) << "the joint has arrived by then";
}

TEST_F(MessageControllerTest, WritesTrimsOfItsOwnWhenTheMainControllerIsSilent) {
  run_until(2 * kCycle_ns - 16 * kMillisecond_ns);
  auto mail = std::make_unique<msgclient::HandOver>(batch(2));
  mail->trim.channel_count = 8;
  mail->trim.gain[2][0][0] = 0.25F;
  adapter_.host().post(*mail, now_ns_);
  run_until(4 * kCycle_ns);
  EXPECT_GE(bus_.sent[can::MessageKind::trim], 16);
}

}  // namespace
}  // namespace gaitway::msgcontroller
