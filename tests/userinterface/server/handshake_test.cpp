// What a client is told before it has a WebSocket, and how long it may take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "raw_client.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string ask(RunningServer& server, const std::string& request) {
  RawClient client(server.port());
  client.send(request);
  return client.receive_all();
}

TEST(Handshake, SucceedsAndNamesTheAcceptedKey) {
  RunningServer server(local());
  RawClient client(server.port());
  EXPECT_THAT(
      client.open_websocket(),
      AllOf(StartsWith("HTTP/1.1 101"), HasSubstr("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n")));
  server.await([](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.opened == 1 && hub.opened.at(0).peer.starts_with("127.0.0.1:") &&
           hub.opened[0].authorised;
  });
}

TEST(Handshake, OffersNoCompression) {
  RunningServer server(local());
  RawClient client(server.port());
  client.send(upgrade_request("Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits\r\n"));
  EXPECT_THAT(client.receive_header(),
              AllOf(StartsWith("HTTP/1.1 101"), testing::Not(HasSubstr("Sec-WebSocket-Extensions"))));
}

TEST(Handshake, APlainRequestIsToldToUpgrade) {
  RunningServer server(local());
  EXPECT_THAT(
      ask(server, "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"),
      AllOf(StartsWith("HTTP/1.1 426 "), HasSubstr("Upgrade: websocket\r\n"), HasSubstr("rosbridge v2")));
  EXPECT_EQ(server.statistics().of(Refusal::no_websocket), 1U);
}

