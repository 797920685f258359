// What each message holds, described once: size, sender, and where every field lies. Codecs, the .dbc file
// and docs/network.md follow this table; which identifier and period a message has is the profile's affair
// (profile.hpp). Freestanding.
//
// Bits are numbered as in a .dbc file with little-endian signals: bit 8·b + i is bit i of byte b.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "gaitway/can/messages.hpp"

namespace gaitway::can {

// In the full profile's order of priority: the lower, the more urgent.
enum class MessageKind : std::uint8_t {
  emergency_stop,
  user_command,
  sync,
  trim,
  feedback,
  fault_report,
  trajectory,
  resynchronisation,
  heartbeat,
  tail
};
inline constexpr std::size_t kMessageKinds = 10;

enum class Sender : std::uint8_t { message_controller, local_controller };

struct FieldSpec {
  std::string_view name;
  std::uint8_t first_bit = 0;
  std::uint8_t width = 0;  // bits, at most 32
  bool is_signed = false;
  std::string_view unit;
};

struct MessageLayout {
  MessageKind kind{};
  std::string_view name;
  std::uint8_t size = 0;  // data bytes
  Sender sender = Sender::message_controller;
  std::span<const FieldSpec> fields;
};

namespace fields {
inline constexpr std::array<FieldSpec, 1> kEmergencyStop{{{"mode", 0, 8, false, ""}}};
inline constexpr std::array<FieldSpec, 3> kUserCommand{{{"node", 0, 8, false, ""},
                                                        {"target_count", 8, 16, true, "count"},
                                                        {"duration_slots", 24, 8, false, "10 ms"}}};
inline constexpr std::array<FieldSpec, 7> kSync{{{"cycle", 0, 16, false, "80 ms"},
                                                 {"slot", 16, 3, false, "10 ms"},
                                                 {"batch_committed", 19, 1, false, ""},
                                                 {"toggle", 20, 1, false, ""},
                                                 {"softness", 21, 3, false, "1/7"},
                                                 {"tail_points", 24, 6, false, "10 ms"},
                                                 {"tail_toggle", 30, 1, false, ""}}};
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

// Indexed by MessageKind.
inline constexpr std::array<MessageLayout, kMessageKinds> kMessageLayouts{{
    {MessageKind::emergency_stop, "emergency stop", 1, Sender::message_controller, fields::kEmergencyStop},
    {MessageKind::user_command, "user command", 4, Sender::message_controller, fields::kUserCommand},
    {MessageKind::sync, "SYNC", 4, Sender::message_controller, fields::kSync},
    {MessageKind::trim, "trim", 8, Sender::message_controller, fields::kTrim},
    {MessageKind::feedback, "feedback", 8, Sender::local_controller, fields::kFeedback},
    {MessageKind::fault_report, "fault report", 1, Sender::local_controller, fields::kFaultReport},
    {MessageKind::trajectory, "trajectory", 8, Sender::message_controller, fields::kTrajectory},
    {MessageKind::resynchronisation, "resynchronisation", 8, Sender::message_controller,
     fields::kResynchronisation},
    {MessageKind::heartbeat, "heartbeat", 5, Sender::message_controller, fields::kHeartbeat},
    {MessageKind::tail, "tail", 8, Sender::message_controller, fields::kTrajectory},
}};

[[nodiscard]] constexpr const MessageLayout& layout(MessageKind kind) noexcept {
  return kMessageLayouts[static_cast<std::size_t>(kind)];
}

}  // namespace gaitway::can
