// The release of an emergency stop in the profile that has no message of its own for it.
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

using Kind = msgclient::UserCommandKind;

class PaperReleaseTest : public MessageControllerTest {
 protected:
  PaperReleaseTest() : MessageControllerTest("paper") {}
};

TEST_F(PaperReleaseTest, TheJointsHoldAgain) {
  run_until(kCycle_ns);
  command(Kind::emergency_stop_hold);
  run_until(now_ns_ + 3 * kSlot_ns);
  EXPECT_EQ(bus_.joint(0).state(), can::JointState::stopped);
  const msgclient::UserCommandMail mail{.sequence = ++commands_, .kind = Kind::release};
  ASSERT_TRUE(adapter_.host().post(mail, now_ns_));
  run_until(now_ns_ + 8 * kSlot_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->verdict, Verdict::accepted);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(bus_.joint(0).state(), can::JointState::holding);
}

// The next cycle begins before the joints, which move again, have confirmed their release.
TEST_F(PaperReleaseTest, NothingOfBeforeTheStopIsPlayed) {
  msgclient::HandOver plan = batch(2);
  for (int point = 0; point < static_cast<int>(plan.point_count); ++point) {
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      if (robot_.joints[joint].node > 12) {
        plan.set_position(point, static_cast<int>(joint), static_cast<float>(robot_.joints[joint].home_rad));
      }
    }
  }
  run_until(2 * kCycle_ns - 16 * kMillisecond_ns);
  ASSERT_TRUE(adapter_.host().post(plan, now_ns_));
  run_until(now_ns_ + 3 * kMillisecond_ns);
  ASSERT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  command(Kind::emergency_stop_hold);
  run_until(2 * kCycle_ns - 7 * kMillisecond_ns);
  ASSERT_TRUE(adapter_.host().post(msgclient::UserCommandMail{.sequence = ++commands_, .kind = Kind::release},
                                   now_ns_));
  run_until(4 * kCycle_ns);
  EXPECT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], 0);
  EXPECT_EQ(bus_.count(0), 0) << "these joints' encoders read 0";
}

}  // namespace
}  // namespace gaitway::msgcontroller
