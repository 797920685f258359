// The same over TLS, with a certificate that the test signs itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/tls1.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "raw_client.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

class Tls : public testing::Test {
 protected:
  [[nodiscard]] ServerOptions secured() const {
    ServerOptions options = local();
    options.token_file = files_.token();
    options.certificate_file = files_.certificate();
    options.key_file = files_.key();
    return options;
  }
  static WebSocketClient::Options with_token(std::string_view token) {
    return {.headers = {{"Authorization", "Bearer " + std::string(token)}}, .tls = true, .highest_tls = 0};
  }
  SecretFiles files_;
};

TEST_F(Tls, CarriesMessagesOfEverySize) {
  RunningServer server(secured());
  WebSocketClient client(server.port(), with_token(SecretFiles::kToken));
  for (const std::size_t size : {0U, 1U, 126U, 16'384U, 65'536U}) {
    const std::string text(size, 'x');
    client.send(text);
    EXPECT_EQ(client.receive().text, text);
  }
  client.send("many 300");
  for (int count = 0; count < 300; ++count) {
    ASSERT_EQ(client.receive().text.size(), 16'384U);
  }
  client.close();
  server.await([](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.of(Closing::by_client) == 1 && statistics.connected == 0 && hub.sessions == 0 &&
           hub.opened.at(0).authorised;
  });
}

TEST_F(Tls, AWrongTokenGetsNoWebSocket) {
  RunningServer server(secured());
  EXPECT_ANY_THROW(WebSocketClient(server.port(), with_token("wrong")));
  EXPECT_EQ(server.statistics().of(Refusal::wrong_token), 1U);
}

TEST_F(Tls, AMissingTokenLeavesTheSessionUnauthorised) {
  RunningServer server(secured());
  WebSocketClient client(server.port(), {.headers = {}, .tls = true, .highest_tls = 0});
  server.await([](const ServerStatistics&, EchoHub& hub) {
    return hub.opened.size() == 1 && !hub.opened[0].authorised;
  });
}

TEST_F(Tls, OldVersionsAreRefused) {
  RunningServer server(secured());
  auto options = with_token(SecretFiles::kToken);
  options.highest_tls = TLS1_1_VERSION;
  EXPECT_ANY_THROW(WebSocketClient(server.port(), options));
  EXPECT_EQ(server.statistics().of(Refusal::tls), 1U);
  options.highest_tls = TLS1_2_VERSION;
  WebSocketClient client(server.port(), options);
  client.send("hello");
  EXPECT_EQ(client.receive().text, "hello");
}

TEST_F(Tls, PlainRequestsAreRefused) {
  RunningServer server(secured());
  RawClient client(server.port());
  client.send(upgrade_request());
  EXPECT_THAT(client.receive_all(), testing::Not(testing::HasSubstr("HTTP/1.1 101")));
  EXPECT_EQ(server.statistics().of(Refusal::tls), 1U);
}

// Whoever reaches the port may begin as many handshakes as there are places.
TEST_F(Tls, HandshakesOfStrangersHoldUpNoStop) {
  constexpr int kStrangers = 60;
  const SecretFiles costly(SecretFiles::KeyKind::costly);
  ServerOptions options = secured();
  options.certificate_file = costly.certificate();
  options.key_file = costly.key();
  RunningServer server(options);
  WebSocketClient holder(server.port(), with_token(SecretFiles::kToken));
  WebSocketClient urgent(server.port(), with_token(SecretFiles::kToken));
  std::vector<std::unique_ptr<RawClient>> strangers;
  for (int count = 0; count < kStrangers; ++count) {
    strangers.push_back(std::make_unique<RawClient>(server.port()));
  }
  server.await([](const ServerStatistics& now, EchoHub&) { return now.connected == kStrangers + 2; });
  const std::string hello = client_hello();
  server.while_held(holder, [&] {
    for (const auto& stranger : strangers) stranger->send(hello);
    urgent.send("urgent stop");
  });
  std::ptrdiff_t before = 0;
  server.await([&](const ServerStatistics&, EchoHub& hub) {
    before = std::ranges::count_if(strangers, [](const auto& one) { return one->has_answer(); });
    return !hub.taken.empty();
  });
  EXPECT_LT(before, kStrangers / 2) << "handshakes were carried on before it";
  server.await([&](const ServerStatistics&, EchoHub&) {
    return std::ranges::all_of(strangers, [](const auto& one) { return one->has_answer(); });
  });
}

TEST_F(Tls, HalfHandshakesEndInTime) {
  ServerOptions options = secured();
  options.limits.handshake_ns = 50'000'000;
  RunningServer server(options);
  RawClient client(server.port());
  client.send("\x16\x03\x01");
  EXPECT_EQ(client.receive_all(), "");
  EXPECT_EQ(server.statistics().of(Refusal::handshake_time), 1U);
}

TEST_F(Tls, SlowReadersAreDropped) {
  ServerOptions options = secured();
  options.limits.silence_ns = 3'600'000'000'000;
  options.limits.write_ns = options.closing_ns = 50'000'000;
  RunningServer server(options);
  WebSocketClient client(server.port(), with_token(SecretFiles::kToken));
  client.send("many 2000");
  server.await([](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.of(Closing::slow) == 1 && statistics.connected == 0 && hub.sessions == 0;
  });
}

TEST_F(Tls, EndsWhenTheServerStops) {
  RunningServer server(secured());
  WebSocketClient client(server.port(), with_token(SecretFiles::kToken));
  server.await([](const ServerStatistics&, EchoHub& hub) { return hub.sessions == 1; });
  std::thread stopping([&] { server.stop(); });
  EXPECT_EQ(client.receive_close(), 1001U);
  stopping.join();
}

// Whatever step of the handshake the end meets: with TLS there are many.
TEST_F(Tls, StoppingDuringAHandshakeEndsIt) {
  ServerOptions options = secured();
  options.closing_ns = 1'000'000;
  options.tick_ns = 1'000'000;
  for (int repetition = 0; repetition < 100; ++repetition) {
    RunningServer server(options);
    std::thread connecting([&] {
      try {
        WebSocketClient(server.port(), with_token(SecretFiles::kToken)).receive_close();
      } catch (const std::exception&) {  // cut off before it had a WebSocket
      }
    });
    server.await([](const ServerStatistics& statistics, EchoHub&) { return statistics.accepted == 1; });
    server.stop();
    connecting.join();
    EXPECT_EQ(server.statistics().connected, 0U);
  }
}

}  // namespace
}  // namespace gaitway::api
