// Subscriptions: their terms, what a slow client costs, and that nobody pays for another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "subscription_fixture.hpp"

namespace gaitway::api {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(SubscriptionTest, BringsMessagesAsRosbridgeDoes) {
  client->subscribe("/zmp", {{"type", "geometry_msgs/PointStamped"}, {"id", "subscribe:1"}});
  EXPECT_THAT(client->receive(), IsEmpty());
  publish(0.5);
  const json message = client->receive_one();
  EXPECT_EQ(message["op"], "publish");
  EXPECT_EQ(message["topic"], "/zmp");
  EXPECT_EQ(message["msg"]["header"]["frame_id"], "odom");
  EXPECT_EQ(message["msg"]["point"]["x"], 0.5);
}

TEST_F(SubscriptionTest, EveryTopicCanBeSubscribedTo) {
  for (const TopicRow& row : kTopics) {
    client->subscribe(row.name, {{"type", row.type}, {"compression", "cbor"}});
  }
  EXPECT_THAT(client->receive(), IsEmpty());
  EXPECT_EQ(hub.statistics().subscriptions, kTopicCount);
}

TEST_F(SubscriptionTest, CborIsBinary) {
  client->subscribe("/zmp", {{"compression", "cbor"}});
  publish(0.5);
  const auto frame = client->next_frame();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->binary);
  const json message = json::from_cbor(*frame->bytes);
  EXPECT_EQ(message["topic"], "/zmp");
  EXPECT_EQ(message["msg"]["point"]["x"], 0.5);
}

// What Foxglove asks for: it decodes the message by its definition.
TEST_F(SubscriptionTest, CborRawCarriesTheMessageInRos2sOwnEncoding) {
  robot.time_ns = 7'000'000'009;
  client->subscribe("/zmp", {{"compression", "cbor-raw"}});
  publish(0.5);
  const auto frame = client->next_frame();
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->binary);
  const json message = json::from_cbor(*frame->bytes);
  EXPECT_EQ(message["msg"]["secs"], 7);
  EXPECT_EQ(message["msg"]["nsecs"], 9);
  const auto& bytes = message["msg"]["bytes"].get_binary();
  const std::vector<std::uint8_t> encapsulation(bytes.begin(), bytes.begin() + 4);
  EXPECT_EQ(encapsulation, (std::vector<std::uint8_t>{0, 1, 0, 0}));
  double x = 0.0;  // the last three numbers are the point
  std::memcpy(&x, bytes.data() + bytes.size() - 3 * sizeof(double), sizeof x);
  EXPECT_EQ(x, 0.5);
}

TEST_F(SubscriptionTest, NobodyIsServedWithoutSubscription) {
  EXPECT_FALSE(hub.wanted(Topic::zmp));
  publish(1.0);
  EXPECT_EQ(client->wakes, 0);
  EXPECT_THAT(client->receive(), IsEmpty());
  client->subscribe("/zmp");
  EXPECT_TRUE(hub.wanted(Topic::zmp));
  EXPECT_THAT(client->receive(), IsEmpty()) << "not latched";
}

TEST_F(SubscriptionTest, AMessageIsEncodedOnceForAllWhoGetIt) {
  const auto other = connect("bert"), third = connect("carl");
  client->subscribe("/zmp");
  other->subscribe("/zmp");
  third->subscribe("/zmp", {{"compression", "cbor"}});
  publish(1.0);
  const auto a = client->next_frame(), b = other->next_frame(), c = third->next_frame();
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(a->bytes, b->bytes) << "the same bytes, not a copy";
  EXPECT_NE(a->bytes, c->bytes);
}

TEST_F(SubscriptionTest, AMessageOfAnotherTypeIsAMistakeOfOurs) {
  EXPECT_THROW(hub.publish(Topic::zmp, ros::String{"x"}), std::logic_error);
}

TEST_F(SubscriptionTest, LatchedTopicsBringTheirLastMessageAtOnce) {
  publish_description("<old/>");
  publish_description("<robot/>");
  client->subscribe("/robot_description");
  EXPECT_EQ(client->receive_one()["msg"]["data"], "<robot/>");
  const auto other = connect("bert");
  other->subscribe("/robot_description", {{"compression", "cbor"}});
  EXPECT_EQ(other->receive_one()["msg"]["data"], "<robot/>");
}

TEST_F(SubscriptionTest, OnlyTheNewestWaitsUnlessAskedOtherwise) {
  client->subscribe("/zmp", {{"queue_length", 0}});
  publish(1);
  publish(2);
  publish(3);
  EXPECT_THAT(xs(client->receive()), ElementsAre(3));
}

