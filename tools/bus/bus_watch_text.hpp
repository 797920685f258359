// What a listener knows of the bus, as lines for the terminal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "tools/bus/bus_watch.hpp"

namespace gaitway::tools {

// The bus stays idle for so long after a frame, which counts to it in the analysis, not in what is measured.
inline constexpr double kInterframe_ms =
    can::kInterframeBits * 1e-6 * static_cast<double>(facts::kBitTime_ns);

// The listener's own station.
struct ListenerState {
  can::BusState state = can::BusState::error_active;
  can::ErrorCounters errors;
};

struct BusWatchView {
  std::string_view source;  // what is listened to
  bool every_identifier = false;
  std::optional<ListenerState> listener{};  // none for a log without reports about errors
};

// The messages whose worst measured response is longer than the proven one.
[[nodiscard]] std::vector<can::MessageKind> beyond_bound(const BusWatch& watch, const can::Proof& proof);

// Lines that each end with a line feed.
[[nodiscard]] std::string bus_watch_text(const BusWatch& watch, const BusWindow& window,
                                         const can::Proof& proof, const BusWatchView& view);

// "0x041..0x056", "0x101..0x12D", "0x008".
[[nodiscard]] std::string identifiers_of(const can::Profile& profile, can::MessageKind kind,
                                         std::size_t nodes);

}  // namespace gaitway::tools
