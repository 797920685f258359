// Messages there and back, and how conversations end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "raw_client.hpp"
#include "running_server.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Waits for this ending, and for the session to be gone.
void await_closing(RunningServer& server, Closing cause, std::uint64_t count = 1) {
  server.await([=](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.of(cause) == count && statistics.connected == 0 && hub.sessions == 0;
  });
}

TEST(Conversation, MessagesComeThroughWholeAndInTheirKind) {
  RunningServer server(local());
  WebSocketClient client(server.port());
  for (const std::size_t size : {0U, 1U, 125U, 126U, 4096U, 65535U, 65536U}) {
    for (const bool binary : {false, true}) {
      const std::string text(size, binary ? '\xFF' : 'x');
      client.send(text, binary);
      const auto echo = client.receive();
      EXPECT_EQ(echo.text, text);
      EXPECT_EQ(echo.binary, binary);
    }
  }
  client.close();
  await_closing(server, Closing::by_client);
  const auto statistics = server.statistics();
  EXPECT_EQ(statistics.messages_in, 14U);
  EXPECT_EQ(statistics.messages_out, 14U);
  EXPECT_EQ(statistics.bytes_in, statistics.bytes_out);
}

TEST(Conversation, FragmentsBecomeOneMessage) {
  RunningServer server(local());
  WebSocketClient client(server.port());
  const std::string text =
      "Gr\xC3\xBC\xC3\x9F"
      "e an den Roboter";
  client.send_in_fragments(text, 1);
  EXPECT_EQ(client.receive().text, text);
  EXPECT_EQ(server.statistics().messages_in, 1U);
}

