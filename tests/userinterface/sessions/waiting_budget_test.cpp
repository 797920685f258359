// What waits for all clients together, in bytes that it really takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <memory>
#include <string>
#include <vector>

#include "subscription_fixture.hpp"

namespace gaitway::api {
namespace {

using testing::HasSubstr;

constexpr std::size_t kOfAll_bytes = 64 * 1024, kOfOne_bytes = 32 * 1024;

HubOptions small_budget() {
  HubOptions options;
  options.limits.waiting_bytes = kOfOne_bytes;
  options.limits.waiting_bytes_of_all = kOfAll_bytes;
  options.limits.messages_per_s = 1e6;
  return options;
}

class WaitingBudgetTest : public SubscriptionTest {
 protected:
  WaitingBudgetTest() : SubscriptionTest(small_budget()) {}

  static void ask(TestClient& asking) { asking.send({{"op", "dance"}}); }
  [[nodiscard]] std::size_t waiting_bytes() const { return hub.statistics().waiting_bytes; }
  // Asks, and reads nothing, until so many bytes wait for it.
  void leave_unread(TestClient& asking, std::size_t bytes) {
    for (const std::size_t before = waiting_bytes(); waiting_bytes() < before + bytes;) {
      ask(asking);
    }
  }
};

TEST_F(WaitingBudgetTest, WhoLeavesMostUnreadIsCutFirst) {
  const auto greedy = connect("greedy"), slow = connect("slow"), late = connect("late");
  leave_unread(*slow, kOfAll_bytes / 4);
  leave_unread(*greedy, kOfAll_bytes * 3 / 8);
  for (int i = 0; i < 1000 && !greedy->closed; ++i) {
    ask(i % 2 == 0 ? *client : *late);
    ASSERT_LE(waiting_bytes(), kOfAll_bytes);
  }
  ASSERT_TRUE(greedy->closed);
  EXPECT_EQ(greedy->closed->first, 1008);
  EXPECT_THAT(greedy->closed->second, HasSubstr("all clients"));
  EXPECT_LT(waiting_bytes(), kOfAll_bytes * 5 / 8 + 1024) << "what waited for it is gone at once";
  for (const TestClient* const other : {client.get(), slow.get(), late.get()}) {
    EXPECT_FALSE(other->closed);
  }
}

TEST_F(WaitingBudgetTest, PublicationsCountToo) {
  std::vector<std::unique_ptr<TestClient>> clients;
  for (int i = 0; i < 10; ++i) {
    clients.push_back(connect("deaf"));
    clients.back()->subscribe("/zmp", {{"queue_length", 100}});
  }
  for (int i = 0; i < 200; ++i) {
    publish(i);
    client->receive();
    ASSERT_LE(waiting_bytes(), kOfAll_bytes);
  }
  EXPECT_GT(hub.statistics().closed_by_us, 0U);
  EXPECT_FALSE(client->closed);
}

TEST_F(WaitingBudgetTest, WhoHasGoneCountsNoMore) {
  auto other = connect("other");
  leave_unread(*other, 1024);
  other.reset();
  EXPECT_EQ(waiting_bytes(), 0U);
}

TEST_F(SubscriptionTest, SmallPiecesOfAnswersCountWithAllThatTheyTake) {
  constexpr int kCalls = 15;
  client->send({{"op", "call_service"}, {"service", "/rosapi/topics_and_raw_types"}, {"fragment_size", 64}});
  const auto before_bytes = mallinfo2().uordblks;
  const std::size_t counted_before = hub.statistics().waiting_bytes;
  for (int i = 0; i < kCalls; ++i) {
    client->send(
        {{"op", "call_service"}, {"service", "/rosapi/topics_and_raw_types"}, {"fragment_size", 64}});
  }
  const std::size_t counted_bytes = hub.statistics().waiting_bytes - counted_before;
  ASSERT_FALSE(client->closed);
  EXPECT_GT(counted_bytes, 100'000U);
  EXPECT_LE(mallinfo2().uordblks, before_bytes + 2 * counted_bytes) << "as most_memory_bytes() assumes";
}

// An order is kept until the robot answers it.
TEST_F(SubscriptionTest, ArgumentsAreNotKeptWhileAnAnswerIsAwaited) {
  const json large(20'000, json::array());
  client->send({{"op", "call_service"}, {"service", "/stop"}, {"args", large}});
  const auto before_bytes = mallinfo2().uordblks;
  for (int i = 0; i < 20; ++i) {
    client->send({{"op", "call_service"}, {"service", "/stop"}, {"args", large}});
  }
  EXPECT_LE(mallinfo2().uordblks, before_bytes + 100'000);
}

TEST(MostMemory, GrowsWithEveryLimitThatCostsSome) {
  const std::size_t shipped = most_memory_bytes({});
  EXPECT_LT(shipped, std::size_t{384} << 20U);
  for (const auto raise :
       {+[](Limits& limits) { limits.connections *= 2; }, +[](Limits& limits) { limits.message_bytes *= 2; },
        +[](Limits& limits) { limits.waiting_bytes_of_all *= 2; }}) {
    Limits limits;
    raise(limits);
    EXPECT_GT(most_memory_bytes(limits), shipped);
  }
}

}  // namespace
}  // namespace gaitway::api
