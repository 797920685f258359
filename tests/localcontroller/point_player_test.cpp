// Batches, lost and repeated frames, repairs: whatever the bus does, the joint ends on the count that was
// meant.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "point_player_fixture.hpp"

namespace gaitway::localcontroller {
namespace {

TEST_F(PointPlayerTest, RandomBatchesReachTheSumOfTheirDeltas) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> delta(-127, 127);
  std::int32_t expected = 0;
  bool toggle = true;
  for (int i = 0; i < 200; ++i, ++cycle, toggle = !toggle) {
    can::Trajectory frame = batch(toggle);
    for (auto& value : frame.delta) {
      value = static_cast<std::int8_t>(delta(random));
    }
    player.on_trajectory(frame);
    for (int slot = 0; slot < 8; ++slot) {
      take_sync(slot, true, toggle);
      expected += frame.delta[static_cast<std::size_t>(slot)];
      ASSERT_EQ(player.count(), expected) << "batch " << i << ", slot " << slot;
      ASSERT_DOUBLE_EQ(player.reference(slot_ns(slot) + kSlot_ns).count, expected);
    }
  }
}

TEST_F(PointPlayerTest, InterpolatesOverTheSlotWithTheSlopeAsRate) {
  player.on_trajectory(batch(true, {20, -10}));
  take_sync(0);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(0)).count, 0.0);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(0) + 5 * kMillisecond_ns).count, 10.0);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(0) + 5 * kMillisecond_ns).rate_per_s, 2000.0);
  take_sync(1);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(1) + 5 * kMillisecond_ns).count, 15.0);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(1) + 5 * kMillisecond_ns).rate_per_s, -1000.0);
}

TEST_F(PointPlayerTest, ABatchWaitsForTheSyncThatCommitsIt) {
  player.on_trajectory(batch(true));
  take_sync(3);
  take_sync(0, false);
  EXPECT_FALSE(player.running());
  ++cycle;
  take_sync(0, true, false);
  EXPECT_FALSE(player.running()) << "committed is another batch than the one it holds";
  EXPECT_EQ(player.count(), 0);
}

TEST_F(PointPlayerTest, ABatchThatWasPassedOverNeverStartsLater) {
  player.on_trajectory(batch(true));
  take_sync(0, true, false);  // its own SYNC was lost, and so was the next batch
  ++cycle;
  take_sync(0, true, true);  // commits a third batch, which bears the first one's toggle
  EXPECT_FALSE(player.running());
  EXPECT_EQ(player.count(), 0);
}

TEST_F(PointPlayerTest, RepeatedTrajectoryFramesChangeNothing) {
  player.on_trajectory(batch(true));
  player.on_trajectory(batch(true));
  take_sync(0);
  player.on_trajectory(batch(true));  // a late repetition of the executing batch
  for (int slot = 1; slot < 8; ++slot) {
    take_sync(slot);
  }
  EXPECT_EQ(player.count(), 36);
  ++cycle;
  take_sync(0);
  EXPECT_FALSE(player.running()) << "the repetition must not be taken for the next batch";
}

