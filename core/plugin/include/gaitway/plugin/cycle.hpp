// What a plug-in and its manager are told at each tick, when the ticks are, and which of them prepares which
// batch.
#pragma once

#include <cstdint>

#include "gaitway/facts/facts.hpp"

namespace gaitway {

struct Tick {
  std::int64_t now_ns = 0;           // clock of the robot, virtual or real
  std::int64_t batch_start_ns = 0;   // when the batch that is being prepared will start to play
  std::uint32_t batch_sequence = 0;  // its cycle's number; between batches: of the next one to come
  std::uint32_t tick = 0;            // ticks of 10 ms since start
  bool batch = false;                // this tick prepares a batch (every eighth)

  friend bool operator==(const Tick&, const Tick&) = default;
};

// Every 10 ms, or only at ticks that prepare a batch.
enum class Period : std::uint32_t { tick = 0, batch = 1 };

namespace core {

// Tick k is at k * 10 ms + phase: by then the feedback of its slot has come in.
inline constexpr std::int64_t kTickPhase_ns = 4 * facts::kMillisecond_ns;
// The batch of cycle n is prepared at the tick of this slot of cycle n - 1: 16 ms before it plays.
inline constexpr std::uint32_t kBatchSlot = 6;

// Whether a tick is due exactly at `now_ns`.
constexpr bool is_tick(std::int64_t now_ns, std::int64_t phase_ns = kTickPhase_ns) noexcept {
  return now_ns >= phase_ns && (now_ns - phase_ns) % facts::kSlot_ns == 0;
}

// The tick of the slot in which `now_ns` lies; 0 <= now_ns.
constexpr Tick tick_at(std::int64_t now_ns) noexcept {
  const std::int64_t slots = now_ns / facts::kSlot_ns;
  const auto slot = static_cast<std::uint32_t>(slots % facts::kSlotsPerCycle);
  const auto cycle = static_cast<std::uint32_t>(slots / facts::kSlotsPerCycle);
  const std::uint32_t next_batch = slot <= kBatchSlot ? cycle + 1 : cycle + 2;
  return {.now_ns = now_ns,
          .batch_start_ns = std::int64_t{next_batch} * facts::kCycle_ns,
          .batch_sequence = next_batch,
          .tick = static_cast<std::uint32_t>(slots),
          .batch = slot == kBatchSlot};
}

// The first tick after `now_ns`.
constexpr std::int64_t next_tick_ns(std::int64_t now_ns, std::int64_t phase_ns = kTickPhase_ns) noexcept {
  const std::int64_t next = (now_ns - phase_ns) / facts::kSlot_ns + 1;
  return now_ns < phase_ns ? phase_ns : next * facts::kSlot_ns + phase_ns;
}

}  // namespace core
}  // namespace gaitway