TEST_F(SubscriptionTest, AQueueKeepsTheNewestInTheirOrder) {
  client->subscribe("/zmp", {{"queue_length", 3}});
  for (int i = 1; i <= 5; ++i) {
    publish(i);
  }
  EXPECT_THAT(xs(client->receive()), ElementsAre(3, 4, 5));
}

TEST_F(SubscriptionTest, EventsAreQueuedUnasked) {
  client->subscribe("/events");
  for (std::uint32_t i = 0; i < 20; ++i) {
    ros::Log event;
    event.line = i;
    hub.publish(Topic::events, event);
  }
  EXPECT_THAT(client->receive(), SizeIs(20));
}

TEST_F(SmallBoxTest, ALongerQueueThanThereIsIsTold) {
  client->subscribe("/zmp", {{"queue_length", 1000}, {"id", "q"}});
  const json status = client->receive_one();
  EXPECT_EQ(status["level"], "warning");
  EXPECT_EQ(status["id"], "q");
  for (int i = 1; i <= 15; ++i) {
    publish(i);
  }
  EXPECT_THAT(client->receive(), SizeIs(10));
}

TEST_F(SubscriptionTest, ThrottledMessagesComeAtTheirRateAndAreTheNewest) {
  client->subscribe("/zmp", {{"throttle_rate", 100}});
  std::vector<double> received;
  std::int64_t last_ns = 0;
  for (int i = 0; i < 100; ++i) {  // a second at 100 Hz
    publish(i);
    for (const double x : xs(client->receive())) {
      EXPECT_TRUE(received.empty() || now_ns - last_ns >= 100 * kMillisecond_ns);
      EXPECT_EQ(x, i);
      received.push_back(x);
      last_ns = now_ns;
    }
    pass(10 * kMillisecond_ns);
  }
  EXPECT_THAT(received, SizeIs(10));
  EXPECT_EQ(hub.statistics().dropped, 0U) << "throttling is no loss";
}

TEST_F(SubscriptionTest, AThrottledMessageIsNotForgottenWhenNoOtherFollows) {
  client->subscribe("/zmp", {{"throttle_rate", 100}});
  publish(1);
  EXPECT_THAT(xs(client->receive()), ElementsAre(1));
  publish(2);
  EXPECT_THAT(client->receive(), IsEmpty());
  const int wakes = client->wakes;
  pass(100 * kMillisecond_ns);
  EXPECT_EQ(client->wakes, wakes + 1);
  EXPECT_THAT(xs(client->receive()), ElementsAre(2));
}

TEST_F(SubscriptionTest, AThrottledClientThatDoesNotReadIsTold) {
  client->subscribe("/zmp", {{"throttle_rate", 100}});
  publish(0);
  EXPECT_THAT(xs(client->receive()), ElementsAre(0));
  for (int i = 1; i <= 100; ++i) {
    publish(i);
    pass(10 * kMillisecond_ns);
  }
  EXPECT_GE(hub.statistics().dropped, 1U);
}

TEST_F(SubscriptionTest, SubscriptionsOfOneTopicAreServedTogether) {
  client->subscribe("/zmp", {{"id", "a"}, {"throttle_rate", 1000}, {"queue_length", 1}});
  client->subscribe("/zmp", {{"id", "b"}, {"throttle_rate", 0}, {"queue_length", 4}});
  for (int i = 1; i <= 5; ++i) {
    publish(i);
  }
  EXPECT_THAT(xs(client->receive()), ElementsAre(2, 3, 4, 5));
  client->send({{"op", "unsubscribe"}, {"topic", "/zmp"}, {"id", "b"}});
  publish(6);
  EXPECT_THAT(client->receive(), IsEmpty()) << "a's interval holds now";
}

TEST_F(SubscriptionTest, EndsByIdOrAsAWhole) {
  client->subscribe("/zmp", {{"id", "a"}});
  client->subscribe("/zmp", {{"id", "b"}});
  client->subscribe("/com");
  client->send({{"op", "unsubscribe"}, {"topic", "/zmp"}, {"id", "a"}});
  publish(1);
  EXPECT_THAT(xs(client->receive()), ElementsAre(1));
  client->send({{"op", "unsubscribe"}, {"topic", "/zmp"}});
  publish(2);
  publish_com(3);
  EXPECT_THAT(xs(client->receive()), ElementsAre(3));
  EXPECT_EQ(hub.statistics().subscriptions, 1U);
  client->send({{"op", "unsubscribe"}, {"topic", "/zmp"}, {"id", "a"}});
  EXPECT_EQ(client->receive_one()["level"], "warning");
}

