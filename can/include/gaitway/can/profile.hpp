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

enum class IdRule : std::uint8_t {
  unused,              // the profile has no such message
  one,                 // one identifier: base_id
  per_node,            // base_id + node
  per_node_and_toggle  // base_id + 2·node + toggle
};

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
  NodeId node = 0;      // 0 for messages to all nodes
  bool toggle = false;  // of a trajectory frame
  friend bool operator==(const Identified&, const Identified&) = default;
};

struct Profile {
  std::string_view name;
  std::array<ProfileRow, kMessageKinds> rows{};  // indexed by MessageKind
  NodeId largest_node = kLargestNode;            // joints with larger nodes are not on the bus

  [[nodiscard]] constexpr const ProfileRow& row(MessageKind kind) const noexcept {
    return rows[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] constexpr bool has(MessageKind kind) const noexcept {
    return row(kind).rule != IdRule::unused;
  }
  // `node` 1..largest_node for messages of or to one node; 0 otherwise. Only for messages that it has.
  [[nodiscard]] constexpr std::uint32_t id_of(MessageKind kind, NodeId node = 0,
                                              bool toggle = false) const noexcept {
    const ProfileRow& message = row(kind);
    switch (message.rule) {
      case IdRule::per_node:
        return std::uint32_t{message.base_id} + node;
      case IdRule::per_node_and_toggle:
        return message.base_id + 2U * node + (toggle ? 1U : 0U);
      default:
        return message.base_id;
    }
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
          return Identified{kind, 0, false};
        }
        continue;
      }
      const bool toggles = message.rule == IdRule::per_node_and_toggle;
      const std::uint32_t node = toggles ? offset / 2 : offset;
      if (node >= 1 && node <= largest_node) {
        return Identified{kind, static_cast<NodeId>(node), toggles && offset % 2 == 1};
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
              {IdRule::one, 0x300, facts::kCycle_ns, false, facts::kCycle_ns}}},          // heartbeat
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
              {}}},                                                        // heartbeat
    .largest_node = 12};

}  // namespace gaitway::can
