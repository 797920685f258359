// Services that clients offer: calls and answers find their way, and neither a provider nor a caller can harm
// the others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "gaitway/api/service_table.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class ClientServicesTest : public HubTest {
 protected:
  explicit ClientServicesTest(HubOptions options = {}) : HubTest(std::move(options)) {}

  static json operation(std::string_view op, std::string_view service, json fields = json::object()) {
    fields["op"] = op;
    fields["service"] = service;
    return fields;
  }
  static void offer(TestClient& client, std::string_view service) {
    client.send(operation("advertise_service", service, {{"type", "my_srvs/Add"}}));
  }
  static void call(TestClient& client, std::string_view service, json fields = json::object()) {
    fields.emplace("id", "c");
    client.send(operation("call_service", service, fields));
  }
  // The call that arrives at the provider.
  static json taken(TestClient& provider) {
    json asked = provider.receive_one();
    EXPECT_EQ(asked.value("op", ""), "call_service") << asked.dump();
    return asked;
  }
  static void respond(TestClient& provider, const json& asked, const json& values,
                      const json& result = true) {
    provider.send({{"op", "service_response"},
                   {"service", asked["service"]},
                   {"id", asked["id"]},
                   {"values", values},
                   {"result", result}});
  }
  static std::string failure_of(TestClient& caller) {
    const json answer = caller.receive_one();
    EXPECT_EQ(answer.value("op", ""), "service_response") << answer.dump();
    EXPECT_EQ(answer.value("result", true), false) << answer.dump();
    EXPECT_EQ(answer.value("id", ""), "c");
    return answer["values"].is_string() ? answer["values"].get<std::string>() : "";
  }
  static std::vector<std::string> warnings(TestClient& client) {
    std::vector<std::string> texts;
    for (const json& status : client.receive()) {
      EXPECT_EQ(status["level"], "warning") << status.dump();
      texts.push_back(status["msg"].get<std::string>());
    }
    return texts;
  }
  json rosapi(std::string_view service, const json& arguments = json::object()) {
    return connect("asks")->call("/rosapi/" + std::string(service), arguments)["values"];
  }

  std::unique_ptr<TestClient> provider = connect("provider"), caller = connect("caller");
};

TEST_F(ClientServicesTest, ACallGoesToItsProviderAndTheAnswerBack) {
  offer(*provider, "/add");
  call(*caller, "/add", {{"args", {{"a", 2}, {"b", 40}}}});
  const json asked = taken(*provider);
  EXPECT_EQ(asked["service"], "/add");
  EXPECT_EQ(asked["args"], json({{"a", 2}, {"b", 40}}));
  EXPECT_NE(asked["id"], "c") << "an id of the robot's own";
  EXPECT_THAT(caller->receive(), IsEmpty());
  respond(*provider, asked, {{"sum", 42}});
  EXPECT_EQ(caller->receive_one(), json({{"op", "service_response"},
                                         {"service", "/add"},
                                         {"id", "c"},
                                         {"result", true},
                                         {"values", {{"sum", 42}}}}));
  EXPECT_THAT(provider->receive(), IsEmpty());
  EXPECT_THAT(robot.told, IsEmpty());
  EXPECT_EQ(hub.statistics().commander, "") << "nobody commands for that";
}

TEST_F(ClientServicesTest, EachHasTheNameAsItWroteIt) {
  offer(*provider, "add");
  call(*caller, "/add");
  const json asked = taken(*provider);
  EXPECT_EQ(asked["service"], "add");
  EXPECT_EQ(asked["args"], json::object());
  respond(*provider, asked, json::object());
  EXPECT_EQ(caller->receive_one()["service"], "/add");
}

TEST_F(ClientServicesTest, AnswersInCborAndInFragments) {
  offer(*provider, "/add");
  call(*caller, "/add", {{"compression", "cbor"}});
  respond(*provider, taken(*provider), {{"sum", 1}});
  const auto frame = caller->next_frame();
  ASSERT_TRUE(frame && frame->binary);
  EXPECT_EQ(json::from_cbor(*frame->bytes)["values"]["sum"], 1);
  call(*caller, "/add", {{"fragment_size", 64}});
  respond(*provider, taken(*provider), {{"text", std::string(500, 'x')}});
  std::string whole;
  for (const json& fragment : caller->receive()) {
    EXPECT_EQ(fragment["op"], "fragment");
    whole += fragment["data"].get<std::string>();
  }
  EXPECT_EQ(json::parse(whole)["values"]["text"], std::string(500, 'x'));
}

