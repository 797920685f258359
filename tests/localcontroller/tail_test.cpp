// What a joint does with the points that it was sent for the time after its batch.
#include <gtest/gtest.h>

#include <numeric>

#include "point_player_fixture.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr std::int32_t kBatchEnd = 1 + 2 + 3 + 4 + 5 + 6 + 7 + 8;

class TailTest : public PointPlayerTest {
 protected:
  static can::Tail part(int index, bool toggle, std::int8_t first) {
    can::Tail tail{.node = 3, .toggle = toggle, .part = static_cast<std::uint8_t>(index)};
    std::iota(tail.delta.begin(), tail.delta.end(), first);
    return tail;
  }
  // Points 10, 11, 12 ... in so many parts.
  void send_tail(int parts, bool toggle = true) {
    for (int index = 0; index < parts; ++index) {
      player.on_tail(part(index, toggle, static_cast<std::int8_t>(10 + 8 * index)));
    }
  }
  can::Sync naming(int slot, int points, bool tail_toggle = true, bool committed = true, bool toggle = true) {
    can::Sync named = sync(slot, committed, toggle);
    named.tail_points = static_cast<std::uint8_t>(points);
    named.tail_toggle = tail_toggle;
    return named;
  }
  // The batch with its SYNCs up to slot 7, which name a tail of so many points.
  void play_batch(int points, bool tail_toggle = true) {
    player.on_trajectory(batch(true));
    for (int slot = 0; slot < 8; ++slot) {
      player.on_sync(naming(slot, points, tail_toggle), slot_ns(slot));
    }
  }
  void fall_silent_for(int slots) { run_alone(slot_ns(7), slot_ns(8 + slots)); }
  static std::int32_t tail_sum(int points) { return points * 10 + points * (points - 1) / 2; }
};

TEST_F(TailTest, WithoutSyncTheTailFollowsTheBatchAndThenTheJointHolds) {
  send_tail(2);
  play_batch(11);
  EXPECT_EQ(player.count(), kBatchEnd);
  for (int slot = 0; slot < 11; ++slot) {
    fall_silent_for(slot + 1);
    EXPECT_EQ(player.count(), kBatchEnd + tail_sum(slot + 1)) << slot;
    EXPECT_TRUE(player.running());
  }
  fall_silent_for(40);
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(11));
  EXPECT_FALSE(player.running());
}

TEST_F(TailTest, ItMovesOnWithoutAStallFromBatchToTail) {
  send_tail(1);
  play_batch(8);
  double before = player.reference(slot_ns(7)).count;
  for (std::int64_t now_ns = slot_ns(7) + kMillisecond_ns; now_ns < slot_ns(10); now_ns += kMillisecond_ns) {
    player.advance_without_sync(now_ns);
    const double here = player.reference(now_ns).count;
    EXPECT_GT(here, before) << (now_ns - slot_ns(7)) / kMillisecond_ns;
    EXPECT_LT(here - before, 2.0) << "a point is 10 counts in 10 ms, more while it makes up for waiting";
    before = here;
  }
}

TEST_F(TailTest, WhatSyncHasNotNamedIsNotUsed) {
  send_tail(2);
  play_batch(0);
  fall_silent_for(10);
  EXPECT_EQ(player.count(), kBatchEnd);
  EXPECT_FALSE(player.tail_missing());
}

TEST_F(TailTest, AnIncompleteTailIsNotUsedAndIsToldOf) {
  player.on_tail(part(0, true, 10));
  play_batch(9);
  EXPECT_TRUE(player.tail_missing());
  fall_silent_for(10);
  EXPECT_EQ(player.count(), kBatchEnd);
}

TEST_F(TailTest, OneThatCountsMayBeCompletedWhileTheNextOneComes) {
  player.on_tail(part(0, true, 10));
  player.on_trajectory(batch(true));
  player.on_sync(naming(0, 12), slot_ns(0));
  EXPECT_TRUE(player.tail_missing());
  player.on_tail(part(0, false, 50));
  player.on_tail(part(1, true, 18));
  player.on_tail(part(1, false, 58));
  for (int slot = 1; slot < 8; ++slot) {
    player.on_sync(naming(slot, 12), slot_ns(slot));
  }
  EXPECT_FALSE(player.tail_missing());
  player.on_trajectory(batch(false));
  player.on_sync(
      [&] {
        can::Sync next = naming(0, 12, false, true, false);
        ++next.cycle;
        return next;
      }(),
      slot_ns(8));
  EXPECT_FALSE(player.tail_missing());
}

TEST_F(TailTest, ATailMayBeNamedWhileItsBatchRuns) {
  player.on_trajectory(batch(true));
  player.on_sync(naming(0, 0), slot_ns(0));
  send_tail(1);
  for (int slot = 1; slot < 8; ++slot) {
    player.on_sync(naming(slot, slot < 3 ? 0 : 4), slot_ns(slot));
  }
  fall_silent_for(10);
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(4));
}

