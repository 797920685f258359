// What the emulated link does is what its settings say, measured over many packets; and what holds for any.
#include "tools/wireless/link_emulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

#include "repeats.hpp"

namespace gaitway::tools {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kS = 1000 * kMs;

Packet numbered(std::uint32_t number, std::size_t size = 100) {
  Packet packet(size);
  std::memcpy(packet.data(), &number, sizeof number);
  return packet;
}

std::uint32_t number_of(const Packet& packet) {
  std::uint32_t number = 0;
  std::memcpy(&number, packet.data(), sizeof number);
  return number;
}

LinkSettings both(const DirectionSettings& settings) {
  return {{settings, settings}, false};
}

void drain(LinkEmulator& link, std::int64_t now_ns, std::vector<Delivery>& out) {
  while (auto delivery = link.receive(now_ns)) out.push_back(std::move(*delivery));
}

// `count` packets from the client, one every `period_ns`.
std::vector<Delivery> stream_through(LinkEmulator& link, int count, std::int64_t period_ns,
                                     std::size_t size = 100) {
  std::vector<Delivery> out;
  for (int i = 0; i < count; ++i) {
    link.send(LinkEnd::client, i * period_ns, numbered(static_cast<std::uint32_t>(i), size));
    drain(link, i * period_ns, out);
  }
  drain(link, count * period_ns + 3600 * kS, out);
  return out;
}

std::uint64_t digest(const std::vector<Delivery>& deliveries) {
  std::uint64_t hash = 0xCBF2'9CE4'8422'2325ULL;
  const auto mix = [&hash](std::uint64_t value) { hash = (hash ^ value) * 0x0000'0100'0000'01B3ULL; };
  for (const Delivery& each : deliveries) {
    mix(static_cast<std::uint64_t>(each.to));
    mix(static_cast<std::uint64_t>(each.at_ns));
    for (const std::uint8_t byte : each.packet) mix(byte);
  }
  return hash;
}

DirectionSettings everything_bad() {
  return {.rate_bit_s = 5e6,
          .queue_bytes = 20'000,
          .delay_ns = 10 * kMs,
          .jitter_ns = 4 * kMs,
          .loss = 0.05,
          .mean_burst = 4.0,
          .reordered = 0.03,
          .held_back_ns = 15 * kMs,
          .duplicated = 0.02};
}

// Traffic of both ends with packets of any size and pauses, and outages, all from one seed.
struct Play {
  LinkEmulator link;
  std::vector<Delivery> out;
  std::int64_t end_ns = 0;
  std::vector<std::int64_t> received_at_ns;  // when receive() gave it

  Play(const LinkSettings& settings, std::uint64_t seed, int packets) : link(settings, seed) {
    std::mt19937_64 random(seed);
    std::int64_t now_ns = 0;
    for (int i = 0; i < packets; ++i) {
      const bool pauses = random() % 50 == 0;
      now_ns += static_cast<std::int64_t>(random() % (pauses ? 50 * kMs : 2 * kMs));
      if (random() % 200 == 0) {
        const std::int64_t begin_ns = now_ns + static_cast<std::int64_t>(random() % (20 * kMs));
        link.add_outage(now_ns, {begin_ns, begin_ns + static_cast<std::int64_t>(random() % (200 * kMs))});
      }
      const auto end = static_cast<LinkEnd>(random() % 2);
      link.send(end, now_ns, numbered(static_cast<std::uint32_t>(i), 40 + random() % 1460));
      receive(now_ns);
    }
    receive(now_ns + 3600 * kS);
    end_ns = now_ns;
  }
  void receive(std::int64_t now_ns) {
    drain(link, now_ns, out);
    received_at_ns.resize(out.size(), now_ns);
  }
};

TEST(LinkEmulator, APerfectLinkGivesEverythingAtOnce) {
  LinkEmulator link({}, 1);
  link.send(LinkEnd::client, 5, numbered(1));
  link.send(LinkEnd::robot, 5, numbered(2));
  std::vector<Delivery> out;
  drain(link, 5, out);
  ASSERT_EQ(out.size(), 2U);
  std::ranges::sort(out, {}, [](const Delivery& one) { return number_of(one.packet); });
  EXPECT_EQ(out[0].to, LinkEnd::robot);
  EXPECT_EQ(out[1].to, LinkEnd::client);
  EXPECT_EQ(out[0].at_ns, 5);
  EXPECT_EQ(out[0].packet, numbered(1));
  EXPECT_FALSE(link.next_ns());
}

TEST(LinkEmulator, DelayAndRateAddUp) {
  LinkEmulator link(both({.rate_bit_s = 8e6, .delay_ns = 10 * kMs}), 1);  // 1 µs a byte
  link.send(LinkEnd::client, 0, numbered(0, 1000));
  link.send(LinkEnd::client, 0, numbered(1, 500));
  std::vector<Delivery> out;
  drain(link, 10 * kMs, out);
  EXPECT_TRUE(out.empty());
  EXPECT_EQ(link.next_ns(), 11 * kMs);
  drain(link, kS, out);
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].at_ns, 11 * kMs);
  EXPECT_EQ(out[1].at_ns, 11 * kMs + kMs / 2);
  EXPECT_EQ(link.statistics(LinkEnd::client).queue_delay.max_ns(), kMs);
}

