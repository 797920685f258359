// Server and client of the control channel over a real socket: answers, hostile peers, a simulator that comes
// and goes. Orders are in order_channel_test.cpp.
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "gaitway/process/private_folder.hpp"
#include "gaitway/simulation/control_client.hpp"
#include "gaitway/simulation/control_server.hpp"

namespace gaitway::simulation {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

class ControlChannelTest : public testing::Test {
 protected:
  ControlChannelTest() { start(); }

  void start() {
    server.reset();
    server = std::make_unique<ControlServer>(path, [this](const Ticket& ticket, const Push& push) {
      if (push.link == "wall") {
        throw std::invalid_argument("link is 'wall', but must be one of the robot's");
      }
      pushed.push_back(push);
      tickets.push_back(ticket);
      return push.link != "patient";
    });
  }
  [[nodiscard]] static Push push(const std::string& link = "trunk") {
    return {.link = link, .force_N = {10.0, 0.0, 0.0}, .duration_s = 0.1};
  }
  // A connection that sends what it likes.
  [[nodiscard]] process::FileDescriptor intruder() const {
    process::FileDescriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const sockaddr_un address = process::socket_address(path);
    EXPECT_EQ(connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return socket;
  }
  static bool say(const process::FileDescriptor& socket, std::span<const std::byte> packet) {
    return send(socket.get(), packet.data(), packet.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(packet.size());
  }
  static std::optional<Answer> hear(const process::FileDescriptor& socket) {
    Packet packet(kMostAnswerBytes);
    const ssize_t size = recv(socket.get(), packet.data(), packet.size(), 0);
    return size > 0 ? decode_answer(std::span(packet).first(static_cast<std::size_t>(size))) : std::nullopt;
  }
  // What becomes of what `asker` has asked, once the server has had this many milliseconds.
  std::optional<Answer> answer(ControlClient& asker, int milliseconds = 3) {
    for (int i = 0; i < milliseconds; ++i) {
      server->step();
      now_ns += facts::kMillisecond_ns;
      asker.step(now_ns);
      if (auto result = asker.take_answer()) {
        return result;
      }
    }
    return std::nullopt;
  }

  process::PrivateFolder folder{"gaitway_control_test"};
  std::filesystem::path path = folder.path() / "simulation.sock";
  std::vector<Ticket> tickets;
  std::vector<Push> pushed;
  std::unique_ptr<ControlServer> server;
  std::int64_t now_ns = facts::kSecond_ns;
};

TEST_F(ControlChannelTest, OnlyItsUserMayConnect) {
  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(ControlChannelTest, APushIsCarriedOutOnceAndAnswered) {
  ControlClient client(path);
  const std::uint32_t number = client.push(push(), now_ns);
  const auto result = answer(client);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->accepted);
  EXPECT_EQ(result->number, number);
  ASSERT_THAT(pushed, SizeIs(1));
  EXPECT_EQ(pushed[0].link, "trunk");
  EXPECT_FALSE(answer(client)) << "one answer for each";
}

TEST_F(ControlChannelTest, RefusalsBearTheReason) {
  ControlClient client(path);
  client.push(push("wall"), now_ns);
  const auto result = answer(client);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->accepted);
  EXPECT_THAT(result->text, HasSubstr("'wall'"));
  Push wrong = push();
  wrong.duration_s = 3.0;
  EXPECT_THROW(client.push(wrong, now_ns), std::invalid_argument);
}

TEST_F(ControlChannelTest, AnotherVersionAndAnUnknownKindAreToldSo) {
  const process::FileDescriptor peer = intruder();
  Request request = request_of(push(), 5);
  request.version = 9;
  ASSERT_TRUE(say(peer, encode(request)));
  server->step();
  server->step();
  auto told = hear(peer);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->number, 5U);
  EXPECT_THAT(told->text, AllOf(HasSubstr("version 9"), HasSubstr("speaks 2")));
  request.version = kControlVersion;
  request.kind = 77;
  ASSERT_TRUE(say(peer, encode(request)));
  server->step();
  told = hear(peer);
  ASSERT_TRUE(told);
  EXPECT_THAT(told->text, HasSubstr("kind is 77"));
  EXPECT_THAT(pushed, SizeIs(0));
}

TEST_F(ControlChannelTest, WhoSpeaksAnythingElseIsDropped) {
  for (const std::size_t size : {std::size_t{1}, kHeadBytes, kMostRequestBytes, kMostRequestBytes + 1}) {
    const process::FileDescriptor peer = intruder();
    ASSERT_TRUE(say(peer, std::vector<std::byte>(size, std::byte{7})));
    server->step();
    EXPECT_EQ(server->client_count(), 1U);
    server->step();
    EXPECT_EQ(server->client_count(), 0U) << size;
  }
}

TEST_F(ControlChannelTest, AMillisecondHasRoomForSomeRequestsAndEveryClientHasItsTurn) {
  const process::FileDescriptor flood = intruder();
  server->step();
  while (say(flood, encode(request_of(push("flood"), 1)))) {
  }
  ControlClient client(path);
  client.push(push("trunk"), now_ns);
  ASSERT_TRUE(client.connected());
  server->step();
  EXPECT_THAT(pushed, SizeIs(ControlServer::kRequestsAStep));
  EXPECT_TRUE(answer(client, 1)) << "it waits for no more than its turn";
  EXPECT_THAT(pushed, SizeIs(2 * ControlServer::kRequestsAStep));
}

TEST_F(ControlChannelTest, WhoDoesNotReadItsAnswersIsDropped) {
  const process::FileDescriptor deaf = intruder();
  server->step();
  for (int i = 0; i < 100'000 && server->client_count() > 0; ++i) {
    static_cast<void>(say(deaf, encode(request_of(push(), 1))));
    server->step();
  }
  EXPECT_EQ(server->client_count(), 0U);
}

TEST_F(ControlChannelTest, ClientsBeyondItsPlacesAreTurnedAwayWithTheReason) {
  std::vector<process::FileDescriptor> peers;
  while (peers.size() < ControlServer::kMostClients) {
    peers.push_back(intruder());
    server->step();
  }
  ControlClient client(path);
  client.push(push(), now_ns);
  auto result = answer(client);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->accepted);
  EXPECT_THAT(result->text, HasSubstr("8 clients at once"));
  peers.pop_back();
  server->step();
  client.push(push(), now_ns);
  result = answer(client);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->accepted) << result->text;
}

