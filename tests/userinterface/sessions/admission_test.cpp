// Who is let in, and who is shown out: tokens, signs of life, rates and numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

HubOptions with_token() {
  HubOptions options;
  options.is_token = [](std::string_view offered) { return offered == "open sesame"; };
  options.limits.connections = 3;
  options.limits.messages_per_s = 100.0;
  return options;
}

class AdmissionTest : public HubTest {
 protected:
  AdmissionTest() : HubTest(with_token()) {}
};

TEST_F(AdmissionTest, WithoutATokenNothingIsDone) {
  const auto client = connect("stranger", false);
  for (const char* const message :
       {R"({"op": "publish", "topic": "/cmd_vel", "msg": {}})", R"({"op": "subscribe", "topic": "/zmp"})",
        R"({"op": "call_service", "service": "/emergency_stop"})", R"({"op": "set_level", "level": "none"})",
        R"({"op": "call_service", "service": "/rosapi/topics"})"}) {
    EXPECT_THAT(client->refusal_of_text(message), HasSubstr("not authorised")) << message;
  }
  EXPECT_THAT(robot.told, IsEmpty());
  EXPECT_EQ(hub.statistics().subscriptions, 0U);
}

TEST_F(AdmissionTest, TheTokenLetsIn) {
  for (const char* const field : {"token", "mac"}) {
    const auto client = connect("anna", false);
    client->send({{"op", "auth"}, {field, "open sesame"}});
    client->drive(0.1);
    EXPECT_THAT(client->receive(), IsEmpty()) << field;
    EXPECT_EQ(robot.told.back(), "walk");
  }
}

TEST_F(AdmissionTest, AWrongTokenEndsTheConnection) {
  for (const char* const token : {"", "open sesam", "open sesame ", "Open sesame", "x"}) {
    const auto client = connect("stranger", false);
    EXPECT_EQ(client->refusal_of({{"op", "auth"}, {"token", token}}), "the token is wrong");
    ASSERT_TRUE(client->closed) << token;
    EXPECT_EQ(client->closed->first, 1008);
    EXPECT_EQ(client->wrong_tokens, 1);
    client->send({{"op", "auth"}, {"token", "open sesame"}});
    client->drive(0.1);
  }
  EXPECT_THAT(robot.told, IsEmpty());
}

TEST_F(AdmissionTest, ThereIsNotMuchTimeToShowIt) {
  const auto slow = connect("slow", false), quick = connect("quick", false);
  quick->send({{"op", "auth"}, {"token", "open sesame"}});
  pass(Limits{}.authentication_ns - 10 * kMillisecond_ns);
  EXPECT_FALSE(slow->closed);
  pass(10 * kMillisecond_ns);
  ASSERT_TRUE(slow->closed);
  EXPECT_EQ(slow->closed->first, 1008);
  EXPECT_FALSE(quick->closed);
}

class OpenHouseTest : public HubTest {};

TEST_F(OpenHouseTest, NoTokenIsRightWhereThereIsNone) {
  for (const char* const token : {"", "x"}) {
    const auto client = connect("stranger", false);
    client->send({{"op", "auth"}, {"token", token}});
    EXPECT_TRUE(client->closed);
  }
}

TEST_F(OpenHouseTest, AQuietWatcherStays) {
  const auto watcher = connect("watcher");
  pass(60 * kSecond_ns);
  EXPECT_FALSE(watcher->closed) << "whether it lives is its connection's matter";
}

TEST_F(OpenHouseTest, AClosedConnectionIsServedNoMore) {
  const auto dead = connect("dead");
  dead->subscribe("/zmp");
  for (int i = 0; i < 1500; ++i) {
    dead->send({{"op", "status"}});
  }
  ASSERT_TRUE(dead->closed);
  EXPECT_EQ(hub.statistics().subscriptions, 0U);
  EXPECT_FALSE(hub.wanted(Topic::zmp));
  dead->subscribe("/zmp");
  EXPECT_EQ(hub.statistics().subscriptions, 0U);
  EXPECT_EQ(hub.statistics().closed_by_us, 1U);
}

TEST_F(AdmissionTest, ConnectionsAreLimited) {
  auto a = connect("a"), b = connect("b"), c = connect("c");
  EXPECT_TRUE(c->is_open());
  EXPECT_FALSE(connect("d")->is_open());
  b->disconnect();
  EXPECT_TRUE(connect("d")->is_open());
}

