// Topics that clients have among themselves: who gets what in which form, what is refused, and what hostile
// clients cannot do to the others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class ClientTopicsTest : public HubTest {
 protected:
  explicit ClientTopicsTest(HubOptions options = {}) : HubTest(std::move(options)) {}

  static json operation(std::string_view op, std::string_view topic, json fields = json::object()) {
    fields["op"] = op;
    fields["topic"] = topic;
    return fields;
  }
  static void advertise(TestClient& client, std::string_view topic, json fields = json::object()) {
    fields.emplace("type", "std_msgs/String");
    client.send(operation("advertise", topic, fields));
  }
  static void subscribe(TestClient& client, std::string_view topic, json fields = json::object()) {
    fields.emplace("type", "std_msgs/String");
    client.send(operation("subscribe", topic, fields));
  }
  static void publish(TestClient& client, std::string_view topic, const json& message) {
    client.send(operation("publish", topic, {{"msg", message}}));
  }
  static json said(std::string_view topic, const json& message) {
    return {{"op", "publish"}, {"topic", topic}, {"msg", message}};
  }
  json rosapi(std::string_view service, const json& arguments = json::object()) {
    return connect("asks")->call("/rosapi/" + std::string(service), arguments)["values"];
  }

  std::unique_ptr<TestClient> anna = connect("anna"), ben = connect("ben"), carl = connect("carl");
};

TEST_F(ClientTopicsTest, AMessageReachesAllWhoSubscribe) {
  advertise(*anna, "/chat");
  subscribe(*ben, "/chat");
  subscribe(*carl, "/chat");
  publish(*anna, "/chat", {{"data", "hello"}});
  for (TestClient* const client : {ben.get(), carl.get()}) {
    EXPECT_EQ(client->receive_one(), said("/chat", {{"data", "hello"}}));
  }
  EXPECT_THAT(anna->receive(), IsEmpty());
  EXPECT_THAT(robot.told, IsEmpty()) << "the robot has no part in it";
  EXPECT_EQ(hub.statistics().commander, "");
}

TEST_F(ClientTopicsTest, WhoPublishesMaySubscribe) {
  subscribe(*anna, "/chat");
  advertise(*anna, "/chat");
  publish(*anna, "/chat", {{"data", "echo"}});
  EXPECT_EQ(anna->receive_one()["msg"]["data"], "echo");
}

TEST_F(ClientTopicsTest, MessagesArePassedOnAsTheyAre) {
  const json strange =
      json::parse(R"({"data": [1, -2, 3.25, 1e300, 18446744073709551615, null, true, {"": {}}],
                                       "\u0000\u2028": "\"\\\ud83d\ude00", "unknown_to_the_type": []})");
  subscribe(*ben, "/chat");
  advertise(*anna, "/chat");
  publish(*anna, "/chat", strange);
  EXPECT_EQ(ben->receive_one()["msg"], strange);
}

TEST_F(ClientTopicsTest, TypesThatTheRobotDoesNotKnowAreFine) {
  advertise(*anna, "/map", {{"type", "my_msgs/Pancake"}});
  subscribe(*ben, "/map", {{"type", "my_msgs/msg/Pancake"}});
  publish(*anna, "/map", {{"syrup", 3}});
  EXPECT_EQ(ben->receive_one()["msg"]["syrup"], 3);
  EXPECT_EQ(rosapi("topic_type", {{"topic", "/map"}})["type"], "my_msgs/msg/Pancake");
}

TEST_F(ClientTopicsTest, CborForWhoAskedForIt) {
  subscribe(*ben, "/chat", {{"compression", "cbor"}});
  subscribe(*carl, "/chat");
  advertise(*anna, "/chat");
  publish(*anna, "/chat", {{"data", "x"}, {"list", {1, 2.5, "y"}}});
  const auto binary = ben->next_frame(), text = carl->next_frame();
  ASSERT_TRUE(binary && text);
  EXPECT_TRUE(binary->binary);
  EXPECT_FALSE(text->binary);
  EXPECT_EQ(json::from_cbor(*binary->bytes), json::parse(*text->bytes));
  EXPECT_THAT(
      ben->refusal_of(operation("subscribe", "/other", {{"type", "a/B"}, {"compression", "cbor-raw"}})),
      HasSubstr("compression"));
}