TEST(Conversation, ManyMessagesShareAWrite) {
  RunningServer server(local());
  WebSocketClient client(server.port());
  client.send("many 300");
  for (int count = 0; count < 300; ++count) {
    ASSERT_EQ(client.receive().text.size(), 16'384U);
  }
  const auto statistics = server.statistics();
  EXPECT_EQ(statistics.messages_out, 300U);
  EXPECT_LT(statistics.writes, 250U);
}

TEST(Conversation, TooLongMessagesEndIt) {
  RunningServer server(local());
  WebSocketClient client(server.port());
  client.send(std::string(65'537, 'x'));
  EXPECT_EQ(client.receive_close(), 1009U);
  await_closing(server, Closing::too_big);
}

TEST(Conversation, TooLongInFragmentsEndsIt) {
  RunningServer server(local());
  RawClient client(server.port());
  client.open_websocket();
  client.send(masked_frame(0x01, std::string(60'000, 'x')) + masked_frame(0x80, std::string(10'000, 'x')));
  EXPECT_EQ(close_code(client.receive_frame().value()), 1009U);
  client.finish_sending();
  await_closing(server, Closing::too_big);
}

TEST(Conversation, BadUtf8EndsIt) {
  for (const std::string& bad : {std::string("\xC3\x28"), std::string("\xFF"), std::string("half \xE2\x82"),
                                 std::string("\xED\xA0\x80"), std::string("\xC0\xAF")}) {
    RunningServer server(local());
    RawClient client(server.port());
    client.open_websocket();
    client.send(masked_frame(kText, bad));
    EXPECT_EQ(close_code(client.receive_frame().value()), 1007U);
    client.finish_sending();
    await_closing(server, Closing::protocol_error);
  }
}

TEST(Conversation, BreachesOfTheProtocolEndIt) {
  const std::vector<std::pair<const char*, std::string>> breaches{
      {"unmasked", "\x81\x05hello"},
      {"reserved opcode", masked_frame(0x83, "x")},
      {"reserved control opcode", masked_frame(0x8B, "x")},
      {"reserved bit", masked_frame(0xC1, "x")},
      {"continuation of nothing", masked_frame(0x80, "x")},
      {"a new message within another", masked_frame(0x01, "x") + masked_frame(kText, "y")},
      {"ping in fragments", masked_frame(0x09, "x")},
      {"long ping", masked_frame(kPing, std::string(126, 'x'))},
      {"close code that may not be sent", masked_frame(kClose, "\x03\xED")},
      {"half a close code", masked_frame(kClose, "\x03")}};
  for (const auto& [what, bytes] : breaches) {
    RunningServer server(local());
    RawClient client(server.port());
    client.open_websocket();
    client.send(bytes);
    EXPECT_EQ(close_code(client.receive_frame().value()), 1002U) << what;
    client.finish_sending();
    await_closing(server, Closing::protocol_error);
    EXPECT_EQ(server.statistics().messages_in, 0U) << what;
  }
}

TEST(Conversation, HugeAnnouncedLengthsReserveNothing) {
  using namespace std::string_literals;
  RunningServer server(local());
  RawClient client(server.port());
  client.open_websocket();
  client.send("\x82\xFF\x3F\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x01\x02\x03\x04"s);
  EXPECT_EQ(close_code(client.receive_frame().value()), 1009U);
}

TEST(Conversation, WhoBreaksTheProtocolAndStaysIsCutOff) {
  ServerOptions options = local();
  options.closing_ns = 50'000'000;
  RunningServer server(options);
  RawClient client(server.port());
  client.open_websocket();
  client.send("\x81\x05hello");
  await_closing(server, Closing::protocol_error);
}

TEST(Conversation, ClosesAfterWhatWaitsWhenItsSessionAsks) {
  RunningServer server(local());
  RawClient client(server.port());
  client.open_websocket();
  client.send(masked_frame(kText, "close"));
  EXPECT_EQ(client.receive_frame().value().payload, "one");
  EXPECT_EQ(client.receive_frame().value().payload, "two");
  const auto close = client.receive_frame().value();
  EXPECT_EQ(close_code(close), 1008U);
  EXPECT_EQ(close_reason(close), "as you wish");
  client.send(masked_frame(kClose, "\x03\xF0"));
  EXPECT_EQ(client.receive_all(), "");
  await_closing(server, Closing::by_session);
}

TEST(Conversation, WithoutAPlaceInTheHubEndsWithTheReason) {
  RunningServer server(local());
  server.await([](const ServerStatistics&, EchoHub& hub) {
    hub.most_sessions = 1;
    return true;
  });
  WebSocketClient first(server.port());
  RawClient second(server.port());
  second.open_websocket();
  const auto close = second.receive_frame().value();
  EXPECT_EQ(close_code(close), 1013U);
  EXPECT_THAT(close_reason(close), HasSubstr("no place"));
  first.send("still here");
  EXPECT_EQ(first.receive().text, "still here");
}

TEST(Conversation, AResetEndsTheSession) {
  RunningServer server(local());
  RawClient client(server.port());
  client.open_websocket();
  server.await([](const ServerStatistics&, EchoHub& hub) { return hub.sessions == 1; });
  client.reset();
  await_closing(server, Closing::lost);
}

TEST(Conversation, EndsWhenTheServerStops) {
  auto server = std::make_unique<RunningServer>(local());
  WebSocketClient client(server->port());
  RawClient deaf(server->port());  // never answers
  deaf.open_websocket();
  RawClient half(server->port());
  half.send("GET /");
  server->await(
      [](const ServerStatistics& now, EchoHub& hub) { return hub.sessions == 2 && now.connected == 3; });
  std::thread stopping([&] { server->stop(); });
  EXPECT_EQ(client.receive_close(), 1001U);
  stopping.join();
  const auto statistics = server->statistics();
  EXPECT_EQ(statistics.of(Closing::shut_down), 2U);
  EXPECT_EQ(statistics.connected, 0U);
  EXPECT_EQ(half.receive_all(), "");
}

TEST(Conversation, IsCutOffWhenTheServerNeverRuns) {
  EchoHub hub;
  std::unique_ptr<RawClient> client;
  {
    Server server(hub, ServerSetup(local()));
    client = std::make_unique<RawClient>(server.port());
    server.stop();
    server.run();
  }
  EXPECT_EQ(client->receive_all(), "");
}

}  // namespace
}  // namespace gaitway::api
