// How old a message may be: at most as old as the newest ping that its client has answered before it.
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "raw_client.hpp"
#include "running_server.hpp"

namespace gaitway::api {
namespace {

using Clock = std::chrono::steady_clock;

ServerOptions quick_pings() {
  ServerOptions options = local();
  options.ping_ns = 20 * facts::kMillisecond_ns;
  return options;
}

// A client that answers pings, or leaves that for later.
class AskingClient {
 public:
  explicit AskingClient(const RunningServer& server) : client_(server.port()) { client_.open_websocket(); }

  // The newest ping that comes within the time.
  std::string newest_ping(std::chrono::milliseconds within) {
    for (const auto end = Clock::now() + within; Clock::now() < end;) {
      age_ms();
    }
    return client_.newest_ping();
  }
  void answer(const std::string& ping) { client_.send(masked_frame(kPong, ping)); }
  // What the server says of a message that is sent now.
  int age_ms() {
    client_.send(masked_frame(kText, "age"));
    return std::stoi(client_.receive_frame().value().payload);
  }

 private:
  RawClient client_;
};

TEST(MessageAge, AFirstMessageIsAsOldAsTheConnection) {
  RunningServer server(quick_pings());
  AskingClient client(server);
  EXPECT_LT(client.age_ms(), 1000);
  client.newest_ping(std::chrono::milliseconds(300));  // and not answered
  EXPECT_GE(client.age_ms(), 250) << "it may have been sent at once, and held up since";
}

TEST(MessageAge, AnAnsweredPingDatesWhatComesAfterIt) {
  RunningServer server(quick_pings());
  AskingClient client(server);
  const std::string old = client.newest_ping(std::chrono::milliseconds(200));
  const auto pinged = Clock::now();
  client.newest_ping(std::chrono::milliseconds(300));
  EXPECT_GE(client.age_ms(), 450);
  client.answer(old);
  const int age_ms = client.age_ms();
  const auto since_ms = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - pinged).count();
  EXPECT_GE(age_ms, 280) << "as old as that ping, and not younger";
  EXPECT_LE(age_ms, since_ms + 100);
}

TEST(MessageAge, APongThatAnswersNoPingDatesNothing) {
  RunningServer server(quick_pings());
  AskingClient client(server);
  client.newest_ping(std::chrono::milliseconds(300));
  for (const char* const pong : {"", "soon", "9223372036854775807", "-1", "12x"}) {
    client.answer(pong);
    EXPECT_GE(client.age_ms(), 250) << pong;
  }
}

}  // namespace
}  // namespace gaitway::api
