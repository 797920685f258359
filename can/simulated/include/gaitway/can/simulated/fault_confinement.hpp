// The error counters of one station and the state that they put it in: fault confinement as of ISO 11898-1
// (rules a to h of the clause on error counting; the same as rules 1 to 12 of the Bosch specification 2.0).
#pragma once

#include <algorithm>

#include "gaitway/can/bus_port.hpp"

namespace gaitway::can {

class FaultConfinement {
 public:
  [[nodiscard]] BusState state() const noexcept {
    if (bus_off_) {
      return BusState::bus_off;
    }
    return counters_.transmit > kPassiveAbove || counters_.receive > kPassiveAbove ? BusState::error_passive
                                                                                   : BusState::error_active;
  }
  [[nodiscard]] const ErrorCounters& counters() const noexcept { return counters_; }
  [[nodiscard]] bool clean() const noexcept { return counters_ == ErrorCounters{}; }

  // Rule a: a receiver detects an error.
  void receiver_error() noexcept { raise_receive(1); }
  // Rule b: a receiver sees a dominant bit right after its error flag, so it was the first to detect.
  void first_to_detect() noexcept { raise_receive(8); }
  // Rule c: a transmitter sends an error flag.
  void transmitter_error() noexcept { raise_transmit(8); }
  // Rule f: eight more dominant bits after a flag.
  void dominant_too_long(bool transmitter) noexcept {
    if (transmitter) {
      raise_transmit(8);
    } else {
      raise_receive(8);
    }
  }
  // Rule g.
  void sent() noexcept { counters_.transmit = std::max(0, counters_.transmit - 1); }
  // Rule h: a passive receiver comes back to a value from 119 to 127. Here it is the highest of them.
  void received() noexcept { counters_.receive = std::clamp(counters_.receive - 1, 0, kPassiveAbove); }
  // Power-on, or bus-off is over.
  void reset() noexcept { *this = {}; }

 private:
  static constexpr int kPassiveAbove = 127;
  static constexpr int kBusOffAbove = 255;
  static constexpr int kLargestReceive = 255;  // the counter has 8 bits and the standard no use for more

  void raise_transmit(int by) noexcept {
    counters_.transmit += by;
    bus_off_ = bus_off_ || counters_.transmit > kBusOffAbove;
  }
  void raise_receive(int by) noexcept {
    counters_.receive = std::min(kLargestReceive, counters_.receive + by);
  }

  ErrorCounters counters_;
  bool bus_off_ = false;
};

}  // namespace gaitway::can