TEST_F(PointPlayerTest, RepeatedSyncsChangeNothing) {
  player.on_trajectory(batch(true));
  for (int slot = 0; slot < 8; ++slot) {
    take_sync(slot);
    player.on_sync(sync(slot), slot_ns(slot) + 150'000);
    ASSERT_TRUE(player.running()) << "slot " << slot;
    ASSERT_EQ(player.count(), (slot + 1) * (slot + 2) / 2);
  }
}

TEST_F(PointPlayerTest, ALostSyncIsReplacedByTheJointsOwnClockAndNotTakenTwice) {
  player.on_trajectory(batch(true));
  take_sync(0);
  EXPECT_FALSE(player.advance_without_sync(slot_ns(1) + kSyncGrace_ns - 1));
  EXPECT_TRUE(player.advance_without_sync(slot_ns(1) + kSyncGrace_ns));
  EXPECT_EQ(player.count(), 3);
  player.on_sync(sync(1), slot_ns(1) + 2 * kMillisecond_ns);
  EXPECT_EQ(player.count(), 3);
  take_sync(2);
  EXPECT_EQ(player.count(), 6);
}

TEST_F(PointPlayerTest, ASyncOfALaterSlotMakesUpForThoseThatWereLost) {
  player.on_trajectory(batch(true));
  take_sync(0);
  take_sync(4);  // without a step in between
  EXPECT_EQ(player.count(), 15);
  player.on_sync(sync(2), slot_ns(4) + kMillisecond_ns);  // late: its point has been played
  EXPECT_EQ(player.count(), 15);
}

TEST_F(PointPlayerTest, WithoutAnySyncTheBatchPlaysOutAndTheJointHolds) {
  player.on_trajectory(batch(true));
  player.on_trajectory(batch(true));
  take_sync(0);
  run_alone(slot_ns(0), slot_ns(8));
  EXPECT_EQ(player.count(), 36);
  run_alone(slot_ns(8), slot_ns(24));
  EXPECT_FALSE(player.running());
  EXPECT_EQ(player.count(), 36);
  EXPECT_EQ(player.reference(slot_ns(24)).rate_per_s, 0.0);
}

TEST_F(PointPlayerTest, ANewBatchDoesNotStartByTheJointsOwnClock) {
  player.on_trajectory(batch(true));
  take_sync(0);
  player.on_trajectory(batch(false));
  run_alone(slot_ns(0), slot_ns(16));
  EXPECT_EQ(player.count(), 36);
  EXPECT_FALSE(player.running());
}

TEST_F(PointPlayerTest, AnyLossOfSyncsWithinABatchEndsOnItsSum) {
  for (unsigned lost = 0; lost < 256; lost += 2) {  // slot 0 arrives: a batch starts on SYNC only
    player = PointPlayer(0, -kLimit, kLimit);
    player.on_trajectory(batch(true));
    for (int slot = 0; slot < 8; ++slot) {
      if (((lost >> static_cast<unsigned>(slot)) & 1U) == 0) {
        take_sync(slot);
      }
      run_alone(slot_ns(slot), slot_ns(slot + 1));
    }
    run_alone(slot_ns(8), slot_ns(8) + 3 * kMillisecond_ns);
    EXPECT_EQ(player.count(), 36) << "lost: " << lost;
    cycle = static_cast<std::uint16_t>(cycle + 2);
  }
}

TEST_F(PointPlayerTest, ARepairBringsAJointThatLostItsBatchOntoItsCount) {
  for (int slot = 2; slot < 8; ++slot) {
    player = PointPlayer(0, -kLimit, kLimit);
    ++cycle;
    can::Resynchronisation repair{.node = 3,
                                  .toggle = true,
                                  .slot = static_cast<std::uint8_t>(slot),
                                  .count = static_cast<std::int16_t>((slot + 1) * (slot + 2) / 2)};
    for (int k = 0; k < can::kResyncDeltas && slot + 1 + k < 8; ++k) {
      repair.delta[static_cast<std::size_t>(k)] = static_cast<std::int8_t>(slot + 2 + k);
    }
    for (int now = 0; now < 8; ++now) {
      take_sync(now);
      if (now == slot - 1) {
        EXPECT_FALSE(player.running());
        player.on_resynchronisation(repair);
        EXPECT_EQ(player.count(), 0) << "it takes effect at its SYNC, not before";
      }
    }
    EXPECT_TRUE(player.running());
    EXPECT_TRUE(player.executing_toggle());
    EXPECT_EQ(player.count(), 36) << "repaired in slot " << slot;
  }
}

TEST_F(PointPlayerTest, ARepairThatComesTooLateOrForAnotherBatchDoesNothing) {
  player.on_trajectory(batch(true));
  take_sync(0);
  take_sync(1);
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 1, .count = 500});
  player.on_resynchronisation({.node = 3, .toggle = false, .slot = 2, .count = 500});
  take_sync(2);
  EXPECT_EQ(player.count(), 6);
}

TEST_F(PointPlayerTest, AfterARepairTheLastFrameOfThatToggleNoLongerCountsAsHeld) {
  player.on_trajectory(batch(false));
  take_sync(0, true, false);
  ++cycle;
  take_sync(0, true, true);  // lost its frame
  take_sync(1, true, true);
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 2, .count = 40});
  take_sync(2, true, true);
  EXPECT_TRUE(player.pending_toggle()) << "or the loss of the next frame, toggle 0, would go unnoticed";
}

TEST_F(PointPlayerTest, ARepairFindsItsSlotThoughSyncsBeforeItWereLostWhileHolding) {
  take_sync(7, false);
  ++cycle;
  run_alone(slot_ns(-1), slot_ns(0) + 9 * kMillisecond_ns);  // SYNC 0 lost
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 2, .count = 40});
  run_alone(slot_ns(0) + 9 * kMillisecond_ns, slot_ns(2));  // SYNC 1 lost
  take_sync(2);
  EXPECT_EQ(player.count(), 40);
}

TEST_F(PointPlayerTest, ARepairWaitsForItsSlotAndLeavesAHoldingJointHolding) {
  take_sync(0, false);
  take_sync(1, false);
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 4, .count = 40, .delta = {9, 9}});
  take_sync(2, false);
  take_sync(3, false);
  EXPECT_EQ(player.count(), 0);
  take_sync(4, false);
  EXPECT_EQ(player.count(), 40);
  EXPECT_FALSE(player.running()) << "no batch is committed: the count alone was wrong";
  take_sync(5, false);
  EXPECT_EQ(player.count(), 40);
}

