// Stations in other processes: what they send is on the bus as if they were in this one, and whatever they do
// wrong stays their own affair.
#include "gaitway/can/simulated/bus_server.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using facts::kMillisecond_ns;
constexpr std::int64_t kStart_ns = 6'000'000'000'000;  // the common clock does not begin at 0

Frame small_frame(std::uint16_t id, std::uint8_t value = 0) {
  return {id, 8, {value, 1, 2, 3, 4, 5, 6, 7}};
}

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const BusError& error) {
    return error.what();
  }
  return "no error";
}

class BusServerTest : public testing::Test {
 protected:
  ~BusServerTest() override { std::filesystem::remove_all(folder); }

  // Runs the bus; the identifiers that were delivered, in order.
  std::vector<int> run_to(std::int64_t until_ns) {
    std::vector<int> ids;
    server->step();
    while (const auto delivery = server->advance(until_ns)) {
      ids.push_back(static_cast<int>(delivery->frame.id));
      deliveries.push_back(*delivery);
    }
    server->flush();
    return ids;
  }
  static std::vector<TimedFrame> all_of(BusClient& client) {
    std::vector<TimedFrame> frames;
    while (const auto frame = client.receive()) {
      frames.push_back(*frame);
    }
    return frames;
  }

  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("gaitway_bus_server_" + std::to_string(getpid()));
  std::filesystem::path socket = folder / "bus.sock";
  std::optional<BusServer> server{std::in_place, in_new_folder(), kStart_ns};
  int silent = server->bus().attach();  // acknowledges what a client sends when no other one is there
  std::vector<SimulatedBus::Delivery> deliveries;

 private:
  std::filesystem::path in_new_folder() const {
    std::filesystem::create_directories(folder);
    return socket;
  }
};

