// Stops between both ends: at once, whatever is full; each once, whatever is repeated or restarted.
#include <gtest/gtest.h>

#include "link_pair.hpp"

namespace gaitway::link::test {
namespace {

struct Stop : testing::Test {
  Stop() { link.run(200 * kMs); }
  void obey() { link.controller->stops_obeyed(link.controller->stops_asked()); }
  LinkPair link;
};

TEST_F(Stop, IsHeardAndAnswered) {
  link.module->stop(StopKind::emergency_hold);
  link.run(3 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{0, 1, 0}));
  EXPECT_EQ(link.module->stops().obeyed(), (StopCounts{}));
  obey();
  link.run(3 * kMs);
  EXPECT_EQ(link.module->stops().obeyed(), (StopCounts{0, 1, 0}));
}

TEST_F(Stop, IsNotHeldUpByOrdersThatFillEverything) {
  while (link.submit(std::string(kMostOrderBytes, 'x'), 5000 * kMs).refusal == Refusal::none) {
  }
  link.run(3 * kMs);
  link.module->stop(StopKind::stop);
  // A frame of an order and the wire's 256 bytes are ahead of it, 1 µs each.
  link.run(500'000, 100'000);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{1, 0, 0}));
}

TEST_F(Stop, IsNotHeldUpByOrdersThatNobodyFetches) {
  for (std::size_t i = 0; i < kMostOpenOrders; ++i) {
    ASSERT_EQ(link.submit("order", 5000 * kMs).refusal, Refusal::none);
  }
  link.run(100 * kMs);
  link.module->stop(StopKind::emergency_soft);
  link.run(2 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{0, 0, 1}));
}

TEST_F(Stop, AFloodIsTakenWhole) {
  for (int i = 0; i < 5000; ++i) link.module->stop(StopKind::stop);
  link.module->stop(StopKind::emergency_hold);
  link.run(3 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{5000, 1, 0}));
}

TEST_F(Stop, IsSaidAgainUntilItIsObeyedAndCountedOnce) {
  link.module->stop(StopKind::stop);
  link.run(100 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{1, 0, 0}));
  const std::uint64_t frames = link.module->statistics().sent_frames;
  obey();
  link.run(100 * kMs);
  EXPECT_LE(link.module->statistics().sent_frames, frames + 8);  // statuses alone
}

TEST_F(Stop, OfAnOutageIsTheFirstThingThatIsHeardBehindIt) {
  link.wire.cut(true);
  link.run(2000 * kMs);
  link.module->stop(StopKind::emergency_hold);
  link.run(100 * kMs);
  link.wire.cut(false);
  link.run(150 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{0, 1, 0}));
}

TEST_F(Stop, WhoseAnswerWasLostInAnOutageIsNotObeyedTwice) {
  link.module->stop(StopKind::stop);
  link.run(2 * kMs);
  ASSERT_EQ(link.controller->stops_asked(), (StopCounts{1, 0, 0}));
  link.wire.cut(true);
  obey();
  link.run(1000 * kMs);
  link.wire.cut(false);
  link.run(300 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{1, 0, 0}));
  EXPECT_EQ(link.module->stops().obeyed(), (StopCounts{1, 0, 0}));
}

TEST_F(Stop, OfAnEarlierRunOfTheControllerIsNotObeyedAgain) {
  link.module->stop(StopKind::stop);
  link.run(3 * kMs);
  obey();
  link.run(3 * kMs);
  link.restart_controller();
  link.run(200 * kMs);
  link.module->stop(StopKind::stop);
  link.run(5 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{1, 0, 0}));
}

TEST_F(Stop, OfARestartedModuleIsCountedBesideTheOldOnes) {
  link.module->stop(StopKind::stop);
  link.run(3 * kMs);
  obey();
  link.restart_module();
  link.run(200 * kMs);
  link.module->stop(StopKind::stop);
  link.run(3 * kMs);
  EXPECT_EQ(link.controller->stops_asked(), (StopCounts{2, 0, 0}));
  EXPECT_EQ(link.module->stops().obeyed(), (StopCounts{}));
  obey();
  link.run(3 * kMs);
  EXPECT_EQ(link.module->stops().obeyed(), (StopCounts{1, 0, 0}));
}

// Also when a module that has been taken over has said so many that the next one's go round.
TEST(StopCounts, GoRound) {
  constexpr std::uint32_t kLast = 0xFFFF'FFFF;
  StopListener listener;
  for (const std::uint32_t count : {kLast / 2, kLast - 1}) {
    listener.on_stop({.asked = {count, 0, 0}, .settled = {}}, 11);
  }
  listener.obeyed(listener.asked());
  ASSERT_EQ(listener.next()->obeyed, (StopCounts{kLast - 1, 0, 0}));
  for (const std::uint32_t count : {kLast, 0U, 1U}) {
    listener.on_stop({.asked = {count, 0, 0}, .settled = {count - 1, 0, 0}}, 11);
    EXPECT_EQ(listener.asked(), (StopCounts{count, 0, 0}));
    EXPECT_EQ(listener.next()->obeyed, (StopCounts{count - 1, 0, 0}));
    listener.obeyed(listener.asked());
    EXPECT_EQ(listener.next()->obeyed, (StopCounts{count, 0, 0}));
  }
  listener.on_stop({.asked = {1, 0, 0}, .settled = {}}, 12);  // of a module that was started anew
  EXPECT_EQ(listener.asked(), (StopCounts{2, 0, 0}));
  EXPECT_EQ(listener.next()->obeyed, (StopCounts{}));
}

TEST(StopCounts, OfTheModuleGoRound) {
  constexpr std::uint32_t kLast = 0xFFFF'FFFF;
  StopAsker asker(1000, {kLast, 0, 0});
  EXPECT_FALSE(asker.next(0));
  asker.ask(StopKind::stop);
  ASSERT_TRUE(asker.next(0));
  EXPECT_EQ(asker.next(2000)->asked, (StopCounts{0, 0, 0}));
  asker.on_answer({{kLast, 0, 0}});
  EXPECT_TRUE(asker.next(4000)) << "it is not obeyed";
  asker.on_answer({{0, 0, 0}});
  EXPECT_FALSE(asker.next(6000));
}

}  // namespace
}  // namespace gaitway::link::test
