// A message controller that starts while the joints stand in the middle of a step, where another one has left
// them: it has to find out where their references are, whatever the bus and single joints do meanwhile.
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

class TakeoverTest : public MessageControllerTest {
 protected:
  // A walk of seven batches whose message controller dies; the joints come to rest by themselves.
  void SetUp() override {
    run_until(2 * kSlot_ns);
    for (std::uint32_t sequence = 2; sequence < 9; ++sequence) {
      run_until(std::int64_t{sequence} * kCycle_ns - 16 * kMillisecond_ns);
      adapter_.host().post(batch(sequence, 40), now_ns_);
      run_until(now_ns_ + 3 * kMillisecond_ns);
      while (adapter_.host().take_answer(now_ns_)) {
      }
    }
    run_until(9 * kCycle_ns - kSlot_ns);
    leave_alone_for(1500);
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      const urdf::Joint& description = robot_.joints[joint];
      bus_.sensors[joint].encoder_count = static_cast<std::int32_t>(
          std::lround(bus_.count(joint) * description.count_rad / description.encoder_count_rad));
    }
    leave_alone_for(30 + (kSlot_ns - now_ns_ % kSlot_ns) / kMillisecond_ns);
  }
  void leave_alone_for(std::int64_t ms) {
    for (const std::int64_t end_ns = now_ns_ + ms * kMillisecond_ns; now_ns_ < end_ns;
         now_ns_ += kMillisecond_ns) {
      step_joints();
    }
  }
  // Nothing that they send arrives.
  void step_joints() {
    can::Frame frame;
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      bus_.joint(joint).step(now_ns_, bus_.sensors[joint]);
      while (bus_.joint(joint).take_frame(frame)) {
      }
    }
  }
  // A millisecond in which neither hears the other.
  void cut(MessageController& controller) {
    can::Frame frame;
    controller.step(now_ns_);
    while (controller.take_frame(frame)) {
    }
    step_joints();
  }
  // A millisecond in which this joint hears nothing, and is heard.
  void pass(MessageController& controller, std::size_t deaf) {
    can::Frame frame;
    controller.step(now_ns_);
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      bus_.joint(joint).step(now_ns_, bus_.sensors[joint]);
    }
    while (controller.take_frame(frame)) {
      controller.on_notice({can::BusNotice::Kind::sent, {frame, now_ns_, now_ns_ + 10'000}});
      for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
        if (joint != deaf) bus_.joint(joint).on_frame(frame, now_ns_ + 10'000);
      }
    }
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      while (bus_.joint(joint).take_frame(frame)) {
        controller.on_frame(frame, now_ns_ + 20'000);
      }
    }
  }
  void expect_all_known(const MessageController& controller, std::size_t except = SIZE_MAX) const {
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      if (joint == except) continue;
      EXPECT_EQ(controller.expected_count(static_cast<int>(joint)), bus_.count(joint)) << joint;
    }
  }

  msgclient::MemoryBlock block_;
  msgclient::EmiAdapter second_adapter_{block_};
  msgclient::Client second_client_ = block_.local_client("message_controller");
  MessageController fresh_{robot_, second_client_, second_adapter_.message()};
};

// Longer than it takes to believe that a joint is not there, while they all are on their way to being stiff.
TEST_F(TakeoverTest, ABusThatComesAndGoesIsWaitedForAndNoJointIsTakenForHome) {
  int ms = 0;
  for (; ms < 1000 && !fresh_.joints_known(); ++ms, now_ns_ += kMillisecond_ns) {
    if (ms < 40 || ms >= 90) {
      bus_.millisecond(fresh_, now_ns_);
    } else {
      cut(fresh_);
    }
  }
  EXPECT_GE(ms, 90);
  EXPECT_LT(ms, 400);
  expect_all_known(fresh_);
}

TEST_F(TakeoverTest, AJointThatHearsNothingKeepsTheOthersWaitingForSecondsAtMost) {
  constexpr std::size_t kDeaf = 20;
  int ms = 0;
  for (; ms < 10'000 && !fresh_.joints_known(); ++ms, now_ns_ += kMillisecond_ns) {
    pass(fresh_, kDeaf);
  }
  EXPECT_LT(ms, 4000);
  expect_all_known(fresh_, kDeaf);
}

}  // namespace
}  // namespace gaitway::msgcontroller
