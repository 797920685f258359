// Bound against simulation: on thousands of random buses no frame takes longer than its bound says, and in
// known worst cases it takes exactly that long.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "bus_traffic.hpp"
#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "random_messages.hpp"

namespace gaitway::can {
namespace {

using test::BusTraffic;
using test::ErrorInjector;
using test::RandomMessages;
using test::Release;

constexpr int kSets = 2500;
constexpr int kFrames = 400;  // about, a simulation

struct Tally {
  int sets = 0, schedulable = 0, unbounded = 0, fifo = 0;
  std::int64_t frames = 0;
  int met_exactly = 0;                      // messages that took as long as their bound
  std::uint64_t corrupted = 0, jammed = 0;  // frames
  int passive = 0;       // simulations in which a station became error-passive: the bounds do not cover them
  int met_by_a_bit = 0;  // and those that lacked the bit by which a blocking frame starts before them
};

void expect_within_bounds(RandomMessages& set, const std::vector<MessageResponse>& bounds,
                          const std::vector<Release>& releases, Tally& tally,
                          ErrorInjector* errors = nullptr) {
  BusTraffic traffic(set.messages, set.station, set.bit_time_ns);
  traffic.play(releases, errors);
  tally.frames += traffic.delivered();
  if (errors != nullptr) {
    tally.corrupted += errors->corrupted();
    tally.jammed += traffic.bus().statistics().injected.jammed_frames;
    if (!errors->all_active()) {
      ++tally.passive;
      return;
    }
  }
  const std::int64_t interframe_ns = kInterframeBits * set.bit_time_ns;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const auto worst_ns = traffic.worst_ns()[i];
    if (!worst_ns || !bounds[i].worst_response_ns) {
      continue;
    }
    // The interframe space belongs to the bound; a bus that waits for a whole bit takes less than it.
    const std::int64_t took_ns = *worst_ns + (set.on_raster ? interframe_ns : 0);
    ASSERT_LE(took_ns, *bounds[i].worst_response_ns)
        << "message " << i << " of " << bounds.size() << ", identifier " << set.messages[i].id;
    const std::int64_t lacks_ns = *bounds[i].worst_response_ns - took_ns;
    tally.met_exactly += lacks_ns == 0 ? 1 : 0;
    tally.met_by_a_bit += lacks_ns == set.bit_time_ns && bounds[i].blocking_ns > 0 ? 1 : 0;
  }
}

TEST(ResponseBound, HoldsOnThousandsOfRandomBuses) {
  Tally tally;
  for (std::uint32_t seed = 1; seed <= kSets && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomMessages set(seed);
    const AnalysisOptions options{.bit_time_ns = set.bit_time_ns, .errors = {}};
    const std::vector<MessageResponse> bounds = response_times(set.messages, options);
    ++tally.sets;
    tally.schedulable += all_schedulable(set.messages, options) ? 1 : 0;
    tally.unbounded += std::any_of(bounds.begin(), bounds.end(),
                                   [](const MessageResponse& bound) { return !bound.worst_response_ns; })
                           ? 1
                           : 0;
    tally.fifo += std::any_of(set.messages.begin(), set.messages.end(),
                              [](const AnalysedMessage& message) { return message.fifo.has_value(); })
                      ? 1
                      : 0;
    for (int i = 0; i < 2; ++i) {
      const std::size_t target = i == 0 ? set.least_urgent() : set.below(set.messages.size());
      expect_within_bounds(set, bounds, set.worst_releases(target, kFrames), tally);
      expect_within_bounds(set, bounds, set.random_releases(kFrames), tally);
    }
  }
  EXPECT_EQ(tally.sets, kSets);
  // The sets are what they should be, and the simulation comes up to the bounds.
  EXPECT_GT(tally.schedulable, kSets / 20);
  EXPECT_GT(tally.unbounded, kSets / 20);
  EXPECT_GT(tally.fifo, kSets / 20);
  EXPECT_GT(tally.met_exactly, kSets / 20);
  EXPECT_GT(tally.met_by_a_bit, kSets / 4);
}

TEST(ResponseBound, HoldsUnderEveryModelOfErrors) {
  Tally tally;
  for (std::uint32_t seed = 1; seed <= kSets && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomMessages set(seed);
    const AnalysisOptions options{.bit_time_ns = set.bit_time_ns, .errors = set.random_errors()};
    const std::vector<MessageResponse> bounds = response_times(set.messages, options);
    ++tally.sets;
    for (int i = 0; i < 2; ++i) {
      ErrorInjector errors(options.errors, set.error_start_ns(), seed);
      const std::size_t target = set.below(set.messages.size());
      expect_within_bounds(
          set, bounds, i == 0 ? set.worst_releases(target, kFrames / 2) : set.random_releases(kFrames / 2),
          tally, &errors);
    }
  }
  EXPECT_EQ(tally.sets, kSets);
  EXPECT_GT(tally.corrupted, 2 * kSets);
  EXPECT_GT(tally.jammed, kSets / 2);
  EXPECT_LT(tally.passive, kSets / 10);
}

// A message of eight bytes and a frame for it that takes exactly `bits`, interframe space included.
struct Exact {
  AnalysedMessage message;
  Frame frame;
};
Exact exactly(std::uint32_t id, int bits, std::int64_t period_ns) {
  std::mt19937 random(id);
  Exact made;
  made.frame = {.id = id, .size = 8, .data = {}};
  while (frame_bits(made.frame) + kInterframeBits != bits) {
    for (std::uint8_t& byte : made.frame.data) {
      byte = random() % 2 == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(random());
    }
  }
  made.message.id = id;
  made.message.length_bits = bits;
  made.message.period_ns = made.message.deadline_ns = period_ns;
  return made;
}

// The bounds, and what the bus makes of messages that are released at `first_ns` and every period from then
// on until `until_ns`, each on a station of its own.
struct Compared {
  std::vector<MessageResponse> bounds;
  std::vector<std::int64_t> took_ns;  // to the end of the interframe space
};
Compared compare(const std::vector<Exact>& set, const std::vector<std::int64_t>& first_ns,
                 std::int64_t bit_time_ns, std::int64_t until_ns) {
  std::vector<AnalysedMessage> messages;
  std::vector<int> station;
  std::vector<Release> releases;
  for (std::size_t i = 0; i < set.size(); ++i) {
    messages.push_back(set[i].message);
    station.push_back(static_cast<int>(i));
    for (std::int64_t at_ns = first_ns[i]; at_ns < until_ns; at_ns += set[i].message.period_ns) {
      releases.push_back({at_ns, at_ns, i, set[i].frame});
    }
  }
  std::stable_sort(releases.begin(), releases.end(),
                   [](const Release& a, const Release& b) { return a.at_ns < b.at_ns; });
  BusTraffic traffic(messages, station, bit_time_ns);
  traffic.play(releases);
  Compared result{response_times(messages, {.bit_time_ns = bit_time_ns, .errors = {}}), {}};
  for (const auto& worst_ns : traffic.worst_ns()) {
    result.took_ns.push_back(worst_ns.value_or(0) + kInterframeBits * bit_time_ns);
  }
  return result;
}

// Davis, Burns, Bril, Lukkien 2007: 1 ms frames every 2.5, 3.5 and 3.5 ms at 125 kbit/s.
TEST(ResponseBound, IsMetByTheSecondInstanceOfThePublishedCounterExample) {
  constexpr std::int64_t kBit_ns = 8000;
  const std::vector<Exact> set{exactly(1, 125, 2'500'000), exactly(2, 125, 3'500'000),
                               exactly(3, 125, 3'500'000)};
  const Compared together = compare(set, {0, 0, 0}, kBit_ns, 7'000'000);
  EXPECT_EQ(together.took_ns[2], 3'500'000);
  EXPECT_EQ(together.took_ns[2], together.bounds[2].worst_response_ns);
  EXPECT_EQ(compare(set, {0, 0, 0}, kBit_ns, 3'500'000).took_ns[2], 3'000'000) << "the first instance alone";

  // A blocking frame has to start before those that it blocks, be it by a nanosecond.
  const Compared blocked = compare(set, {1, 1, 0}, kBit_ns, 7'000'000);
  EXPECT_EQ(blocked.took_ns[0], *blocked.bounds[0].worst_response_ns - 1);
  EXPECT_EQ(blocked.took_ns[1], *blocked.bounds[1].worst_response_ns - 1);
}

// The first message comes again at the very bit at which the third would start.
TEST(ResponseBound, IsMetWhereTwoFramesStartTogether) {
  constexpr std::int64_t kBit_ns = facts::kBitTime_ns;
  std::vector<Exact> set{exactly(1, 120, 240'000), exactly(2, 120, 4'000'000), exactly(3, 120, 4'000'000)};
  const Compared tie = compare(set, {0, 0, 0}, kBit_ns, 4'000'000);
  EXPECT_EQ(tie.took_ns[2], 480'000);
  EXPECT_EQ(tie.took_ns[2], tie.bounds[2].worst_response_ns);
  set[0].message.period_ns += kBit_ns;
  const Compared later = compare(set, {0, 0, 0}, kBit_ns, 4'000'000);
  EXPECT_EQ(later.took_ns[2], 360'000);
  EXPECT_EQ(later.took_ns[2], later.bounds[2].worst_response_ns);
}

// Of two messages in one queue, the first comes at 0, late, and again at 10 us; the second right behind that.
TEST(ResponseBound, IsMetBehindTheSecondInstanceOfAnotherMessageInAFifoQueue) {
  std::vector<Exact> set{exactly(1, 120, 180'000), exactly(2, 120, 10'000'000)};
  set[0].message.jitter_ns = 170'000;
  std::vector<AnalysedMessage> messages{set[0].message, set[1].message};
  messages[0].fifo = messages[1].fifo = 1;
  BusTraffic traffic(messages, std::vector{0, 0}, 1000);
  traffic.play(std::vector<Release>{
      {0, -170'000, 0, set[0].frame}, {10'000, 10'000, 0, set[0].frame}, {10'000, 10'000, 1, set[1].frame}});
  EXPECT_EQ(*traffic.worst_ns()[1] + kInterframeBits * 1000, 350'000);
  EXPECT_EQ(response_times(messages)[1].worst_response_ns, 350'000);
}

}  // namespace
}  // namespace gaitway::can