TEST_F(SmallBoxTest, AreLimitedInNumber) {
  client->subscribe("/zmp", {{"id", 1}});
  client->subscribe("/zmp", {{"id", 2}});
  client->subscribe("/com", {{"id", 3}});
  client->subscribe("/com", {{"id", 3}, {"throttle_rate", 5}});
  EXPECT_THAT(client->receive(), IsEmpty()) << "other terms are no further subscription";
  EXPECT_THAT(client->refusal_of({{"op", "subscribe"}, {"topic", "/com"}, {"id", 4}}),
              HasSubstr("unsubscribe first"));
  client->send({{"op", "unsubscribe"}, {"topic", "/zmp"}, {"id", 1}});
  client->subscribe("/com", {{"id", 4}});
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(SubscriptionTest, TopicsTakeTurns) {
  for (const char* const topic : {"/zmp", "/com"}) {
    client->subscribe(topic, {{"queue_length", 50}});
  }
  for (int i = 0; i < 50; ++i) {
    publish(i);
  }
  publish_com(100);
  const auto received = xs(client->receive());
  ASSERT_THAT(received, SizeIs(51));
  EXPECT_TRUE(received[0] == 100 || received[1] == 100) << "not behind the other topic's queue";
}

TEST_F(SubscriptionTest, AnswersGoBeforePublications) {
  client->subscribe("/zmp", {{"queue_length", 50}});
  for (int i = 0; i < 50; ++i) {
    publish(i);
  }
  client->send({{"op", "dance"}});
  EXPECT_EQ(json::parse(*client->next_frame()->bytes)["op"], "status");
}

TEST_F(SubscriptionTest, WakesOnceUntilAllIsTaken) {
  client->subscribe("/zmp");
  publish(1);
  publish(2);
  EXPECT_EQ(client->wakes, 1);
  client->receive();
  publish(3);
  EXPECT_EQ(client->wakes, 2);
}

TEST_F(SmallBoxTest, ASlowClientHoldsAtMostItsBytesAndCostsNobodyElse) {
  const auto quick = connect("bert");
  for (TestClient* const each : {client.get(), quick.get()}) {
    each->subscribe("/zmp", {{"queue_length", 10}});
    each->subscribe("/robot_description");
    each->subscribe("/com", {{"queue_length", 10}});
  }
  std::size_t received = 0;
  for (int i = 0; i < 1000; ++i) {
    publish(i);
    publish_com(i);
    publish_description(std::string(static_cast<std::size_t>(i) * 3, 'x'));
    ASSERT_LE(hub.statistics().waiting_bytes, 2 * 4096U);
    received += quick->receive().size();
    ASSERT_LE(hub.statistics().waiting_bytes, 4096U);
  }
  EXPECT_EQ(received, 3000U);
}

TEST_F(SmallBoxTest, AMessageThatNeverFitsIsDroppedAndTold) {
  client->subscribe("/robot_description");
  publish_description(std::string(5000, 'x'));
  step();
  EXPECT_THAT(client->receive_one()["msg"], HasSubstr("1 of /robot_description"));
}

TEST_F(SubscriptionTest, DropsAreToldAtMostOnceASecond) {
  client->subscribe("/zmp");
  std::vector<std::string> warnings;
  for (int i = 0; i < 250; ++i) {  // 2.5 s, 100 Hz
    publish(i);
    publish(i);
    for (const json& message : client->receive()) {
      if (message["op"] == "status") {
        EXPECT_EQ(message["level"], "warning");
        warnings.push_back(message["msg"]);
      }
    }
    pass(10 * kMillisecond_ns);
  }
  ASSERT_THAT(warnings, SizeIs(3));
  EXPECT_THAT(warnings[0], HasSubstr("1 of /zmp"));
  EXPECT_THAT(warnings[1], HasSubstr("100 of /zmp"));
  EXPECT_GE(hub.statistics().dropped, 201U);
}

TEST_F(SmallBoxTest, WhoNeverReadsItsAnswersIsClosed) {
  for (int i = 0; i < 100 && !client->closed; ++i) {
    client->send({{"op", "dance"}});
  }
  ASSERT_TRUE(client->closed);
  EXPECT_EQ(client->closed->first, 1008);
  EXPECT_LE(hub.statistics().waiting_bytes, 4096U);
}

TEST_F(SmallBoxTest, PublicationsGiveWayToAnswers) {
  client->subscribe("/zmp", {{"queue_length", 10}});
  client->subscribe("/robot_description");
  publish_description(std::string(3500, 'x'));
  for (int i = 0; i < 4; ++i) {
    publish(i);
  }
  for (int i = 0; i < 10; ++i) {
    client->send({{"op", "dance"}});
  }
  EXPECT_FALSE(client->closed);
  EXPECT_EQ(json::parse(*client->next_frame()->bytes)["op"], "status");
}

}  // namespace
}  // namespace gaitway::api