TEST_F(AdmissionTest, ABurstOfASecondIsTakenAndMoreIsRefused) {
  const auto client = connect("anna");
  for (int i = 0; i < 110; ++i) {
    client->drive(0.1);
  }
  EXPECT_EQ(robot.velocities.size(), 100U);
  EXPECT_THAT(client->receive_one()["msg"], HasSubstr("at most 100.0 a second")) << "told once";
  pass(500 * kMillisecond_ns);
  for (int i = 0; i < 50; ++i) {
    client->drive(0.1);
  }
  EXPECT_EQ(robot.velocities.size(), 150U);
  EXPECT_FALSE(client->closed);
}

TEST_F(AdmissionTest, WhoGoesOnIsClosed) {
  const auto client = connect("anna");
  for (int i = 0; i < 1000 && !client->closed; ++i) {  // 200 a second
    client->drive(0.1);
    client->receive();
    now_ns += 5 * kMillisecond_ns;
  }
  ASSERT_TRUE(client->closed);
  EXPECT_EQ(client->closed->first, 1008);
  EXPECT_EQ(robot.told.back(), "stand");
  EXPECT_EQ(hub.statistics().commander, "");
}

TEST_F(AdmissionTest, WhoKeepsToTheRateIsNeverRefused) {
  const auto client = connect("anna");
  for (int i = 0; i < 1000; ++i) {
    client->drive(0.1);
    now_ns += 10 * kMillisecond_ns;
  }
  EXPECT_EQ(robot.velocities.size(), 1000U);
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(AdmissionTest, AnEmergencyStopIsHeardInAFlood) {
  const auto client = connect("anna");
  for (int i = 0; i < 120; ++i) {
    client->drive(0.1);
  }
  client->send({{"op", "call_service"}, {"service", "/emergency_stop"}});
  EXPECT_THAT(robot.told, Contains("emergency_stop hold"));
  EXPECT_FALSE(robot.walking);
}

TEST_F(AdmissionTest, ACallBeyondTheRateIsAnswered) {
  const auto client = connect("anna");
  for (int i = 0; i < 100; ++i) {
    client->send({{"op", "status"}});
  }
  const json args = {{"id", "of the arguments"}, {"service", {{"op", "publish"}}}};
  for (const json& id : {json(7), json("seven"), json()}) {
    json call = {{"op", "call_service"}, {"service", "/stand"}, {"args", args}};
    if (!id.is_null()) {
      call["id"] = id;
    }
    client->send(call);
    const json answer = client->receive_one();
    EXPECT_EQ(answer["op"], "service_response") << answer.dump();
    EXPECT_EQ(answer["service"], "/stand");
    EXPECT_EQ(answer["result"], false);
    EXPECT_EQ(answer.value("id", json()), id);
    EXPECT_THAT(answer["values"], HasSubstr("at most 100.0 a second"));
  }
  client->send({{"op", "call_service"}, {"service", "/stand"}, {"compression", "cbor"}, {"id", 1}});
  EXPECT_EQ(client->receive_one()["result"], false);
  EXPECT_THAT(robot.told, IsEmpty());
}

TEST_F(AdmissionTest, ACallBeyondTheRateThatIsNoneIsToldOnce) {
  const auto client = connect("anna");
  for (int i = 0; i < 100; ++i) {
    client->send({{"op", "status"}});
  }
  const std::string name(300, 'x');
  client->send({{"op", "call_service"}, {"service", name}});
  EXPECT_EQ(client->receive_one()["op"], "status");
  client->send({{"op", "call_service"}, {"service", "/stand"}, {"id", name}});
  client->send_text("{\"op\": \"call_service\", \"service\": \"/stand\"");
  client->send_text("[]");
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(AdmissionTest, TheWordStopIsNoWayAroundTheRate) {
  const auto client = connect("anna");
  for (int i = 0; i < 300; ++i) {
    client->send({{"op", "publish"}, {"id", "stop"}, {"topic", "/cmd_vel"}, {"msg", json::object()}});
  }
  EXPECT_TRUE(client->closed);
  EXPECT_LE(robot.velocities.size(), 202U);
}

}  // namespace
}  // namespace gaitway::api
