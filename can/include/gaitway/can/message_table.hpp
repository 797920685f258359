// The one table of all messages (profile `full`): identifiers, sizes, periods, and where each field lies in
// its frame. Codecs, identification and the timeline of reports read it; so will response-time analysis and
// the .dbc file.
//
// Bits are numbered as in a .dbc file with little-endian signals: bit 8·b + i is bit i of byte b.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "gaitway/can/messages.hpp"

namespace gaitway::can {

// In order of priority: the lower, the more urgent.
enum class MessageKind : std::uint8_t {
  emergency_stop,
  user_command,
  sync,
  trim,
  feedback,
  fault_report,
  trajectory,
  resynchronisation,
  heartbeat
};
inline constexpr std::size_t kMessageKinds = 9;
inline constexpr NodeId kLargestNode = 64;

enum class Sender : std::uint8_t { message_controller, local_controller };

struct FieldSpec {
  std::string_view name;
  std::uint8_t first_bit = 0;
  std::uint8_t width = 0;  // bits, at most 32
  bool is_signed = false;
  std::string_view unit;
};

struct MessageSpec {
  MessageKind kind{};
  std::string_view name;
  std::uint16_t base_id = 0;
  std::uint8_t ids_per_node =
      0;                  // 0: one message for all nodes; 1: id = base + node; 2: base + 2·node + toggle
  std::uint8_t size = 0;  // data bytes
  std::int64_t period_ns = 0;  // 0: on event
  Sender sender = Sender::message_controller;
  std::span<const FieldSpec> fields;
};

namespace fields {
inline constexpr std::array<FieldSpec, 1> kEmergencyStop{{{"mode", 0, 8, false, ""}}};
inline constexpr std::array<FieldSpec, 3> kUserCommand{{{"node", 0, 8, false, ""},
                                                        {"target_count", 8, 16, true, "count"},
                                                        {"duration_slots", 24, 8, false, "10 ms"}}};
inline constexpr std::array<FieldSpec, 4> kSync{{{"cycle", 0, 16, false, "80 ms"},
                                                 {"slot", 16, 3, false, "10 ms"},
                                                 {"batch_committed", 19, 1, false, ""},
                                                 {"toggle", 20, 1, false, ""}}};
inline constexpr std::array<FieldSpec, 8> kTrim{{{"trim_0", 0, 8, true, "trim count"},
                                                 {"trim_1", 8, 8, true, "trim count"},
                                                 {"trim_2", 16, 8, true, "trim count"},
                                                 {"trim_3", 24, 8, true, "trim count"},
                                                 {"trim_4", 32, 8, true, "trim count"},
                                                 {"trim_5", 40, 8, true, "trim count"},
                                                 {"trim_6", 48, 8, true, "trim count"},
                                                 {"trim_7", 56, 8, true, "trim count"}}};
inline constexpr std::array<FieldSpec, 8> kFeedback{{{"position", 0, 16, true, "turn/65536"},
                                                     {"current", 16, 8, true, "N*m/8"},
                                                     {"reference_low", 24, 4, false, "count"},
                                                     {"executing_toggle", 28, 1, false, ""},
                                                     {"pending_toggle", 29, 1, false, ""},
                                                     {"state", 30, 2, false, ""},
                                                     {"channel_0", 32, 16, true, "network file"},
                                                     {"channel_1", 48, 16, true, "network file"}}};
inline constexpr std::array<FieldSpec, 1> kFaultReport{{{"faults", 0, 8, false, "bit mask"}}};
inline constexpr std::array<FieldSpec, 8> kTrajectory{{{"delta_0", 0, 8, true, "count"},
                                                       {"delta_1", 8, 8, true, "count"},
                                                       {"delta_2", 16, 8, true, "count"},
                                                       {"delta_3", 24, 8, true, "count"},
                                                       {"delta_4", 32, 8, true, "count"},
                                                       {"delta_5", 40, 8, true, "count"},
                                                       {"delta_6", 48, 8, true, "count"},
                                                       {"delta_7", 56, 8, true, "count"}}};
inline constexpr std::array<FieldSpec, 8> kResynchronisation{{{"count", 0, 16, true, "count"},
                                                              {"slot", 16, 3, false, "10 ms"},
                                                              {"toggle", 19, 1, false, ""},
                                                              {"delta_0", 24, 8, true, "count"},
                                                              {"delta_1", 32, 8, true, "count"},
                                                              {"delta_2", 40, 8, true, "count"},
                                                              {"delta_3", 48, 8, true, "count"},
                                                              {"delta_4", 56, 8, true, "count"}}};
inline constexpr std::array<FieldSpec, 2> kHeartbeat{
    {{"mode", 0, 8, false, ""}, {"cycle", 8, 32, false, "80 ms"}}};
}  // namespace fields

inline constexpr std::int64_t kSlotPeriod_ns = 10'000'000;
inline constexpr std::int64_t kCyclePeriod_ns = 80'000'000;

// Indexed by MessageKind. Identifiers leave room for 64 nodes each.
inline constexpr std::array<MessageSpec, kMessageKinds> kFullProfile{{
    {MessageKind::emergency_stop, "emergency stop", 0x001, 0, 1, 0, Sender::message_controller,
     fields::kEmergencyStop},
    {MessageKind::user_command, "user command", 0x002, 0, 4, 0, Sender::message_controller,
     fields::kUserCommand},
    {MessageKind::sync, "SYNC", 0x008, 0, 3, kSlotPeriod_ns, Sender::message_controller, fields::kSync},
    {MessageKind::trim, "trim", 0x010, 0, 8, kSlotPeriod_ns, Sender::message_controller, fields::kTrim},
    {MessageKind::feedback, "feedback", 0x040, 1, 8, kSlotPeriod_ns, Sender::local_controller,
     fields::kFeedback},
    {MessageKind::fault_report, "fault report", 0x0A0, 1, 1, 0, Sender::local_controller,
     fields::kFaultReport},
    {MessageKind::trajectory, "trajectory", 0x100, 2, 8, kCyclePeriod_ns, Sender::message_controller,
     fields::kTrajectory},
    {MessageKind::resynchronisation, "resynchronisation", 0x200, 1, 8, 0, Sender::message_controller,
     fields::kResynchronisation},
    {MessageKind::heartbeat, "heartbeat", 0x300, 0, 5, kCyclePeriod_ns, Sender::message_controller,
     fields::kHeartbeat},
}};

[[nodiscard]] constexpr const MessageSpec& spec(MessageKind kind) noexcept {
  return kFullProfile[static_cast<std::size_t>(kind)];
}

struct Identified {
  MessageKind kind{};
  NodeId node = 0;      // 0 for messages to all nodes
  bool toggle = false;  // of a trajectory frame
  friend bool operator==(const Identified&, const Identified&) = default;
};

// `node` 1..64 for messages of or to one node; 0 otherwise.
[[nodiscard]] constexpr std::uint16_t id_of(MessageKind kind, NodeId node = 0, bool toggle = false) noexcept {
  const MessageSpec& message = spec(kind);
  const unsigned offset =
      message.ids_per_node == 2 ? 2U * node + (toggle ? 1U : 0U) : message.ids_per_node * node;
  return static_cast<std::uint16_t>(message.base_id + offset);
}

// Nothing for an identifier that the profile does not use.
[[nodiscard]] constexpr std::optional<Identified> identify(std::uint16_t id) noexcept {
  for (const MessageSpec& message : kFullProfile) {
    if (message.ids_per_node == 0) {
      if (id == message.base_id) {
        return Identified{message.kind, 0, false};
      }
      continue;
    }
    const int offset = id - message.base_id;
    const int node = offset / message.ids_per_node;
    if (offset > 0 && node >= 1 && node <= kLargestNode) {
      return Identified{message.kind, static_cast<NodeId>(node),
                        message.ids_per_node == 2 && offset % 2 == 1};
    }
  }
  return std::nullopt;
}

}  // namespace gaitway::can
