// A player of points, and the SYNCs and batches that tests give it.
#pragma once

#include <gtest/gtest.h>

#include "gaitway/facts/facts.hpp"
#include "gaitway/localcontroller/point_player.hpp"

namespace gaitway::localcontroller {

inline constexpr std::int32_t kLimit = 100'000;
using facts::kMillisecond_ns;
using facts::kSlot_ns;

class PointPlayerTest : public testing::Test {
 protected:
  static can::Trajectory batch(bool toggle, std::array<std::int8_t, 8> delta = {1, 2, 3, 4, 5, 6, 7, 8}) {
    return {.node = 3, .toggle = toggle, .delta = delta};
  }
  can::Sync sync(int slot, bool committed = true, bool toggle = true) const {
    return {.cycle = cycle,
            .slot = static_cast<std::uint8_t>(slot),
            .batch_committed = committed,
            .toggle = toggle};
  }
  std::int64_t slot_ns(int slot) const { return (std::int64_t{cycle} * 8 + slot) * kSlot_ns; }
  void take_sync(int slot, bool committed = true, bool toggle = true) {
    player.on_sync(sync(slot, committed, toggle), slot_ns(slot));
  }
  // Steps of a millisecond within (from, until).
  void run_alone(std::int64_t from_ns, std::int64_t until_ns) {
    for (std::int64_t now_ns = from_ns + kMillisecond_ns; now_ns < until_ns; now_ns += kMillisecond_ns) {
      player.advance_without_sync(now_ns);
    }
  }

  std::uint16_t cycle = 100;
  PointPlayer player{0, -kLimit, kLimit};
};

}  // namespace gaitway::localcontroller
