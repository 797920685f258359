// A profile says which messages a robot's bus carries: the identifier of each (which is its priority), how
// often it may come, and by when it must have arrived. Scheduler, response-time analysis, codecs, the .dbc
// file and docs/network.md read it; both ends of the bus must have the same one. Freestanding.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "gaitway/can/message_layout.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {

inline constexpr NodeId kLargestNode = 64;
inline constexpr std::uint32_t kNodesAPart = std::uint32_t{kLargestNode} + 1;

enum class IdRule : std::uint8_t {
  unused,                   // the profile has no such message
  one,                      // one identifier: base_id
  per_node,                 // base_id + node
  per_node_and_toggle,      // base_id + 2·node + toggle
  per_part_node_and_toggle  // base_id + 2·((kLargestNode + 1)·part + node) + toggle, of the parts of a tail
};
[[nodiscard]] constexpr bool has_toggle(IdRule rule) noexcept {
  return rule == IdRule::per_node_and_toggle || rule == IdRule::per_part_node_and_toggle;
}

// One message of a profile.
struct ProfileRow {
  IdRule rule = IdRule::unused;
  std::uint16_t base_id = 0;
  // The shortest time between two frames of one identifier (of one node): senders keep it, and the analysis
  // counts on it.
  std::int64_t period_ns = 0;
  bool on_event = false;         // comes when something happens, not every period
  std::int64_t deadline_ns = 0;  // from the instant at which its sender wants to send it, to its arrival
};

struct Identified {
  MessageKind kind{};
  NodeId node = 0;        // 0 for messages to all nodes
  bool toggle = false;    // of a trajectory frame, or of a tail's
  std::uint8_t part = 0;  // of a tail
  friend bool operator==(const Identified&, const Identified&) = default;
};

struct Profile {
  std::string_view name;
  std::array<ProfileRow, kMessageKinds> rows{};  // indexed by MessageKind
  NodeId largest_node = kLargestNode;            // joints with larger nodes are not on the bus
  std::uint8_t tail_parts = 3;                   // of kTailParts: frames that a joint's tail has at most

  [[nodiscard]] constexpr const ProfileRow& row(MessageKind kind) const noexcept {
    return rows[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] constexpr bool has(MessageKind kind) const noexcept {
    return row(kind).rule != IdRule::unused;
  }
  // The same bus with so many parts of tails at most.
  [[nodiscard]] constexpr Profile with_tail_parts(int parts) const noexcept {
    Profile other = *this;
    other.tail_parts = static_cast<std::uint8_t>(parts);
    if (parts == 0) {
      other.rows[static_cast<std::size_t>(MessageKind::tail)] = {};
    }
    return other;
  }
  // How many messages of that kind each node has, each with identifiers of its own.
  [[nodiscard]] constexpr int parts(MessageKind kind) const noexcept {
    return row(kind).rule == IdRule::per_part_node_and_toggle ? int{tail_parts} : 1;
  }
  // `node` 1..largest_node for messages of or to one node; 0 otherwise. Only for messages that it has.
  [[nodiscard]] constexpr std::uint32_t id_of(MessageKind kind, NodeId node = 0, bool toggle = false,
                                              int part = 0) const noexcept {
    const ProfileRow& message = row(kind);
    switch (message.rule) {
      case IdRule::per_node:
        return std::uint32_t{message.base_id} + node;
      case IdRule::per_node_and_toggle:
        return message.base_id + 2U * node + (toggle ? 1U : 0U);
      case IdRule::per_part_node_and_toggle:
        return message.base_id + 2U * (kNodesAPart * static_cast<std::uint32_t>(part) + node) +
               (toggle ? 1U : 0U);
      default:
        return message.base_id;
    }
  }
  // The largest identifier of a message that it has.
  [[nodiscard]] constexpr std::uint32_t last_id(MessageKind kind) const noexcept {
    const IdRule rule = row(kind).rule;
    return id_of(kind, rule == IdRule::one ? NodeId{0} : largest_node, has_toggle(rule), parts(kind) - 1);
  }
  // Nothing for an identifier that the profile does not use.
  [[nodiscard]] constexpr std::optional<Identified> identify(std::uint32_t id) const noexcept {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const ProfileRow& message = rows[k];
      const auto kind = static_cast<MessageKind>(k);
      if (message.rule == IdRule::unused || id < message.base_id) {
        continue;
      }
      const std::uint32_t offset = id - message.base_id;
      if (message.rule == IdRule::one) {
        if (offset == 0) {
          return Identified{kind};
        }
        continue;
      }
      const bool toggles = has_toggle(message.rule);
      const std::uint32_t number = toggles ? offset / 2 : offset;
      const std::uint32_t part = message.rule == IdRule::per_part_node_and_toggle ? number / kNodesAPart : 0;
      const std::uint32_t node = number - part * kNodesAPart;
      if (node >= 1 && node <= largest_node && part < static_cast<std::uint32_t>(parts(kind))) {
        return Identified{kind, static_cast<NodeId>(node), toggles && offset % 2 == 1,
                          static_cast<std::uint8_t>(part)};
      }
    }
    return std::nullopt;
  }
};

// 22 joints and more (up to 64): the most urgent deadline first. Deadlines: a stop is there within 4 ms even
// on a disturbed bus; a batch that comes too late for its start is made up for within two time slots.
inline constexpr Profile kFullProfile{
    .name = "full",
    .rows = {{{IdRule::one, 0x001, 10'000'000, true, 4'000'000},                          // emergency stop
              {IdRule::one, 0x002, 10'000'000, true, 4'000'000},                          // user command
              {IdRule::one, 0x008, facts::kSlot_ns, false, 5'000'000},                    // SYNC
              {IdRule::one, 0x010, facts::kSlot_ns, false, 5'000'000},                    // trim
              {IdRule::per_node, 0x040, facts::kSlot_ns, false, 10'000'000},              // feedback
              {IdRule::per_node, 0x0A0, facts::kCycle_ns, true, 10'000'000},              // fault report
              {IdRule::per_node_and_toggle, 0x100, facts::kCycle_ns, false, 20'000'000},  // trajectory
              {IdRule::per_node, 0x200, facts::kSlot_ns, true, 3 * facts::kSlot_ns},      // resynchronisation
              {IdRule::one, 0x300, facts::kCycle_ns, false, facts::kCycle_ns},            // heartbeat
              {IdRule::per_part_node_and_toggle, 0x310, facts::kCycle_ns, false, facts::kCycle_ns}}},  // tail
    .largest_node = kLargestNode};

// The published robot's 25 messages and nothing else: trajectories 1..12, sensors 13..24, user command 25.
inline constexpr Profile kPaperProfile{
    .name = "paper",
    .rows = {{{},                                                          // emergency stop: a user command
              {IdRule::one, 25, 10'000'000, true, 10'000'000},             // user command
              {},                                                          // SYNC: batches start on arrival
              {},                                                          // trim
              {IdRule::per_node, 12, facts::kSlot_ns, false, 10'000'000},  // feedback
              {},                                                          // fault report
              {IdRule::per_node, 0, facts::kCycle_ns, false, 10'000'000},  // trajectory
              {},                                                          // resynchronisation
              {},                                                          // heartbeat
              {}}},                                                        // tail
    .largest_node = 12};

}  // namespace gaitway::can
