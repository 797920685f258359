// Trajectory frames out, feedback in, repairs out.
#include "gaitway/msgcontroller/joint_supervision.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kSlot_ns;
using facts::kSlotsPerCycle;

constexpr int kLastSlot = kSlotsPerCycle - 1;
// A joint tells once in a cycle that it lacks a tail. Who tells so in the next cycle again has not been
// helped, and who does so three times gets no tail, it seems: none is named for a second then.
constexpr std::uint32_t kSlotsUntilRepairHelps = 2 * kSlotsPerCycle;
constexpr int kRepairsInVain = 3;
constexpr std::uint32_t kSlotsOfDistrust = 100;
// A joint gets its tails again no more often, whatever it tells and how often: else the queue has no room
// left for what everybody needs. Honest reports come a cycle apart.
constexpr std::uint32_t kSlotsBetweenRepairs = kSlotsPerCycle - 2;

}  // namespace

void JointSupervision::begin_cycle() noexcept {
  covered_until_.fill(kLastSlot);
  start_waiting_tail();
}

void JointSupervision::start_waiting_tail() noexcept {
  running_tail_ = waiting_tail_;
  waiting_tail_ = {.toggle = running_tail_.toggle};
}

void JointSupervision::enter_slot(int slot) noexcept {
  waits_for_next_slot_ = playback_.waiting_segment() != nullptr && slot == kLastSlot;
}

void JointSupervision::drop(can::MessageKind kind) noexcept {
  const can::Profile& profile = link_.profile;
  if (profile.has(kind)) {
    link_.queue.drop_identifiers(profile.row(kind).base_id, profile.last_id(kind));
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
  send_waiting_tail();
}

// As long as it can be of use: it may still be under way when its segment starts, and is named when it is
// whole.
void JointSupervision::send_waiting_tail() noexcept {
  if (!link_.profile.has(can::MessageKind::tail) || playback_.waiting_segment() == nullptr) {
    return;
  }
  forget_waiting_tail();
  const int points = playback_.points_to_both_feet(can::kBatchPoints * link_.profile.tail_parts).value_or(0);
  waiting_tail_ = {.toggle = running_tail_.toggle != (points > 0), .points = points};
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    for (int point = 0; point < points; ++point) {
      waiting_tail_.delta[static_cast<std::size_t>(joint)][static_cast<std::size_t>(point)] =
          static_cast<std::int8_t>(playback_.tail_delta(joint, point));
    }
  }
  const int slots_to_end = slots_to_end_of_waiting();
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    send_tail(joint, waiting_tail_, slots_to_end);
  }
}

int JointSupervision::slots_to_end_of_waiting() const noexcept {
  return 2 * kSlotsPerCycle - playback_.slot();
}

void JointSupervision::send_tail(int joint, SentTail& tail, int slots_to_end) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  if (link_.node[j] == 0) {
    return;
  }
  for (int first = 0; first < tail.points; first += can::kBatchPoints) {
    can::Tail frame{.node = link_.node[j],
                    .toggle = tail.toggle,
                    .part = static_cast<std::uint8_t>(first / can::kBatchPoints)};
    std::copy_n(tail.delta[j].begin() + first, frame.delta.size(), frame.delta.begin());
    ++tail.frames_left;
    link_.send(can::encode(link_.profile, frame), link_.slot_start_ns + slots_to_end * kSlot_ns);
  }
}

// The others keep what they have: SYNC goes on naming it while this joint gets its points again, which takes
// less than a slot. A step that one joint of them does not end is better than one that nobody ends.
void JointSupervision::repair_tails(int joint) noexcept {
  Lack& lack = lack_[static_cast<std::size_t>(joint)];
  const std::uint32_t now = link_.slots_since_start;
  if (lack.repaired != 0 && now - lack.repaired < kSlotsBetweenRepairs) {
    return;
  }
  lack.repaired = now;
  const int named_frames_left = running_tail_.frames_left;
  send_tail(joint, running_tail_, kSlotsPerCycle - playback_.slot());
  if (named_frames_left == 0) {
    running_tail_.frames_left = 0;
  }
  if (playback_.waiting_segment() != nullptr) {
    send_tail(joint, waiting_tail_, slots_to_end_of_waiting());
  }
}

void JointSupervision::on_tail_missing(int joint) noexcept {
  Lack& lack = lack_[static_cast<std::size_t>(joint)];
  const std::uint32_t slots = link_.slots_since_start - lack.told;
  const bool again = lack.told != 0 && slots < kSlotsBetweenRepairs;
  if (running_tail_.points == 0 || again) {
    return;
  }
  const bool not_helped = lack.told != 0 && slots <= kSlotsUntilRepairHelps;
  const bool still_distrusted = lack.in_a_row >= kRepairsInVain && slots <= 2 * kSlotsOfDistrust;
  lack.in_a_row = not_helped ? lack.in_a_row + 1 : still_distrusted ? lack.in_a_row : 1;
  lack.told = link_.slots_since_start;
  repair_tails(joint);
}

int JointSupervision::tail_points() const noexcept {
  const bool lacking = std::ranges::any_of(lack_, [this](const Lack& lack) {
    return lack.in_a_row >= kRepairsInVain && link_.slots_since_start - lack.told <= kSlotsOfDistrust;
  });
  return lacking ? 0 : running_tail_.usable_points();
}

void JointSupervision::on_tail_sent(bool toggle) noexcept {
  SentTail& tail = waiting_tail_.points > 0 && waiting_tail_.toggle == toggle ? waiting_tail_ : running_tail_;
  if (tail.toggle == toggle && tail.frames_left > 0) {
    --tail.frames_left;
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

// Of the batch that has not started. After its start the frame would be of no use.
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
  const int slots_left = kSlotsPerCycle - playback_.slot();
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
  // The batch that comes next must have arrived by the feedback of the slot before it starts; if not, it is
  // sent once more. A segment of the safe tail is sent within the last slot, after the joints have answered
  // its SYNC.
  const bool synchronised = link_.synchronised();
  const Segment* const waiting = playback_.waiting_segment();
  if (synchronised && waits_for_next_slot_ && waiting != nullptr &&
      feedback.pending_toggle != waiting->toggle) {
    link_.watch.count(Incident::trajectory_lost, feedback.node);
    repair_waiting(joint);
  }
  if (arrival.returned) {
    repair_tails(joint);
  }
  if (resync_until_[j] > link_.slots_since_start) {
    return;  // a repair is on its way, or a manual movement is under way
  }
  if (!synchronised && playback_.slot() == 0) {
    return;  // it may have answered before its batch, which starts as it arrives, was there
  }
  // One that was away may have come back as another, but when all were on their own nobody was away.
  const bool is_another = arrival.returned && !playback_.left_to_joints();
  if (!plays_as_expected(joint, feedback) || is_another) {
    const bool never_came = playback_.slot() <= 1 && playback_.running_segment().active &&
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
      .toggle = playback_.running_segment().toggle,
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