TEST_F(ClientTopicsTest, TheNameComesBackAsItWasWritten) {
  subscribe(*ben, "chat");
  subscribe(*carl, "/chat");
  advertise(*anna, "chat");
  publish(*anna, "/chat", {{"data", "x"}});
  EXPECT_EQ(ben->receive_one()["topic"], "chat");
  EXPECT_EQ(carl->receive_one()["topic"], "/chat");
}

TEST_F(ClientTopicsTest, ThrottledAsTheRobotsTopics) {
  subscribe(*ben, "/chat", {{"throttle_rate", 100}, {"queue_length", 1}});
  advertise(*anna, "/chat");
  std::vector<int> heard;
  for (int i = 0; i < 30; ++i) {
    publish(*anna, "/chat", {{"data", i}});
    pass(10 * kMillisecond_ns);
    for (const json& message : ben->receive()) {
      heard.push_back(message["msg"]["data"].get<int>());
    }
  }
  EXPECT_THAT(heard, SizeIs(testing::AllOf(testing::Ge(3U), testing::Le(4U))));
}

TEST_F(ClientTopicsTest, QueuesKeepTheNewest) {
  subscribe(*ben, "/chat", {{"queue_length", 2}});
  advertise(*anna, "/chat");
  for (int i = 0; i < 5; ++i) {
    publish(*anna, "/chat", {{"data", i}});
  }
  const auto messages = ben->receive();
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0]["msg"]["data"], 3);
  EXPECT_EQ(messages[1]["msg"]["data"], 4);
  pass(2 * kSecond_ns);
  EXPECT_THAT(ben->receive_one()["msg"].get<std::string>(), HasSubstr("3 of /chat"));
  EXPECT_EQ(hub.statistics().dropped, 3U);
}

TEST_F(ClientTopicsTest, LongMessagesComeInFragments) {
  subscribe(*ben, "/chat", {{"fragment_size", 100}});
  advertise(*anna, "/chat");
  const json message = {{"data", std::string(1000, 'x')}};
  publish(*anna, "/chat", message);
  std::string whole;
  const auto fragments = ben->receive();
  for (const json& fragment : fragments) {
    EXPECT_EQ(fragment["op"], "fragment");
    whole += fragment["data"].get<std::string>();
  }
  EXPECT_GT(fragments.size(), 5U);
  EXPECT_EQ(json::parse(whole), said("/chat", message));
}

TEST_F(ClientTopicsTest, SeveralMayAdvertiseATopicWithOneType) {
  subscribe(*carl, "/chat");
  advertise(*anna, "/chat", {{"type", "std_msgs/msg/String"}});
  advertise(*ben, "/chat", {{"type", "std_msgs/String"}});
  publish(*anna, "/chat", {{"data", "a"}});
  publish(*ben, "/chat", {{"data", "b"}});
  EXPECT_THAT(carl->receive(), ElementsAre(said("/chat", {{"data", "a"}}), said("/chat", {{"data", "b"}})));
  for (const char* const op : {"advertise", "subscribe", "publish"}) {
    EXPECT_THAT(ben->refusal_of(operation(op, "/chat", {{"type", "std_msgs/Bool"}, {"msg", json::object()}})),
                testing::AllOf(HasSubstr("std_msgs/msg/Bool"), HasSubstr("/chat is of std_msgs/msg/String")));
  }
}

TEST_F(ClientTopicsTest, ATypeLastsAsLongAsSomebodyUsesTheTopic) {
  advertise(*anna, "/chat");
  anna->send(operation("unadvertise", "/chat"));
  advertise(*ben, "/chat", {{"type", "std_msgs/Bool"}});
  EXPECT_THAT(ben->receive(), IsEmpty());
  ben.reset();
  subscribe(*carl, "/chat");
  EXPECT_THAT(carl->receive(), IsEmpty());
  carl->send(operation("unsubscribe", "/chat"));
  EXPECT_THAT(rosapi("topics")["topics"], Not(Contains("/chat")));
}

