// The SocketCAN port in words: its states and counters by name, and the line that tells of a change.
#include "gaitway/can/socketcan_port.hpp"

#include <array>

namespace gaitway::can {

std::string_view name_of(BusState state) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"error-active", "error-passive", "bus-off", "down"};
  return kNames[static_cast<std::size_t>(state)];
}

std::vector<std::pair<std::string_view, std::uint64_t>> counters(const SocketCanStatistics& statistics) {
  return {{"accepted", statistics.accepted},
          {"sent", statistics.sent},
          {"unconfirmed", statistics.unconfirmed},
          {"lost", statistics.lost},
          {"flushed", statistics.flushed},
          {"failed", statistics.failed},
          {"late_echoes", statistics.late_echoes},
          {"refused_full", statistics.refused_full},
          {"refused_unusable", statistics.refused_unusable},
          {"refused_invalid", statistics.refused_invalid},
          {"kernel_buffer_full", statistics.kernel_buffer_full},
          {"received", statistics.received},
          {"fd_ignored", statistics.fd_ignored},
          {"dropped_by_kernel", statistics.dropped_by_kernel},
          {"receive_failed", statistics.receive_failed},
          {"without_stamp", statistics.without_stamp},
          {"hardware_stamps", statistics.hardware_stamps},
          {"error_frames", statistics.error_frames},
          {"error_passive", statistics.error_passive},
          {"bus_off", statistics.bus_off},
          {"recovered", statistics.recovered},
          {"restarts_requested", statistics.restarts_requested},
          {"restarts_refused", statistics.restarts_refused},
          {"interface_down", statistics.interface_down},
          {"interface_up", statistics.interface_up},
          {"rebound", statistics.rebound},
          {"no_acknowledge", statistics.no_acknowledge},
          {"arbitration_lost", statistics.arbitration_lost},
          {"protocol_violations", statistics.protocol_violations},
          {"transceiver_faults", statistics.transceiver_faults},
          {"transmit_timeouts", statistics.transmit_timeouts},
          {"controller_overflows", statistics.controller_overflows}};
}

std::string SocketCanReporter::news(const SocketCanPort& port) {
  if (port.state() != state_) {
    state_ = port.state();
    refused_before_ = port.statistics().restarts_refused;
    told_problem_ = false;
    return "CAN interface '" + port.interface() + "' is " + std::string(name_of(state_));
  }
  if (state_ == BusState::bus_off && !told_problem_ && port.statistics().restarts_refused > refused_before_) {
    told_problem_ = true;
    return port.restart_problem();
  }
  return {};
}

}  // namespace gaitway::can
