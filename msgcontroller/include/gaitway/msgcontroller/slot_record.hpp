// What was on the bus in one time slot, for those who look on: every 25th slot is recorded, so that the eight
// slots of a cycle have their turns. Nothing that the message controller does depends on it.
#pragma once

#include <cstdint>
#include <numeric>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

inline constexpr std::int64_t kSlotsBetweenRecords = 25;
static_assert(std::gcd(kSlotsBetweenRecords, facts::kSlotsPerCycle) == 1);

// How `BusSlot::id` says what an entry is (as SocketCAN does).
inline constexpr std::uint32_t kExtendedFrame = 1U << 31U;
inline constexpr std::uint32_t kRemoteFrame = 1U << 30U;
inline constexpr std::uint32_t kErrorOnTheBus = 1U << 29U;

// Neither allocates nor throws. In slots that are not recorded, a frame costs a comparison.
class SlotRecord {
 public:
  // A time slot begins. The one that has ended, if it was recorded; it holds until the next call.
  const BusSlot* enter_slot(std::int64_t edge_ns) noexcept;
  // A frame of another station, at its last bit.
  void take(const can::Frame& frame, std::int64_t end_ns) noexcept;
  // A frame of this station that was sent, or an error on the bus.
  void take(const can::BusNotice& notice) noexcept;

 private:
  void add(std::uint32_t id, std::int64_t end_ns, int bits) noexcept;

  bool records_ = false;
  BusSlot slot_{};
};

}  // namespace gaitway::msgcontroller
