// Trajectory frames out, feedback in, repairs out.
#include "gaitway/msgcontroller/joint_supervision.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kSlot_ns;
using facts::kSlotsPerCycle;

constexpr int kLastSlot = kSlotsPerCycle - 1;

}  // namespace

void JointSupervision::begin_cycle() noexcept {
  covered_until_.fill(kLastSlot);
}

void JointSupervision::enter_slot(int slot, bool revised) noexcept {
  if (revised) {
    covered_until_.fill(kLastSlot);
  }
  waits_for_next_slot_ = playback_.waiting_segment() != nullptr && playback_.waiting_from() == slot + 1;
}

void JointSupervision::drop(can::MessageKind kind) noexcept {
  const can::Profile& profile = link_.profile;
  if (profile.has(kind)) {
    link_.queue.drop_identifiers(profile.row(kind).base_id, profile.id_of(kind, profile.largest_node, true));
  }
}

void JointSupervision::leave_alone(int joint, std::uint32_t slots) noexcept {
  resync_until_[static_cast<std::size_t>(joint)] = link_.slots_since_start + slots;
}

void JointSupervision::set_counts() noexcept {
  resync_until_.fill(0);
  covered_until_.fill(kLastSlot);
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    if (link_.node[static_cast<std::size_t>(joint)] != 0) {
      resynchronise(joint);
    }
  }
}

void JointSupervision::repair_waiting(int joint) noexcept {
  ++link_.state.repaired;
  send_waiting_trajectory(joint);
}

void JointSupervision::send_waiting() noexcept {
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    send_waiting_trajectory(joint);
  }
}

void JointSupervision::send_running() noexcept {
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    can::Trajectory frame{.node = link_.node[static_cast<std::size_t>(joint)],
                          .toggle = playback_.running_segment().toggle};
    for (int slot = 0; slot < kBatchPoints; ++slot) {
      frame.delta[static_cast<std::size_t>(slot)] =
          static_cast<std::int8_t>(playback_.running_delta(joint, slot));
    }
    if (frame.node != 0) {
      link_.send(can::encode(link_.profile, frame), link_.slot_start_ns + kSlot_ns);
    }
  }
}

// Of the batch, or revision, that has not started. After its start the frame would be of no use.
void JointSupervision::send_waiting_trajectory(int joint) noexcept {
  const can::NodeId node = link_.node[static_cast<std::size_t>(joint)];
  const Segment* const waiting = playback_.waiting_segment();
  if (node == 0 || waiting == nullptr) {
    return;
  }
  can::Trajectory frame{.node = node, .toggle = waiting->toggle};
  for (int slot = 0; slot < kBatchPoints; ++slot) {
    frame.delta[static_cast<std::size_t>(slot)] =
        static_cast<std::int8_t>(playback_.waiting_delta(joint, slot));
  }
  const int slots_left = playback_.waiting_from() - playback_.slot();
  link_.send(can::encode(link_.profile, frame), link_.slot_start_ns + slots_left * kSlot_ns);
}

bool JointSupervision::plays_as_expected(int joint, const can::Feedback& feedback) const noexcept {
  const Segment& running = playback_.running_segment();
  const bool toggles =
      link_.profile.row(can::MessageKind::trajectory).rule == can::IdRule::per_node_and_toggle;
  const bool plays_batch = !running.active || (feedback.state == can::JointState::running &&
                                               (!toggles || feedback.executing_toggle == running.toggle));
  const auto expected_low =
      static_cast<std::uint8_t>(static_cast<std::uint32_t>(expected_count(joint)) & 0xFU);
  return plays_batch && feedback.reference_low == expected_low;
}

