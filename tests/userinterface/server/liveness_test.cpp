// Who shows no sign of life, does not read, or does nothing but ping.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gaitway/facts/facts.hpp"
#include "raw_client.hpp"
#include "running_server.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kMs = facts::kMillisecond_ns;
constexpr std::int64_t kForEver = 3'600'000 * kMs;

// A computer that is busy elsewhere for so long.
void stall(std::int64_t duration_ns) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::nanoseconds(duration_ns);
  std::this_thread::sleep_until(end);
}

TEST(Liveness, SilentClientsAreDropped) {
  ServerOptions options = local();
  options.limits.silence_ns = 100 * kMs;
  options.ping_ns = 30 * kMs;
  options.closing_ns = 30 * kMs;
  RunningServer server(options);
  RawClient half_open(server.port());
  half_open.open_websocket();
  server.await([](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.of(Closing::silent) == 1 && statistics.connected == 0 && hub.sessions == 0;
  });
  const auto close = half_open.receive_frame().value();
  EXPECT_EQ(close_code(close), 1008U);
  EXPECT_THAT(close_reason(close), HasSubstr("100 ms"));
}

TEST(Liveness, DefaultsEndACommandWithinASecondAndAWatcherWithinTen) {
  const ServerOptions options;
  EXPECT_EQ(options.limits.lease_ns, 1000 * kMs);
  EXPECT_EQ(options.limits.silence_ns, 10'000 * kMs);
  EXPECT_GE(options.limits.silence_ns, 3 * options.ping_ns);
}

TEST(Liveness, AServerThatStoodStillDropsNobody) {
  ServerOptions options = local();
  options.limits.silence_ns = options.limits.write_ns = 200 * kMs;
  options.ping_ns = 50 * kMs;
  RunningServer server(options);
  WebSocketClient client(server.port());
  RawClient holder(server.port()), asking(server.port());
  holder.open_websocket();
  asking.open_websocket();
  asking.send(masked_frame(kText, "many 2000"));  // so that a write to it is under way
  std::thread reading([&] { EXPECT_EQ(client.receive_close(), 1001U); });
  server.while_held(holder, [&] { stall(3 * options.limits.silence_ns); });
  server.await([steps = std::uint64_t{0}](const ServerStatistics&, EchoHub& hub) mutable {
    steps = steps == 0 ? hub.steps : steps;
    return hub.steps > steps + 5;
  });
  EXPECT_EQ(server.statistics().of(Closing::silent) + server.statistics().of(Closing::slow), 0U);
  server.stop();
  reading.join();
}

TEST(Liveness, AnswersToPingsKeepAQuietConnection) {
  ServerOptions options = local();
  options.limits.silence_ns = 400 * kMs;
  options.ping_ns = 20 * kMs;
  RunningServer server(options);
  WebSocketClient client(server.port());
  std::thread reading([&] { EXPECT_EQ(client.receive_close(), 1001U); });
  // More than silence_ns can hold without them.
  server.await([](const ServerStatistics& statistics, EchoHub&) { return statistics.control_frames >= 30; });
  EXPECT_EQ(server.statistics().of(Closing::silent), 0U);
  server.stop();
  reading.join();
}

TEST(Liveness, AMessageThatArrivesSlowlyIsASignOfLife) {
  ServerOptions options = local();
  options.limits.silence_ns = 300 * kMs;
  RunningServer server(options);
  RawClient client(server.port());
  client.open_websocket();
  const std::string message(60, 'x');
  for (const char byte : masked_frame(kText, message)) {
    client.send({&byte, 1});
    static_cast<void>(server.statistics());  // a tick
  }
  EXPECT_EQ(client.receive_frame().value().payload, message);
}

TEST(Liveness, PingsAreAnsweredWithTheirOwnBytes) {
  RunningServer server(local());
  RawClient client(server.port());
  client.open_websocket();
  client.send(masked_frame(kPing, "are you there"));
  const auto pong = client.receive_frame().value();
  EXPECT_EQ(pong.opcode, kPong);
  EXPECT_EQ(pong.payload, "are you there");
  server.await([](const ServerStatistics& statistics, EchoHub&) { return statistics.control_frames == 1; });
}

std::string pings(int count) {
  std::string all;
  for (int ping = 0; ping < count; ++ping) {
    all += masked_frame(kPing, "flood");
  }
  return all;
}

TEST(Liveness, AFloodOfPingsEndsTheConversation) {
  RunningServer server(local());
  RawClient client(server.port());
  client.open_websocket();
  client.send(pings(150));
  std::optional<RawClient::Message> last;
  while (const auto message = client.receive_frame()) {
    last = message;
    if (close_code(*message) != 0) {
      client.finish_sending();
    }
  }
  ASSERT_TRUE(last);
  EXPECT_EQ(close_code(*last), 1008U);
  server.await(
      [](const ServerStatistics& statistics, EchoHub&) { return statistics.of(Closing::flood) == 1; });
}

TEST(Liveness, AFloodThatDoesNotReadIsCutOff) {
  ServerOptions options = local();
  options.limits.silence_ns = options.limits.write_ns = kForEver;
  RunningServer server(options);
  RawClient client(server.port());
  client.open_websocket();
  const std::string flood = pings(1000);
  while (client.send(flood)) {
  }
  server.await([](const ServerStatistics& statistics, EchoHub& hub) {
    return statistics.of(Closing::flood) == 1 && statistics.connected == 0 && hub.sessions == 0;
  });
}

// A client that asks for more than its and the server's kernel buffers hold, and does not read.
void expect_slow_client_is_told(ServerOptions options) {
  options.closing_ns = 100 * kMs;
  RunningServer server(options);
  RawClient slow(server.port());
  WebSocketClient other(server.port());
  slow.open_websocket();
  slow.send(masked_frame(kText, "many 2000"));
  bool dropped = false;
  while (!dropped) {  // nobody else notices
    other.send("undisturbed");
    ASSERT_EQ(other.receive().text, "undisturbed");
    const auto statistics = server.statistics();
    dropped = statistics.of(Closing::slow) == 1 && statistics.connected == 1;
  }
  std::optional<RawClient::Message> last;
  std::size_t whole = 0;
  while (auto message = slow.receive_frame()) {
    whole += message->opcode == kBinary ? std::size_t{1} : 0;
    EXPECT_TRUE(message->opcode != kBinary || message->payload.size() == 16'384U);
    last = std::move(message);
  }
  EXPECT_GT(whole, 0U);
  EXPECT_LT(whole, 2000U);
  ASSERT_TRUE(last);
  EXPECT_EQ(close_code(*last), 1013U);
  EXPECT_THAT(close_reason(*last), HasSubstr("too slow"));
}

TEST(Liveness, SlowReadersAreToldAndDropped) {
  ServerOptions options = local();
  options.limits.silence_ns = kForEver;
  options.limits.write_ns = 100 * kMs;
  expect_slow_client_is_told(options);
}

TEST(Liveness, SlowReadersThatAnswerNothingAreToldAndDropped) {
  ServerOptions options = local();
  options.limits.write_ns = kForEver;
  options.limits.silence_ns = 300 * kMs;
  options.ping_ns = 50 * kMs;
  expect_slow_client_is_told(options);
}

}  // namespace
}  // namespace gaitway::api
