// Orders between both ends: answered once, refused when late, reported when nobody can answer.
#include <gtest/gtest.h>

#include "allocation_count.hpp"
#include "link_pair.hpp"

namespace gaitway::link::test {
namespace {

// Both ends know each other.
struct OpenLink : testing::Test {
  OpenLink() { link.run(200 * kMs); }
  LinkPair link;
};
using Orders = OpenLink;

TEST_F(Orders, AreCarriedOutAndAnswered) {
  ASSERT_TRUE(link.open());
  const Submission submission = link.submit("walk");
  ASSERT_EQ(submission.refusal, Refusal::none);
  link.run(5 * kMs);
  const std::optional<Order> order = link.controller->next_order(link.robot_ns());
  ASSERT_TRUE(order);
  EXPECT_EQ(text_of(order->payload), "walk");
  EXPECT_EQ(order->kind, 1);
  EXPECT_TRUE(link.controller->answer(order->id, 7, bytes_of("walks")));
  EXPECT_FALSE(link.controller->answer(order->id, 7, bytes_of("again")));
  link.run(5 * kMs);
  const std::optional<Outcome> outcome = link.module->next_outcome(link.now_ns);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->id, submission.id);
  EXPECT_EQ(outcome->verdict, Verdict::answered);
  EXPECT_EQ(outcome->result, 7);
  EXPECT_EQ(text_of(outcome->payload), "walks");
  EXPECT_FALSE(link.module->next_outcome(link.now_ns));
}

TEST_F(Orders, OfTheLargestSizeArriveWhole) {
  std::string text(kMostOrderBytes, 'x');
  text.front() = 'a', text.back() = 'z';
  ASSERT_EQ(link.submit(text).refusal, Refusal::none);
  EXPECT_EQ(link.submit(text + "!").refusal, Refusal::too_long);
  link.run(20 * kMs);
  const std::optional<Order> order = link.controller->next_order(link.robot_ns());
  ASSERT_TRUE(order);
  EXPECT_EQ(text_of(order->payload), text);
}

TEST_F(Orders, KeepTheirSequence) {
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(link.submit(std::to_string(i)).refusal, Refusal::none);
  }
  link.run(50 * kMs);
  for (int i = 0; i < 20; ++i) {
    const std::optional<Order> order = link.controller->next_order(link.robot_ns());
    ASSERT_TRUE(order);
    EXPECT_EQ(text_of(order->payload), std::to_string(i));
  }
}

TEST_F(Orders, ThatAreLateAreRefusedByName) {
  ASSERT_EQ(link.submit("walk", 50 * kMs).refusal, Refusal::none);
  link.run(60 * kMs);  // it has arrived, and nobody fetched it in time
  EXPECT_FALSE(link.controller->next_order(link.robot_ns()));
  EXPECT_EQ(link.controller->late_orders(), 1U);
  link.run(10 * kMs);
  const auto outcomes = link.outcomes();
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].verdict, Verdict::late);
}

TEST_F(Orders, ThatHaveExpiredAreNotSentAtAll) {
  EXPECT_EQ(link.submit("walk", -1 * kMs).refusal, Refusal::expired);
}

TEST_F(Orders, AreRefusedWithoutASession) {
  link.wire.cut(true);
  link.run(300 * kMs);
  EXPECT_EQ(link.submit("walk").refusal, Refusal::no_session);
}

TEST_F(Orders, ThatNobodyAnswersAreReportedInTime) {
  ASSERT_EQ(link.submit("walk", 50 * kMs).refusal, Refusal::none);
  link.run(20 * kMs);
  const std::optional<Order> order = link.controller->next_order(link.robot_ns());
  ASSERT_TRUE(order);
  link.run(520 * kMs);
  EXPECT_TRUE(link.outcomes().empty());
  link.run(15 * kMs);
  const auto outcomes = link.outcomes();
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].verdict, Verdict::unanswered);
  // An answer that comes later frees its place at the controller, and is nobody's news.
  EXPECT_TRUE(link.controller->answer(order->id, 0, {}));
  link.run(20 * kMs);
  EXPECT_TRUE(link.outcomes().empty());
}

TEST_F(Orders, BeyondThePlacesAreRefusedAndFitAgainLater) {
  for (std::size_t i = 0; i < kMostOpenOrders; ++i) {
    ASSERT_EQ(link.submit("order", 2000 * kMs).refusal, Refusal::none);
  }
  EXPECT_EQ(link.submit("one too many").refusal, Refusal::full);
  link.run(100 * kMs);
  while (const std::optional<Order> order = link.controller->next_order(link.robot_ns())) {
    EXPECT_TRUE(link.controller->answer(order->id, 0, {}));
  }
  link.run(100 * kMs);
  EXPECT_EQ(link.outcomes().size(), kMostOpenOrders);
  EXPECT_EQ(link.submit("fits").refusal, Refusal::none);
}

TEST_F(Orders, AreReportedAsUnansweredWhenTheLinkIsCut) {
  ASSERT_EQ(link.submit("walk", 2000 * kMs).refusal, Refusal::none);
  link.wire.cut(true);
  link.run(260 * kMs);
  const auto outcomes = link.outcomes();
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].verdict, Verdict::unanswered);
}

