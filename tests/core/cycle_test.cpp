// Ticks and the batches that they prepare.
#include "gaitway/plugin/cycle.hpp"

#include <gtest/gtest.h>

namespace gaitway::core {
namespace {

constexpr std::int64_t kMs = facts::kMillisecond_ns;

TEST(Cycle, TicksAreFourMillisecondsAfterEachSlotsEdge) {
  EXPECT_FALSE(is_tick(0));
  EXPECT_TRUE(is_tick(4 * kMs));
  EXPECT_FALSE(is_tick(5 * kMs));
  EXPECT_TRUE(is_tick(1234 * kMs));
  EXPECT_EQ(next_tick_ns(0), 4 * kMs);
  EXPECT_EQ(next_tick_ns(4 * kMs), 14 * kMs);
  EXPECT_EQ(next_tick_ns(13 * kMs), 14 * kMs);
}

TEST(Cycle, BatchIsPreparedSixteenMillisecondsAhead) {
  const Tick tick = tick_at(64 * kMs);
  EXPECT_TRUE(tick.batch);
  EXPECT_EQ(tick.batch_sequence, 1U);
  EXPECT_EQ(tick.batch_start_ns, 80 * kMs);
  EXPECT_EQ(tick.batch_start_ns - tick.now_ns, 16 * kMs);
}

TEST(Cycle, OtherTicksNameTheNextBatchToCome) {
  for (std::uint32_t slot = 0; slot < 800; ++slot) {
    const Tick tick = tick_at(std::int64_t{slot} * facts::kSlot_ns + kTickPhase_ns);
    EXPECT_EQ(tick.tick, slot);
    EXPECT_EQ(tick.batch, slot % 8 == 6);
    EXPECT_EQ(tick.batch_sequence, (slot + 1) / 8 + 1);
    EXPECT_EQ(tick.batch_start_ns, std::int64_t{tick.batch_sequence} * 80 * kMs);
  }
}

}  // namespace
}  // namespace gaitway::core