TEST_F(BusServerTest, AFrameReachesAllOtherStationsWithItsTimesOnTheBus) {
  const int local = server->bus().attach();
  BusClient sender(socket, "sender", Pace::free);
  BusClient listener(socket, "listener", Pace::free);
  const Frame frame = small_frame(0x123, 42);
  ASSERT_TRUE(sender.transmit(frame, kStart_ns + 10'000));
  sender.flush(kStart_ns + 10'000);
  EXPECT_THAT(run_to(kStart_ns + kMillisecond_ns), ElementsAre(0x123));
  EXPECT_NE(deliveries[0].sender, local);

  const std::vector<TimedFrame> heard = all_of(listener);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].frame, frame);
  EXPECT_EQ(heard[0].start_ns, kStart_ns + 10'000);
  EXPECT_EQ(heard[0].end_ns, kStart_ns + 10'000 + frame_bits(frame) * 1000);
  EXPECT_TRUE(all_of(sender).empty()) << "nobody hears himself";
}

TEST_F(BusServerTest, LocalStationsAndClientsArbitrateOnOneBus) {
  const int local = server->bus().attach();
  BusClient client(socket, "client", Pace::free);
  client.transmit(small_frame(0x200), kStart_ns);
  client.flush(kStart_ns);
  server->bus().transmit(local, small_frame(0x100), kStart_ns);
  EXPECT_THAT(run_to(kStart_ns + kMillisecond_ns), ElementsAre(0x100, 0x200));
  EXPECT_THAT(all_of(client), ElementsAre(testing::Field(&TimedFrame::frame, small_frame(0x100))));
}

TEST_F(BusServerTest, AFrameWaitsForItsTime) {
  BusClient client(socket, "client", Pace::free);
  client.transmit(small_frame(0x100), kStart_ns + 2 * kMillisecond_ns);
  client.flush(kStart_ns);
  EXPECT_TRUE(run_to(kStart_ns + 2 * kMillisecond_ns).empty());
  EXPECT_THAT(run_to(kStart_ns + 3 * kMillisecond_ns), ElementsAre(0x100));
  EXPECT_EQ(deliveries[0].start_ns, kStart_ns + 2 * kMillisecond_ns);
}

TEST_F(BusServerTest, AFrameWhoseTimeHasPassedGoesOutAtOnceAndIsCounted) {
  BusClient client(socket, "client", Pace::free);
  run_to(kStart_ns + 5 * kMillisecond_ns);
  client.transmit(small_frame(0x100), kStart_ns + 2 * kMillisecond_ns);
  client.flush(kStart_ns + 2 * kMillisecond_ns);
  EXPECT_THAT(run_to(kStart_ns + 6 * kMillisecond_ns), ElementsAre(0x100));
  EXPECT_EQ(deliveries[0].start_ns, kStart_ns + 5 * kMillisecond_ns);
  EXPECT_EQ(server->statistics().late_frames, 1U);
}

TEST_F(BusServerTest, AMoreUrgentFrameThatComesLaterOvertakesThoseThatWait) {
  BusClient client(socket, "client", Pace::free);
  client.transmit(small_frame(0x300), kStart_ns);  // on the wire for more than 100 us
  client.transmit(small_frame(0x200), kStart_ns + 10'000);
  client.transmit(small_frame(0x100), kStart_ns + 50'000);
  client.flush(kStart_ns + 50'000);
  EXPECT_THAT(run_to(kStart_ns + kMillisecond_ns), ElementsAre(0x300, 0x100, 0x200));
}

TEST_F(BusServerTest, FramesOfOneIdentifierKeepTheirOrderWhenOneGivesWay) {
  const int local = server->bus().attach();
  BusClient client(socket, "client", Pace::free);
  server->bus().transmit(local, small_frame(0x001), kStart_ns);  // keeps the bus busy
  client.transmit(small_frame(0x200, 1), kStart_ns);
  client.transmit(small_frame(0x200, 2), kStart_ns + 10'000);
  client.transmit(small_frame(0x100), kStart_ns + 20'000);  // takes the place of the first one
  client.flush(kStart_ns + 20'000);
  EXPECT_THAT(run_to(kStart_ns + kMillisecond_ns), ElementsAre(0x001, 0x100, 0x200, 0x200));
  EXPECT_EQ(deliveries[2].frame.data[0], 1);
  EXPECT_EQ(deliveries[3].frame.data[0], 2);
}

TEST_F(BusServerTest, AFullSetOfTransmitBuffersRefusesUntilTheBusHasSent) {
  BusClient client(socket, "client", Pace::free);
  EXPECT_FALSE(client.transmit_pending());
  for (int i = 0; i < kTransmitBuffers; ++i) {
    ASSERT_TRUE(client.transmit(small_frame(0x100, static_cast<std::uint8_t>(i)), kStart_ns));
  }
  EXPECT_FALSE(client.transmit(small_frame(0x001), kStart_ns));
  client.flush(kStart_ns);
  EXPECT_EQ(run_to(kStart_ns + 10 * kMillisecond_ns).size(), static_cast<std::size_t>(kTransmitBuffers));
  EXPECT_TRUE(client.transmit_pending()) << "it has not looked yet";
  EXPECT_TRUE(all_of(client).empty());
  EXPECT_FALSE(client.transmit_pending());
  EXPECT_TRUE(client.transmit(small_frame(0x001), kStart_ns + 10 * kMillisecond_ns));
}

TEST_F(BusServerTest, AFrameThatGetsLostCountsAsSentAndReachesNobody) {
  BusClient sender(socket, "sender", Pace::free);
  BusClient listener(socket, "listener", Pace::free);
  server->bus().set_loss([](const Frame& frame, std::int64_t) { return frame.id == 0x100; });
  sender.transmit(small_frame(0x100), kStart_ns);
  sender.transmit(small_frame(0x101), kStart_ns);
  sender.flush(kStart_ns);
  run_to(kStart_ns + kMillisecond_ns);
  EXPECT_THAT(all_of(listener), ElementsAre(testing::Field(&TimedFrame::frame, small_frame(0x101))));
  EXPECT_TRUE(all_of(sender).empty());
  EXPECT_FALSE(sender.transmit_pending());
}

TEST_F(BusServerTest, AClientNoticesWhatItHasSentAndErrorsInTheOrderOfTheBus) {
  BusClient sender(socket, "sender", Pace::free);
  BusClient listener(socket, "listener", Pace::free);
  server->bus().set_random_faults({.seed = 1, .corruption = 1.0});
  sender.transmit(small_frame(0x100), kStart_ns);
  sender.flush(kStart_ns);
  run_to(kStart_ns + 50'000);
  server->bus().set_random_faults({});  // the second attempt succeeds
  run_to(kStart_ns + kMillisecond_ns);
  ASSERT_EQ(deliveries.size(), 1U);
  EXPECT_FALSE(sender.next_notice()) << "nothing before it has looked";
  EXPECT_TRUE(all_of(sender).empty());
  EXPECT_EQ(all_of(listener).size(), 1U);
  for (BusClient* const client : {&sender, &listener}) {
    const auto error = client->next_notice();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind, BusNotice::Kind::error);
    EXPECT_GT(error->frame.end_ns, kStart_ns);
    EXPECT_LT(error->frame.end_ns, deliveries[0].start_ns);
  }
  const auto sent = sender.next_notice();
  ASSERT_TRUE(sent);
  EXPECT_EQ(sent->kind, BusNotice::Kind::sent);
  EXPECT_EQ(sent->frame.frame, small_frame(0x100));
  EXPECT_EQ(sent->frame.start_ns, deliveries[0].start_ns);
  EXPECT_EQ(sent->frame.end_ns, deliveries[0].end_ns);
  EXPECT_FALSE(sender.next_notice());
  EXPECT_FALSE(listener.next_notice()) << "that was another's";
}

TEST_F(BusServerTest, AClientThatAFaultLeavesOutGetsNothing) {
  BusClient sender(socket, "sender", Pace::free);
  BusClient left_out(socket, "left_out", Pace::free);
  BusClient other(socket, "other", Pace::free);
  run_to(kStart_ns);
  StationSet victims;
  victims.insert(silent + 2);  // clients attach in their order
  server->bus().set_random_faults({.seed = 1, .omission = 1.0, .victims = victims});
  sender.transmit(small_frame(0x100), kStart_ns);
  sender.flush(kStart_ns);
  run_to(kStart_ns + kMillisecond_ns);
  EXPECT_TRUE(all_of(left_out).empty());
  EXPECT_EQ(all_of(other).size(), 1U);
  EXPECT_TRUE(all_of(sender).empty());
  EXPECT_FALSE(sender.transmit_pending());
}

TEST_F(BusServerTest, AFrameThatComesTwiceIsSentOnce) {
  BusClient sender(socket, "sender", Pace::free);
  BusClient listener(socket, "listener", Pace::free);
  server->bus().set_random_faults({.seed = 1, .duplicate = 1.0});
  sender.transmit(small_frame(0x100), kStart_ns);
  sender.transmit(small_frame(0x101), kStart_ns);
  sender.flush(kStart_ns);
  run_to(kStart_ns + 140'000);  // into the repetition of the first
  ASSERT_EQ(deliveries.size(), 1U);
  EXPECT_TRUE(all_of(sender).empty());
  EXPECT_TRUE(sender.transmit_pending());
  server->bus().set_random_faults({});
  run_to(kStart_ns + 2 * kMillisecond_ns);
  EXPECT_TRUE(all_of(sender).empty());
  EXPECT_FALSE(sender.transmit_pending());
  std::size_t sent = 0;
  std::size_t heard = 0;
  for (const auto& delivery : deliveries) {
    sent += delivery.sent_by(delivery.sender) ? 1U : 0U;
    heard += delivery.received_by(silent + 2) ? 1U : 0U;
  }
  EXPECT_EQ(sent, 2U);
  EXPECT_GT(deliveries.size(), sent);
  EXPECT_EQ(all_of(listener).size(), heard);
}

TEST_F(BusServerTest, AClientsFrameWaitsOutItsBusOff) {
  BusClient client(socket, "client", Pace::free);
  run_to(kStart_ns);
  server->bus().force_bus_off(silent + 1, kStart_ns);
  client.transmit(small_frame(0x100), kStart_ns);
  client.flush(kStart_ns);
  EXPECT_THAT(run_to(kStart_ns + 20 * kMillisecond_ns), ElementsAre(0x100));
  EXPECT_TRUE(all_of(client).empty());
  EXPECT_FALSE(client.transmit_pending());
  EXPECT_EQ(server->bus().statistics().recoveries, 1U);
}

TEST_F(BusServerTest, AClientThatComesAfterAnotherInheritsNoErrors) {
  {
    BusClient faulty(socket, "faulty", Pace::free);
    run_to(kStart_ns);
    server->bus().set_recovery(silent + 1, Recovery::on_request);
    server->bus().force_bus_off(silent + 1, kStart_ns);
    faulty.transmit(small_frame(0x100), kStart_ns);
    faulty.flush(kStart_ns);
    EXPECT_TRUE(run_to(kStart_ns + 20 * kMillisecond_ns).empty());
    EXPECT_EQ(server->bus().state(silent + 1), BusState::bus_off);
  }
  run_to(kStart_ns + 21 * kMillisecond_ns);
  BusClient next(socket, "next", Pace::free);
  next.transmit(small_frame(0x200), kStart_ns + 22 * kMillisecond_ns);
  next.flush(kStart_ns + 22 * kMillisecond_ns);
  EXPECT_THAT(run_to(kStart_ns + 23 * kMillisecond_ns), ElementsAre(0x200));
  EXPECT_EQ(deliveries.back().sender, silent + 1) << "the same station";
}

TEST_F(BusServerTest, TheBusKnowsHowFarAClientWhosePaceItKeepsHasCome) {
  BusClient free_one(socket, "free", Pace::free);
  EXPECT_TRUE(server->reached(kStart_ns + 5 * kMillisecond_ns)) << "nobody to wait for";
  std::optional<BusClient> paced(std::in_place, socket, "paced", Pace::kept);
  server->step();
  EXPECT_TRUE(server->reached(kStart_ns + 5 * kMillisecond_ns)) << "it is still setting up";
  paced->flush(kStart_ns);
  server->step();
  EXPECT_TRUE(server->reached(kStart_ns));
  EXPECT_FALSE(server->reached(kStart_ns + kMillisecond_ns));
  paced->flush(kStart_ns + kMillisecond_ns);
  server->step();
  EXPECT_TRUE(server->reached(kStart_ns + kMillisecond_ns));
  EXPECT_FALSE(server->reached(kStart_ns + 2 * kMillisecond_ns));
  EXPECT_FALSE(paced->caught_up(kStart_ns + kMillisecond_ns)) << "the bus has not run yet";
  EXPECT_TRUE(free_one.caught_up(kStart_ns + kMillisecond_ns)) << "it does not keep step";
  run_to(kStart_ns + kMillisecond_ns);
  EXPECT_TRUE(all_of(*paced).empty());
  EXPECT_TRUE(paced->caught_up(kStart_ns + kMillisecond_ns));
  EXPECT_FALSE(paced->caught_up(kStart_ns + kMillisecond_ns + 1));
  paced.reset();
  server->step();
  EXPECT_TRUE(server->reached(kStart_ns + 2 * kMillisecond_ns)) << "it has gone";
}

TEST_F(BusServerTest, AFrameTellsHowFarTheBusHasRunBeforeTheRoundsEndDoes) {
  BusClient sender(socket, "sender", Pace::free);
  BusClient paced(socket, "paced", Pace::kept);
  sender.transmit(small_frame(0x100), kStart_ns + 3 * kMillisecond_ns);
  sender.flush(kStart_ns);
  run_to(kStart_ns + 20 * kMillisecond_ns);  // caught up in one go
  ASSERT_TRUE(paced.receive());
  EXPECT_TRUE(paced.caught_up(kStart_ns + 3 * kMillisecond_ns));
  EXPECT_FALSE(paced.caught_up(kStart_ns + 4 * kMillisecond_ns));
  EXPECT_FALSE(paced.receive());
  EXPECT_TRUE(paced.caught_up(kStart_ns + 20 * kMillisecond_ns));
}

TEST_F(BusServerTest, AClientThatIsKilledLeavesTheBusWithItsFrames) {
  BusClient listener(socket, "listener", Pace::free);
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    BusClient client(socket, "victim", Pace::kept);
    client.transmit(small_frame(0x100), kStart_ns);
    client.transmit(small_frame(0x101), kStart_ns);
    client.flush(kStart_ns);
    (void)!write(ready[1], "r", 1);
    pause();
    _exit(1);
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  close(ready[0]);
  close(ready[1]);
  run_to(kStart_ns + 50'000);  // its first frame is on the wire
  EXPECT_EQ(server->client_count(), 2U);
  kill(child, SIGKILL);
  ASSERT_EQ(waitpid(child, nullptr, 0), child);

  EXPECT_THAT(run_to(kStart_ns + kMillisecond_ns), ElementsAre(0x100))
      << "a started frame ends, the others never come";
  EXPECT_EQ(server->client_count(), 1U);
  EXPECT_EQ(all_of(listener).size(), 1U);

  // Whoever comes next gets its station and finds it empty.
  BusClient next(socket, "next", Pace::free);
  next.transmit(small_frame(0x050), kStart_ns + kMillisecond_ns);
  next.flush(kStart_ns + kMillisecond_ns);
  EXPECT_THAT(run_to(kStart_ns + 2 * kMillisecond_ns), ElementsAre(0x050));
  EXPECT_EQ(deliveries.back().sender, deliveries.front().sender);
}

TEST_F(BusServerTest, AClientThatSpeaksAnotherProtocolIsDroppedAlone) {
  BusClient listener(socket, "listener", Pace::free);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
  for (const std::string& nonsense : {std::string("hello"), std::string(32, '\0'), std::string(64, 'x')}) {
    const process::FileDescriptor stranger(::socket(AF_UNIX, SOCK_SEQPACKET, 0));
    ASSERT_EQ(connect(stranger.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_GT(send(stranger.get(), nonsense.data(), nonsense.size(), 0), 0);
    server->step();
    char byte = 0;
    EXPECT_EQ(recv(stranger.get(), &byte, 1, 0), 0) << "it is told by the end of its connection";
  }
  EXPECT_EQ(server->statistics().broken, 3U);
  EXPECT_EQ(server->client_count(), 1U);
  EXPECT_FALSE(listener.closed());
}

TEST_F(BusServerTest, AClientThatReadsNothingForSecondsIsDroppedAlone) {
  const int local = server->bus().attach();
  BusClient reader(socket, "reader", Pace::free);
  BusClient sleeper(socket, "sleeper", Pace::free);
  std::size_t heard = 0;
  std::size_t sent = 0;
  for (; sent < 100'000 && (sent == 0 || server->client_count() == 2U); ++sent) {
    const std::int64_t now_ns = kStart_ns + static_cast<std::int64_t>(sent) * kMillisecond_ns;
    server->bus().transmit(local, small_frame(0x100), now_ns);
    run_to(now_ns + kMillisecond_ns);
    heard += all_of(reader).size();
  }
  EXPECT_EQ(server->client_count(), 1U);
  EXPECT_EQ(server->statistics().not_reading, 1U);
  EXPECT_EQ(heard, sent) << "the one that reads misses nothing";
  EXPECT_GT(sent, 8'000U);
  EXPECT_FALSE(reader.closed());
}

TEST_F(BusServerTest, AClientSeesThatTheBusHasGone) {
  BusClient client(socket, "client", Pace::free);
  server->step();
  server.reset();
  EXPECT_EQ(client.receive(), std::nullopt);
  EXPECT_TRUE(client.closed());
  EXPECT_FALSE(client.transmit(small_frame(0x100), kStart_ns));
  EXPECT_NO_THROW(client.flush(kStart_ns));
  EXPECT_FALSE(std::filesystem::exists(socket));
}

TEST_F(BusServerTest, ASecondServerIsRefusedAndThatOfAKilledOneReplaced) {
  EXPECT_THROW(BusServer second(socket, 0), process::SocketError);
  EXPECT_TRUE(std::filesystem::exists(socket)) << "the first one's socket is untouched";

  const std::filesystem::path stale = folder / "stale.sock";
  if (const pid_t child = fork(); child == 0) {
    const BusServer killed(stale, 0);
    kill(getpid(), SIGKILL);
  } else {
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
  }
  ASSERT_TRUE(std::filesystem::exists(stale));
  BusServer next(stale, 0);
  EXPECT_NO_THROW(BusClient(stale, "client", Pace::free));
}

TEST_F(BusServerTest, AClientSaysWhereNobodyServesABus) {
  EXPECT_THAT(
      error_of([&] { BusClient client(folder / "nobody.sock", "client", Pace::free); }),
      AllOf(HasSubstr("nobody.sock"), HasSubstr("virtual_robot"), HasSubstr("No such file or directory")));
}

}  // namespace
}  // namespace gaitway::can