void JointSupervision::take_feedback(int joint, const NetworkWatch::Arrival& arrival) noexcept {
  const can::Feedback& feedback = arrival.feedback;
  const auto j = static_cast<std::size_t>(joint);
  // The batch or revision that comes next must have arrived by the feedback of the slot before it starts; if
  // not, it is sent once more. A segment of the safe tail is sent within the last slot, after the joints have
  // answered its SYNC.
  const bool synchronised = link_.synchronised();
  const Segment* const waiting = playback_.waiting_segment();
  if (synchronised && waits_for_next_slot_ && waiting != nullptr &&
      feedback.pending_toggle != waiting->toggle) {
    link_.watch.count(Incident::trajectory_lost, feedback.node);
    repair_waiting(joint);
  }
  if (resync_until_[j] > link_.slots_since_start) {
    return;  // a repair is on its way, or a manual movement is under way
  }
  if (!synchronised && playback_.slot() == 0) {
    return;  // it may have answered before its batch, which starts as it arrives, was there
  }
  if (!plays_as_expected(joint, feedback) || arrival.returned) {
    const bool never_came = playback_.slot() <= playback_.running_from() + 1 &&
                            playback_.running_segment().active &&
                            feedback.executing_toggle != playback_.running_segment().toggle;
    link_.watch.count(never_came ? Incident::trajectory_lost : Incident::count_differed, feedback.node);
    resynchronise(joint);
  } else if (playback_.running_segment().active && covered_until_[j] < kLastSlot) {
    resynchronise(joint);  // the points that the last repair had no room for
  }
}

void JointSupervision::resynchronise(int joint) noexcept {
  if (!link_.profile.has(can::MessageKind::resynchronisation)) {
    restart_points(joint);
    return;
  }
  const int effective_slot = playback_.slot() + 1;
  if (effective_slot > kLastSlot) {
    return;  // the next cycle's first feedback shows whether it is still needed
  }
  const auto j = static_cast<std::size_t>(joint);
  resync_until_[j] = link_.slots_since_start + 1;
  covered_until_[j] = std::min(kLastSlot, effective_slot + can::kResyncDeltas);
  can::Resynchronisation frame{
      .node = link_.node[j],
      .toggle = playback_.segment_in(effective_slot).toggle,
      .slot = static_cast<std::uint8_t>(effective_slot),
      .count = static_cast<std::int16_t>(playback_.expected_count(joint, effective_slot))};
  for (int k = 0; k < can::kResyncDeltas && effective_slot + k < kLastSlot; ++k) {
    frame.delta[static_cast<std::size_t>(k)] =
        static_cast<std::int8_t>(playback_.expected_count(joint, effective_slot + k + 1) -
                                 playback_.expected_count(joint, effective_slot + k));
  }
  ++link_.state.resynchronised;
  link_.send(can::encode(link_.profile, frame), link_.slot_start_ns + kSlot_ns);
}

// Repair in a profile without absolute frames: a joint that did not get its batch stands where the batch
// began, so the rest of it is sent as a batch of its own, with what was missed spread over its points.
void JointSupervision::restart_points(int joint) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  if (!playback_.running_segment().active || playback_.slot() == kLastSlot) {
    return;
  }
  can::Trajectory frame{.node = link_.node[j], .toggle = playback_.running_segment().toggle};
  std::int32_t count = playback_.expected_count(joint, 0) - playback_.running_delta(joint, 0);
  for (int point = 0; point < kBatchPoints; ++point) {
    const int slot = std::min(playback_.slot() + 1 + point, kLastSlot);
    const std::int32_t change = std::clamp(playback_.expected_count(joint, slot) - count,
                                           -facts::kLargestByte_counts, facts::kLargestByte_counts);
    frame.delta[static_cast<std::size_t>(point)] = static_cast<std::int8_t>(change);
    count += change;
  }
  // It starts as it arrives, so each of its points comes up to a slot early.
  resync_until_[j] = link_.slots_since_start + static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  ++link_.state.resynchronised;
  link_.send(can::encode(link_.profile, frame), link_.slot_start_ns + kSlot_ns);
}

}  // namespace gaitway::msgcontroller
