// Stop datagrams on a wire that loses, doubles, delays and reorders: each stop is carried out once, and what
// was recorded or changed leads to none.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/stopgram/stop_desk.hpp"
#include "gaitway/stopgram/stop_sender.hpp"
#include "repeats.hpp"

namespace gaitway::stopgram {
namespace {

using Datagram = std::vector<std::uint8_t>;
constexpr std::int64_t kMs = facts::kMillisecond_ns;
constexpr char kToken[] = "0123456789abcdef";
const Peer kPeer{.address = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 192, 168, 1, 7}, .port = 5000};

struct Robot {
  explicit Robot(std::uint64_t epoch, bool does_obey = true)
      : desk(StopKey(kToken), epoch), obeys(does_obey) {}
  Datagram take(Bytes datagram, std::int64_t now_ns) {
    const Bytes answer = desk.on_datagram(datagram, kPeer, now_ns);
    EXPECT_LE(answer.size(), datagram.size());
    Datagram copy(answer.begin(), answer.end());
    while (const auto stop = desk.next_stop(asked)) {
      ++(stop->kind == StopKind::stop             ? asked.stops
         : stop->kind == StopKind::emergency_hold ? asked.holds
                                                  : asked.softs);
      ++carried_out[{stop->client, stop->number}];
    }
    if (obeys) desk.obeyed(asked);
    return copy;
  }
  [[nodiscard]] std::size_t stops() const { return asked.stops + asked.holds + asked.softs; }

