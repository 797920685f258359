// A CAN interface as the kernel's network configuration (rtnetlink) sees it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gaitway/can/bus_port.hpp"

namespace gaitway::can {

struct CanLink {
  std::string kind;                 // "can" for hardware, "vcan" and so on for what has no controller
  std::optional<BusState> state;    // of hardware
  std::uint32_t restart_ms = 0;     // after bus-off, by itself; 0: never
  std::uint32_t bitrate_per_s = 0;  // 0: it has none
  ErrorCounters counters;
};

// Nothing when the kernel does not answer.
std::optional<CanLink> read_link(int index);

// Starts the controller again after bus-off. Returns 0, or the kernel's refusal as an errno: EPERM without
// the right (CAP_NET_ADMIN), EINVAL where the kernel restarts it by itself, EBUSY where it is not bus-off,
// EOPNOTSUPP where the driver cannot. Waits for the kernel's lock of the network configuration, which another
// program may hold for a moment.
int restart_link(int index) noexcept;

}  // namespace gaitway::can
