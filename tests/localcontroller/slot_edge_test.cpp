// What the servo gets at the edges of slots: however late, early or lost a SYNC is, the reference runs on
// without a jump and no point is left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/localcontroller/point_player.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr std::int32_t kLimit = 100'000;
using facts::kMillisecond_ns;
using facts::kSlot_ns;
constexpr int kSlots = 8 * 250;

// Random batches that speed up and slow down as a walk does: by a few counts from point to point.
std::vector<std::int8_t> draw_deltas(std::mt19937& random) {
  std::uniform_int_distribution<int> change(-12, 12);
  std::vector<std::int8_t> deltas;
  int delta = 0;
  for (int slot = 0; slot < kSlots; ++slot) {
    delta = std::clamp(delta + change(random), -90, 90);
    deltas.push_back(static_cast<std::int8_t>(delta));
  }
  return deltas;
}

struct Edges {
  double drift_ppm = 0.0;        // the joint's clock runs fast by this
  std::int64_t jitter_ns = 0;    // a SYNC comes up to this much late
  double lost = 0.0;             // share of SYNCs that are lost; slot 0 arrives: a batch starts there only
  double largest_change = 0.0;   // out: of the reference from one millisecond to the next, in counts
  double largest_ripple = 0.0;   // out: of the rate from one millisecond to the next, in counts/s
  double largest_offset = 0.0;   // out: between reference and plan, in counts
  std::int32_t final_error = 0;  // out: counts left out or played twice
};

// Plays all batches on a joint whose servo steps every millisecond of its own clock.
void play(Edges& edges, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int64_t> late_ns(0, edges.jitter_ns);
  std::bernoulli_distribution is_lost(edges.lost);
  const std::vector<std::int8_t> deltas = draw_deltas(random);
  PointPlayer player(0, -kLimit, kLimit);
  const double speed = 1.0 + edges.drift_ppm * 1e-6;
  std::int64_t step_ns = 0;
  PointPlayer::Reference last;
  double plan = 0.0;
  const auto steps_until = [&](std::int64_t until_ns, double from, double delta, std::int64_t slot_ns) {
    for (; step_ns < until_ns; step_ns += kMillisecond_ns) {
      player.advance_without_sync(step_ns);
      const PointPlayer::Reference now = player.reference(step_ns);
      edges.largest_change = std::max(edges.largest_change, std::abs(now.count - last.count));
      edges.largest_ripple = std::max(edges.largest_ripple, std::abs(now.rate_per_s - last.rate_per_s));
      const double share = static_cast<double>(step_ns - slot_ns) / static_cast<double>(kSlot_ns);
      edges.largest_offset = std::max(edges.largest_offset, std::abs(now.count - (from + delta * share)));
      last = now;
    }
  };
  std::int64_t slot_ns = 0;
  for (int slot = 0; slot < kSlots; ++slot) {
    const auto cycle = static_cast<std::uint16_t>(slot / 8);
    const bool toggle = cycle % 2 == 0;
    if (slot % 8 == 0) {
      can::Trajectory batch{.node = 3, .toggle = toggle, .delta = {}};
      std::copy_n(deltas.begin() + slot, 8, batch.delta.begin());
      player.on_trajectory(batch);
    }
    slot_ns = std::llround(static_cast<double>(slot) * static_cast<double>(kSlot_ns) * speed);
    const std::int64_t arrival_ns = slot_ns + late_ns(random);
    const double before = slot == 0 ? 0.0 : deltas[static_cast<std::size_t>(slot) - 1];
    steps_until(arrival_ns, plan, before, slot_ns);  // still on the way of the slot before, or coasting
    if (slot % 8 == 0 || !is_lost(random)) {
      player.on_sync({.cycle = cycle,
                      .slot = static_cast<std::uint8_t>(slot % 8),
                      .batch_committed = true,
                      .toggle = toggle},
                     arrival_ns);
    }
    const double delta = deltas[static_cast<std::size_t>(slot)];
    steps_until(slot_ns + 9 * kMillisecond_ns, plan, delta, slot_ns);
    plan += delta;
  }
  slot_ns += kSlot_ns;
  steps_until(slot_ns + kMillisecond_ns, plan, deltas.back(), slot_ns);
  edges.final_error = player.count() - static_cast<std::int32_t>(plan);
}

// 90 counts a slot are 9 a millisecond; what is made up for after a late SYNC comes on top.
TEST(SlotEdges, ADriftingClockAndJitterOfSyncNeverMakeTheReferenceJumpOrStall) {
  for (const double drift_ppm : {-50.0, 0.0, 50.0}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Edges edges{.drift_ppm = drift_ppm, .jitter_ns = 1'000'000};
      play(edges, seed);
      EXPECT_EQ(edges.final_error, 0);
      EXPECT_LT(edges.largest_change, 9.0 * 1.2);
      EXPECT_LT(edges.largest_ripple, 3500.0) << "1200 are the batch's own; a stall would be 9000";
      EXPECT_LT(edges.largest_offset, 12.0) << "a jitter of 1 ms at full speed is 9 counts";
    }
  }
}

TEST(SlotEdges, LostSyncsNeverMakeTheReferenceJumpOrStall) {
  for (const double lost : {0.02, 0.3, 1.0}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Edges edges{.drift_ppm = 50.0, .lost = lost};
      play(edges, seed);
      EXPECT_EQ(edges.final_error, 0);
      EXPECT_LT(edges.largest_change, 9.0 * 1.2);
      EXPECT_LT(edges.largest_ripple, 1700.0);
      EXPECT_LT(edges.largest_offset, 3.0)
          << "none within a batch; past its last point the next is not known";
    }
  }
}