TEST(LinkEmulator, DirectionsHaveSettingsOfTheirOwn) {
  LinkSettings settings;
  settings.from[static_cast<std::size_t>(LinkEnd::robot)].delay_ns = 30 * kMs;
  settings.from[static_cast<std::size_t>(LinkEnd::client)].loss = 1.0;
  LinkEmulator link(settings, 1);
  link.send(LinkEnd::robot, 0, numbered(0));
  link.send(LinkEnd::client, 0, numbered(1));
  std::vector<Delivery> out;
  drain(link, kS, out);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].to, LinkEnd::client);
  EXPECT_EQ(out[0].at_ns, 30 * kMs);
  EXPECT_EQ(link.statistics(LinkEnd::client).lost_on_air, 1U);
}

struct Loss {
  double share;
  std::optional<double> burst;
};

class LinkEmulatorLoss : public testing::TestWithParam<Loss> {};

TEST_P(LinkEmulatorLoss, ShareAndBurstsAreAsSet) {
  const auto [share, burst] = GetParam();
  const int count = test::repeats(400'000);
  LinkEmulator link(both({.loss = share, .mean_burst = burst}), 3);
  std::vector<bool> came(static_cast<std::size_t>(count));
  for (const Delivery& each : stream_through(link, count, kMs)) came[number_of(each.packet)] = true;
  const auto lost = static_cast<double>(std::ranges::count(came, false));
  double bursts = 0.0;
  for (std::size_t i = 0; i < came.size(); ++i) {
    bursts += !came[i] && (i == 0 || came[i - 1]) ? 1.0 : 0.0;
  }
  const double mean_burst = burst.value_or(1.0 / (1.0 - share));
  // A count of bursts of geometric length: its deviation relative to its mean is below sqrt(2 / bursts).
  const double five_sigma = 5.0 * std::sqrt(2.0 / (count * share / mean_burst));
  EXPECT_NEAR(lost / count, share, share * five_sigma);
  EXPECT_NEAR(lost / bursts, mean_burst, mean_burst * five_sigma);
  EXPECT_EQ(link.statistics(LinkEnd::client).lost_on_air, static_cast<std::uint64_t>(lost));
}

INSTANTIATE_TEST_SUITE_P(Losses, LinkEmulatorLoss,
                         testing::Values(Loss{0.01, {}}, Loss{0.3, {}}, Loss{0.03, 8.0}, Loss{0.1, 1.0},
                                         Loss{0.1, 50.0}, Loss{0.6, 4.0}));

// Packets every millisecond see each fade as a row of losses; packets every second see fades of 40 ms as
// single ones.
TEST(LinkEmulator, FadesLastByTheClock) {
  constexpr double kShare = 0.1;
  const int count = test::repeats(400'000);
  const auto losses_in_a_row = [count](std::int64_t period_ns) {
    LinkEmulator link(both({.loss = kShare, .mean_fade_ns = 40 * kMs}), 5);
    std::vector<bool> came(static_cast<std::size_t>(count));
    for (const Delivery& each : stream_through(link, count, period_ns)) came[number_of(each.packet)] = true;
    const auto lost = static_cast<double>(std::ranges::count(came, false));
    double rows = 0.0;
    for (std::size_t i = 0; i < came.size(); ++i) {
      rows += !came[i] && (i == 0 || came[i - 1]) ? 1.0 : 0.0;
    }
    EXPECT_NEAR(lost / count, kShare, kShare * 5.0 * std::sqrt(2.0 / rows));
    return lost / rows;
  };
  EXPECT_NEAR(losses_in_a_row(kMs), 40.0, 8.0);
  EXPECT_NEAR(losses_in_a_row(1000 * kMs), 1.0 / (1.0 - kShare), 0.05);
}

TEST(LinkEmulator, JitterIsEvenAndKeepsTheOrder) {
  LinkEmulator link(both({.delay_ns = 10 * kMs, .jitter_ns = 4 * kMs}), 5);
  const int count = test::repeats(100'000);
  const std::vector<Delivery> out = stream_through(link, count, 10 * kMs);  // too far apart to meet
  ASSERT_EQ(out.size(), static_cast<std::size_t>(count));
  double sum = 0.0, squares = 0.0;
  for (const Delivery& each : out) {
    const double delay_ms = static_cast<double>(each.at_ns - each.sent_ns) * 1e-6;
    EXPECT_GE(delay_ms, 6.0);
    EXPECT_LE(delay_ms, 14.0);
    sum += delay_ms;
    squares += (delay_ms - 10.0) * (delay_ms - 10.0);
  }
  const double deviation = 4.0 / std::sqrt(3.0);
  EXPECT_NEAR(sum / count, 10.0, 5.0 * deviation / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), deviation, 0.05);

  LinkEmulator close(both({.delay_ns = 10 * kMs, .jitter_ns = 4 * kMs}), 5);
  const std::vector<Delivery> in_order = stream_through(close, 10'000, kMs / 10);
  EXPECT_TRUE(
      std::ranges::is_sorted(in_order, {}, [](const Delivery& one) { return number_of(one.packet); }));
}

TEST(LinkEmulator, ReorderedPacketsAreOvertaken) {
  LinkEmulator link(both({.delay_ns = 5 * kMs, .reordered = 0.05, .held_back_ns = 3 * kMs + kMs / 2}), 5);
  const int count = test::repeats(100'000);
  const std::vector<Delivery> out = stream_through(link, count, kMs);
  ASSERT_EQ(out.size(), static_cast<std::size_t>(count));
  int late = 0;
  std::uint32_t newest = 0;
  for (const Delivery& each : out) {
    const std::uint32_t number = number_of(each.packet);
    late += number < newest ? 1 : 0;
    newest = std::max(newest, number);
    const std::int64_t delay_ns = each.at_ns - each.sent_ns;
    EXPECT_TRUE(delay_ns == 5 * kMs || delay_ns == 8 * kMs + kMs / 2) << delay_ns;
  }
  EXPECT_NEAR(static_cast<double>(late) / count, 0.05, 5.0 * std::sqrt(0.05 * 0.95 / count));
}

TEST(LinkEmulator, DuplicatesComeTwiceAndTakeTheirTime) {
  LinkEmulator link(both({.rate_bit_s = 8e6, .duplicated = 0.1}), 5);
  const int count = test::repeats(50'000);
  std::vector<int> times(static_cast<std::size_t>(count));
  for (const Delivery& each : stream_through(link, count, kMs, 400)) {  // 0.4 ms each, twice fits
    const std::int64_t delay_ns = each.at_ns - each.sent_ns;
    EXPECT_EQ(delay_ns, ++times[number_of(each.packet)] == 1 ? 400'000 : 800'000);
  }
  const auto twice = static_cast<double>(std::ranges::count(times, 2));
  EXPECT_EQ(std::ranges::count(times, 1) + static_cast<int>(twice), count);
  EXPECT_NEAR(twice / count, 0.1, 5.0 * std::sqrt(0.09 / count));
}

TEST(LinkEmulator, AnOfferAboveTheRateFillsTheQueueAndNoMore) {
  LinkEmulator link(both({.rate_bit_s = 1e6, .queue_bytes = 15'000}), 1);
  const std::vector<Delivery> out = stream_through(link, 10'000, kMs, 1000);  // 8 Mbit/s offered, for 10 s
  const DirectionStatistics& statistics = link.statistics(LinkEnd::client);
  EXPECT_EQ(statistics.delivered + statistics.lost_in_queue, 10'000U);
  EXPECT_NEAR(static_cast<double>(statistics.delivered_bytes) * 8.0, 1e6 * 10.0 + 15'000 * 8.0, 2.0 * 8000.0);
  EXPECT_LE(statistics.queue_delay.max_ns(), 14 * 8 * kMs);  // 14 packets ahead of it
  EXPECT_GE(statistics.queue_delay.max_ns(), 13 * 8 * kMs);
  EXPECT_EQ(out.back().at_ns - out[out.size() - 2].at_ns, 8 * kMs);
}

TEST(LinkEmulator, DuringAnOutageEverythingIsLost) {
  LinkEmulator link(both({.rate_bit_s = 8e6, .delay_ns = 10 * kMs}), 1);
  link.add_outage(0, {100 * kMs, 200 * kMs});
  std::vector<bool> came(300);
  for (const Delivery& each : stream_through(link, 300, kMs, 500)) came[number_of(each.packet)] = true;
  for (std::size_t i = 0; i < came.size(); ++i) {
    // Sent at i ms, transmitted for 0.5 ms, there 10.5 ms later: lost if either falls into 100..200 ms.
    EXPECT_EQ(came[i], i <= 89 || i >= 200) << i;
  }
  EXPECT_EQ(link.statistics(LinkEnd::client).lost_in_outages, 110U);
}

TEST(LinkEmulator, AnOutageThatHoldsLosesOnlyWhatDoesNotFit) {
  LinkSettings settings = both({.rate_bit_s = 8e6, .queue_bytes = 50'000, .delay_ns = 10 * kMs});
  settings.outages_hold = true;
  LinkEmulator link(settings, 1);
  link.add_outage(0, {100 * kMs + kMs / 4, 250 * kMs});
  const std::vector<Delivery> out = stream_through(link, 300, kMs, 500);
  const DirectionStatistics& statistics = link.statistics(LinkEnd::client);
  EXPECT_EQ(statistics.lost_in_outages, 0U);
  // The queue holds 100 of the 150, and empties twice as fast as it fills.
  EXPECT_NEAR(static_cast<double>(statistics.lost_in_queue), 50.0, 1.0);
  EXPECT_EQ(out.size() + statistics.lost_in_queue, 300U);
  EXPECT_TRUE(std::ranges::is_sorted(out, {}, [](const Delivery& one) { return number_of(one.packet); }));
  EXPECT_TRUE(std::ranges::none_of(
      out, [](const Delivery& one) { return one.at_ns >= 100 * kMs + kMs / 4 && one.at_ns < 250 * kMs; }));
}

TEST(LinkEmulator, AnOutageOnCommandBeginsAtOnceAndLeavesThePast) {
  LinkEmulator link(both({.delay_ns = 10 * kMs}), 1);
  link.send(LinkEnd::client, 0, numbered(0));
  link.send(LinkEnd::client, 5 * kMs, numbered(1));
  link.add_outage(10 * kMs, {0, 12 * kMs + kMs});
  link.send(LinkEnd::client, 20 * kMs, numbered(2));
  std::vector<Delivery> out;
  drain(link, kS, out);
  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(number_of(out[0].packet), 0U);
  EXPECT_EQ(link.outages().all(), (std::vector<Outage>{{10 * kMs + 1, 13 * kMs}}));
  link.add_outage(2 * kS, {kS, 2 * kS});  // over
  EXPECT_EQ(link.outages().all().size(), 1U);
}

class LinkEmulatorProperties : public testing::TestWithParam<bool> {};

TEST_P(LinkEmulatorProperties, HoldWhateverTheSettings) {
  LinkSettings settings = both(everything_bad());
  settings.outages_hold = GetParam();
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::repeats(20)); ++seed) {
    const Play play(settings, seed, 5000);
    std::array<std::vector<const Delivery*>, 2> to;
    std::int64_t latest_ns = 0;
    for (std::size_t i = 0; i < play.out.size(); ++i) {
      const Delivery& each = play.out[i];
      const auto transmission_ns = static_cast<std::int64_t>(each.packet.size()) * 8 * 200;
      EXPECT_GE(each.at_ns, each.sent_ns + transmission_ns + 6 * kMs);
      EXPECT_LE(each.at_ns, play.received_at_ns[i]);  // never before its time
      EXPECT_FALSE(play.link.outages().covering(each.at_ns)) << "seed " << seed;
      EXPECT_GE(each.at_ns, latest_ns);
      latest_ns = each.at_ns;
      to[static_cast<std::size_t>(each.to)].push_back(&each);
    }
    for (const auto& side : to) {
      for (std::size_t i = 1; i < side.size(); ++i) {  // each takes its time at the exit
        EXPECT_GE(side[i]->at_ns - side[i - 1]->at_ns,
                  static_cast<std::int64_t>(side[i]->packet.size()) * 8 * 200);
      }
    }
    for (const LinkEnd from : {LinkEnd::robot, LinkEnd::client}) {
      const DirectionStatistics& count = play.link.statistics(from);
      EXPECT_EQ(count.sent + count.duplicated,
                count.delivered + count.lost_on_air + count.lost_in_queue + count.lost_in_outages);
      EXPECT_EQ(count.delivered, to[static_cast<std::size_t>(other_end(from))].size());
      EXPECT_EQ(play.link.under_way(from), 0U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Outages, LinkEmulatorProperties, testing::Bool());

TEST(LinkEmulator, OneSeedGivesOneDigest) {
  const LinkSettings settings = both(everything_bad());
  // Written down, so that no library or machine changes it unnoticed.
  EXPECT_EQ(digest(Play(settings, 1, 5000).out), 14705295332477064127ULL);
  EXPECT_EQ(digest(Play(settings, 2, 5000).out), digest(Play(settings, 2, 5000).out));
  EXPECT_NE(digest(Play(settings, 2, 5000).out), digest(Play(settings, 3, 5000).out));
}

TEST(LinkEmulator, HowOftenItIsAskedChangesNothing) {
  const LinkSettings settings = both(everything_bad());
  LinkEmulator often(settings, 9), rarely(settings, 9);
  std::vector<Delivery> from_often, from_rarely;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const std::int64_t now_ns = i * kMs;
    for (int step = 0; step < 5; ++step) drain(often, now_ns - kMs + step * kMs / 5, from_often);
    often.send(LinkEnd::client, now_ns, numbered(i));
    rarely.send(LinkEnd::client, now_ns, numbered(i));
  }
  drain(often, 100 * kS, from_often);
  drain(rarely, 100 * kS, from_rarely);
  EXPECT_EQ(digest(from_often), digest(from_rarely));
}

TEST(LinkEmulator, NextInstantIsWhenSomethingComes) {
  LinkEmulator link(both(everything_bad()), 4);
  for (std::uint32_t i = 0; i < 100; ++i) link.send(LinkEnd::client, 0, numbered(i));
  std::vector<Delivery> out;
  while (const auto next_ns = link.next_ns()) {
    std::vector<Delivery> early;
    drain(link, *next_ns - 1, early);
    EXPECT_TRUE(early.empty());
    const std::size_t before = out.size();
    drain(link, *next_ns, out);
    for (std::size_t i = before; i < out.size(); ++i) EXPECT_EQ(out[i].at_ns, *next_ns);
  }
  EXPECT_GT(out.size(), 80U);
}

TEST(LinkEmulator, RefusesSettingsThatNoLinkHas) {
  for (const DirectionSettings& wrong :
       std::vector<DirectionSettings>{{.rate_bit_s = -1.0},
                                      {.queue_bytes = 10},
                                      {.delay_ns = -1},
                                      {.delay_ns = 1, .jitter_ns = 2},
                                      {.loss = 1.1},
                                      {.loss = 0.1, .mean_burst = 0.5},
                                      {.loss = 0.9, .mean_burst = 2.0},
                                      {.loss = 0.1, .mean_fade_ns = 10},
                                      {.loss = 0.1, .mean_burst = 2.0, .mean_fade_ns = kMs},
                                      {.reordered = -0.1},
                                      {.held_back_ns = -1},
                                      {.duplicated = 2.0}}) {
    EXPECT_THROW(LinkEmulator(both(wrong), 1), std::invalid_argument);
  }
}

}  // namespace
}  // namespace gaitway::tools
