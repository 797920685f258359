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

}  // namespace
}  // namespace gaitway::link::test