TEST_F(ClientTopicsTest, PublishingAdvertisesWhereTheTypeIsKnown) {
  EXPECT_THAT(anna->refusal_of(operation("publish", "/chat", {{"msg", {{"data", 1}}}})),
              HasSubstr("type is missing"));
  subscribe(*ben, "/chat");
  publish(*anna, "/chat", {{"data", 1}});
  EXPECT_EQ(ben->receive_one()["msg"]["data"], 1);
  EXPECT_THAT(rosapi("publishers", {{"topic", "/chat"}})["publishers"], SizeIs(1));
  anna->send(operation("publish", "/new", {{"type", "std_msgs/String"}, {"msg", json::object()}}));
  EXPECT_THAT(anna->receive(), IsEmpty());
  EXPECT_EQ(rosapi("topic_type", {{"topic", "/new"}})["type"], "std_msgs/msg/String");
}

TEST_F(ClientTopicsTest, UnadvertisedByIdOrAltogether) {
  advertise(*anna, "/chat", {{"id", "a"}});
  advertise(*anna, "/chat", {{"id", "b"}});
  anna->send(operation("unadvertise", "/chat", {{"id", "a"}}));
  EXPECT_THAT(rosapi("topics")["topics"], Contains("/chat"));
  anna->send(operation("unadvertise", "/chat", {{"id", "a"}}));
  EXPECT_EQ(anna->receive_one()["level"], "warning");
  anna->send(operation("unadvertise", "/chat"));
  EXPECT_THAT(anna->receive(), IsEmpty());
  EXPECT_THAT(rosapi("topics")["topics"], Not(Contains("/chat")));
}

TEST_F(ClientTopicsTest, UnsubscribedByIdOrAltogether) {
  subscribe(*ben, "/chat", {{"id", "json"}});
  subscribe(*ben, "/chat", {{"id", "cbor"}, {"compression", "cbor"}});
  EXPECT_EQ(hub.statistics().subscriptions, 2U);
  publish(*anna, "/chat", {{"data", 1}});
  EXPECT_TRUE(ben->next_frame()->binary);
  ben->send(operation("unsubscribe", "/chat", {{"id", "cbor"}}));
  publish(*anna, "/chat", {{"data", 2}});
  EXPECT_FALSE(ben->next_frame()->binary);
  ben->send(operation("unsubscribe", "/chat"));
  publish(*anna, "/chat", {{"data", 3}});
  EXPECT_THAT(ben->receive(), IsEmpty());
  EXPECT_EQ(hub.statistics().subscriptions, 0U);
  ben->send(operation("unsubscribe", "/chat"));
  EXPECT_EQ(ben->receive_one()["level"], "warning");
}

TEST_F(ClientTopicsTest, LatchedMessagesReachWhoComesLater) {
  advertise(*anna, "/map", {{"latch", true}});
  publish(*anna, "/map", {{"data", "old"}});
  publish(*anna, "/map", {{"data", "new"}});
  subscribe(*ben, "/map");
  EXPECT_EQ(ben->receive_one(), said("/map", {{"data", "new"}}));
  subscribe(*carl, "/map", {{"compression", "cbor"}});
  EXPECT_EQ(carl->receive_one(), said("/map", {{"data", "new"}}));
}

TEST_F(ClientTopicsTest, WhatIsKeptGoesWithWhoSaidIt) {
  advertise(*anna, "/map", {{"latch", true}});
  advertise(*ben, "/map", {{"latch", true}});
  publish(*anna, "/map", {{"data", "of anna"}});
  publish(*ben, "/map", {{"data", "of ben"}});
  subscribe(*carl, "/map");
  EXPECT_THAT(carl->receive(), SizeIs(2));
  anna.reset();
  carl->send(operation("unsubscribe", "/map"));
  subscribe(*carl, "/map");
  EXPECT_EQ(carl->receive_one(), said("/map", {{"data", "of ben"}}));
  ben->send(operation("unadvertise", "/map"));
  EXPECT_EQ(hub.statistics().waiting_bytes, 0U);
}