TEST_F(ClientServicesTest, AFailureOfTheProviderIsOneOfTheCall) {
  offer(*provider, "/add");
  call(*caller, "/add");
  respond(*provider, taken(*provider), "out of numbers", false);
  EXPECT_EQ(failure_of(*caller), "out of numbers");
  call(*caller, "/add");
  respond(*provider, taken(*provider), {{"sum", 0}}, false);
  const json answer = caller->receive_one();
  EXPECT_EQ(answer["result"], false);
  EXPECT_EQ(answer["values"], json({{"sum", 0}}));
}

TEST_F(ClientServicesTest, CallsAreAnsweredInAnyOrder) {
  const auto other = connect("other");
  offer(*provider, "/add");
  call(*caller, "/add", {{"id", 1}});
  call(*other, "/add", {{"id", 1}});
  const auto asked = provider->receive();
  ASSERT_THAT(asked, SizeIs(2));
  EXPECT_NE(asked[0]["id"], asked[1]["id"]);
  respond(*provider, asked[1], {{"sum", 2}});
  respond(*provider, asked[0], {{"sum", 1}});
  EXPECT_EQ(caller->receive_one()["values"]["sum"], 1);
  EXPECT_EQ(other->receive_one()["values"]["sum"], 2);
}

TEST_F(ClientServicesTest, ASecondProviderIsRefused) {
  const auto second = connect("second");
  offer(*provider, "/add");
  EXPECT_THAT(second->refusal_of(operation("advertise_service", "add", {{"type", "my_srvs/Add"}})),
              HasSubstr("another connection offers"));
  second->send(operation("unadvertise_service", "/add"));
  EXPECT_THAT(warnings(*second), ElementsAre(HasSubstr("does not offer")));
  offer(*provider, "/add");
  EXPECT_THAT(provider->receive(), IsEmpty()) << "the same again is fine";
  provider->send(operation("unadvertise_service", "/add"));
  offer(*second, "/add");
  EXPECT_THAT(second->receive(), IsEmpty());
}

TEST_F(ClientServicesTest, TheRobotsOwnServicesCannotBeTaken) {
  for (const ServiceRow& row : kServices) {
    for (const std::string& name : {std::string(row.name), std::string(row.name.substr(1))}) {
      EXPECT_THAT(provider->refusal_of(operation("advertise_service", name, {{"type", row.type}})),
                  AllOf(HasSubstr(name), HasSubstr("the robot's own")));
    }
  }
  EXPECT_THAT(provider->refusal_of(operation("advertise_service", "/rosapi/more", {{"type", "a/B"}})),
              HasSubstr("the robot's own"));
  call(*caller, "stop");
  EXPECT_THAT(robot.told, Contains("stop"));
}

