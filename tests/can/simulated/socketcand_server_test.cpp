// Clients of the socketcand protocol over TCP: each is a station of the bus, and whatever one does wrong
// stays its own affair.
#include "gaitway/can/simulated/socketcand_server.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using facts::kMillisecond_ns;
constexpr int kPatience_ms = 20'000;  // for the kernel's loopback; ends a test that fails

// A client that blocks while it reads.
class TcpClient {
 public:
  // `receive_buffer_bytes`: 0 leaves it to the kernel.
  explicit TcpClient(std::uint16_t port, int receive_buffer_bytes = 0)
      : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    if (receive_buffer_bytes > 0) {
      setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes, sizeof receive_buffer_bytes);
    }
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  void say(const std::string& text) const {
    ASSERT_EQ(send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  void finish() const { shutdown(socket_.get(), SHUT_WR); }
  void leave() { socket_ = process::FileDescriptor(); }
  [[nodiscard]] int fd() const { return socket_.get(); }
  // Everything that has come, without waiting.
  std::string heard() {
    char piece[4096];
    ssize_t bytes = 0;
    while ((bytes = recv(socket_.get(), piece, sizeof piece, MSG_DONTWAIT)) > 0) {
      text_.append(piece, static_cast<std::size_t>(bytes));
    }
    closed_ = closed_ || bytes == 0;
    return text_;
  }
  bool closed() {
    heard();
    return closed_;
  }

 private:
  process::FileDescriptor socket_;
  std::string text_;
  bool closed_ = false;
};

class SocketcandServerTest : public testing::Test {
 protected:
  // One round: a millisecond of the bus.
  void round() {
    server.step(now_ns);
    server.offer(now_ns, now_ns + kMillisecond_ns);
    while (const auto delivery = bus.advance(now_ns + kMillisecond_ns)) {
      server.on_delivery(*delivery);
      deliveries.push_back(*delivery);
    }
    now_ns += kMillisecond_ns;
    server.flush(now_ns);
  }
  // Rounds until something is so; the kernel may take its time to hand over what was sent.
  bool rounds_until(const std::function<bool()>& done) {
    for (int i = 0; i < kPatience_ms; ++i) {
      round();
      if (done()) {
        return true;
      }
      poll(nullptr, 0, i < 5000 ? 0 : 1);
    }
    return false;
  }
  bool hears(TcpClient& client, const std::string& text) {
    return rounds_until([&] { return client.heard().find(text) != std::string::npos; });
  }
  // In raw mode, past the pause.
  TcpClient raw_client(int receive_buffer_bytes = 0) {
    TcpClient client(server.port(), receive_buffer_bytes);
    client.say("< open can0 >< rawmode >");
    EXPECT_TRUE(hears(client, "< ok >< ok >"));
    for (int i = 0; i < 101; ++i) {
      round();
    }
    return client;
  }
  static std::string error_of(const std::function<void()>& action) {
    try {
      action();
    } catch (const BusError& error) {
      return error.what();
    }
    return "no error";
  }

  SimulatedBus bus;
  const int station = bus.attach();
  std::int64_t now_ns = 5'000'000'000'000;
  SocketcandServer server{SocketcandAddress::parse("0"), bus, {.beacon_port = 0}};
  std::vector<SimulatedBus::Delivery> deliveries;
};

TEST_F(SocketcandServerTest, EveryFrameOfTheBusIsToldWithTheTimeOfItsLastBit) {
  TcpClient client = raw_client();
  const Frame frame{.id = 0x123, .size = 2, .data = {0xAB, 0xCD}};
  bus.transmit(station, frame, now_ns);
  const std::int64_t end_us = now_ns / 1000 + frame_bits(frame);
  const std::string time =
      std::to_string(end_us / 1'000'000) + "." + std::to_string(1'000'000 + end_us % 1'000'000).substr(1);
  EXPECT_TRUE(hears(client, "< frame 123 " + time + " ABCD >")) << time << " " << client.heard();
}

TEST_F(SocketcandServerTest, AClientIsAStationWhoseFramesTheOthersHear) {
  TcpClient one = raw_client();
  TcpClient other = raw_client();
  one.say("< send 7AB 1 5 >");
  EXPECT_TRUE(hears(other, "< frame 7AB"));
  EXPECT_THAT(one.heard(), testing::Not(HasSubstr("frame"))) << "not its own";
  ASSERT_EQ(deliveries.size(), 1);
  EXPECT_EQ(deliveries[0].frame, (Frame{.id = 0x7AB, .size = 1, .data = {5}}));
  EXPECT_EQ(server.statistics().frames, 1);
}

TEST_F(SocketcandServerTest, ClientsFramesTakePartInArbitration) {
  TcpClient one = raw_client();
  TcpClient other = raw_client();
  one.say("< send 300 0 >< send 100 0 >");
  other.say("< send 200 0 >");
  EXPECT_TRUE(rounds_until([&] { return deliveries.size() == 3; }));
  std::vector<std::uint32_t> ids;
  for (const auto& delivery : deliveries) {
    ids.push_back(delivery.frame.id);
  }
  EXPECT_THAT(ids, testing::AnyOf(ElementsAre(0x200, 0x300, 0x100), ElementsAre(0x300, 0x100, 0x200)))
      << "each client's frames in their order; 200 may have come later than the others";
}

TEST_F(SocketcandServerTest, CyclicFramesComeInTheRhythmOfTheBus) {
  TcpClient client(server.port());
  client.say("< open can0 >< add 0 250 123 1 9 >");
  EXPECT_TRUE(rounds_until([&] { return deliveries.size() >= 9; }));
  for (std::size_t i = 1; i < deliveries.size(); ++i) {
    EXPECT_EQ(deliveries[i].start_ns - deliveries[i - 1].start_ns, 250'000);
  }
}

TEST_F(SocketcandServerTest, WhatAClientSaidBeforeItFinishedIsStillSent) {
  TcpClient client(server.port());
  client.say("< open can0 >< send 123 0 >< send 124 0 >");
  client.finish();
  EXPECT_TRUE(rounds_until([&] { return deliveries.size() == 2 && server.client_count() == 0; }));
}

TEST_F(SocketcandServerTest, TheStationOfAClientThatLeftServesTheNextOne) {
  for (int i = 0; i < SimulatedBus::kMaximumStations + 10; ++i) {
    TcpClient client(server.port());
    client.say("< open can0 >< send 001 0 >");
    EXPECT_TRUE(hears(client, "< ok >"));
    client.leave();
    EXPECT_TRUE(rounds_until([&] { return server.client_count() == 0; }));
  }
  EXPECT_LE(bus.attach(), 4);
  EXPECT_EQ(server.statistics().clients, SimulatedBus::kMaximumStations + 10);
}

TEST_F(SocketcandServerTest, AFrameThatAClientsStationDoesNotReceiveIsNotTold) {
  TcpClient client = raw_client();
  bus.set_loss([](const Frame& frame, std::int64_t) { return frame.id == 0x123; });
  bus.transmit(station, {.id = 0x123}, now_ns);
  round();
  bus.transmit(station, {.id = 0x124}, now_ns);
  EXPECT_TRUE(hears(client, "< frame 124"));
  EXPECT_THAT(client.heard(), testing::Not(HasSubstr("< frame 123")));
}

TEST_F(SocketcandServerTest, AnUnknownBusIsRefusedAndTheConnectionEnds) {
  TcpClient client(server.port());
  client.say("< open can7 >");
  EXPECT_TRUE(rounds_until([&] { return client.closed(); }));
  EXPECT_THAT(client.heard(), HasSubstr("< error there is no bus 'can7'"));
  EXPECT_EQ(server.client_count(), 0);
}

TEST_F(SocketcandServerTest, ABadCommandIsAnsweredAndTheClientStays) {
  TcpClient client = raw_client();
  client.say("< send 123 9 >");
  EXPECT_TRUE(hears(client, "< error '9': the number of data bytes must be"));
  client.say("< echo >");
  EXPECT_TRUE(hears(client, "< echo >"));
  EXPECT_EQ(server.statistics().rejected_commands, 1);
}

TEST_F(SocketcandServerTest, AClientThatDoesNotReadIsDroppedAndTheOthersGoOn) {
  TcpClient sleeper = raw_client(4096);
  TcpClient reader = raw_client();
  TcpClient sender = raw_client();
  sender.say("< bcmmode >< add 0 100 123 8 1 2 3 4 5 6 7 8 >");
  EXPECT_TRUE(rounds_until([&] {
    EXPECT_THAT(reader.heard(), testing::Not(HasSubstr("error")));
    return server.statistics().not_reading == 1;
  }));
  EXPECT_EQ(server.client_count(), 2);
}

TEST_F(SocketcandServerTest, AClientThatFloodsIsHeldBackAndLosesNothing) {
  TcpClient client = raw_client();
  std::string flood;
  constexpr std::size_t kFrames = 3000;
  for (std::size_t i = 0; i < kFrames; ++i) {
    flood += "< send 123 2 " + std::to_string(i / 100) + " " + std::to_string(i % 100) + " >";
  }
  client.say(flood);
  EXPECT_TRUE(rounds_until([&] { return deliveries.size() == kFrames; })) << deliveries.size();
  EXPECT_EQ(server.client_count(), 1);
}

TEST_F(SocketcandServerTest, TooManyClientsAreTurnedAway) {
  std::vector<TcpClient> clients;
  for (std::size_t i = 0; i < SocketcandServer::kMostClients; ++i) {
    clients.emplace_back(server.port());
    EXPECT_TRUE(hears(clients.back(), "< hi >"));
  }
  TcpClient late(server.port());
  EXPECT_TRUE(hears(late, "< error there are 32 clients already >"));
  EXPECT_TRUE(late.closed());
}

TEST_F(SocketcandServerTest, TheDescriptorWakesForClientsAndWhatTheySay) {
  const auto wakes = [this](int patience_ms) {
    pollfd wake{server.wake_fd(), POLLIN, 0};
    return poll(&wake, 1, patience_ms) == 1;
  };
  EXPECT_FALSE(wakes(0));
  TcpClient client(server.port());
  EXPECT_TRUE(wakes(kPatience_ms));
  server.step(now_ns);
  EXPECT_FALSE(wakes(0));
  client.say("< echo >");
  EXPECT_TRUE(wakes(kPatience_ms));
  server.step(now_ns);
  EXPECT_FALSE(wakes(0));
}

TEST_F(SocketcandServerTest, ATakenPortIsNamedWithTheRemedy) {
  const std::string port = std::to_string(server.port());
  EXPECT_THAT(error_of([&] { SocketcandServer(SocketcandAddress::parse(port), bus); }),
              AllOf(HasSubstr("can://127.0.0.1:" + port), HasSubstr("taken by another program"),
                    HasSubstr("choose another port")));
}

TEST(SocketcandAddressTest, IsAPortWithALoopbackAddressBeforeIt) {
  EXPECT_EQ(SocketcandAddress::parse("29536").host, "127.0.0.1");
  EXPECT_EQ(SocketcandAddress::parse("29536").port, 29536);
  EXPECT_EQ(SocketcandAddress::parse("localhost:1").host, "127.0.0.1");
  EXPECT_EQ(SocketcandAddress::parse("127.3.2.1:65535").host, "127.3.2.1");
  EXPECT_EQ(SocketcandAddress::parse("[::1]:5").host, "::1");
}

TEST(SocketcandAddressTest, AnAddressThatOthersCanReachIsRefusedWithTheReason) {
  for (const char* const text :
       {"0.0.0.0:29536", "192.168.1.5:29536", "[::]:29536", "example:29536", ":29536"}) {
    try {
      SocketcandAddress::parse(text);
      ADD_FAILURE() << text;
    } catch (const BusError& error) {
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr(text), HasSubstr("loopback"), HasSubstr("no passwords"), HasSubstr("ssh")));
    }
  }
  for (const char* const text : {"", "can", "127.0.0.1:", "65536", "-1", "29536x"}) {
    EXPECT_THROW(SocketcandAddress::parse(text), BusError) << text;
  }
}

TEST(SocketcandBeaconTest, TellsTheLoopbackWhereTheBusIsEveryThreeSeconds) {
  const process::FileDescriptor listener(socket(AF_INET, SOCK_DGRAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(getsockname(listener.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
  SimulatedBus bus;
  SocketcandServer server(SocketcandAddress::parse("0"), bus, {.beacon_port = ntohs(address.sin_port)});
  for (std::int64_t time_ns = 0; time_ns < 7'000'000'000; time_ns += 10'000'000) {
    server.flush(time_ns);
  }
  std::vector<std::string> beacons;
  char text[1024];
  ssize_t bytes = 0;
  while ((bytes = recv(listener.get(), text, sizeof text, MSG_DONTWAIT)) > 0) {
    beacons.emplace_back(text, static_cast<std::size_t>(bytes));
  }
  ASSERT_EQ(beacons.size(), 3) << "at 0, 3 and 6 s";
  EXPECT_THAT(beacons[0], AllOf(StartsWith("<CANBeacon "),
                                HasSubstr("<URL>can://127.0.0.1:" + std::to_string(server.port()) + "</URL>"),
                                HasSubstr("<Bus name=\"can0\"/>")));
}

}  // namespace
}  // namespace gaitway::can
