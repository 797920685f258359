// The beat that everybody keeps: cycles of 80 ms with eight time slots of 10 ms. Cycle n starts at n * 80 ms.
#pragma once

#include <cstdint>

namespace gaitway::msgclient {

inline constexpr std::int64_t kMillisecond_ns = 1'000'000;
inline constexpr std::int64_t kSlot_ns = 10 * kMillisecond_ns;
inline constexpr int kSlotsPerCycle = 8;
inline constexpr std::int64_t kCycle_ns = kSlotsPerCycle * kSlot_ns;

}  // namespace gaitway::msgclient