TEST_F(ClientTopicsTest, WhatIsKeptCountsForWhoSaidIt) {
  advertise(*anna, "/map", {{"latch", true}});
  publish(*anna, "/map", {{"data", std::string(10'000, 'x')}});
  EXPECT_GE(hub.statistics().waiting_bytes, 10'000U);
  publish(*anna, "/map", {{"data", "short"}});
  EXPECT_LT(hub.statistics().waiting_bytes, 1'000U);
  EXPECT_THAT(anna->refusal_of(operation("publish", "/map", {{"msg", {{"data", std::string(20'000, 'x')}}}})),
              HasSubstr("16384"));
  subscribe(*ben, "/map");
  EXPECT_EQ(ben->receive_one()["msg"]["data"], "short") << "the last that was taken";
}

TEST_F(ClientTopicsTest, TheRobotsOwnTopicsCannotBeTaken) {
  for (const TopicRow& row : kTopics) {
    for (const std::string& name : {std::string(row.name), std::string(row.name.substr(1))}) {
      EXPECT_THAT(anna->refusal_of(operation("advertise", name, {{"type", row.type}})),
                  testing::AllOf(HasSubstr(name), HasSubstr("the robot's own")));
      EXPECT_THAT(anna->refusal_of(operation("publish", name, {{"type", row.type}, {"msg", json::object()}})),
                  HasSubstr("the robot's own"));
    }
  }
  EXPECT_THAT(anna->refusal_of(operation("subscribe", "/cmd_vel", {{"type", "geometry_msgs/Twist"}})),
              HasSubstr("takes and does not publish"));
  EXPECT_EQ(hub.statistics().subscriptions, 0U);
}

TEST_F(ClientTopicsTest, OddNamesAreRefused) {
  for (const std::string name : {"/", "//chat", "/chat/", "/a//b", "/chat room", "/chat\n", "/ch\u00e4t",
                                 "/../chat", "~chat", "/<script>", "/a\\b", "/chat\u202e", "/{x}"}) {
    for (const char* const op : {"advertise", "subscribe", "publish"}) {
      EXPECT_THAT(anna->refusal_of(operation(op, name, {{"type", "a/B"}, {"msg", json::object()}})),
                  HasSubstr("letters, digits and _"))
          << name;
    }
  }
  EXPECT_THAT(anna->refusal_of_text("{\"op\":\"advertise\",\"type\":\"a/B\",\"topic\":\"/a\\u0000b\"}"),
              HasSubstr("letters"));
  EXPECT_THAT(anna->refusal_of(operation("advertise", "/" + std::string(300, 'x'), {{"type", "a/B"}})),
              HasSubstr("1 to 256 bytes"));
}

TEST_F(ClientTopicsTest, OddTypesAreRefused) {
  for (const std::string& type :
       {std::string("String"), std::string("a/b/c/d"), std::string("/a/B"), std::string("a/B\n"),
        std::string("a/<b>"), "a/" + std::string(50'000, 'x')}) {
    EXPECT_THAT(anna->refusal_of(operation("advertise", "/chat", {{"type", type}})), HasSubstr("type is"));
  }
  EXPECT_THAT(anna->refusal_of(operation("advertise", "/chat", {{"type", 5}})), HasSubstr("type is 5"));
  EXPECT_THAT(anna->refusal_of(operation("advertise", "/chat")), HasSubstr("type is missing"));
  EXPECT_THAT(anna->refusal_of(operation("advertise", "/chat", {{"type", "a/B"}, {"latch", "yes"}})),
              HasSubstr("latch"));
  EXPECT_THAT(anna->refusal_of(operation("publish", "/chat", {{"type", "a/B"}})),
              HasSubstr("msg is missing"));
  EXPECT_THAT(anna->refusal_of(operation("publish", "/chat", {{"type", "a/B"}, {"msg", {1, 2}}})),
              HasSubstr("msg is a list"));
  EXPECT_THAT(rosapi("topics")["topics"], Not(Contains("/chat")));
}

TEST_F(ClientTopicsTest, DeepAndLongMessagesAreRefused) {
  advertise(*anna, "/chat");
  subscribe(*ben, "/chat");
  const std::string begin = R"({"op":"publish","topic":"/chat","msg":{"data":)";
  EXPECT_THAT(anna->refusal_of_text(begin + std::string(40, '[') + std::string(40, ']') + "}}"),
              HasSubstr("nested too deeply"));
  EXPECT_THAT(anna->refusal_of_text(begin + "\"" + std::string(70'000, 'x') + "\"}}"),
              HasSubstr("at most 65536"));
  EXPECT_THAT(ben->receive(), IsEmpty());
}

TEST_F(ClientTopicsTest, RosapiTellsOfThem) {
  advertise(*anna, "/chat");
  subscribe(*ben, "chat");
  const json topics = rosapi("topics");
  const auto at = std::ranges::find(topics["topics"], "/chat") - topics["topics"].begin();
  ASSERT_LT(at, static_cast<std::ptrdiff_t>(topics["topics"].size()));
  EXPECT_EQ(topics["types"][static_cast<std::size_t>(at)], "std_msgs/msg/String");
  EXPECT_THAT(rosapi("topics_for_type", {{"type", "std_msgs/String"}})["topics"], Contains("/chat"));
  const json raw = rosapi("topics_and_raw_types");
  EXPECT_EQ(raw["typedefs_full_text"].size(), raw["topics"].size());
  const json publishers = rosapi("publishers", {{"topic", "/chat"}})["publishers"];
  const json subscribers = rosapi("subscribers", {{"topic", "/chat"}})["subscribers"];
  ASSERT_THAT(publishers, SizeIs(1));
  ASSERT_THAT(subscribers, SizeIs(1));
  EXPECT_NE(publishers[0], subscribers[0]);
  EXPECT_THAT(rosapi("nodes")["nodes"],
              testing::AllOf(Contains("/gaitway"), Contains(publishers[0]), Contains(subscribers[0])));
  EXPECT_THAT(rosapi("node_details", {{"node", publishers[0]}})["publishing"], ElementsAre("/chat"));
  EXPECT_THAT(rosapi("node_details", {{"node", subscribers[0]}})["subscribing"], ElementsAre("/chat"));
}

TEST_F(ClientTopicsTest, OneClientAdvertisesAndSubscribesWithinLimits) {
  for (std::size_t i = 0; i < Limits{}.advertisements; ++i) {
    advertise(*anna, "/own_" + std::to_string(i));
  }
  for (std::size_t i = 0; i < Limits{}.subscriptions; ++i) {
    subscribe(*anna, "/heard_" + std::to_string(i));
  }
  EXPECT_THAT(anna->receive(), IsEmpty());
  EXPECT_THAT(anna->refusal_of(operation("advertise", "/more", {{"type", "a/B"}})),
              HasSubstr("unadvertise first"));
  EXPECT_THAT(anna->refusal_of(operation("publish", "/more", {{"type", "a/B"}, {"msg", json::object()}})),
              HasSubstr("unadvertise first"));
  EXPECT_THAT(anna->refusal_of(operation("advertise", "/cmd_vel")), HasSubstr("unadvertise first"));
  EXPECT_THAT(anna->refusal_of(operation("subscribe", "/more", {{"type", "a/B"}})),
              HasSubstr("unsubscribe first"));
  EXPECT_THAT(anna->refusal_of(operation("subscribe", "/zmp")), HasSubstr("unsubscribe first"));
  advertise(*anna, "/own_1");
  subscribe(*anna, "/heard_1");
  EXPECT_THAT(anna->receive(), IsEmpty()) << "the same again is nothing more";
}

TEST_F(ClientTopicsTest, AHundredClientsAdvertiseWithinALimit) {
  std::vector<std::unique_ptr<TestClient>> clients;
  std::size_t refused = 0;
  for (int i = 0; i < 100; ++i) {
    clients.push_back(connect("one of many"));
    for (int k = 0; k < 16; ++k) {
      advertise(*clients.back(), "/t" + std::to_string(i) + "/" + std::to_string(k));
    }
    for (const json& status : clients.back()->receive()) {
      EXPECT_THAT(status["msg"].get<std::string>(), HasSubstr(std::to_string(Limits{}.client_topics)));
      ++refused;
    }
  }
  EXPECT_EQ(refused, 1600 - Limits{}.client_topics);
  EXPECT_EQ(rosapi("topics")["topics"].size(), kTopicCount + 1 + Limits{}.client_topics);
  clients.clear();
  EXPECT_EQ(rosapi("topics")["topics"].size(), kTopicCount + 1);
}

TEST_F(ClientTopicsTest, AFloodHarmsNobodyWhoIsSlow) {
  subscribe(*ben, "/chat");
  subscribe(*ben, "/zmp", {{"type", ""}});
  subscribe(*carl, "/chat");
  advertise(*anna, "/chat");
  const std::string text(60'000, 'x');
  for (int i = 0; i < 400; ++i) {
    publish(*anna, "/chat", {{"data", text}});
    carl->receive();
    ASSERT_LE(hub.statistics().waiting_bytes, Limits{}.waiting_bytes);
  }
  EXPECT_FALSE(ben->closed);
  EXPECT_FALSE(carl->closed);
  hub.publish(Topic::zmp, ros::PointStamped{});
  const auto messages = ben->receive();
  EXPECT_THAT(messages,
              Contains(testing::ResultOf([](const json& one) { return one.value("topic", ""); }, "/zmp")));
}

TEST_F(ClientTopicsTest, WhoFloodsIsBoundToTheRateOfMessages) {
  advertise(*anna, "/chat");
  for (int i = 0; i < 2000 && !anna->closed; ++i) {
    publish(*anna, "/chat", {{"data", i}});
  }
  EXPECT_TRUE(anna->closed);
}

TEST_F(ClientTopicsTest, WhoHasNotShownTheTokenHasNoPart) {
  const auto stranger = connect("stranger", false);
  EXPECT_THAT(stranger->refusal_of(operation("advertise", "/chat", {{"type", "a/B"}})),
              HasSubstr("not authorised"));
  EXPECT_THAT(stranger->refusal_of(operation("subscribe", "/chat", {{"type", "a/B"}})),
              HasSubstr("not authorised"));
  EXPECT_THAT(rosapi("topics")["topics"], Not(Contains("/chat")));
}

HubOptions tight_budget() {
  HubOptions options;
  options.limits.waiting_bytes = 32 * 1024;
  options.limits.waiting_bytes_of_all = 64 * 1024;
  options.limits.kept_bytes = 8 * 1024;
  return options;
}

class TightTopicsTest : public ClientTopicsTest {
 protected:
  TightTopicsTest() : ClientTopicsTest(tight_budget()) {}
};

TEST_F(TightTopicsTest, KeptMessagesAreWithinTheBudgetOfAll) {
  std::vector<std::unique_ptr<TestClient>> hoarders;
  for (int i = 0; i < 10; ++i) {
    hoarders.push_back(connect("hoarder"));
    for (int k = 0; k < 3; ++k) {
      const std::string topic = "/hoard_" + std::to_string(i) + "_" + std::to_string(k);
      advertise(*hoarders.back(), topic, {{"latch", true}});
      publish(*hoarders.back(), topic, {{"data", std::string(7'000, 'x')}});
      ASSERT_LE(hub.statistics().waiting_bytes, 64U * 1024);
    }
  }
  EXPECT_GT(hub.statistics().closed_by_us, 0U);
  EXPECT_FALSE(anna->closed || ben->closed || carl->closed);
  hoarders.clear();
  EXPECT_EQ(hub.statistics().waiting_bytes, 0U);
}

TEST_F(TightTopicsTest, NoMoreIsKeptThanOneClientMayHave) {
  for (int k = 0; k < 6; ++k) {
    advertise(*anna, "/hoard_" + std::to_string(k), {{"latch", true}});
    publish(*anna, "/hoard_" + std::to_string(k), {{"data", std::string(7'000, 'x')}});
  }
  EXPECT_FALSE(anna->closed);
  EXPECT_LE(hub.statistics().waiting_bytes, 32U * 1024);
  const auto statuses = anna->receive();
  ASSERT_THAT(statuses, SizeIs(2));
  EXPECT_THAT(statuses[0]["msg"].get<std::string>(), HasSubstr("cannot be kept"));
}

}  // namespace
}  // namespace gaitway::api
