// Lays out a listener's figures in columns.
#include "tools/bus/bus_watch_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "gaitway/can/socketcan_port.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;

std::string range(const Spread& spread, int decimals) {
  return spread.count == 0 ? std::string("-")
                           : fmt::format("{:.{}f}..{:.{}f}", spread.min, decimals, spread.max, decimals);
}

std::string milliseconds_text(std::optional<std::int64_t> time_ns) {
  return time_ns ? fmt::format("{:.3f}", static_cast<double>(*time_ns) * 1e-6) : std::string("-");
}

std::string row(std::string_view name, std::string_view ids, std::string_view rate, std::string_view nominal,
                const MessageFigures& figures, std::string_view bound, std::string_view from) {
  return fmt::format(
      "{:<18}{:<15}{:>8}{:>9}{:>10}{:>11}{:>16}{:>10}{:>8}  {}\n", name, ids, figures.frames, rate, nominal,
      range(figures.length_us, 0), range(figures.interval_ms, 2),
      figures.response_ms.count == 0 ? std::string("-") : fmt::format("{:.3f}", figures.response_ms.max),
      bound, from);
}

std::string message_row(const BusWatch& watch, const BusWindow& window, const can::Proof& proof,
                        MessageKind kind) {
  const can::ProfileRow& message = watch.profile().row(kind);
  const bool one = message.rule == can::IdRule::one;
  const std::size_t nodes = one ? 1 : watch.nodes().size();
  const double nominal = static_cast<double>(nodes) * 1e9 / static_cast<double>(message.period_ns);
  std::string name(can::layout(kind).name);
  const bool beyond = std::ranges::count(beyond_bound(watch, proof), kind) != 0;
  return row(name, identifiers_of(watch.profile(), kind, nodes),
             fmt::format("{:.1f}", window.rate_per_s[static_cast<std::size_t>(kind)]),
             message.on_event ? std::string("event") : fmt::format("{:.1f}", nominal), watch.message(kind),
             milliseconds_text(proof.worst_response_ns(kind)),
             fmt::format("{}{}", watch.response_from(kind), beyond ? "  BEYOND ITS BOUND" : ""));
}

std::string identifier_rows(const BusWatch& watch, const BusWindow& window) {
  std::string text;
  for (const auto& [id, figures] : watch.identifiers()) {
    const can::Identified message = *watch.profile().identify(id);
    const std::string name = message.node == 0
                                 ? std::string(can::layout(message.kind).name)
                                 : fmt::format("{} {}", can::layout(message.kind).name, message.node);
    const double rate =
        window.seconds > 0.0 ? static_cast<double>(figures.frames_in_window) / window.seconds : 0.0;
    text += row(name, fmt::format("0x{:03X}", id), fmt::format("{:.1f}", rate), "", figures, "", "");
  }
  return text;
}

std::string node_line(const BusWatch& watch) {
  constexpr std::array<std::string_view, 4> kStates{"running", "holding", "soft", "stopped"};
  std::array<int, 4> in_state{};
  std::vector<int> faulty;
  for (const auto& [node, figures] : watch.nodes()) {
    in_state[static_cast<std::size_t>(figures.state)] += figures.feedbacks > 0 ? 1 : 0;
    if (figures.faults != 0) {
      faulty.push_back(node);
    }
  }
  const std::vector<can::NodeId> silent = watch.silent_nodes();
  std::string text =
      fmt::format("nodes     {} of {} answer", watch.nodes().size() - silent.size(), watch.nodes().size());
  for (std::size_t state = 0; state < kStates.size(); ++state) {
    if (in_state[state] > 0) {
      text += fmt::format(", {} {}", in_state[state], kStates[state]);
    }
  }
  if (!silent.empty()) {
    text += fmt::format("; silent: {}", fmt::join(silent, " "));
  }
  if (!faulty.empty()) {
    text += fmt::format("; report a fault: {}", fmt::join(faulty, " "));
  }
  return text + "\n";
}

std::string stranger_line(const BusWatch& watch) {
  std::string text =
      fmt::format("unknown   {} frames: identifier {}, size {}, extended {}, remote {}", watch.strangers(),
                  watch.strangers(Stranger::unknown_identifier), watch.strangers(Stranger::wrong_size),
                  watch.strangers(Stranger::extended), watch.strangers(Stranger::remote));
  if (const auto& last = watch.last_stranger()) {
    text += fmt::format("; last: {:0{}X}#{}", last->id, last->extended ? 8 : 3, last->remote ? "R" : "");
    for (const std::uint8_t byte : last->payload()) {
      text += fmt::format("{:02X}", byte);
    }
  }
  return text + "\n";
}

}  // namespace

std::string identifiers_of(const can::Profile& profile, MessageKind kind, std::size_t nodes) {
  const std::uint32_t first = profile.id_of(kind, profile.row(kind).rule == can::IdRule::one ? 0 : 1);
  if (profile.row(kind).rule == can::IdRule::one || nodes <= 1) {
    return fmt::format("0x{:03X}", first);
  }
  return fmt::format("0x{:03X}..0x{:03X}", first, profile.id_of(kind, static_cast<can::NodeId>(nodes), true));
}

std::vector<MessageKind> beyond_bound(const BusWatch& watch, const can::Proof& proof) {
  std::vector<MessageKind> kinds;
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    const auto bound_ns = proof.worst_response_ns(message.kind);
    const Spread& measured_ms = watch.message(message.kind).response_ms;
    // The bound counts the interframe space, a listener has the frame before it.
    if (bound_ns && measured_ms.count > 0 &&
        measured_ms.max + kInterframe_ms > static_cast<double>(*bound_ns) * 1e-6 + 1e-9) {
      kinds.push_back(message.kind);
    }
  }
  return kinds;
}

std::string bus_watch_text(const BusWatch& watch, const BusWindow& window, const can::Proof& proof,
                           const BusWatchView& view) {
  std::string text = fmt::format("{}  profile {}  t = {:.3f} s\n", view.source, watch.profile().name,
                                 static_cast<double>(watch.last_ns()) * 1e-9);
  text += fmt::format("load      {:.1f} % ({:.1f} % over {:.1f} s)   {:.0f} frames/s, {} frames in all\n",
                      100.0 * window.load, 100.0 * watch.load(), watch.seconds(), window.frames_per_s,
                      watch.frames());
  text += fmt::format("{:<18}{:<15}{:>8}{:>9}{:>10}{:>11}{:>16}{:>10}{:>8}  {}\n", "message", "identifiers",
                      "frames", "rate/s", "nominal", "length us", "interval ms", "worst ms", "bound",
                      "response from");
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    if (watch.profile().has(message.kind)) {
      text += message_row(watch, window, proof, message.kind);
    }
  }
  if (view.every_identifier) {
    text += identifier_rows(watch, window);
  }
  text += node_line(watch);
  text += stranger_line(watch);
  text += fmt::format("errors    {} reports", watch.error_reports());
  if (view.listener) {
    text += fmt::format("; this station is {}, TEC {}, REC {}", can::name_of(view.listener->state),
                        view.listener->errors.transmit, view.listener->errors.receive);
  }
  return text + "\n";
}

}  // namespace gaitway::tools
