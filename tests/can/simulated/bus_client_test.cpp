// A station's end of the bus socket against a server that says what no bus can.
#include "gaitway/can/simulated/bus_client.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "can/simulated/bus_protocol.hpp"
#include "gaitway/can/simulated/bus_server.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::can {
namespace {

using facts::kMillisecond_ns;
using protocol::Kind;
using protocol::Record;

TEST(BusClientTest, FramesThatNoBusCanCarryReachNobodyThoughTheirSenderIsToldOfThem) {
  std::string folder = (std::filesystem::temp_directory_path() / "gaitway_bus_XXXXXX").native();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  {
    process::ListeningSocket listener(std::filesystem::path(folder) / "bus", "bus");
    BusClient client(listener.path(), "client", Pace::free);
    const process::FileDescriptor server = listener.accept();
    ASSERT_TRUE(server);
    const Frame frame{.id = 0x100, .size = 1};
    ASSERT_TRUE(client.transmit(frame, 1));
    ASSERT_TRUE(client.transmit(frame, 1));
    Record too_long = protocol::record_of(Kind::sent, frame, 1, 2);
    too_long.size = 255;
    const std::array said{too_long, protocol::record_of(Kind::sent, frame, 3, 4)};
    ASSERT_EQ(send(server.get(), said.data(), sizeof said, 0), static_cast<ssize_t>(sizeof said));
    EXPECT_FALSE(client.receive());
    const auto notice = client.next_notice();
    ASSERT_TRUE(notice);
    EXPECT_EQ(notice->frame.start_ns, 3) << "the one that can be";
    EXPECT_FALSE(client.next_notice());
  }
  std::filesystem::remove_all(folder);
}

class LastingBusClientTest : public testing::Test {
 protected:
  static std::filesystem::path new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_bus_XXXXXX").native();
    return mkdtemp(name.data());
  }
  ~LastingBusClientTest() override { std::filesystem::remove_all(folder); }

  // With another station, which acknowledges.
  std::unique_ptr<BusServer> new_server() const {
    auto made = std::make_unique<BusServer>(folder / "bus", now_ns);
    made->bus().attach();
    return made;
  }
  // As the message controller and virtual_robot do it, a millisecond after the other.
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      now_ns += kMillisecond_ns;
      if (server) {
        server->step();
        while (server->advance(now_ns)) {
        }
        server->flush();
      }
      while (client.receive()) {
      }
      client.flush(now_ns);
    }
  }

  std::filesystem::path folder = new_folder();
  std::int64_t now_ns = 1'000'000'000;
  std::unique_ptr<BusServer> server = new_server();
  LastingBusClient client{folder / "bus", "client", Pace::kept};
};

TEST_F(LastingBusClientTest, IsOffABusThatHasGoneAndOnTheOneThatComesInItsPlace) {
  run(20);
  EXPECT_EQ(client.state(), BusState::error_active);
  ASSERT_TRUE(client.transmit({.id = 0x100, .size = 1}, now_ns));
  server.reset();
  run(3);
  EXPECT_EQ(client.state(), BusState::down);
  EXPECT_FALSE(client.connected());
  EXPECT_EQ(client.wake_fd(), -1);
  EXPECT_FALSE(client.transmit({.id = 0x101, .size = 1}, now_ns)) << "nothing waits for another bus";
  EXPECT_FALSE(client.transmit_pending()) << "what was offered is gone with it";
  EXPECT_TRUE(client.caught_up(now_ns)) << "nobody is to wait for it";
  run(5000);
  EXPECT_EQ(client.state(), BusState::down);
  server = new_server();
  run(static_cast<int>(LastingBusClient::kBetweenTries_ns / kMillisecond_ns) + 3);
  EXPECT_EQ(client.state(), BusState::error_active);
  EXPECT_EQ(client.outages(), 1U);
  ASSERT_TRUE(client.transmit({.id = 0x102, .size = 1}, now_ns));
  run(3);
  EXPECT_FALSE(client.transmit_pending());
  EXPECT_EQ(server->bus().statistics().frames, 1U) << "of before nothing comes";
}

TEST_F(LastingBusClientTest, TriesAreBoundedInTheirRate) {
  server.reset();
  process::ListeningSocket nobody_home(folder / "bus", "bus");
  int tries = 0;
  for (int i = 0; i < 1000; ++i) {
    run(1);
    const process::FileDescriptor taken = nobody_home.accept();  // and hangs up
    tries += taken ? 1 : 0;
  }
  EXPECT_GE(tries, 15);
  EXPECT_LE(tries, 20);
  EXPECT_EQ(client.state(), BusState::down) << "it has told nothing";
  EXPECT_EQ(client.outages(), 1U);
}

TEST_F(LastingBusClientTest, ABusThatStandsStillIsNoBusUntilItRuns) {
  run(20);
  auto stopped = std::move(server);
  run(190);
  EXPECT_EQ(client.state(), BusState::error_active);
  run(20);
  EXPECT_EQ(client.state(), BusState::down);
  EXPECT_TRUE(client.connected());
  run(20'000);  // its socket is full by now
  server = std::move(stopped);
  run(200);
  EXPECT_EQ(client.state(), BusState::error_active);
  EXPECT_EQ(server->statistics().broken, 0U);
}

// As a process that was stopped: the bus went on and could not tell it. It is not the bus that was away.
TEST_F(LastingBusClientTest, WhoDidNotListenHasNotLostTheBus) {
  const int talker = server->bus().attach();
  run(20);
  // Its socket is full soon, and the server keeps back what it has to say.
  for (int i = 0; i < 20'000; ++i) {
    now_ns += kMillisecond_ns;
    server->bus().transmit(talker, {.id = 0x200, .size = 1}, now_ns);
    server->step();
    while (server->advance(now_ns)) {
    }
    server->flush();
  }
  run(1);
  EXPECT_EQ(client.state(), BusState::error_active);
  run(2);
  EXPECT_TRUE(client.caught_up(now_ns - kMillisecond_ns));
  EXPECT_EQ(client.outages(), 0U);
  EXPECT_EQ(server->statistics().not_reading, 0U);
  EXPECT_EQ(server->client_count(), 1U);
}

}  // namespace
}  // namespace gaitway::can
