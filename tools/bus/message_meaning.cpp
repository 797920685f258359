// The texts, in the order of the message table.
#include "tools/bus/network_description.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string>

#include "gaitway/msgcontroller/message_controller.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;
using msgcontroller::Mode;

template <class Enum>
constexpr NamedValue named(Enum value, std::string_view name, std::string_view meaning) {
  return {static_cast<std::int64_t>(value), name, meaning};
}

constexpr std::array<std::string_view, can::kMessageKinds> kMessages{
    "Every joint stops at once. Sent again until each joint's feedback says that it did.",
    "Manual joint command: one joint moves to an absolute count while the robot stands.",
    "The beat of the network, at every edge of a time slot. Batches start on it, joints answer it with their "
    "feedback, and it says how soft all servos are, and with how many points the joints can go on after the "
    "batch.",
    "Absolute corrections of up to eight joints, added to their references; slew-limited in the joint, and "
    "fading out when none comes for three time slots.",
    "One joint's position, torque, state and two sensor channels, in answer to each SYNC; its heartbeat, "
    "too.",
    "Sent when a fault begins and when it ends.",
    "One joint's batch: the changes of its reference count in the eight time slots of a cycle. The toggle "
    "bit in the identifier tells a new batch from a repeated frame.",
    "Repairs one joint: its absolute count at the end of a time slot, and the changes of the slots after it.",
    "The message controller's sign of life, once a cycle.",
    "Eight points for the time after one joint's batch, sent in advance: with them it ends the step by "
    "itself "
    "when no SYNC comes any more. They count once SYNC names the tail that they belong to."};

constexpr std::array kStopModes{
    named(can::StopMode::hold, "hold", "keeps its place"),
    named(can::StopMode::soft, "soft", "no torque any more"),
    named(can::StopMode::release, "release", "holds where it is, and takes batches again")};
constexpr std::array kJointStates{
    named(can::JointState::running, "running",
          "plays a batch or its tail, or holds compliantly because SYNC was lost"),
    named(can::JointState::holding, "holding", "has no batch to play and holds its last reference"),
    named(can::JointState::soft, "soft", "no torque, after an emergency stop"),
    named(can::JointState::stopped, "stopped", "holds after an emergency stop")};
constexpr std::array kFaults{
    named(can::Fault::position_limit, "position_limit", "the reference was kept within the joint's limits"),
    named(can::Fault::torque_saturated, "torque_saturated",
          "the servo has wanted more torque than there is for a while"),
    named(can::Fault::sync_lost, "sync_lost", "several SYNCs in a row did not come"),
    named(can::Fault::encoder, "encoder", "the encoder jumps further than the joint can move"),
    named(can::Fault::restarted, "restarted",
          "has started and stands where its encoder says, not where it was told"),
    named(can::Fault::tail_missing, "tail_missing",
          "SYNC names a tail of which it does not hold every point")};
constexpr std::array kModes{named(Mode::batches, "batches", "plays what the main controller hands over"),
                            named(Mode::safe_tail, "safe_tail",
                                  "brings the robot to a stand, since no new batch came or a stop was "
                                  "asked for"),
                            named(Mode::holding, "holding", "nothing to play: the robot stands"),
                            named(Mode::emergency_stop, "emergency_stop", "an emergency stop holds")};

struct FieldText {
  MessageKind kind;
  std::string_view field;  // a name that ends in _* stands for all that begin so
  std::string_view meaning;
  std::span<const NamedValue> values = {};
  bool mask = false;
};

constexpr FieldText kFields[]{
    {MessageKind::emergency_stop, "mode", "what the joints do", kStopModes},
    {MessageKind::user_command, "node",
     "the joint that moves; 0, in a profile without an emergency stop of its "
     "own: all stop at once, as the target says (0 hold, 1 soft, 2 release)"},
    {MessageKind::user_command, "target_count", "where the joint moves to, in its counts"},
    {MessageKind::user_command, "duration_slots", "over how many time slots it moves there"},
    {MessageKind::sync, "cycle", "low 16 bits of the cycle's number, which is its batch's sequence number"},
    {MessageKind::sync, "slot", "the time slot that begins, 0..7"},
    {MessageKind::sync, "batch_committed",
     "a batch is played in this cycle: whoever holds it starts it at slot 0"},
    {MessageKind::sync, "toggle", "toggle of the batch that is played"},
    {MessageKind::sync, "softness",
     "of all joints, in every slot and with or without a batch, for a fall: 0 the servos give their whole "
     "torque, 7 none; softer at once, stiffer in half a second"},
    {MessageKind::sync, "tail_points",
     "of a committed batch: time slots after it that the joints can go on without SYNC; 0: they hold where "
     "it "
     "ends"},
    {MessageKind::sync, "tail_toggle", "toggle of the tail that has these points"},
    {MessageKind::trim, "trim_*", "correction of the joint with this trim channel"},
    {MessageKind::feedback, "position", "measured angle"},
    {MessageKind::feedback, "current", "motor torque, rounded and saturating"},
    {MessageKind::feedback, "reference_low",
     "low four bits of the joint's own reference count at this slot's end: a lost or doubled trajectory "
     "frame "
     "shows here"},
    {MessageKind::feedback, "executing_toggle", "toggle of the batch that it plays, or played last"},
    {MessageKind::feedback, "pending_toggle", "toggle of the newest trajectory frame that it holds"},
    {MessageKind::feedback, "state", "what the joint does", kJointStates},
    {MessageKind::feedback, "channel_*", "a sensor of the network file, filtered over the slot"},
    {MessageKind::fault_report, "faults", "the faults that are present", kFaults, true},
    {MessageKind::trajectory, "delta_*", "change of the reference count in this time slot"},
    {MessageKind::resynchronisation, "count", "reference count at the end of the slot"},
    {MessageKind::resynchronisation, "slot", "the slot of the running cycle at whose SYNC it takes effect"},
    {MessageKind::resynchronisation, "toggle", "toggle of the batch that it belongs to"},
    {MessageKind::resynchronisation, "delta_*",
     "change of the reference count in the slots after it; zero past the batch's end"},
    {MessageKind::heartbeat, "mode", "what the message controller does", kModes},
    {MessageKind::heartbeat, "cycle", "the cycle's number"},
    {MessageKind::tail, "delta_*",
     "change of the reference count in this slot after the batch; zero past the tail's end"}};

const FieldText& text_of(MessageKind kind, std::string_view field) {
  const auto matches = [&](const FieldText& text) {
    const bool pattern = text.field.back() == '*';
    return text.kind == kind &&
           (pattern ? field.starts_with(text.field.substr(0, text.field.size() - 1)) : field == text.field);
  };
  const auto* const found = std::ranges::find_if(kFields, matches);
  if (found == std::end(kFields)) {
    throw std::logic_error("tools/message_meaning.cpp: the field '" + std::string(field) +
                           "' of the message '" + std::string(can::layout(kind).name) +
                           "' has no description. Add one");
  }
  return *found;
}

}  // namespace

std::string_view meaning_of(MessageKind kind) {
  return kMessages[static_cast<std::size_t>(kind)];
}

std::string_view meaning_of(MessageKind kind, std::string_view field) {
  return text_of(kind, field).meaning;
}

std::span<const NamedValue> values_of(MessageKind kind, std::string_view field) {
  return text_of(kind, field).values;
}

bool is_mask(MessageKind kind, std::string_view field) {
  return text_of(kind, field).mask;
}

}  // namespace gaitway::tools