  StopDesk desk;
  bool obeys;
  link::StopCounts asked;
  std::map<std::pair<std::uint64_t, std::uint32_t>, int> carried_out;
};

// On a wire that does nothing wrong.
void exchange(StopSender& sender, Robot& robot, std::int64_t now_ns,
              std::vector<Datagram>* record = nullptr) {
  for (Bytes said; !(said = sender.next(now_ns)).empty();) {
    if (record != nullptr) record->emplace_back(said.begin(), said.end());
    sender.on_datagram(robot.take(said, now_ns), now_ns);
  }
}

TEST(Stops, AreObeyedAtTheNextRepetition) {
  Robot robot(1, false);
  StopSender sender(StopKey(kToken), 7);
  exchange(sender, robot, 0);
  EXPECT_TRUE(sender.acquainted());
  sender.stop(StopKind::emergency_soft);
  exchange(sender, robot, kMs);
  EXPECT_EQ(sender.state(StopKind::emergency_soft), StopState::heard);
  EXPECT_EQ(sender.next_due_ns(), 11 * kMs);
  robot.desk.obeyed(robot.asked);
  exchange(sender, robot, 11 * kMs);
  EXPECT_EQ(sender.state(StopKind::emergency_soft), StopState::obeyed);
  EXPECT_EQ(robot.asked, (link::StopCounts{0, 0, 1}));
}

TEST(Stops, ArriveOnceOverABadWireAndRestarts) {
  const int runs = gaitway::test::repeats(3000);
  for (int seed = 0; seed < runs && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const auto chance = [&](double p) { return std::bernoulli_distribution(p)(random); };
    const double loss = 0.6 * std::uniform_real_distribution(0.0, 1.0)(random);
    const bool restarts = seed % 2 == 1;
    auto robot = std::make_unique<Robot>(random());
    auto sender = std::make_unique<StopSender>(StopKey(kToken), random());
    std::multimap<std::int64_t, Datagram> to_robot, to_sender;
    std::vector<Datagram> record;
    std::uint32_t asked = 0;
    const auto put = [&](auto& wire, Bytes bytes, std::int64_t now_ns) {
      if (bytes.empty()) return;
      for (int copies = chance(0.2) ? 2 : 1; copies > 0; --copies) {
        if (!chance(loss)) {
          wire.emplace(now_ns + kMs * static_cast<std::int64_t>(random() % 40),
                       Datagram(bytes.begin(), bytes.end()));
        }
      }
    };
    const auto deliver = [](auto& wire, std::int64_t now_ns, auto take) {
      while (!wire.empty() && wire.begin()->first <= now_ns) {
        const Datagram datagram = std::move(wire.begin()->second);
        wire.erase(wire.begin());
        take(datagram);
      }
    };
    for (std::int64_t now_ns = 0; now_ns < 4000 * kMs; now_ns += kMs) {
      const bool is_quiet = now_ns > 2000 * kMs;
      if (restarts && !is_quiet && chance(0.001)) robot = std::make_unique<Robot>(random());
      if (restarts && !is_quiet && chance(0.001)) {
        sender = std::make_unique<StopSender>(StopKey(kToken), random());
        asked = 0;
      }
      if (!is_quiet && chance(0.003)) {
        sender->stop(static_cast<StopKind>(random() % kStopKinds));
        ++asked;
      }
      if (!record.empty() && chance(0.2)) to_robot.emplace(now_ns, record[random() % record.size()]);
      for (Bytes said; !(said = sender->next(now_ns)).empty();) {
        record.emplace_back(said.begin(), said.end());
        put(to_robot, said, now_ns);
      }
      deliver(to_robot, now_ns, [&](const Datagram& d) { put(to_sender, robot->take(d, now_ns), now_ns); });
      deliver(to_sender, now_ns, [&](const Datagram& d) { sender->on_datagram(d, now_ns); });
    }
    for (const auto& [stop, times] : robot->carried_out) EXPECT_EQ(times, 1);
    for (std::size_t kind = 0; kind < kStopKinds; ++kind) {
      const StopState state = sender->state(static_cast<StopKind>(kind));
      EXPECT_TRUE(state == StopState::none || state == StopState::obeyed) << "after two quiet seconds";
    }
    EXPECT_TRUE(restarts || robot->stops() <= asked);
    // All that was ever said, again: to this desk, much later, and to one of another run.
    const std::size_t before = robot->stops();
    Robot other(random());
    for (const Datagram& datagram : record) {
      robot->take(datagram, 100'000 * kMs);
      other.take(datagram, 100'000 * kMs);
    }
    EXPECT_EQ(robot->stops(), before);
    EXPECT_EQ(other.stops(), 0U);
  }
}

TEST(Stops, WithOneBitFlippedAreRefusedAndNotAnswered) {
  Robot robot(1);
  StopSender sender(StopKey(kToken), 7);
  std::vector<Datagram> record;
  exchange(sender, robot, 0, &record);
  sender.stop(StopKind::stop);
  const Bytes said = sender.next(0);
  record.emplace_back(said.begin(), said.end());
  for (const Datagram& datagram : record) {
    for (std::size_t bit = 0; bit < datagram.size() * 8; ++bit) {
      Datagram changed = datagram;
      changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1U << (bit % 8));
      EXPECT_TRUE(robot.take(changed, 0).empty()) << bit;
    }
  }
  EXPECT_EQ(robot.stops(), 0U);
  StopSender stranger(StopKey("another token 01"), 8);
  EXPECT_TRUE(robot.take(stranger.next(0), 0).empty());
}

TEST(Stops, OfAClientThatLostItsPlaceAreNotObeyedFromARecording) {
  Robot robot(1);
  std::vector<Datagram> record;
  for (std::uint64_t client = 1; client <= 3 * StopDesk::kClients; ++client) {
    StopSender sender(StopKey(kToken), client);
    const auto now_ns = static_cast<std::int64_t>(client) * kMs;
    exchange(sender, robot, now_ns, &record);
    sender.stop(StopKind::stop);
    exchange(sender, robot, now_ns, &record);
    exchange(sender, robot, now_ns + StopSender::kRepeat_ns, &record);
    ASSERT_EQ(sender.state(StopKind::stop), StopState::obeyed);
  }
  const std::size_t before = robot.stops();
  EXPECT_EQ(before, 3 * StopDesk::kClients);
  for (const Datagram& datagram : record) robot.take(datagram, 1000 * kMs);
  EXPECT_EQ(robot.stops(), before);
  EXPECT_GT(robot.desk.counts().strangers, 0U);
}

TEST(Stops, OfARecordingHoldNobodysPlace) {
  Robot robot(1);
  std::vector<Datagram> newest;
  const auto ask = [&](std::uint64_t client, std::int64_t now_ns) {
    StopSender sender(StopKey(kToken), client);
    exchange(sender, robot, now_ns);
    sender.stop(StopKind::stop);
    const Bytes said = sender.next(now_ns);
    newest.emplace_back(said.begin(), said.end());
    robot.take(said, now_ns);
  };
  for (std::uint64_t client = 1; client < StopDesk::kClients; ++client) ask(client, kMs);
  const std::vector<Datagram> recorded = newest;
  const std::int64_t later_ns = StopDesk::kFreshness_ns + 10 * kMs;
  ask(1000, later_ns);
  for (const Datagram& datagram : recorded) robot.take(datagram, later_ns + kMs);
  ask(1001, later_ns + 2 * kMs);
  robot.take(newest[recorded.size()], later_ns + 3 * kMs);
  EXPECT_EQ(robot.desk.counts().strangers, 0U) << "who was heard last has its place";
}

TEST(Stops, ThatWereHeldBackAreNotObeyedForLong) {
  Robot robot(1);
  StopSender sender(StopKey(kToken), 7);
  exchange(sender, robot, 0);
  sender.stop(StopKind::stop);
  const Bytes said = sender.next(0);
  const Datagram held(said.begin(), said.end());
  robot.take(held, StopDesk::kFreshness_ns + 1);
  EXPECT_EQ(robot.stops(), 0U);
  for (std::int64_t now_ns = StopDesk::kFreshness_ns + 10 * kMs; now_ns < StopDesk::kFreshness_ns + 100 * kMs;
       now_ns += kMs) {
    exchange(sender, robot, now_ns);
  }
  EXPECT_EQ(robot.stops(), 1U) << "who is there is heard, with a new stamp";
}

TEST(Refusals, AreToldOnceInTenSecondsForEachAddressAndBounded) {
  Robot robot(1);
  for (int i = 0; i < 100; ++i) robot.take(Datagram(3, 1), kMs);
  EXPECT_EQ(robot.desk.take_refusal(kMs),
            "refused what is no stop datagram: from 192.168.1.7:5000, the latest of 100");
  robot.take(Datagram(3, 1), 2 * kMs);
  EXPECT_EQ(robot.desk.take_refusal(9'000 * kMs), std::nullopt);
  EXPECT_NE(robot.desk.take_refusal(11'000 * kMs), std::nullopt);
  int lines = 0;
  for (int i = 0; i < 1000; ++i) {
    Peer peer = kPeer;
    peer.address[15] = static_cast<std::uint8_t>(i);
    peer.address[14] = static_cast<std::uint8_t>(i / 256);
    robot.desk.on_datagram(Datagram(3, 1), peer, 30'000 * kMs);
    while (robot.desk.take_refusal(30'000 * kMs)) ++lines;
  }
  EXPECT_LE(lines, static_cast<int>(RefusalTally::kAddresses) + 1);
}

}  // namespace
}  // namespace gaitway::stopgram
