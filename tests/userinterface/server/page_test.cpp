// The page over HTTP, and the view beside the robot API: who gets what, under which name, and how fast.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/api/view_hub.hpp"
#include "gaitway/page/view_frame.hpp"
#include "gaitway/process/real_time.hpp"
#include "page_host.hpp"
#include "raw_client.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

page::AssetTable small_page() {
  page::AssetTable assets;
  assets.add("/", "text/html; charset=utf-8", "<p>the page</p>", false);
  assets.add("/page.js", "text/javascript; charset=utf-8", std::string(20'000, ' ') + "// end", false);
  assets.add("/robot.json", "application/json", "{}", true);
  return assets;
}

// A server with page and view, whose view shows a new frame whenever one is due.
class PageServer {
 public:
  explicit PageServer(ServerOptions options = local(), ViewOptions view = {})
      : view_(std::move(view)),
        server_(hub_, ServerSetup(std::move(options)),
                {.on_tick = {},
                 .on_poll =
                     [this](std::int64_t wall_ns) {
                       if (view_.due(wall_ns)) {
                         state_.commander = "somebody";
                         view_.show(state_, wall_ns);
                       }
                     },
                 .on_refusals = [this](const std::string& line) { refusals_.push(line); }},
                {.assets = &assets_, .view = &view_, .version = "of-the-test"}),
        thread_([this] { server_.run(); }) {}
  ~PageServer() {
    server_.stop();
    thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return server_.port(); }
  [[nodiscard]] std::string await_refusal() const { return refusals_.wait(); }
  [[nodiscard]] std::string ask(const std::string& line, const std::string& more = "",
                                const std::string& host = "127.0.0.1") const {
    RawClient client(port());
    client.send(line + " HTTP/1.1\r\nHost: " + host + "\r\n" + more + "\r\n");
    return client.receive_all();
  }

 private:
  // The newest line, which another thread has waited for.
  class Lines {
   public:
    void push(const std::string& line) {
      const std::scoped_lock lock(mutex_);
      line_ = line;
      news_.notify_all();
    }
    [[nodiscard]] std::string wait() const {
      constexpr auto kPatience = std::chrono::seconds(20);
      std::unique_lock lock(mutex_);
      news_.wait_for(lock, kPatience, [this] { return !line_.empty(); });
      return line_;
    }

   private:
    mutable std::mutex mutex_;
    mutable std::condition_variable news_;
    std::string line_;
  };

  Lines refusals_;
  EchoHub hub_;
  ViewHub view_;
  page::ViewState state_;
  page::AssetTable assets_ = small_page();
  Server server_;
  std::thread thread_;
};

ServerOptions with_token(const SecretFiles& files) {
  ServerOptions options = local();
  options.token_file = files.token();
  return options;
}

WebSocketClient::Options to_view() {
  WebSocketClient::Options options;
  options.target = "/view";
  return options;
}

std::uint32_t frame_of(const std::string& bytes) {
  std::uint32_t frame = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    frame |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(2 + i))) << (8 * i);
  }
  return frame;
}

TEST(Page, IsGivenWithItsTypeAndAStrictPolicy) {
  const PageServer server;
  EXPECT_THAT(server.ask("GET /"),
              AllOf(StartsWith("HTTP/1.1 200 "), HasSubstr("Content-Type: text/html; charset=utf-8\r\n"),
                    HasSubstr("Content-Security-Policy: default-src 'none'; script-src 'self';"),
                    HasSubstr("X-Content-Type-Options: nosniff\r\n"), Not(HasSubstr("unsafe")),
                    HasSubstr("Content-Length: 15\r\n"), EndsWith("\r\n\r\n<p>the page</p>")));
  EXPECT_THAT(server.ask("GET /page.js"), EndsWith("// end"));
}