TEST_F(PointPlayerTest, ARepairThatMissedItsSlotIsNotAppliedACycleLater) {
  take_sync(0, false);
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 5, .count = 40});
  run_alone(slot_ns(0), slot_ns(9));  // all SYNCs lost, that of the next cycle, too
  ++cycle;
  for (int slot = 1; slot < 8; ++slot) {
    take_sync(slot, false);
  }
  EXPECT_EQ(player.count(), 0);
}

TEST_F(PointPlayerTest, ABatchThatCameTooLateAndWasRepairedNeverStarts) {
  take_sync(0);
  player.on_trajectory(batch(true));
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 2, .count = 6, .delta = {4, 5, 6, 7, 8}});
  for (int slot = 1; slot < 8; ++slot) {
    take_sync(slot);
  }
  EXPECT_EQ(player.count(), 36);
  cycle = static_cast<std::uint16_t>(cycle + 2);  // a cycle's SYNCs and two batches are lost
  take_sync(0);
  EXPECT_FALSE(player.running());
  EXPECT_EQ(player.count(), 36);
}

TEST_F(PointPlayerTest, AMissedBatchIsNotTakenForTheNextOne) {
  take_sync(0);  // toggle 1 was committed, its frame lost
  EXPECT_TRUE(player.pending_toggle()) << "or the loss of the next frame, toggle 0, would go unnoticed";
}

TEST_F(PointPlayerTest, TheReferenceStaysWithinItsLimits) {
  player = PointPlayer(0, -10, 10);
  player.on_trajectory(batch(true, {8, 8, 8, -1}));
  take_sync(0);
  EXPECT_FALSE(player.at_limit());
  take_sync(1);
  EXPECT_TRUE(player.at_limit());
  EXPECT_EQ(player.count(), 10);
  take_sync(2);
  EXPECT_EQ(player.count(), 10);
  take_sync(3);
  EXPECT_FALSE(player.at_limit());
  EXPECT_EQ(player.count(), 9);
}

TEST_F(PointPlayerTest, MovesByHandInAStraightLineWhileHoldingOnly) {
  take_sync(0, false);
  ASSERT_TRUE(player.move_to(100, 10, slot_ns(0)));
  for (int slot = 1; slot < 5; ++slot) {
    take_sync(slot, false);
    EXPECT_NEAR(player.reference(slot_ns(slot)).count, 10.0 * slot, 1e-9);
  }
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(10)).count, 100.0);
  EXPECT_FALSE(player.move_to(50, 0, slot_ns(10)));
  ++cycle;
  player.on_trajectory(batch(true, {0, 0, 5}));
  take_sync(0);
  EXPECT_FALSE(player.move_to(0, 10, slot_ns(0)));
}

TEST_F(PointPlayerTest, MovesByHandOutOfABatchThatLeavesItWhereItIs) {
  player.on_trajectory(batch(true, {7}));
  take_sync(0);
  EXPECT_FALSE(player.move_to(27, 2, slot_ns(0))) << "it moves";
  take_sync(1);
  ASSERT_TRUE(player.move_to(27, 2, slot_ns(1)));
  EXPECT_FALSE(player.running());
  take_sync(2);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(2)).count, 17.0);
  take_sync(3);
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(3)).count, 27.0);
}

TEST_F(PointPlayerTest, FreezesOnTheNearestCount) {
  for (const int sign : {-1, 1}) {
    player = PointPlayer(0, -kLimit, kLimit);
    player.on_trajectory(batch(true, {static_cast<std::int8_t>(sign * 101)}));
    take_sync(0);
    player.freeze(slot_ns(0) + 6 * kMillisecond_ns);  // at 60.6
    EXPECT_EQ(player.count(), sign * 61);
    ++cycle;
  }
}

TEST_F(PointPlayerTest, FrozenItStaysWhereItIsWhateverComes) {
  player.on_trajectory(batch(true, {100, 100, 100}));
  take_sync(0);
  const std::int64_t stop_ns = slot_ns(0) + 4 * kMillisecond_ns;
  player.freeze(stop_ns);
  player.on_trajectory(batch(false));
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 2, .count = 400});
  take_sync(2);
  player.freeze(slot_ns(2));
  EXPECT_FALSE(player.move_to(7, 3, slot_ns(3)));
  run_alone(slot_ns(2), slot_ns(12));
  EXPECT_FALSE(player.running());
  EXPECT_DOUBLE_EQ(player.reference(slot_ns(12)).count, 40.0);
  EXPECT_EQ(player.reference(slot_ns(12)).rate_per_s, 0.0);
}

}  // namespace
}  // namespace gaitway::localcontroller
