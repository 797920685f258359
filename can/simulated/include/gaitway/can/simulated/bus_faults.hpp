// What can go wrong on the simulated bus: what to inject, what was really injected, what the bus tells about
// it, and what happened on the bus in numbers.
#pragma once

#include <cstdint>
#include <limits>

#include "gaitway/can/simulated/bit_station.hpp"
#include "gaitway/can/simulated/station_set.hpp"

namespace gaitway::can {

// Drawn anew for each attempt to send a frame, in this order; an attempt meets at most one of them. The same
// seed and traffic take the same course.
struct RandomFaults {
  std::uint64_t seed = 1;
  // One bit of the frame (not its start of frame, nor the last bit of its end) is inverted for all stations.
  // Error frame and retransmission follow.
  double corruption = 0.0;
  // Some error-active receivers, but not all receivers, see an error in the last but one bit of end-of-frame:
  // they reject what the others have taken, the frame is repeated, and the others get it twice (Rufino,
  // Verissimo, Arroz, Almeida, Rodrigues 1998). Needs two receivers.
  double duplicate = 0.0;
  // Some receivers do not get the frame, and neither its sender nor they notice, as with a full receive
  // buffer or the double disturbance of Proenza and Miro-Julia 2000. Needs two receivers, unless `victims`
  // says who.
  double omission = 0.0;
  StationSet
      victims{};  // of omissions: those of them that receive; empty: some receivers at random, never all
};

enum class JamKind : std::uint8_t {
  noise,          // a frame on the wire breaks, and the stations wait for 11 recessive bits after it
  stuck_dominant  // the line is dominant: the stations count errors for as long as it lasts
};

// How often something was really done to the traffic, as opposed to asked for.
struct InjectedFaults {
  std::uint64_t corruptions = 0;  // frames with an inverted bit
  std::uint64_t duplicates = 0;   // frames that some receivers took and others rejected, to be repeated
  std::uint64_t omissions = 0;    // frames that at least one receiver did not get
  std::uint64_t omitted_receptions = 0;  // frames times receivers
  std::uint64_t jams = 0;
  std::uint64_t jammed_frames = 0;    // that a jam destroyed
  std::uint64_t babbled_frames = 0;   // sent by babbling stations
  std::uint64_t forced_failures = 0;  // frames destroyed to force a station off the bus
  std::uint64_t forced_bus_offs = 0;  // stations that this has brought to bus-off
  std::uint64_t power_offs = 0;
  std::uint64_t power_ons = 0;
  friend bool operator==(const InjectedFaults&, const InjectedFaults&) = default;
};

enum class FaultCause : std::uint8_t {
  corruption,
  duplicate,
  forced_bus_off,
  jam,
  collision,       // two stations sent one identifier with different content
  no_acknowledge,  // nobody else is there
  consequence      // of another fault: a sender lost its power, a passive station fell out of step
};

// An error that the stations signalled. When the frame was destroyed it comes again, unless its owner takes
// it back.
struct ErrorFrame {
  Frame frame;
  int sender = -1;            // the lowest station that sent it; -1: there was no frame
  int detected_by = 0;        // the lowest of the stations that saw the error first
  std::int64_t start_ns = 0;  // start of frame
  std::int64_t error_ns = 0;  // end of the bit in which the error was seen: the error flag begins
  int bit = 0;                // the number of this bit, start of frame being 0
  ErrorKind kind = ErrorKind::bit;
  FaultCause cause = FaultCause::corruption;
  ErrorCounters sender_counters;  // after the error
};

struct StateChange {
  int station = 0;
  BusState state = BusState::error_active;
  ErrorCounters counters;
  std::int64_t time_ns = 0;
};

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
