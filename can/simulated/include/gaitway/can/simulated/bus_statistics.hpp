// What happened on the simulated bus, in numbers.
#pragma once

#include <cstdint>
#include <limits>

#include "gaitway/can/simulated/bus_faults.hpp"

namespace gaitway::can {

// Lengths in microseconds, interframe space included.
struct LengthStatistics {
  std::uint64_t count = 0;
  double sum = 0.0;
  double min = std::numeric_limits<double>::infinity();
  double max = 0.0;
  [[nodiscard]] double mean() const noexcept { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
};

struct BusStatistics {
  std::uint64_t frames = 0;           // sent successfully, as their senders see it
  std::uint64_t lost = 0;             // of them: received by nobody
  std::uint64_t error_frames = 0;     // errors signalled, whatever their cause
  std::uint64_t retransmissions = 0;  // attempts to send a frame that an error had destroyed
  std::uint64_t collisions = 0;       // attempts in which stations sent one identifier with different content
  std::uint64_t merged = 0;           // frames that several stations sent at once, equal to the bit
  std::uint64_t unacknowledged = 0;   // attempts that failed since nobody else was there
  std::uint64_t bus_offs = 0;         // entries into bus-off
  std::uint64_t recoveries = 0;       // returns from it
  std::int64_t busy_ns = 0;           // frames, error frames, jams and the spaces between them
  LengthStatistics eight_byte_us;     // data frames with 8 bytes that were sent
  InjectedFaults injected;
  // Records that nobody fetched in time.
  std::uint64_t error_frames_dropped = 0;
  std::uint64_t state_changes_dropped = 0;
  [[nodiscard]] double load(std::int64_t elapsed_ns) const noexcept {
    return elapsed_ns > 0 ? static_cast<double>(busy_ns) / static_cast<double>(elapsed_ns) : 0.0;
  }
};

}  // namespace gaitway::can