TEST(Page, IsCompressedForWhoAsksForIt) {
  const PageServer server;
  const std::string answer = server.ask("GET /page.js", "Accept-Encoding: deflate, gzip;q=1.0\r\n");
  EXPECT_THAT(answer, AllOf(StartsWith("HTTP/1.1 200 "), HasSubstr("Content-Encoding: gzip\r\n")));
  EXPECT_LT(answer.size(), 2'000U);
}

TEST(Page, HeadGetsTheHeaderAlone) {
  const PageServer server;
  EXPECT_THAT(server.ask("HEAD /"),
              AllOf(StartsWith("HTTP/1.1 200 "), HasSubstr("Content-Length: 15\r\n"), EndsWith("\r\n\r\n")));
}

TEST(Page, NothingElseIsThere) {
  const PageServer server;
  EXPECT_THAT(server.ask("GET /other"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(server.ask("GET /../etc/passwd"), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(server.ask("POST /"), AllOf(StartsWith("HTTP/1.1 405 "), HasSubstr("Allow: GET")));
  EXPECT_THAT(server.ask("GET /" + std::string(9000, 'x')), StartsWith("HTTP/1.1 431 "));
}

// Else a page of somebody's could have its name point to the robot, and read it as its own.
TEST(Page, IsGivenUnderNamesOfTheRobotAlone) {
  const PageServer server;
  for (const char* host : {"127.0.0.1", "localhost:9090", "[::1]:9090", "192.168.1.5"}) {
    EXPECT_THAT(server.ask("GET /", "", host), StartsWith("HTTP/1.1 200 ")) << host;
  }
  for (const char* host :
       {"robot.example", "127.0.0.1.evil.example", "localhost.evil.example:9090", "", "[::1"}) {
    EXPECT_THAT(server.ask("GET /", "", host), StartsWith("HTTP/1.1 421 ")) << host;
  }
  ServerOptions options = local();
  options.origins = {"http://robot.example:9090"};
  const PageServer named(std::move(options));
  EXPECT_THAT(named.ask("GET /", "", "robot.example:9090"), StartsWith("HTTP/1.1 200 "));
}

TEST(Page, DescriptionOfTheRobotWantsTheTokenAndThePageDoesNot) {
  const SecretFiles files;
  const PageServer server(with_token(files));
  EXPECT_THAT(server.ask("GET /"), StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(server.ask("GET /robot.json"), AllOf(StartsWith("HTTP/1.1 401 "), Not(HasSubstr("{}"))));
  EXPECT_THAT(server.ask("GET /robot.json", "Authorization: Bearer wrong-token-of-bytes\r\n"),
              StartsWith("HTTP/1.1 401 "));
  EXPECT_THAT(
      server.ask("GET /robot.json", "Authorization: Bearer " + std::string(SecretFiles::kToken) + "\r\n"),
      EndsWith("{}"));
}

TEST(Page, OfTheRobotItselfMayTalkToItAndOthersMayNot) {
  EXPECT_TRUE(is_own_page("https://192.168.1.5:9090", "192.168.1.5:9090", true));
  EXPECT_TRUE(is_own_page("http://[fe80::1]:9090", "[fe80::1]:9090", false));
  EXPECT_FALSE(is_own_page("http://192.168.1.5:9090", "192.168.1.5:9090", true));
  EXPECT_FALSE(is_own_page("http://192.168.1.5:8080", "192.168.1.5:9090", false));
  EXPECT_FALSE(is_own_page("http://evil.example", "evil.example", false));
  EXPECT_FALSE(is_own_page("null", "127.0.0.1:9090", false));
}

TEST(View, GivesNewerAndNewerFramesToWhoAcknowledgesThem) {
  const PageServer server;
  WebSocketClient client(server.port(), to_view());
  std::uint32_t last = 0;
  for (int count = 0; count < 20; ++count) {
    const auto message = client.receive();
    ASSERT_TRUE(message.binary);
    ASSERT_LE(message.text.size(), page::kMostViewBytes);
    EXPECT_GT(frame_of(message.text), last);
    last = frame_of(message.text);
    client.send(message.text.substr(2, 4), true);
  }
}

TEST(View, SendsNoMoreThanEightToWhoAcknowledgesNone) {
  const PageServer server;
  WebSocketClient idle(server.port(), to_view());
  WebSocketClient busy(server.port(), to_view());
  std::uint32_t newest = 0;
  for (int count = 0; count < 30; ++count) {
    const std::string frame = busy.receive().text;
    newest = frame_of(frame);
    busy.send(frame.substr(2, 4), true);
  }
  std::string frame;
  for (std::size_t count = 0; count < ViewHub::kMostInFlight; ++count) {
    frame = idle.receive().text;
  }
  EXPECT_LT(frame_of(frame), newest);
  idle.send(frame.substr(2, 4), true);
  EXPECT_GE(frame_of(idle.receive().text), newest) << "an old frame waited";
}

TEST(View, PingsWhoAcknowledgesNothingAlone) {
  const PageServer server;
  RawClient busy(server.port()), idle(server.port());
  for (RawClient* client : {&busy, &idle}) {
    client->send(upgrade_request("", "/view"));
    client->receive_header();
  }
  for (int count = 0; count < 15; ++count) {
    busy.send(masked_frame(kBinary, busy.receive_frame().value().payload.substr(2, 4)));
  }
  for (std::size_t count = 0; count < ViewHub::kMostInFlight; ++count) {
    static_cast<void>(idle.receive_frame());
  }
  EXPECT_EQ(busy.newest_ping(), "");
  EXPECT_NE(idle.newest_ping(), "");
}

TEST(View, DoesNotWaitForClientsThatLeaveMuchUnread) {
  const PageServer server;
  std::vector<std::unique_ptr<RawClient>> greedy;
  for (int count = 0; count < 20; ++count) {
    greedy.push_back(std::make_unique<RawClient>(server.port()));
    greedy.back()->open_websocket();
    greedy.back()->send(masked_frame(kText, "many 200"));
  }
  WebSocketClient client(server.port(), to_view());
  std::int64_t longest_ns = 0;
  for (int count = 0; count < 30; ++count) {
    const std::int64_t asked_ns = process::monotonic_ns();
    const std::string frame = client.receive().text;
    longest_ns = std::max(longest_ns, process::monotonic_ns() - asked_ns);
    client.send(frame.substr(2, 4), true);
  }
  EXPECT_LT(longest_ns, 250'000'000);
}

TEST(View, ClosesOnWhatIsNoAcknowledgement) {
  const PageServer server;
  for (const bool binary : {false, true}) {
    WebSocketClient client(server.port(), to_view());
    client.send(std::string("\x7F\x7F\x7F\x7F"), binary);
    EXPECT_EQ(client.receive_close(), 1008U);
  }
}

TEST(View, IsRefusedToAPageOfAnotherVersionAndGivenToOneOfThisOne) {
  const PageServer server;
  EXPECT_THAT(server.ask("GET /view?page=of-last-year",
                         "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"),
              AllOf(StartsWith("HTTP/1.1 409 "), HasSubstr("version 'of-last-year'"),
                    HasSubstr("serves 'of-the-test'"), HasSubstr("load the page again")));
  EXPECT_THAT(server.await_refusal(),
              AllOf(HasSubstr("a page of another version"), HasSubstr("127.0.0.1, page 'of-last-year'")));
  WebSocketClient::Options options;
  options.target = "/view?page=of-the-test";
  WebSocketClient client(server.port(), options);
  EXPECT_GT(frame_of(client.receive().text), 0U);
}

TEST(View, WantsTheTokenFirst) {
  const SecretFiles files;
  const PageServer server(with_token(files),
                          {.is_token = [](std::string_view text) { return text == SecretFiles::kToken; }});
  WebSocketClient client(server.port(), to_view());
  client.send(SecretFiles::kToken);
  EXPECT_TRUE(client.receive().binary);
  WebSocketClient wrong(server.port(), to_view());
  wrong.send("wrong");
  EXPECT_EQ(wrong.receive_close(), 1008U);
}

TEST(View, AndPageLeaveTheRobotApiWhereItWas) {
  const PageServer server;
  WebSocketClient client(server.port());
  client.send("echo");
  EXPECT_EQ(client.receive().text, "echo");
  EXPECT_THAT(server.ask("GET /view"), StartsWith("HTTP/1.1 404 "));
}

}  // namespace
}  // namespace gaitway::api