can::Sync committed(std::uint16_t cycle, std::uint8_t slot, bool toggle) {
  return {.cycle = cycle, .slot = slot, .batch_committed = true, .toggle = toggle};
}

TEST(SlotEdges, WhatACoastingJointRanAheadItTakesBackWhenTheBatchHasEnded) {
  PointPlayer player(0, -kLimit, kLimit);
  player.on_trajectory({.node = 3, .toggle = true, .delta = {50, 50, 50, 50, 50, 50, 50, 50}});
  player.on_sync(committed(0, 0, true), 0);
  double last = 0.0;
  for (std::int64_t now_ns = 0; now_ns <= 120 * kMillisecond_ns; now_ns += kMillisecond_ns) {
    player.advance_without_sync(now_ns);
    const double count = player.reference(now_ns).count;
    ASSERT_LE(std::abs(count - last), 6.0) << now_ns;
    ASSERT_LE(count, 400.0 + 5.0 * 1.5);
    last = count;
  }
  EXPECT_FALSE(player.running());
  EXPECT_DOUBLE_EQ(last, 400.0);
}

TEST(SlotEdges, CoastingNeverLeavesThePositionLimitsAndEnds) {
  for (const int sign : {-1, 1}) {
    PointPlayer player(0, -100, 100);
    player.on_trajectory(
        {.node = 3,
         .toggle = true,
         .delta = {static_cast<std::int8_t>(sign * 99), static_cast<std::int8_t>(sign * 99)}});
    player.on_sync(committed(0, 0, true), 0);
    for (std::int64_t now_ns = 0; now_ns <= 12 * kMillisecond_ns; now_ns += kMillisecond_ns / 10) {
      ASSERT_LE(std::abs(player.reference(now_ns).count), 100.0);
    }
  }
  PointPlayer player(0, -kLimit, kLimit);
  player.on_trajectory({.node = 3, .toggle = true, .delta = {99, 20}});
  player.on_sync(committed(0, 0, true), 0);
  EXPECT_DOUBLE_EQ(player.reference(11 * kMillisecond_ns).count, 101.0) << "on the way to the next point";
  EXPECT_DOUBLE_EQ(player.reference(13 * kMillisecond_ns).count, 99.0);
}

TEST(SlotEdges, ARepairIsNotOvershotWhenTheNextSyncIsLate) {
  for (const std::uint8_t slot : {std::uint8_t{2}, std::uint8_t{7}}) {
    PointPlayer player(0, -kLimit, kLimit);
    player.on_trajectory({.node = 3, .toggle = true, .delta = {0, 0, 0, 0, 0, 0, 0, 90}});
    player.on_sync(committed(0, 0, true), 0);
    player.on_resynchronisation({.node = 3, .toggle = true, .slot = slot, .count = 500});
    player.on_sync(committed(0, slot, true), slot * kSlot_ns);
    EXPECT_DOUBLE_EQ(player.reference((slot + 1) * kSlot_ns + kMillisecond_ns).count, 500.0);
  }
}

TEST(SlotEdges, AServoThatWasHeldUpForSlotsPlaysThemOneAfterTheOtherWithoutAJump) {
  PointPlayer player(0, -kLimit, kLimit);
  player.on_trajectory({.node = 3, .toggle = true, .delta = {10, 10, 10, 10, 10, 10, 10, 10}});
  player.on_sync(committed(0, 0, true), 0);
  double last = player.reference(10 * kMillisecond_ns).count;
  for (std::int64_t now_ns = 38 * kMillisecond_ns; now_ns < 110 * kMillisecond_ns;
       now_ns += kMillisecond_ns) {
    player.advance_without_sync(now_ns);
    const double count = player.reference(now_ns).count;
    ASSERT_LE(std::abs(count - last), 10.0) << now_ns;
    last = count;
  }
  EXPECT_DOUBLE_EQ(last, 80.0);
}

TEST(SlotEdges, PointsWhoseSyncsWereLostAtTheEndOfABatchAreMadeUpForByTheNext) {
  PointPlayer player(0, -kLimit, kLimit);
  player.on_trajectory({.node = 3, .toggle = true, .delta = {1, 2, 3, 4, 5, 6, 7, 8}});
  player.on_sync(committed(0, 0, true), 0);
  player.on_sync(committed(0, 5, true), 50 * kMillisecond_ns);
  player.on_trajectory({.node = 3, .toggle = false, .delta = {100}});
  player.on_sync(committed(1, 0, false), 80 * kMillisecond_ns);
  EXPECT_EQ(player.count(), 136);
}

TEST(SlotEdges, MakingUpForPointsKeepsWithinTheLimitsAtEachOfThem) {
  PointPlayer player(0, -10, 10);
  player.on_trajectory({.node = 3, .toggle = true, .delta = {8, 8, 8, -1}});
  player.on_sync(committed(0, 0, true), 0);
  player.on_sync(committed(0, 3, true), 30 * kMillisecond_ns);
  EXPECT_EQ(player.count(), 9) << "as a joint that got every SYNC";
}

TEST(SlotEdges, AJointThatMissedABatchTakesTheNext) {
  PointPlayer player(0, -kLimit, kLimit);
  for (std::uint16_t cycle = 0; cycle < 5; ++cycle) {
    const bool toggle = cycle % 2 == 0;
    if (cycle != 1 && cycle != 3) {
      player.on_trajectory({.node = 3, .toggle = toggle, .delta = {10}});
    }
    for (std::uint8_t slot = 0; slot < 8; ++slot) {
      player.on_sync(committed(cycle, slot, toggle), (cycle * 8 + slot) * kSlot_ns);
      EXPECT_EQ(player.running(), cycle % 2 == 0);
    }
  }
  EXPECT_EQ(player.count(), 30);
}

}  // namespace
}  // namespace gaitway::localcontroller