TEST_F(TailTest, TheNextBatchStartsWhereTheLastOneEndedHoweverLateItsSyncIs) {
  for (const int late_ms : {0, 1, 2, 3, 5, 9}) {
    player = PointPlayer(0, -kLimit, kLimit);
    send_tail(1);
    play_batch(8);
    player.on_trajectory(batch(false));
    const std::int64_t late_ns = late_ms * kMillisecond_ns;
    run_alone(slot_ns(7), slot_ns(8) + late_ns);
    ++cycle;
    can::Sync next = naming(0, 0, false, true, false);
    player.on_sync(next, slot_ns(0) + late_ns);
    EXPECT_EQ(player.count(), kBatchEnd + 1) << late_ms;
    EXPECT_FALSE(player.executing_toggle());
    --cycle;
  }
}

TEST_F(TailTest, SoDoesOneWhoseSyncComesWhenAShortTailIsOver) {
  send_tail(1);
  play_batch(1);
  player.on_trajectory(batch(false));
  const std::int64_t late_ns = 25 * kMillisecond_ns;
  run_alone(slot_ns(7), slot_ns(8) + late_ns);
  EXPECT_FALSE(player.running());
  ++cycle;
  player.on_sync(naming(0, 0, false, true, false), slot_ns(0) + late_ns);
  EXPECT_EQ(player.count(), kBatchEnd + 1);
}

TEST_F(TailTest, ABatchThatWasNeverCommittedIsForgotten) {
  send_tail(1);
  play_batch(8);
  player.on_trajectory(batch(false));
  fall_silent_for(4);
  EXPECT_FALSE(player.pending_toggle()) << "its SYNC may still be under way";
  ++cycle;
  player.on_sync(naming(5, 0, false, false), slot_ns(5));
  EXPECT_TRUE(player.pending_toggle()) << "so that the loss of another one of that toggle shows";
  ++cycle;
  player.on_sync(naming(0, 0, false, true, false), slot_ns(0));
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(8))
      << "another batch is meant, which this joint does not have";
}

TEST_F(TailTest, NeitherIsItStartedByAnotherToggle) {
  send_tail(1);
  play_batch(8);
  player.on_trajectory(batch(false));
  fall_silent_for(4);
  ++cycle;
  player.on_sync(naming(5, 0, false, false), slot_ns(5));
  ++cycle;
  player.on_sync(naming(0, 0, false, true, true), slot_ns(0));
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(8));
  EXPECT_FALSE(player.running());
}

TEST_F(TailTest, ASyncThatWaitedForLongTellsNothing) {
  send_tail(1);
  play_batch(8);
  fall_silent_for(4);
  const std::int32_t count = player.count();
  EXPECT_FALSE(player.on_sync(naming(6, 8), slot_ns(12))) << "of the batch's own cycle";
  ++cycle;
  EXPECT_FALSE(player.on_sync(naming(1, 0, false, false), slot_ns(4)));
  EXPECT_EQ(player.count(), count);
}

// As when the bus was cut with the SYNC in the port, and is there again: its batch was given up long ago.
TEST_F(TailTest, ASyncThatWaitedForLongStartsNoBatch) {
  for (const int slots_late : {5, 500}) {
    player = PointPlayer(0, -kLimit, kLimit);
    send_tail(2);
    play_batch(11);
    player.on_trajectory(batch(false));
    fall_silent_for(slots_late + 1);
    const std::int32_t before = player.count();
    ++cycle;
    player.on_sync(sync(0, true, false), slot_ns(slots_late) + kSlot_ns / 2);
    run_alone(slot_ns(slots_late) + kSlot_ns / 2, slot_ns(slots_late + 30));
    EXPECT_EQ(player.count(), slots_late == 5 ? kBatchEnd + tail_sum(11) : before) << slots_late;
    cycle += 1000;
  }
}

// Until then the message controller counts on it.
TEST_F(TailTest, ASyncThatIsFourSlotsLateStartsItsBatch) {
  send_tail(2);
  play_batch(11);
  player.on_trajectory(batch(false));
  fall_silent_for(4);
  ++cycle;
  player.on_sync(sync(0, true, false), slot_ns(4) + kMillisecond_ns);
  EXPECT_EQ(player.executing_toggle(), false);
  EXPECT_TRUE(player.running());
}

TEST_F(TailTest, ABatchOfALaterCycleStartsWhereTheTailIsThen) {
  send_tail(2);
  play_batch(16);
  fall_silent_for(7);
  player.on_trajectory(batch(false));
  cycle = static_cast<std::uint16_t>(cycle + 1);
  player.on_sync(naming(7, 0, true, false), slot_ns(7));  // whoever returns commits nothing yet
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(8));
  EXPECT_TRUE(player.running());
  cycle = static_cast<std::uint16_t>(cycle + 1);
  player.on_sync(naming(0, 0, true, true, false), slot_ns(0));
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(8) + 1);
}

