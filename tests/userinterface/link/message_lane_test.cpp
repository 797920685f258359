// One lane by itself: windows, losses, repetitions.
#include "gaitway/link/message_lane.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gaitway::link {
namespace {

constexpr std::int64_t kResend_ns = 1000;

Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

struct Lane : testing::Test {
  // What the sender says now and what is not lost of it arrives at once.
  void move(std::int64_t now_ns, bool lost = false, std::uint32_t limit = 100) {
    while (const auto part = sender->next(now_ns)) {
      if (lost) continue;
      if (const auto message = receiver->take(*part, limit)) {
        arrived.emplace_back(message->begin(), message->end());
      }
    }
  }
  void confirm(std::int64_t now_ns, std::uint32_t limit = 100) {
    sender->confirm(receiver->position(), limit, now_ns);
  }
  std::unique_ptr<MessageSender> sender = std::make_unique<MessageSender>(8, kResend_ns);
  std::unique_ptr<MessageReceiver> receiver = std::make_unique<MessageReceiver>();
  std::vector<std::string> arrived;
};

TEST_F(Lane, SendsNothingBeforeThereIsRoom) {
  EXPECT_EQ(sender->push(bytes_of("head "), bytes_of("body of it")), 1U);
  EXPECT_FALSE(sender->next(0));
  confirm(0, 1);
  move(0);
  EXPECT_EQ(arrived, std::vector<std::string>{"head body of it"});
  EXPECT_EQ(sender->confirmed(), 0U);
  confirm(0);
  EXPECT_EQ(sender->confirmed(), 1U);
}

TEST_F(Lane, GoesBackToWhatIsNotConfirmed) {
  confirm(0);
  sender->push({}, bytes_of("one"));
  sender->push({}, bytes_of("two"));
  move(0, true);
  move(kResend_ns - 1);
  EXPECT_TRUE(arrived.empty());
  move(kResend_ns);
  EXPECT_EQ(arrived, (std::vector<std::string>{"one", "two"}));
  move(2 * kResend_ns);  // the confirmation was lost: all comes again
  EXPECT_EQ(arrived.size(), 2U);
  EXPECT_EQ(receiver->repeated(), 2U);
  EXPECT_EQ(sender->resends(), 2U);
}

TEST_F(Lane, ConfirmsPartsOfLongMessages) {
  confirm(0);
  sender->push({}, bytes_of(std::string(20, 'x')));
  ASSERT_TRUE(receiver->take(*sender->next(0), 100) == std::nullopt);
  confirm(0);
  move(0, true);
  move(kResend_ns);
  EXPECT_EQ(arrived, std::vector<std::string>{std::string(20, 'x')});
  EXPECT_EQ(receiver->repeated(), 0U);
}

TEST_F(Lane, HoldsAsManyAsItMay) {
  for (std::uint32_t i = 0; i < kLaneMessages; ++i) {
    EXPECT_EQ(sender->push({}, bytes_of("x")), i + 1);
  }
  EXPECT_EQ(sender->push({}, bytes_of("x")), 0U);
  EXPECT_EQ(MessageSender(8, 1).push({}, bytes_of(std::string(kMostMessageBytes + 1, 'x'))), 0U);
}

TEST_F(Lane, IgnoresConfirmationsOfWhatWasNeverSent) {
  sender->push({}, bytes_of("x"));
  sender->confirm({50, 0}, 100, 0);
  EXPECT_EQ(sender->confirmed(), 0U);
  move(0);
  EXPECT_EQ(arrived.size(), 1U);
}

TEST_F(Lane, IgnoresConfirmationsOfPartsThatTheMessageDoesNotHave) {
  sender->push({}, bytes_of("one"));
  sender->push({}, bytes_of("two"));
  confirm(0);
  move(0, true);
  sender->confirm({1, 200}, 100, 0);
  sender->confirm({2, 1}, 100, 0);
  for (const std::string expected : {"one", "two"}) {
    const auto part = sender->next(kResend_ns);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->part, 0);
    EXPECT_EQ(std::string(part->payload.begin(), part->payload.end()), expected);
  }
}

TEST_F(Lane, LeavesOutWhatIsBeyondItsLimit) {
  confirm(0);
  sender->push({}, bytes_of("one"));
  sender->push({}, bytes_of("two"));
  move(0, false, 1);
  EXPECT_EQ(arrived.size(), 1U);
  EXPECT_EQ(receiver->early(), 1U);
}

}  // namespace
}  // namespace gaitway::link
