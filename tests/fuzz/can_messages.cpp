// All decoders of the robot's CAN messages, in both profiles (can/messages.hpp). Whatever the frame:
// - at most the decoder of the message that the identifier belongs to takes it, and only a base data frame of
//   the message's own length,
// - what is taken has the frame's own field bits when it is encoded again, and decodes to the same message,
// - what any message is encoded into decodes to that message.
#include <bit>
#include <optional>
#include <span>

#include "fuzz_frame.hpp"
#include "gaitway/can/message_layout.hpp"

namespace gaitway::fuzz {
namespace {

using can::Frame;
using can::MessageKind;
using can::Profile;

std::uint64_t bits_of(const Frame& frame) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < frame.size; ++i) {
    bits |= std::uint64_t{frame.data[i]} << (8 * i);
  }
  return bits;
}

std::uint64_t field_bits(MessageKind kind) {
  std::uint64_t bits = 0;
  for (const can::FieldSpec& field : can::layout(kind).fields) {
    bits |= ((std::uint64_t{1} << field.width) - 1) << field.first_bit;
  }
  return bits;
}

// Returns whether the frame was taken.
template <class Message>
bool check_decoded(const Profile& profile, const Frame& frame, MessageKind kind,
                   std::optional<Message> (*decode)(const Profile&, const Frame&) noexcept) {
  const std::optional<Message> message = decode(profile, frame);
  if (!message) {
    return false;
  }
  const auto identified = profile.identify(frame.id);
  require(identified && identified->kind == kind, "only the identifier's own decoder takes a frame");
  require(!frame.extended && !frame.remote && frame.size == can::layout(kind).size,
          "only base data frames of the message's length are taken");
  const Frame again = can::encode(profile, *message);
  require(again.id == frame.id && again.size == frame.size, "the same identifier and length come back");
  require((bits_of(again) ^ (bits_of(frame) & field_bits(kind))) == 0, "the same field bits come back");
  require(decode(profile, again) == message, "what was encoded again is the same message");
  return true;
}

int count_takers(const Profile& profile, const Frame& frame) {
  int takers = 0;
  takers += check_decoded(profile, frame, MessageKind::emergency_stop, can::decode_emergency_stop);
  takers += check_decoded(profile, frame, MessageKind::user_command, can::decode_user_command);
  takers += check_decoded(profile, frame, MessageKind::sync, can::decode_sync);
  takers += check_decoded(profile, frame, MessageKind::trim, can::decode_trim);
  takers += check_decoded(profile, frame, MessageKind::feedback, can::decode_feedback);
  takers += check_decoded(profile, frame, MessageKind::fault_report, can::decode_fault_report);
  takers += check_decoded(profile, frame, MessageKind::trajectory, can::decode_trajectory);
  takers += check_decoded(profile, frame, MessageKind::resynchronisation, can::decode_resynchronisation);
  takers += check_decoded(profile, frame, MessageKind::heartbeat, can::decode_heartbeat);
  takers += check_decoded(profile, frame, MessageKind::tail, can::decode_tail);
  return takers;
}

template <class Message>
void check_encoded(const Profile& profile, MessageKind kind, const Message& message,
                   std::optional<Message> (*decode)(const Profile&, const Frame&) noexcept) {
  if (profile.has(kind)) {
    require(decode(profile, can::encode(profile, message)) == message, "a message survives its frame");
  }
}

template <class Array>
void fill(Array& values, Input& input) {
  for (auto& value : values) {
    value = input.take<std::remove_reference_t<decltype(value)>>();
  }
}

void check_messages_of_joints(const Profile& profile, can::NodeId node, Input& input) {
  can::Feedback feedback{.node = node, .position = input.take<std::int16_t>()};
  feedback.current = input.take<std::int8_t>();
  feedback.state = static_cast<can::JointState>(input.choose(4));
  feedback.pending_toggle = input.flag();
  feedback.executing_toggle = input.flag();
  feedback.reference_low = static_cast<std::uint8_t>(input.choose(16));
  fill(feedback.channel, input);
  check_encoded(profile, MessageKind::feedback, feedback, can::decode_feedback);
  check_encoded(profile, MessageKind::fault_report, can::FaultReport{node, input.take<std::uint8_t>()},
                can::decode_fault_report);
  // A profile without toggles has one identifier for both.
  const bool toggles = profile.row(MessageKind::trajectory).rule == can::IdRule::per_node_and_toggle;
  can::Trajectory trajectory{.node = node, .toggle = toggles && input.flag()};
  fill(trajectory.delta, input);
  check_encoded(profile, MessageKind::trajectory, trajectory, can::decode_trajectory);
  can::Resynchronisation repair{.node = node, .toggle = input.flag()};
  repair.slot = static_cast<std::uint8_t>(input.choose(8));
  repair.count = input.take<std::int16_t>();
  fill(repair.delta, input);
  check_encoded(profile, MessageKind::resynchronisation, repair, can::decode_resynchronisation);
  can::Tail tail{.node = node, .toggle = input.flag()};
  tail.part = static_cast<std::uint8_t>(input.choose(profile.tail_parts));
  fill(tail.delta, input);
  check_encoded(profile, MessageKind::tail, tail, can::decode_tail);
}

void check_messages(const Profile& profile, Input& input) {
  const auto node = static_cast<can::NodeId>(1 + input.choose(profile.largest_node));
  check_encoded(profile, MessageKind::emergency_stop,
                can::EmergencyStop{static_cast<can::StopMode>(input.choose(3))}, can::decode_emergency_stop);
  check_encoded(profile, MessageKind::user_command,
                can::UserCommand{node, input.take<std::int16_t>(), input.take<std::uint8_t>()},
                can::decode_user_command);
  can::Sync sync{.cycle = input.take<std::uint16_t>(), .slot = static_cast<std::uint8_t>(input.choose(8))};
  sync.batch_committed = input.flag();
  sync.toggle = input.flag();
  sync.tail_points = static_cast<std::uint8_t>(input.choose(can::kTailPoints + 1));
  sync.tail_toggle = input.flag();
  check_encoded(profile, MessageKind::sync, sync, can::decode_sync);
  can::Trim trim;
  fill(trim.count, input);
  check_encoded(profile, MessageKind::trim, trim, can::decode_trim);
  check_encoded(profile, MessageKind::heartbeat,
                can::Heartbeat{input.take<std::uint8_t>(), input.take<std::uint32_t>()},
                can::decode_heartbeat);
  check_messages_of_joints(profile, node, input);
}

}  // namespace

void can_messages(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const Profile& profile = take_profile(input);
  const Frame frame = take_frame(input);
  require(count_takers(profile, frame) <= 1, "a frame is one message");
  const auto node = static_cast<can::NodeId>(1 + input.choose(profile.largest_node));
  require(count_takers(profile, take_known_frame(input, profile, node)) <= 1, "a frame is one message");
  check_messages(profile, input);
}

}  // namespace gaitway::fuzz