TEST(Handshake, OtherPathsAreNotFound) {
  RunningServer server(local());
  EXPECT_THAT(ask(server, upgrade_request("", "/other")),
              AllOf(StartsWith("HTTP/1.1 404 "), HasSubstr("'/other'")));
  EXPECT_THAT(ask(server, upgrade_request("", "/../etc/passwd")), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(ask(server, upgrade_request("", "http://robot.example/")), StartsWith("HTTP/1.1 404 "));
  RawClient client(server.port());
  client.send(upgrade_request("", "/?token=none"));
  EXPECT_THAT(client.receive_header(), StartsWith("HTTP/1.1 101 "));
  EXPECT_EQ(server.statistics().of(Refusal::wrong_path), 3U);
}

TEST(Handshake, BadRequestsAreAnsweredWith400) {
  RunningServer server(local());
  const std::string key = "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  std::string bad_key = upgrade_request();
  bad_key.replace(bad_key.find(key), key.size(), "Sec-WebSocket-Key: short\r\n");
  std::string no_key = upgrade_request();
  no_key.erase(no_key.find(key), key.size());
  for (const std::string& request :
       {std::string("nonsense\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("\x16\x03\x01\x02\x00\x01\r\n\r\n", 10), bad_key, no_key,
        upgrade_request("Content-Length: 5\r\n"), upgrade_request("Content-Length: 5\r\n") + "12345",
        upgrade_request() + masked_frame(kText, "too early"), upgrade_request() + upgrade_request(),
        std::string("GET / HTTP/1.1\r\nbad header\r\n\r\n")}) {
    EXPECT_THAT(ask(server, request), StartsWith("HTTP/1.1 400 ")) << request;
  }
  EXPECT_EQ(server.statistics().of(Refusal::bad_request), 10U);
  EXPECT_EQ(server.statistics().opened, 0U);
}

TEST(Handshake, OtherMethodsAreRefused) {
  RunningServer server(local());
  EXPECT_THAT(ask(server, "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 405 "), HasSubstr("Allow: GET\r\n")));
}

TEST(Handshake, OtherVersionsOfTheProtocolAreToldTheRightOne) {
  RunningServer server(local());
  std::string request = upgrade_request();
  request.replace(request.find("Version: 13"), 11, "Version: 12");
  EXPECT_THAT(ask(server, request),
              AllOf(StartsWith("HTTP/1.1 426 "), HasSubstr("Sec-WebSocket-Version: 13\r\n")));
}

TEST(Handshake, LongHeadersAreRefused) {
  RunningServer server(local());
  for (const std::string& more : {"X-Long: " + std::string(100'000, 'x') + "\r\n", [] {
                                    std::string lines;
                                    for (int line = 0; line < 2000; ++line) {
                                      lines += "X-Line: " + std::to_string(line) + "\r\n";
                                    }
                                    return lines;
                                  }()}) {
    EXPECT_THAT(ask(server, upgrade_request(more)),
                AllOf(StartsWith("HTTP/1.1 431 "), HasSubstr("8192 bytes")));
  }
  const std::string endless(1'000'000, 'G');
  EXPECT_THAT(ask(server, endless), testing::AnyOf(StartsWith("HTTP/1.1 431 "), StartsWith("HTTP/1.1 400 ")));
}

TEST(Handshake, ForeignPagesAreRefusedWithTheReason) {
  RunningServer server(local());
  for (const std::string& origin :
       {std::string("http://evil.example"), std::string("null"), std::string("file://")}) {
    EXPECT_THAT(ask(server, upgrade_request("Origin: " + origin + "\r\n")),
                AllOf(StartsWith("HTTP/1.1 403 "), HasSubstr("'" + origin + "'"), HasSubstr("origins")));
  }
  EXPECT_THAT(ask(server, upgrade_request("Origin: http://localhost\r\nOrigin: http://evil.example\r\n")),
              StartsWith("HTTP/1.1 403 "));
  RawClient client(server.port());
  client.send(upgrade_request("Origin: http://localhost:8080\r\n"));
  EXPECT_THAT(client.receive_header(), StartsWith("HTTP/1.1 101 "));
  EXPECT_EQ(server.statistics().of(Refusal::foreign_origin), 4U);
}

TEST(Handshake, TokensInTheHeaderAreCheckedAtOnce) {
  const SecretFiles files;
  ServerOptions options = local();
  options.token_file = files.token();
  RunningServer server(options);
  const std::string right = "Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n";
  for (const std::string& wrong :
       {std::string("Authorization: Bearer wrong\r\n"), std::string("Authorization: Bearer\r\n"),
        std::string("Authorization: Basic dXNlcjpwYXNz\r\n"),
        "Authorization: Bearer " + std::string(SecretFiles::kToken) + "x\r\n", right + right}) {
    EXPECT_THAT(ask(server, upgrade_request(wrong)),
                AllOf(StartsWith("HTTP/1.1 401 "), HasSubstr("WWW-Authenticate: Bearer\r\n"),
                      HasSubstr("token_file"), testing::Not(HasSubstr(std::string(SecretFiles::kToken)))));
  }
  EXPECT_EQ(server.statistics().of(Refusal::wrong_token), 5U);
  RawClient with(server.port());
  with.send(upgrade_request(right));
  EXPECT_THAT(with.receive_header(), StartsWith("HTTP/1.1 101 "));
  server.await([](const ServerStatistics&, EchoHub& hub) {
    return hub.opened.size() == 1 && hub.opened[0].authorised;
  });
  RawClient without(server.port());
  EXPECT_THAT(without.open_websocket(), StartsWith("HTTP/1.1 101 "));
  server.await([](const ServerStatistics&, EchoHub& hub) {
    return hub.opened.size() == 2 && !hub.opened[1].authorised;
  });
}

TEST(Handshake, HalfOnesEndInTime) {
  ServerOptions options = local();
  options.limits.handshake_ns = 50'000'000;
  RunningServer server(options);
  RawClient silent(server.port()), half(server.port());
  half.send("GET / HTTP/1.1\r\nHost: loc");
  EXPECT_EQ(silent.receive_all(), "");
  EXPECT_EQ(half.receive_all(), "");
  EXPECT_EQ(server.statistics().of(Refusal::handshake_time), 2U);
  EXPECT_EQ(server.statistics().connected, 0U);
}

TEST(Handshake, DrippingDoesNotProlongIt) {
  ServerOptions options = local();
  options.limits.handshake_ns = 100'000'000;
  RunningServer server(options);
  RawClient drip(server.port());
  std::uint64_t sent = 0;
  drip.send("GET / HTTP/1.1\r\nX-Drip: ");
  // One byte a tick, for as long as the server takes them.
  while (server.statistics().connected > 0) {
    drip.send("x");
    ++sent;
  }
  EXPECT_GE(sent, 2U);
  EXPECT_EQ(server.statistics().of(Refusal::handshake_time), 1U);
}

TEST(Handshake, ThoseWhoLeaveAreForgotten) {
  RunningServer server(local());
  RawClient(server.port()).reset();
  {
    RawClient half(server.port());
    half.send("GET / HT");
  }
  server.await([](const ServerStatistics& statistics, EchoHub&) {
    return statistics.accepted == 2 && statistics.connected == 0 && statistics.of(Refusal::left) == 2;
  });
}

TEST(Handshake, ConnectionsBeyondTheLimitOfTheirAddressAreToldSo) {
  ServerOptions options = local();
  options.limits.connections_of_one_address = 100;
  RunningServer server(options);
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int count = 0; count < 100; ++count) {
    clients.push_back(std::make_unique<RawClient>(server.port()));
    ASSERT_THAT(clients.back()->open_websocket(), StartsWith("HTTP/1.1 101 "));
  }
  EXPECT_THAT(ask(server, upgrade_request()), AllOf(StartsWith("HTTP/1.1 503 "), HasSubstr("Retry-After")));
  EXPECT_EQ(server.statistics().of(Refusal::too_many), 1U);
  clients.pop_back();
  server.await([](const ServerStatistics& statistics, EchoHub&) { return statistics.connected == 99; });
  RawClient next(server.port());
  EXPECT_THAT(next.open_websocket(), StartsWith("HTTP/1.1 101 "));
}

TEST(Handshake, FarTooManyConnectionsAreClosedWithoutAWord) {
  ServerOptions options = local();
  options.limits.connections = 2;
  RunningServer server(options);
  std::vector<std::unique_ptr<RawClient>> clients;
  for (std::size_t count = 0; count < 34; ++count) {
    clients.push_back(std::make_unique<RawClient>(server.port()));
    if (count < options.limits.connections) {
      ASSERT_THAT(clients.back()->open_websocket(), StartsWith("HTTP/1.1 101 "));
    }
  }
  server.await([](const ServerStatistics& statistics, EchoHub&) { return statistics.connected == 34; });
  RawClient last(server.port());
  EXPECT_EQ(last.receive_all(), "");
  EXPECT_THAT(clients[2]->open_websocket(), StartsWith("HTTP/1.1 503 "));
}

}  // namespace
}  // namespace gaitway::api
