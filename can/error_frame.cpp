// Reads the kernel's CAN error frames: bits of linux/can/error.h, one by one.
#include "gaitway/can/socketcan_port.hpp"

#include <linux/can/error.h>

namespace gaitway::can {
namespace {

std::optional<BusState> state_of(std::uint32_t error_class, std::uint32_t controller) noexcept {
  if ((error_class & CAN_ERR_BUSOFF) != 0) {
    return BusState::bus_off;
  }
  if ((error_class & CAN_ERR_CRTL) != 0) {
    if ((controller & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0) {
      return BusState::error_passive;
    }
    if ((controller & (CAN_ERR_CRTL_ACTIVE | CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) != 0) {
      return BusState::error_active;
    }
  }
  if ((error_class & CAN_ERR_RESTARTED) != 0) {
    return BusState::error_active;
  }
  return std::nullopt;
}

}  // namespace

ErrorReport read_error_frame(std::uint32_t error_class, const std::array<std::uint8_t, 8>& data) noexcept {
  const std::uint32_t controller = (error_class & CAN_ERR_CRTL) != 0 ? data[1] : 0U;
  ErrorReport report;
  report.state = state_of(error_class, controller);
  // Drivers older than the flag put the counters there with every change of state, too.
  if ((error_class & CAN_ERR_CNT) != 0 ||
      ((error_class & CAN_ERR_CRTL) != 0 && (data[6] != 0 || data[7] != 0))) {
    report.counters = ErrorCounters{data[6], data[7]};
  }
  report.restarted = (error_class & CAN_ERR_RESTARTED) != 0;
  report.no_acknowledge = (error_class & CAN_ERR_ACK) != 0;
  report.lost_arbitration = (error_class & CAN_ERR_LOSTARB) != 0;
  report.protocol_violation = (error_class & (CAN_ERR_PROT | CAN_ERR_BUSERROR)) != 0;
  report.transceiver_fault = (error_class & CAN_ERR_TRX) != 0;
  report.transmit_timeout = (error_class & CAN_ERR_TX_TIMEOUT) != 0;
  report.receive_overflow = (controller & CAN_ERR_CRTL_RX_OVERFLOW) != 0;
  report.transmit_overflow = (controller & CAN_ERR_CRTL_TX_OVERFLOW) != 0;
  return report;
}

}  // namespace gaitway::can