TEST_F(ClientServicesTest, WrongOffersAreRefused) {
  for (const char* const name : {"//stop", "/stop/", "/st op", "/stop\n", "/\u0455top", "/"}) {
    EXPECT_THAT(provider->refusal_of(operation("advertise_service", name, {{"type", "a/B"}})),
                HasSubstr("letters"));
  }
  EXPECT_THAT(provider->refusal_of(operation("advertise_service", "/add")), HasSubstr("type is missing"));
  EXPECT_THAT(provider->refusal_of(
                  operation("advertise_service", "/add", {{"type", "a/" + std::string(50'000, 'x')}})),
              HasSubstr("type is"));
  EXPECT_THAT(rosapi("services")["services"], Not(Contains("/add")));
}

TEST_F(ClientServicesTest, WrongArgumentsFail) {
  offer(*provider, "/add");
  call(*caller, "/add", {{"args", 5}});
  EXPECT_THAT(failure_of(*caller), HasSubstr("args is 5"));
  EXPECT_THAT(provider->receive(), IsEmpty());
  call(*caller, "/add", {{"args", {1, 2}}});
  EXPECT_EQ(taken(*provider)["args"], json({1, 2}));
}

TEST_F(ClientServicesTest, AProviderThatNeverAnswersCostsATimeOut) {
  offer(*provider, "/add");
  call(*caller, "/add", {{"timeout", 0.5}});
  const json asked = taken(*provider);
  pass(400 * kMillisecond_ns);
  EXPECT_THAT(caller->receive(), IsEmpty());
  pass(200 * kMillisecond_ns);
  EXPECT_THAT(failure_of(*caller), HasSubstr("not answered in time"));
  respond(*provider, asked, {{"sum", 42}});
  EXPECT_THAT(warnings(*provider), ElementsAre(HasSubstr("no call with this id")));
  EXPECT_THAT(caller->receive(), IsEmpty()) << "answered once";
  call(*caller, "/add");
  pass(Limits{}.answer_ns + 20 * kMillisecond_ns);
  EXPECT_THAT(failure_of(*caller), HasSubstr("not answered in time"));
}

TEST_F(ClientServicesTest, WhenTheProviderGoesItsCallersKnowAtOnce) {
  offer(*provider, "/add");
  call(*caller, "/add");
  provider.reset();
  EXPECT_THAT(failure_of(*caller), HasSubstr("connection has ended"));
  call(*caller, "/add");
  EXPECT_THAT(failure_of(*caller), HasSubstr("/rosapi/services"));
}

TEST_F(ClientServicesTest, WhenTheServiceGoesItsCallersKnowAtOnce) {
  offer(*provider, "/add");
  offer(*provider, "/subtract");
  call(*caller, "/add");
  call(*caller, "/subtract", {{"id", "d"}});
  const auto asked = provider->receive();
  provider->send(operation("unadvertise_service", "add"));
  EXPECT_THAT(failure_of(*caller), HasSubstr("no more"));
  ASSERT_THAT(asked, SizeIs(2));
  respond(*provider, asked[1], json::object());
  EXPECT_EQ(caller->receive_one()["id"], "d");
}

TEST_F(ClientServicesTest, WhenTheCallerGoesTheAnswerGoesNowhere) {
  offer(*provider, "/add");
  call(*caller, "/add");
  const json asked = taken(*provider);
  caller.reset();
  respond(*provider, asked, {{"sum", 42}});
  EXPECT_THAT(warnings(*provider), SizeIs(1));
}

TEST_F(ClientServicesTest, ForgedAnswersReachNobody) {
  const auto forger = connect("forger");
  offer(*provider, "/add");
  offer(*forger, "/forge");
  call(*caller, "/add");
  const json asked = taken(*provider);
  respond(*forger, asked, {{"sum", 666}});
  EXPECT_THAT(warnings(*forger), SizeIs(1));
  for (const json& id : {json("call:"), json("call:-1"), json("call:1x"),
                         json("call:99999999999999999999999"), json("c"), json(1), json("call:0"), json()}) {
    respond(*provider, {{"service", "/add"}, {"id", id}}, {{"sum", 666}});
  }
  EXPECT_THAT(warnings(*provider), SizeIs(8));
  EXPECT_THAT(caller->receive(), IsEmpty());
  respond(*provider, asked, {{"sum", 42}});
  EXPECT_EQ(caller->receive_one()["values"]["sum"], 42);
}

TEST_F(ClientServicesTest, ASecondAnswerReachesNobody) {
  offer(*provider, "/add");
  call(*caller, "/add");
  const json asked = taken(*provider);
  respond(*provider, asked, {{"sum", 42}});
  respond(*provider, asked, {{"sum", 43}});
  EXPECT_EQ(caller->receive_one()["values"]["sum"], 42);
  EXPECT_THAT(warnings(*provider), SizeIs(1));
}

TEST_F(ClientServicesTest, AnAnswerOfNoUseFailsTheCallAtOnce) {
  offer(*provider, "/add");
  for (const char* const rest : {R"("values": {})", R"("values": {}, "result": "yes")",
                                 R"("values": [1], "result": true)", R"("values": "sum", "result": true)"}) {
    call(*caller, "/add");
    const json asked = taken(*provider);
    EXPECT_THAT(provider->refusal_of_text(R"({"op": "service_response", "service": "/add", "id": )" +
                                          asked["id"].dump() + ", " + rest + "}"),
                testing::AnyOf(HasSubstr("result is"), HasSubstr("values is")));
    EXPECT_THAT(failure_of(*caller), HasSubstr("of no use"));
  }
}

TEST_F(ClientServicesTest, AProviderMayCallItself) {
  offer(*provider, "/loop");
  call(*provider, "/loop");
  const json asked = taken(*provider);
  respond(*provider, asked, {{"deep", 1}});
  EXPECT_EQ(provider->receive_one()["values"]["deep"], 1);
  for (std::size_t i = 0; i < Limits{}.calls_of_provider; ++i) {
    call(*provider, "/loop");
    taken(*provider);  // and calls again, before it answers
  }
  call(*provider, "/loop");
  EXPECT_THAT(failure_of(*provider), HasSubstr("32"));
  provider.reset();
  EXPECT_EQ(hub.statistics().clients, 1U);
}

TEST_F(ClientServicesTest, OneProviderHasSoManyCallsToAnswer) {
  offer(*provider, "/add");
  std::vector<std::unique_ptr<TestClient>> callers;
  for (std::size_t i = 0; i < Limits{}.calls_of_provider; ++i) {
    callers.push_back(connect("one of many"));
    call(*callers.back(), "/add");
  }
  call(*caller, "/add");
  EXPECT_THAT(failure_of(*caller), HasSubstr("32 calls to answer"));
  callers.pop_back();
  call(*caller, "/add");
  EXPECT_THAT(caller->receive(), IsEmpty()) << "who has gone takes no place";
}

TEST_F(ClientServicesTest, OneCallerWaitsForSoManyAnswers) {
  const auto second = connect("second");
  offer(*provider, "/add");
  offer(*second, "/more");
  for (int i = 0; i < 32; ++i) {
    call(*caller, i % 2 == 0 ? "/add" : "/more");
  }
  call(*caller, "/add");
  EXPECT_THAT(failure_of(*caller), HasSubstr("wait for one of them"));
}

TEST_F(ClientServicesTest, OffersAreLimited) {
  for (std::size_t i = 0; i < Limits{}.services; ++i) {
    offer(*provider, "/s" + std::to_string(i));
  }
  EXPECT_THAT(provider->receive(), IsEmpty());
  EXPECT_THAT(provider->refusal_of(operation("advertise_service", "/more", {{"type", "a/B"}})),
              HasSubstr("unadvertise_service first"));
  std::vector<std::unique_ptr<TestClient>> many;
  for (std::size_t i = Limits{}.services; i < Limits{}.client_services; ++i) {
    if (i % 16 == 0) {
      many.push_back(connect("one of many"));
    }
    offer(*many.back(), "/s" + std::to_string(i));
  }
  EXPECT_THAT(caller->refusal_of(operation("advertise_service", "/more", {{"type", "a/B"}})),
              HasSubstr("256"));
  EXPECT_EQ(rosapi("services")["services"].size(), kServices.size() + Limits{}.client_services);
  many.clear();
  EXPECT_EQ(rosapi("services")["services"].size(), kServices.size() + Limits{}.services);
}

// A caller that gives up at once cannot fill what waits for the provider until that is dropped.
TEST_F(ClientServicesTest, CallsDoNotEndAProviderThatReadsSlowly) {
  offer(*provider, "/add");
  for (int i = 0; i < 400; ++i) {
    call(*caller, "/add", {{"timeout", 0.001}, {"args", {{"text", std::string(60'000, 'x')}}}});
    now_ns += 10 * kMillisecond_ns;
    hub.step(now_ns);
    caller->receive();
  }
  EXPECT_FALSE(provider->closed);
  EXPECT_LE(hub.statistics().waiting_bytes, Limits{}.waiting_bytes / 2 + 100'000);
  call(*caller, "/add");
  pass(20 * kMillisecond_ns);
  EXPECT_FALSE(caller->closed);
  EXPECT_THAT(provider->receive(), Not(IsEmpty()));
}

TEST_F(ClientServicesTest, WhoCallEachOtherMayBothGo) {
  // Each waits for the other: the end of one is told to the other.
  offer(*provider, "/a");
  offer(*caller, "/b");
  for (int i = 0; i < 16; ++i) {
    call(*caller, "/a");
    call(*provider, "/b");
  }
  provider.reset();
  caller.reset();
  EXPECT_EQ(hub.statistics().clients, 0U);
  EXPECT_EQ(hub.statistics().waiting_bytes, 0U);
}

TEST_F(ClientServicesTest, RosapiTellsOfThem) {
  offer(*provider, "add");
  EXPECT_THAT(rosapi("services")["services"], Contains("/add"));
  EXPECT_EQ(rosapi("service_type", {{"service", "/add"}})["type"], "my_srvs/srv/Add");
  EXPECT_THAT(rosapi("services_for_type", {{"type", "my_srvs/srv/Add"}})["services"], ElementsAre("/add"));
  const json node = rosapi("service_node", {{"service", "/add"}})["node"];
  EXPECT_THAT(node.get<std::string>(), HasSubstr("/client_"));
  EXPECT_THAT(rosapi("service_providers", {{"service", "my_srvs/srv/Add"}})["providers"], ElementsAre(node));
  EXPECT_THAT(rosapi("nodes")["nodes"], Contains(node));
  EXPECT_THAT(rosapi("node_details", {{"node", node}})["services"], ElementsAre("/add"));
  EXPECT_EQ(rosapi("service_node", {{"service", "/stand"}})["node"], "/gaitway");
}

TEST_F(ClientServicesTest, TheRobotsServicesAreCalledAsEver) {
  offer(*provider, "/add");
  EXPECT_EQ(caller->call("/command/acquire", {{"name", "x"}})["values"]["success"], true);
  EXPECT_THAT(provider->receive(), IsEmpty());
}

}  // namespace
}  // namespace gaitway::api
