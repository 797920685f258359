// State on its way: conflated, fair, complete, and converging whatever was lost.
#include <gtest/gtest.h>

#include "link_pair.hpp"

namespace gaitway::link::test {
namespace {

constexpr std::size_t kSmall = 0, kLarge = 1, kText = 2;

struct State : testing::Test {
  State() { link.run(200 * kMs); }
  void publish(std::size_t channel, std::string_view value) {
    ASSERT_TRUE(link.controller->publish(channel, bytes_of(value), link.robot_ns()));
  }
  [[nodiscard]] std::string received(std::size_t channel) const {
    return text_of(link.module->state().value(channel).bytes);
  }
  LinkPair link;
};

TEST_F(State, ArrivesWithItsStamp) {
  const std::int64_t stamp_ns = link.robot_ns();
  publish(kText, "stands");
  link.run(3 * kMs);
  EXPECT_EQ(link.module->state().next_changed(), kText);
  EXPECT_EQ(link.module->state().next_changed(), std::nullopt);
  EXPECT_EQ(received(kText), "stands");
  EXPECT_EQ(link.module->state().value(kText).stamp_ns, stamp_ns);
  EXPECT_EQ(link.module->state().value(kText).updates, 1U);
}

TEST_F(State, AnEmptyValueIsOne) {
  publish(kText, "");
  link.run(3 * kMs);
  EXPECT_EQ(link.module->state().next_changed(), kText);
  EXPECT_EQ(received(kText), "");
}

TEST_F(State, OfWhichThereIsTooMuchIsRefused) {
  EXPECT_FALSE(link.controller->publish(kSmall, bytes_of(std::string(41, 'x')), 0));
  EXPECT_FALSE(link.controller->publish(kChannels.size(), {}, 0));
}

TEST_F(State, TheNewestValueWins) {
  for (int i = 0; i < 100; ++i) publish(kText, std::to_string(i));
  link.run(10 * kMs);
  EXPECT_EQ(received(kText), "99");
  EXPECT_LE(link.module->state().value(kText).updates, 2U);
}

TEST_F(State, ALargeValueDoesNotHoldUpASmallOne) {
  publish(kLarge, std::string(3000, 'l'));
  link.run(500'000, 100'000);
  publish(kSmall, "s");
  link.run(2 * kMs, 100'000);
  EXPECT_EQ(received(kSmall), "s");
  EXPECT_EQ(received(kLarge), "");
  link.run(20 * kMs);
  EXPECT_EQ(received(kLarge), std::string(3000, 'l'));
}

TEST_F(State, ALargeValueArrivesThoughNewerOnesCome) {
  for (int i = 0; i < 200; ++i) {
    publish(kLarge, std::string(3000, static_cast<char>('a' + i % 26)));
    link.run(kMs);
    const std::string value = received(kLarge);
    ASSERT_EQ(value, std::string(value.size(), value.empty() ? ' ' : value.front())) << "two versions mixed";
  }
  EXPECT_GE(link.module->state().value(kLarge).updates, 5U);
}

TEST_F(State, AnswersGoAheadOfIt) {
  publish(kLarge, std::string(3000, 'l'));
  ASSERT_EQ(link.submit("order").refusal, Refusal::none);
  link.run(2 * kMs);
  const auto order = link.controller->next_order(link.robot_ns());
  ASSERT_TRUE(order);
  ASSERT_TRUE(link.controller->answer(order->id, 0, {}));
  link.run(3 * kMs);
  EXPECT_EQ(link.outcomes().size(), 1U);
  EXPECT_EQ(received(kLarge), "");
}

TEST_F(State, FragmentsThatWereLostAreSentAgainWithoutTheOthers) {
  WireFaults faults;
  faults.lost = 0.002;
  link.wire.set_faults(faults);
  publish(kLarge, std::string(3000, 'l'));
  link.run(300 * kMs);
  EXPECT_EQ(received(kLarge), std::string(3000, 'l'));
  EXPECT_GT(link.controller->state().lost_frames(), 0U);
  EXPECT_TRUE(link.controller->state().settled());
}

TEST_F(State, ConvergesBehindAnOutage) {
  publish(kText, "before");
  link.run(5 * kMs);
  link.wire.cut(true);
  publish(kText, "during");
  publish(kLarge, std::string(3000, 'd'));
  link.run(3000 * kMs);
  EXPECT_EQ(received(kText), "before");
  link.wire.cut(false);
  link.run(200 * kMs);
  EXPECT_EQ(received(kText), "during");
  EXPECT_EQ(received(kLarge), std::string(3000, 'd'));
}

TEST_F(State, IsAllThereForARestartedModule) {
  publish(kText, "old news");
  link.run(1000 * kMs);
  link.restart_module();
  link.run(200 * kMs);
  EXPECT_EQ(received(kText), "old news");
}

TEST_F(State, WindowBoundsWhatIsUnderWay) {
  link.wire.cut(true, true);
  for (int i = 0; i < 100; ++i) {
    publish(kText, std::to_string(i));
    link.run(kMs);
  }
  link.wire.cut(false);
  link.run(10 * kMs);
  EXPECT_EQ(received(kText), "99");
  EXPECT_LE(link.module->state().value(kText).updates, 10U);  // no backlog of what is old
}

}  // namespace
}  // namespace gaitway::link::test
