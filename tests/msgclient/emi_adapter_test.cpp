// The EMI adapter: mails, answers, what a transfer costs, and what each fault does.
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace gaitway::msgclient {
namespace {

constexpr std::int64_t kMillisecond = facts::kMillisecond_ns;

class EmiAdapterTest : public testing::Test {
 protected:
  void SetUp() override {
    hand_over->sequence = 7;
    hand_over->joint_count = 22;
    hand_over->point_count = 148;
    hand_over->trim.channel_count = kTrimChannels;
    for (int point = 0; point < 148; ++point) {
      hand_over->support[static_cast<std::size_t>(point)] = static_cast<std::uint8_t>(point % 3);
      for (int joint = 0; joint < 22; ++joint) {
        hand_over->set_position(point, joint, static_cast<float>(std::sin(0.1 * point + joint)));
      }
    }
  }

  MemoryBlock block;
  EmiAdapter emi{block};
  std::unique_ptr<HandOver> hand_over = std::make_unique<HandOver>();
  std::unique_ptr<HandOver> received = std::make_unique<HandOver>();
};

TEST_F(EmiAdapterTest, CarriesAHandOverAndItsAnswer) {
  const PostResult posted = emi.host().post(*hand_over, 0);
  ASSERT_TRUE(posted);
  ASSERT_EQ(emi.message().take_hand_over(*received, posted.transfer_ns), TakeStatus::mail);
  EXPECT_EQ(received->sequence, 7u);
  EXPECT_EQ(received->position_at(147, 21), hand_over->position_at(147, 21));
  EXPECT_EQ(emi.message().take_hand_over(*received, kMillisecond), TakeStatus::none) << "taken once";

  EXPECT_FALSE(emi.host().take_answer(kMillisecond));
  for (const Answer& answer :
       {Answer{MailKind::hand_over, 7, Verdict::accepted},
        Answer{MailKind::hand_over, 8, Verdict::late, Reason::too_late},
        Answer{MailKind::hand_over, 9, Verdict::refused, Reason::too_fast, 3, 12, -140.0F}}) {
    ASSERT_TRUE(emi.message().answer(answer));
    EXPECT_EQ(emi.host().take_answer(2 * kMillisecond), answer);
  }
  EXPECT_FALSE(emi.host().take_answer(2 * kMillisecond));
}

TEST_F(EmiAdapterTest, ChargesFiftyNanosecondsAWordAndShowsTheMailAfterwards) {
  const PostResult posted = emi.host().post(*hand_over, 5 * kMillisecond);
  const std::size_t words = hand_over_words(22, 148, kTrimChannels) + 4;
  EXPECT_EQ(posted.transfer_ns, static_cast<std::int64_t>(words) * 50);
  EXPECT_LT(posted.transfer_ns, 200'000) << "well below 1 ms";
  EXPECT_EQ(emi.host().statistics().words, words);
  EXPECT_EQ(emi.host().statistics().busy_ns, posted.transfer_ns);
  EXPECT_EQ(emi.message().take_hand_over(*received, 5 * kMillisecond + posted.transfer_ns - 1),
            TakeStatus::none);
  EXPECT_EQ(emi.message().take_hand_over(*received, 5 * kMillisecond + posted.transfer_ns), TakeStatus::mail);
}

TEST_F(EmiAdapterTest, TransfersWaitForEachOther) {
  const std::int64_t first = emi.host().post(*hand_over, 0).transfer_ns;
  const std::int64_t read = *emi.host().charge_read(sizeof(JointStates), 0);
  EXPECT_EQ(read, first + static_cast<std::int64_t>(sizeof(JointStates)) / 4 * 50);
  EXPECT_EQ(*emi.host().charge_read(4, kMillisecond), 50) << "the bus is free again";
}

TEST(EmiTiming, FollowsClockAndCycles) {
  EXPECT_EQ((EmiTiming{.clock_hz = 50'000'000, .setup_cycles = 2, .strobe_cycles = 4, .hold_cycles = 2})
                .transfer_ns(10),
            1600);
  EXPECT_EQ((EmiTiming{.clock_hz = 3'000'000'000}).transfer_ns(1), 2) << "rounded up";
  MemoryBlock block;
  EXPECT_THROW((EmiAdapter{block, EmiTiming{.clock_hz = 0}}), TopicError);
}

TEST_F(EmiAdapterTest, AnOccupiedMailboxRefuses) {
  ASSERT_TRUE(emi.host().post(*hand_over, 0));
  hand_over->sequence = 8;
  EXPECT_EQ(emi.host().post(*hand_over, kMillisecond).status, PostStatus::occupied);
  EXPECT_EQ(emi.host().statistics().occupied, 1u);
  EXPECT_TRUE(emi.host().post(UserCommandMail{.sequence = 1}, kMillisecond)) << "each mailbox for itself";
  ASSERT_EQ(emi.message().take_hand_over(*received, 2 * kMillisecond), TakeStatus::mail);
  EXPECT_EQ(received->sequence, 7u) << "the first mail is unharmed";
  EXPECT_TRUE(emi.host().post(*hand_over, 2 * kMillisecond));
}

TEST_F(EmiAdapterTest, CarriesTrimsAndUserCommands) {
  TrimUpdate trim{.stamp_ns = -1'234'567'890'123,
                  .channel_count = 8,
                  .angle = {0.1F, -0.2F, 0, 0, 0, 0, 0, 0.3F},
                  .softness = 0.75F};
  const UserCommandMail command{.sequence = 3,
                                .kind = UserCommandKind::manual_joint,
                                .joint = 5,
                                .position = -0.25F,
                                .duration_slots = 40};
  ASSERT_TRUE(emi.host().post(trim, 0));
  ASSERT_TRUE(emi.host().post(command, 0));
  TrimUpdate trim_received;
  UserCommandMail command_received;
  EXPECT_EQ(emi.message().take_trim(trim_received, kMillisecond), TakeStatus::mail);
  EXPECT_EQ(emi.message().take_user_command(command_received, kMillisecond), TakeStatus::mail);
  EXPECT_EQ(trim_received, trim);
  EXPECT_EQ(command_received, command);
  trim.channel_count = 9;
  EXPECT_EQ(emi.host().post(trim, kMillisecond).status, PostStatus::invalid);
}

TEST_F(EmiAdapterTest, FlippedBitsAreFoundAndAnsweredAsCorrupt) {
  for (std::uint32_t word = 0; word < hand_over_words(22, 148, kTrimChannels); word += 97) {
    emi.host().faults().flip_next = EmiFaults::Flip{MailKind::hand_over, word, 1u << (word % 32)};
    ASSERT_TRUE(emi.host().post(*hand_over, word * kMillisecond));
    EXPECT_EQ(emi.message().take_hand_over(*received, (word + 1) * kMillisecond), TakeStatus::corrupt);
    const auto answer = emi.host().take_answer((word + 1) * kMillisecond);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->verdict, Verdict::corrupt);
    EXPECT_EQ(answer->reason, Reason::checksum);
  }
  ASSERT_TRUE(emi.host().post(*hand_over, 10'000 * kMillisecond)) << "the next one is whole again";
  EXPECT_EQ(emi.message().take_hand_over(*received, 10'001 * kMillisecond), TakeStatus::mail);
}

TEST_F(EmiAdapterTest, FlippedBitsInSmallMailsAreFound) {
  emi.host().faults().flip_next = EmiFaults::Flip{MailKind::trim, 4, 0x80000000};
  ASSERT_TRUE(emi.host().post(TrimUpdate{.channel_count = 8}, 0));
  TrimUpdate trim;
  EXPECT_EQ(emi.message().take_trim(trim, kMillisecond), TakeStatus::corrupt);
  emi.host().faults().flip_next = EmiFaults::Flip{MailKind::user_command, 1, 1};
  ASSERT_TRUE(emi.host().post(UserCommandMail{.sequence = 6, .kind = UserCommandKind::stop}, kMillisecond));
  UserCommandMail command;
  EXPECT_EQ(emi.message().take_user_command(command, 2 * kMillisecond), TakeStatus::corrupt);
  const auto answer = emi.host().take_answer(2 * kMillisecond);
  ASSERT_TRUE(answer) << "a damaged user command is answered, a damaged trim is replaced by the next";
  EXPECT_EQ(answer->mail, MailKind::user_command);
  EXPECT_EQ(answer->sequence, 6u);
  EXPECT_EQ(emi.message().corrupt(), 2u);
}

TEST_F(EmiAdapterTest, ALostDoorbellDelaysTheMailUntilTheNextOneRings) {
  emi.host().faults().lose_doorbells = 1;
  ASSERT_TRUE(emi.host().post(*hand_over, 0));
  EXPECT_EQ(emi.message().take_hand_over(*received, 5 * kMillisecond), TakeStatus::none);
  ASSERT_TRUE(emi.host().post(TrimUpdate{}, 10 * kMillisecond));
  EXPECT_EQ(emi.message().take_hand_over(*received, 11 * kMillisecond), TakeStatus::mail);
}

TEST_F(EmiAdapterTest, AnOccupiedPostRingsForTheMailThatWaits) {
  emi.host().faults().lose_doorbells = 1;
  ASSERT_TRUE(emi.host().post(*hand_over, 0));
  EXPECT_EQ(emi.host().post(*hand_over, 80 * kMillisecond).status, PostStatus::occupied);
  EXPECT_EQ(emi.message().take_hand_over(*received, 81 * kMillisecond), TakeStatus::mail);
}

TEST_F(EmiAdapterTest, ALostDoorbellOfAnAnswerLosesNoAnswer) {
  emi.message().faults().lose_doorbells = 1;
  ASSERT_TRUE(emi.message().answer({MailKind::hand_over, 1}));
  EXPECT_FALSE(emi.host().take_answer(0));
  ASSERT_TRUE(emi.message().answer({MailKind::hand_over, 2}));
  EXPECT_EQ(emi.host().take_answer(0)->sequence, 1u);
  EXPECT_EQ(emi.host().take_answer(0)->sequence, 2u);
}

TEST_F(EmiAdapterTest, AStuckBusRefusesAllTransfersAndCharges) {
  emi.host().faults().bus_stuck = true;
  ASSERT_TRUE(emi.message().answer({MailKind::hand_over, 1}));
  EXPECT_EQ(emi.host().post(*hand_over, 0).status, PostStatus::bus_stuck);
  EXPECT_FALSE(emi.host().charge_read(100, 0));
  EXPECT_FALSE(emi.host().take_answer(0));
  EXPECT_EQ(emi.host().statistics().words, 0u);
  EXPECT_EQ(emi.host().statistics().stuck, 3u);
  EXPECT_EQ(emi.message().take_hand_over(*received, kMillisecond), TakeStatus::none);
  emi.host().faults().bus_stuck = false;
  EXPECT_TRUE(emi.host().post(*hand_over, kMillisecond));
  EXPECT_EQ(emi.host().take_answer(kMillisecond)->sequence, 1u);
}

TEST_F(EmiAdapterTest, AnswersThatNobodyTakesHoldBackFurtherHandOvers) {
  for (std::uint32_t i = 0; i < kAnswerSlots; ++i) {
    ASSERT_TRUE(emi.message().answer({MailKind::hand_over, i}));
  }
  EXPECT_FALSE(emi.message().answer({MailKind::hand_over, 99}));
  ASSERT_TRUE(emi.host().post(*hand_over, 0));
  EXPECT_EQ(emi.message().take_hand_over(*received, kMillisecond), TakeStatus::none);
  EXPECT_EQ(emi.host().take_answer(kMillisecond)->sequence, 0u);
  EXPECT_EQ(emi.message().take_hand_over(*received, kMillisecond), TakeStatus::mail);
}

TEST_F(EmiAdapterTest, ARestartedHostGoesOnWhereTheOldOneEnded) {
  MemoryBlock other;
  EmiMessage message = [&] {
    Client client = other.local_client("message_controller");
    return EmiMessage(client);
  }();
  Client main = other.local_client("main_controller");
  auto host = std::make_unique<EmiHost>(main);
  ASSERT_TRUE(host->post(*hand_over, 0));
  ASSERT_TRUE(message.answer({MailKind::hand_over, 7}));
  EXPECT_THROW(EmiHost second(main), TopicError) << "one host at a time";
  host.reset();
  EmiHost restarted(main);
  EXPECT_EQ(restarted.post(*hand_over, kMillisecond).status, PostStatus::occupied);
  EXPECT_EQ(message.take_hand_over(*received, kMillisecond), TakeStatus::mail);
  EXPECT_EQ(restarted.take_answer(kMillisecond)->sequence, 7u);
  EXPECT_TRUE(restarted.post(*hand_over, 2 * kMillisecond));
}

TEST(Reasons, EachHasItsOwnText) {
  for (std::uint32_t i = 0; i <= static_cast<std::uint32_t>(Reason::node_fault); ++i) {
    EXPECT_NE(reason_text(static_cast<Reason>(i)), "unknown reason") << i;
  }
  EXPECT_NE(reason_text(Reason::not_stopped), "unknown reason");
  EXPECT_NE(reason_text(Reason::releasing), "unknown reason");
  EXPECT_EQ(reason_text(static_cast<Reason>(1000)), "unknown reason");
}

}  // namespace
}  // namespace gaitway::msgclient