TEST_F(ControlChannelTest, WithoutASimulatorARefusalComesAtOnceAndThePushIsNotKept) {
  server.reset();
  ControlClient client(path);
  client.push(push(), now_ns);
  const auto refused = client.take_answer();
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_THAT(refused->text, HasSubstr("the simulator is not there"));
  start();
  EXPECT_FALSE(answer(client, 100));
  EXPECT_TRUE(client.connected()) << "it connects by itself";
  EXPECT_THAT(pushed, SizeIs(0));
}

TEST_F(ControlChannelTest, ASimulatorThatWasStartedAnewIsFoundAndNothingIsSentTwice) {
  ControlClient client(path);
  client.push(push(), now_ns);
  start();  // the first has not looked at it
  auto result = answer(client);
  ASSERT_TRUE(result);
  EXPECT_THAT(result->text, HasSubstr("ended before it answered"));
  client.push(push(), now_ns);
  result = answer(client);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->accepted) << result->text;
  EXPECT_THAT(pushed, SizeIs(1));
}

TEST_F(ControlChannelTest, AnAnswerThatDoesNotComeIsReported) {
  ControlClient client(path);
  const std::uint32_t number = client.push(push(), now_ns);
  client.step(now_ns + ControlClient::kPatience_ns - 1);
  EXPECT_FALSE(client.take_answer());
  client.step(now_ns + ControlClient::kPatience_ns);
  const auto result = client.take_answer();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->number, number);
  EXPECT_THAT(result->text, HasSubstr("not answered within 2 s"));
}

}  // namespace
}  // namespace gaitway::simulation
