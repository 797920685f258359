// What a SocketCAN error frame tells: the kernel reports the state of the CAN controller and what went wrong
// on the bus in frames of their own (linux/can/error.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/can/bus_port.hpp"

namespace gaitway::can {

struct ErrorReport {
  std::optional<BusState> state;  // the controller's new state, if the frame tells of a change
  std::optional<ErrorCounters> counters;
  bool restarted = false;
  bool no_acknowledge = false;      // nobody else was there to acknowledge a frame
  bool lost_arbitration = false;    // to a more urgent frame: it is sent again
  bool protocol_violation = false;  // a bit, stuff, form or check sum error, of whatever sender
  bool transceiver_fault = false;   // as of a cut wire
  bool transmit_timeout = false;    // the driver gave up a frame
  bool receive_overflow = false;    // the controller had no room for a frame, which is lost
  bool transmit_overflow = false;   // the controller's transmit buffer was full
};

// `error_class`: the frame's identifier without its flags; `data`: its eight bytes.
[[nodiscard]] ErrorReport read_error_frame(std::uint32_t error_class,
                                           const std::array<std::uint8_t, 8>& data) noexcept;

}  // namespace gaitway::can
