// How long a stop or an order waits at worst on a carrier that loses nothing, and with losses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "gaitway/link/i2c_bus.hpp"
#include "gaitway/link/link_settings.hpp"
#include "gaitway/link/messages.hpp"
#include "gaitway/link/order.hpp"
#include "gaitway/link/serial_carrier.hpp"

namespace gaitway::link {

// What a carrier does with the bytes of one direction.
struct CarrierTiming {
  std::int64_t byte_ns = 0;
  std::size_t buffer_bytes = 0;             // that it takes ahead; 0: what is written is there at once
  std::size_t transfer_bytes = 0;           // in one transfer; 0: there are no transfers
  std::int64_t transfer_ns = 0;             // what each adds to its bytes
  std::int64_t opposite_ns = 0;             // the longest transfer of the other direction
  std::int64_t transfers_per_opposite = 1;  // one of those after so many
};

[[nodiscard]] constexpr CarrierTiming unix_timing() noexcept {
  return {};
}
// Both directions have a wire of their own; ten bits a byte.
[[nodiscard]] constexpr CarrierTiming serial_timing(std::uint32_t baud) noexcept {
  return {.byte_ns = (10 * facts::kSecond_ns + baud - 1) / baud, .buffer_bytes = SerialCarrier::kMostQueued};
}
// From the module to the controller.
[[nodiscard]] constexpr CarrierTiming i2c_timing(const I2cSettings& settings) noexcept {
  return {.byte_ns = settings.byte_ns(),
          .buffer_bytes = settings.transfer_bytes,
          .transfer_bytes = settings.transfer_bytes,
          .transfer_ns = settings.transfer_ns(0),
          .opposite_ns = settings.transfer_ns(settings.transfer_bytes),
          .transfers_per_opposite = settings.writes_per_read};
}

// How often either end is pumped; 0: whenever the carrier has sent or brought something.
struct PumpPeriods {
  std::int64_t sender_ns = 0, receiver_ns = 0;
};

[[nodiscard]] constexpr std::int64_t ceil_ratio(std::size_t count, std::size_t by) noexcept {
  return static_cast<std::int64_t>((count + by - 1) / by);
}

// From the moment at which the first of `bytes` is offered to that at which the last one has been received.
//
//   sender_ns + bytes · byte_ns + T · transfer_ns + (1 + T / transfers_per_opposite) · opposite_ns
//   + F · max(0, sender_ns - buffer_bytes · byte_ns) + receiver_ns
//
// T = bytes / transfer_bytes + 1 transfers, the first of which may be a short one; F = bytes / buffer_bytes
// fillings of a buffer that may run empty before the next; ratios are rounded up.
[[nodiscard]] constexpr std::int64_t worst_transport_ns(const CarrierTiming& carrier, std::size_t bytes,
                                                        PumpPeriods periods) noexcept {
  std::int64_t wire_ns = static_cast<std::int64_t>(bytes) * carrier.byte_ns;
  if (carrier.transfer_bytes > 0) {
    const std::int64_t transfers = ceil_ratio(bytes, carrier.transfer_bytes) + 1;
    const std::int64_t opposites =
        1 + (transfers + carrier.transfers_per_opposite - 1) / carrier.transfers_per_opposite;
    wire_ns += transfers * carrier.transfer_ns + opposites * carrier.opposite_ns;
  }
  if (carrier.buffer_bytes > 0) {
    const std::int64_t empty_ns =
        periods.sender_ns - static_cast<std::int64_t>(carrier.buffer_bytes) * carrier.byte_ns;
    wire_ns += ceil_ratio(bytes, carrier.buffer_bytes) * std::max<std::int64_t>(0, empty_ns);
  }
  return periods.sender_ns + wire_ns + periods.receiver_ns;
}

// The largest frame that the module may have begun when something more urgent comes.
[[nodiscard]] constexpr std::size_t largest_module_frame_bytes(const LinkSettings& settings) noexcept {
  return kFramingBytes + std::max({kPartHeadBytes + settings.fragment_bytes, kStatusContentBytes,
                                   kStopContentBytes, kHelloContentBytes});
}

// Ahead of a stop are what the carrier holds and the rest of one frame.
[[nodiscard]] constexpr std::int64_t worst_stop_wait_ns(const CarrierTiming& carrier,
                                                        const LinkSettings& settings,
                                                        PumpPeriods periods = {}) noexcept {
  const std::size_t bytes =
      carrier.buffer_bytes + largest_module_frame_bytes(settings) + kStopContentBytes + kFramingBytes;
  return worst_transport_ns(carrier, bytes, periods);
}

// Ahead of an order of so many bytes, if no other order is under way, are also a stop, and a status for each
// of its parts.
[[nodiscard]] constexpr std::int64_t worst_order_wait_ns(const CarrierTiming& carrier,
                                                         const LinkSettings& settings,
                                                         std::size_t order_bytes,
                                                         PumpPeriods periods = {}) noexcept {
  const std::size_t message = kOrderHeadBytes + order_bytes;
  const std::size_t parts = fragments_of(message, settings.fragment_bytes);
  const std::size_t own = message + parts * (kPartHeadBytes + kFramingBytes);
  const std::size_t others =
      kStopContentBytes + kFramingBytes + parts * (kStatusContentBytes + kFramingBytes);
  return worst_transport_ns(
      carrier, carrier.buffer_bytes + largest_module_frame_bytes(settings) + others + own, periods);
}

// The same of one in a session that both ends know of, while no stop is under way either: then the module can
// have begun a status only, and another one may be due.
[[nodiscard]] constexpr std::int64_t worst_lone_order_wait_ns(const CarrierTiming& carrier,
                                                              const LinkSettings& settings,
                                                              std::size_t order_bytes,
                                                              PumpPeriods periods = {}) noexcept {
  constexpr std::size_t kStatusFrame = kStatusContentBytes + kFramingBytes;
  const std::size_t message = kOrderHeadBytes + order_bytes;
  const std::size_t parts = fragments_of(message, settings.fragment_bytes);
  const std::size_t own = message + parts * (kPartHeadBytes + kFramingBytes + kStatusFrame);
  return worst_transport_ns(carrier, carrier.buffer_bytes + kStatusFrame + own, periods);
}

// The same as worst_order_wait_ns() when `losses` sendings of it, or of what confirms them, are lost one
// after the other.
[[nodiscard]] constexpr std::int64_t worst_order_wait_with_losses_ns(const CarrierTiming& carrier,
                                                                     const LinkSettings& settings,
                                                                     std::size_t order_bytes, int losses,
                                                                     PumpPeriods periods = {}) noexcept {
  return (losses + 1) * worst_order_wait_ns(carrier, settings, order_bytes, periods) +
         losses * settings.resend_after_ns;
}
[[nodiscard]] constexpr std::int64_t worst_stop_wait_with_losses_ns(const CarrierTiming& carrier,
                                                                    const LinkSettings& settings, int losses,
                                                                    PumpPeriods periods = {}) noexcept {
  return (losses + 1) * worst_stop_wait_ns(carrier, settings, periods) + losses * settings.stop_repeat_ns;
}

}  // namespace gaitway::link
