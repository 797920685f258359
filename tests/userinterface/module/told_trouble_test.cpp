// What the module itself says of bad input, to its log and to its clients: a certificate that has expired, a
// link with nobody at its other end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "module_process.hpp"
#include "secret_files.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

// The message of a topic that the module sends first, or the first one for which `holds`.
template <class Holds>
json message_of(WebSocketClient& client, const std::string& topic, Holds holds) {
  client.send(json{{"op", "subscribe"}, {"topic", topic}}.dump());
  for (;;) {
    json message = json::parse(client.receive().text);
    if (message["op"] == "publish" && message["topic"] == topic && holds(message["msg"])) {
      return message["msg"];
    }
  }
}
const auto kAny = [](const json&) { return true; };

TEST(ToldTrouble, AnExpiredCertificateIsInTheLogAndOnATopicAndRefusesNobody) {
  const SecretFiles files(SecretFiles::KeyKind::elliptic, {-10 * SecretFiles::kDay, -SecretFiles::kDay});
  const ModuleProcess module(
      {"--token-file", files.token(), "--certificate-file", files.certificate(), "--key-file", files.key()});
  EXPECT_THAT(module.said(),
              AllOf(HasSubstr("the certificate of 'localhost' in certificate_file"), HasSubstr("expired on"),
                    HasSubstr("1 day ago"), HasSubstr(files.certificate().native()), HasSubstr("renew it")));
  WebSocketClient client(module.port(),
                         {.headers = {{"Authorization", "Bearer " + std::string(SecretFiles::kToken)}},
                          .tls = true,
                          .highest_tls = 0});
  const json state = message_of(client, "/certificate_state", kAny);
  EXPECT_THAT(state["data"].get<std::string>(), HasSubstr("expired on"));
}

TEST(ToldTrouble, ACertificateThatCountsIsNotSpokenOf) {
  const SecretFiles files(SecretFiles::KeyKind::elliptic, {-SecretFiles::kDay, 300 * SecretFiles::kDay});
  const ModuleProcess module(
      {"--token-file", files.token(), "--certificate-file", files.certificate(), "--key-file", files.key()});
  EXPECT_THAT(module.said(), testing::Not(HasSubstr("certificate")));
  WebSocketClient client(module.port(),
                         {.headers = {{"Authorization", "Bearer " + std::string(SecretFiles::kToken)}},
                          .tls = true,
                          .highest_tls = 0});
  EXPECT_EQ(message_of(client, "/certificate_state", kAny)["data"], "");
}

TEST(ToldTrouble, ALinkWithNobodyAtItsOtherEndIsToldWithItsPathEachSecond) {
  const ModuleProcess module({});
  WebSocketClient client(module.port());
  const json first = message_of(client, "/link_state", [](const json& state) {
    return state["text"].get<std::string>().find("cannot connect") != std::string::npos;
  });
  EXPECT_EQ(first["state"], "down");
  EXPECT_EQ(first["link"], "unix:/nowhere/link.sock");
  EXPECT_THAT(first["text"].get<std::string>(),
              AllOf(HasSubstr("'/nowhere/link.sock'"), HasSubstr("Is main_controller running")));
  const json later = message_of(client, "/link_state",
                                [&](const json& state) { return state["seconds"] > first["seconds"]; });
  EXPECT_EQ(later["text"], first["text"]);
}

}  // namespace
}  // namespace gaitway::api