TEST_F(TailTest, ASyncThatCommitsNothingAlignsItAndLetsItGoOn) {
  send_tail(1);
  play_batch(8);
  ++cycle;
  for (int slot = 0; slot < 8; ++slot) {
    EXPECT_TRUE(player.on_sync(naming(slot, 0, false, false), slot_ns(slot) + 300'000));
    EXPECT_EQ(player.count(), kBatchEnd + tail_sum(slot + 1));
  }
  ++cycle;
  player.on_sync(naming(0, 0, false, false), slot_ns(0));
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(8));
  EXPECT_FALSE(player.running());
}

TEST_F(TailTest, SlotsThatPassedWhileNobodySpokeAreMadeUpFor) {
  send_tail(1);
  play_batch(8);
  ++cycle;
  player.on_sync(naming(3, 0, false, false), slot_ns(3));
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(4));
}

TEST_F(TailTest, ANewTailReplacesAnOlderOneThatWasNeverNamed) {
  send_tail(2, true);  // of a batch that was given up
  player.on_tail(part(0, false, 20));
  player.on_tail(part(0, true, 10));  // the next one's first part, whose second is lost
  play_batch(9);
  EXPECT_TRUE(player.tail_missing()) << "the old second part is not this tail's";
}

TEST_F(TailTest, WhatBelongsToABatchThatIsOverIsNotLeftBehind) {
  send_tail(2, true);
  play_batch(16);
  player.on_trajectory(batch(false));
  ++cycle;
  player.on_sync(naming(0, 0, false, true, false), slot_ns(0));  // its tail is not whole
  player.on_tail(part(0, true, 10));
  player.on_sync(naming(1, 9, true, true, false), slot_ns(1));
  EXPECT_TRUE(player.tail_missing());
}

TEST_F(TailTest, ARepeatedPartChangesNothing) {
  send_tail(2);
  player.on_tail(part(0, true, 10));
  play_batch(11);
  player.on_tail(part(1, true, 18));
  fall_silent_for(20);
  EXPECT_EQ(player.count(), kBatchEnd + tail_sum(11));
}

TEST_F(TailTest, AnEmergencyStopEndsIt) {
  send_tail(2);
  play_batch(16);
  fall_silent_for(2);
  player.freeze(slot_ns(10));
  const std::int32_t frozen = player.count();
  run_alone(slot_ns(10), slot_ns(30));
  EXPECT_EQ(player.count(), frozen);
  send_tail(2);
  EXPECT_TRUE(player.frozen());
}

TEST_F(TailTest, NoManualCommandInterruptsIt) {
  send_tail(1);
  play_batch(8);
  fall_silent_for(2);
  EXPECT_FALSE(player.move_to(0, 10, slot_ns(10)));
  fall_silent_for(12);
  EXPECT_TRUE(player.move_to(0, 10, slot_ns(20)));
}

TEST_F(TailTest, ItStaysWithinTheJointsLimits) {
  player = PointPlayer(0, -100, kBatchEnd + 15);
  send_tail(1);
  play_batch(8);
  fall_silent_for(10);
  EXPECT_EQ(player.count(), kBatchEnd + 15);
}

TEST_F(TailTest, ARepairEndsIt) {
  send_tail(1);
  play_batch(8);
  fall_silent_for(2);
  ++cycle;
  player.on_resynchronisation(
      {.node = 3, .toggle = false, .slot = 3, .count = 500, .delta = {1, 1, 1, 1, 1}});
  player.on_sync(naming(3, 0, false, true, false), slot_ns(3));
  EXPECT_EQ(player.count(), 500);
}

// Clocks of joints differ by 100 ppm either way: a batch and the longest tail later they are still together.
TEST_F(TailTest, JointsStayTogetherByTheirOwnClocks) {
  constexpr int kPoints = 24;
  std::array<std::int64_t, 2> end_ns{};
  for (const int which : {0, 1}) {
    const double rate = which == 0 ? 1.0 - 100e-6 : 1.0 + 100e-6;
    player = PointPlayer(0, -kLimit, kLimit);
    send_tail(3);
    player.on_trajectory(batch(true));
    const auto local = [rate](std::int64_t now_ns) {
      return static_cast<std::int64_t>(static_cast<double>(now_ns) * rate);
    };
    player.on_sync(naming(0, kPoints), local(slot_ns(0)));
    for (std::int64_t us = 0; us < 400'000; us += 10) {  // finer than a servo period, to see the difference
      player.advance_without_sync(local(slot_ns(0) + us * 1000));
      if (player.running()) {
        end_ns[static_cast<std::size_t>(which)] = us * 1000;
      }
    }
    EXPECT_EQ(player.count(), kBatchEnd + tail_sum(kPoints));
  }
  EXPECT_LT(std::abs(end_ns[0] - end_ns[1]), 100'000);
}

}  // namespace
}  // namespace gaitway::localcontroller
