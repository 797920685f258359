// A batch that is revised while it plays: whichever SYNCs and frames are lost, the joint ends on the count of
// one of its versions, and its reference does not jump.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "point_player_fixture.hpp"

namespace gaitway::localcontroller {
namespace {

TEST_F(PointPlayerTest, ARevisionTakesTheBatchsPlaceFromItsSyncOn) {
  player.on_trajectory(batch(true));
  for (int slot = 0; slot < 3; ++slot) {
    take_sync(slot);
  }
  player.on_trajectory(batch(false, {1, 2, 3, 4, -5, -6, -7, -8}));
  take_sync(3);
  EXPECT_EQ(player.count(), 10);
  EXPECT_TRUE(player.executing_toggle()) << "nothing changes before a SYNC says so";
  EXPECT_FALSE(player.pending_toggle());
  take_sync(4, true, false);
  EXPECT_EQ(player.count(), 5);
  EXPECT_FALSE(player.executing_toggle());
  player.on_trajectory(batch(false, {9, 9, 9, 9, 9, 9, 9, 9}));  // a repetition, as it seems
  for (int slot = 5; slot < 8; ++slot) {
    take_sync(slot, true, false);
  }
  EXPECT_EQ(player.count(), 10 - 26);
  ++cycle;
  player.on_trajectory(batch(true));
  take_sync(0, true, true);
  EXPECT_EQ(player.count(), 10 - 26 + 1) << "the next batch has the other toggle";
}

// Whichever SYNCs are lost and however late the revision's frame comes: once a SYNC has named it to a joint
// that holds it, the joint is where the revised batch has it, and its reference has not jumped.
TEST_F(PointPlayerTest, AnyLossOfSyncsAroundARevisionEndsOnTheRevisedSum) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> delta(-60, 60), chance(0, 3), some_slot(2, 6);
  for (int trial = 0; trial < 2000; ++trial, cycle = static_cast<std::uint16_t>(cycle + 2)) {
    player = PointPlayer(0, -kLimit, kLimit);
    can::Trajectory first = batch(true), revised = batch(false);
    const int from = some_slot(random);
    for (int slot = 0; slot < 8; ++slot) {
      const auto s = static_cast<std::size_t>(slot);
      first.delta[s] = static_cast<std::int8_t>(delta(random));
      revised.delta[s] = slot < from ? first.delta[s] : static_cast<std::int8_t>(delta(random));
    }
    const int arrives = from - 1 + (chance(random) == 0 ? 1 : 0);
    player.on_trajectory(first);
    bool told = false;
    double before = 0.0;
    for (int slot = 0; slot < 8; ++slot) {
      if (slot == 0 || chance(random) > 0) {
        take_sync(slot, true, slot < from);
        told = told || (slot >= from && slot > arrives);
      }
      EXPECT_NEAR(player.reference(slot_ns(slot)).count, before, 1e-9) << "trial " << trial;
      if (slot == arrives) {
        player.on_trajectory(revised);
      }
      run_alone(slot_ns(slot), slot_ns(slot + 1));
      before = player.reference(slot_ns(slot + 1)).count;
    }
    run_alone(slot_ns(8) - kMillisecond_ns, slot_ns(8) + 3 * kMillisecond_ns);
    const can::Trajectory& played = told ? revised : first;
    EXPECT_EQ(player.count(), std::accumulate(played.delta.begin(), played.delta.end(), 0))
        << "trial " << trial << ", from slot " << from;
  }
}

TEST_F(PointPlayerTest, ARevisionFitsAJointThatWasRepaired) {
  take_sync(0);  // lost its frame
  player.on_resynchronisation({.node = 3, .toggle = true, .slot = 2, .count = 6, .delta = {4, 5, 6, 7, 8}});
  take_sync(1);
  take_sync(2);
  player.on_trajectory(batch(false, {1, 2, 3, 4, 50, 6, 7, 8}));
  take_sync(3);
  ASSERT_EQ(player.count(), 10);
  take_sync(5, true, false);  // that of slot 4 was lost
  EXPECT_EQ(player.count(), 10 + 50 + 6);
}

TEST_F(PointPlayerTest, ARevisionStartsNoBatch) {
  player.on_trajectory(batch(true));
  take_sync(0, false);
  take_sync(1, true, true);
  EXPECT_FALSE(player.running());
  EXPECT_EQ(player.count(), 0);
}

}  // namespace
}  // namespace gaitway::localcontroller