TEST_F(Orders, OfBeforeAnOutageAreNotCarriedOutBehindIt) {
  ASSERT_EQ(link.submit("walk", 60'000 * kMs).refusal, Refusal::none);
  link.wire.cut(true, true);  // it waits in the carrier
  link.run(400 * kMs);
  link.wire.cut(false);
  link.run(300 * kMs);
  ASSERT_TRUE(link.open());
  EXPECT_FALSE(link.controller->next_order(link.robot_ns()));
}

TEST_F(Orders, ThatArrivedBeforeTheControllerSleptAreNotCarriedOutBehindIt) {
  ASSERT_EQ(link.submit("walk", 60'000 * kMs).refusal, Refusal::none);
  link.run(5 * kMs);
  link.now_ns += 400 * kMs;
  EXPECT_FALSE(link.controller->next_order(link.robot_ns()));
}

TEST_F(Orders, ThatWaitedWhileTheControllerSleptAreNotCarriedOutBehindIt) {
  ASSERT_EQ(link.submit("walk", 60'000 * kMs).refusal, Refusal::none);
  const Bytes bytes = link.module->pending(link.now_ns);
  ASSERT_FALSE(bytes.empty());
  link.now_ns += 400 * kMs;
  link.controller->on_bytes(bytes, link.robot_ns());  // the first thing that it does
  EXPECT_FALSE(link.controller->next_order(link.robot_ns()));
}

TEST_F(Orders, SurviveAnOutageThatIsShorterThanTheSilence) {
  link.wire.cut(true);
  ASSERT_EQ(link.submit("walk", 500 * kMs).refusal, Refusal::none);
  link.run(100 * kMs);
  link.wire.cut(false);
  link.run(50 * kMs);
  EXPECT_TRUE(link.controller->next_order(link.robot_ns()));
  EXPECT_FALSE(link.controller->next_order(link.robot_ns()));
}

TEST_F(Orders, OfARestartedModuleAreNotMistakenForItsOldOnes) {
  ASSERT_EQ(link.submit("old", 60'000 * kMs).refusal, Refusal::none);
  link.run(3 * kMs);
  link.restart_module();
  link.run(200 * kMs);
  ASSERT_TRUE(link.open());
  ASSERT_EQ(link.submit("new").refusal, Refusal::none);
  link.run(5 * kMs);
  const std::optional<Order> order = link.controller->next_order(link.robot_ns());
  ASSERT_TRUE(order);
  EXPECT_EQ(text_of(order->payload), "new");
}

TEST_F(Orders, AreReportedWhenTheControllerIsRestarted) {
  ASSERT_EQ(link.submit("walk", 60'000 * kMs).refusal, Refusal::none);
  link.run(3 * kMs);
  link.restart_controller();
  link.run(100 * kMs);
  ASSERT_TRUE(link.open());
  const auto outcomes = link.outcomes();
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_EQ(outcomes[0].verdict, Verdict::unanswered);
  EXPECT_FALSE(link.controller->next_order(link.robot_ns()));
}

TEST_F(Orders, AnswersOfAnEndedSessionGoNowhere) {
  ASSERT_EQ(link.submit("walk", 60'000 * kMs).refusal, Refusal::none);
  link.run(5 * kMs);
  const std::optional<Order> order = link.controller->next_order(link.robot_ns());
  ASSERT_TRUE(order);
  const OrderId id = order->id;
  link.restart_module();
  link.run(200 * kMs);
  EXPECT_FALSE(link.controller->answer(id, 0, {}));
}

TEST_F(Orders, RobotTimeIsNeverAheadOfTheRobots) {
  for (int i = 0; i < 100; ++i) {
    link.run(7 * kMs);
    const std::optional<std::int64_t> robot_ns = link.module->robot_time_ns(link.now_ns);
    ASSERT_TRUE(robot_ns);
    EXPECT_LE(*robot_ns, link.robot_ns());
    EXPECT_GE(*robot_ns, link.robot_ns() - 3 * kMs);
  }
}

TEST_F(Orders, NothingAllocatesOnThePath) {
  const std::vector<std::uint8_t> large(3000, 1);
  link.run(100 * kMs);
  // The test's own wire allocates: bytes go from end to end by hand.
  const long before = gaitway::test::allocation_count();
  for (int i = 0; i < 100; ++i) {
    link.now_ns += kMs;
    link.controller->publish(1, large, link.robot_ns());
    link.module->stop(StopKind::stop);
    static_cast<void>(link.module->submit(1, bytes_of("walk"), link.robot_ns() + kMs, link.now_ns));
    for (Bytes bytes; !(bytes = link.module->pending(link.now_ns)).empty();
         link.module->taken(bytes.size())) {
      link.controller->on_bytes(bytes, link.robot_ns());
    }
    while (const auto order = link.controller->next_order(link.robot_ns())) {
      link.controller->answer(order->id, 0, bytes_of("done"));
    }
    link.controller->stops_obeyed(link.controller->stops_asked());
    for (Bytes bytes; !(bytes = link.controller->pending(link.robot_ns())).empty();
         link.controller->taken(bytes.size())) {
      link.module->on_bytes(bytes, link.now_ns);
    }
    while (link.module->next_outcome(link.now_ns)) {
    }
  }
  EXPECT_EQ(gaitway::test::allocation_count(), before);
  EXPECT_GT(link.module->state().value(1).updates, 0U);
}

}  // namespace
}  // namespace gaitway::link::test
