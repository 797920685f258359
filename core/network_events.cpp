// Names of the causes, and when they are told.
#include "gaitway/core/network_events.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gaitway::core {
namespace {

struct Cause {
  std::uint64_t NetworkHealth::*count;
  std::uint32_t incident;  // as in NetworkHealth::last_incident
  std::string_view text;
};

constexpr std::array<Cause, NetworkEvents::kCauses> kTold{{
    {&NetworkHealth::forged, 11,
     "frames of others that claim to come from the message controller: safe stop"},
    {&NetworkHealth::second_senders, 13, "time slots with two different feedback frames of one node"},
    {&NetworkHealth::bus_offs, 17, "times off the bus"},
    {&NetworkHealth::feedback_missing, 1, "nodes fell silent for two time slots"},
    {&NetworkHealth::nodes_restarted, 3, "nodes have restarted"},
    {&NetworkHealth::stops_repeated, 18, "emergency stops sent again, since a joint had not confirmed them"},
    {&NetworkHealth::unknown_identifiers, 6, "frames with an unknown identifier"},
    {&NetworkHealth::wrong_lengths, 7, "frames of a wrong length"},
    {&NetworkHealth::remote_frames, 8, "remote frames"},
    {&NetworkHealth::extended_frames, 9, "frames with an extended identifier"},
    {&NetworkHealth::undefined_values, 10, "frames with an undefined value"},
    {&NetworkHealth::expired, 14, "frames not sent before their transmit deadline"},
    {&NetworkHealth::flushed, 15, "frames dropped while the bus was off"},
    {&NetworkHealth::queue_full, 16, "frames for which the transmit queue had no room"},
    {&NetworkHealth::doubled, 12, "frames that came twice"},
}};

}  // namespace

std::size_t NetworkEvents::describe(std::size_t cause, const NetworkHealth& health,
                                    std::array<char, 160>& text) noexcept {
  const std::uint64_t count = health.*kTold[cause].count;
  if (count == 0 || count < next_[cause]) {
    return 0;
  }
  next_[cause] = 2 * count;
  const bool node_known = health.last_incident == kTold[cause].incident && health.last_incident_node != 0;
  const auto end = node_known ? fmt::format_to_n(text.data(), text.size(), "message network: {} {} (node {})",
                                                 count, kTold[cause].text, health.last_incident_node)
                              : fmt::format_to_n(text.data(), text.size(), "message network: {} {}", count,
                                                 kTold[cause].text);
  return std::min(end.size, text.size());
}

}  // namespace gaitway::core
