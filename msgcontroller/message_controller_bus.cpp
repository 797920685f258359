// The message controller's side of the bus: what it sends, what it hears, and how it repairs what was lost.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kSlot_ns;
using facts::kSlotsPerCycle;

constexpr int kLastSlot = kSlotsPerCycle - 1;
// Feedback that has not come by then, its deadline, does not come any more in this slot.
constexpr std::int64_t kFeedbackInSlot_ns = 7 * facts::kMillisecond_ns;
// Longer than the longest frame with a station's time to react: nobody had anything more urgent to send.
constexpr std::int64_t kQuietBus_ns = 200'000;

}  // namespace

void MessageController::send(const can::Frame& frame, std::int64_t expires_ns) noexcept {
  if (watch_.bus_state() >= can::BusState::bus_off) {
    watch_.count(Incident::flushed);
  } else if (!queue_.push(frame, expires_ns)) {
    watch_.count(Incident::queue_full);
  }
}

void MessageController::on_bus_state(can::BusState state, can::ErrorCounters errors,
                                     std::int64_t now_ns) noexcept {
  const bool was_off = watch_.bus_state() >= can::BusState::bus_off;
  const bool is_off = state >= can::BusState::bus_off;
  watch_.on_bus_state(state, errors);
  if (is_off && !was_off) {
    watch_.count(Incident::flushed, 0, queue_.clear());
  }
  if (was_off && !is_off) {
    if (mode() == Mode::emergency_stop) {
      send_stop();
    } else if (profile_.has(can::MessageKind::sync)) {
      send_waiting();
    }
  }
  watch_.health().stamp_ns = now_ns;
}

// The slot's edge on the bus. Without a SYNC in the profile, the trajectory frames themselves start the
// batch.
void MessageController::send_sync(std::int64_t now_ns) noexcept {
  const Segment& running = playback_.running_segment();
  if (profile_.has(can::MessageKind::sync)) {
    send(can::encode(profile_, can::Sync{.cycle = static_cast<std::uint16_t>(state_.cycle),
                                         .slot = static_cast<std::uint8_t>(state_.slot),
                                         .batch_committed = running.active,
                                         .toggle = running.toggle,
                                         .softness = softness_}),
         now_ns + kSlot_ns);
  } else if (state_.slot == 0 && running.active) {
    send_running();
  }
  if (state_.slot == 0 && profile_.has(can::MessageKind::heartbeat)) {
    send(can::encode(profile_,
                     can::Heartbeat{.mode = static_cast<std::uint8_t>(state_.mode), .cycle = state_.cycle}),
         now_ns + facts::kCycle_ns);
  }
}

void MessageController::send_waiting() noexcept {
  for (int joint = 0; joint < joint_count_; ++joint) {
    send_waiting_trajectory(joint);
  }
}

void MessageController::send_running() noexcept {
  for (int joint = 0; joint < joint_count_; ++joint) {
    can::Trajectory frame{.node = node_[static_cast<std::size_t>(joint)],
                          .toggle = playback_.running_segment().toggle};
    for (int slot = 0; slot < kBatchPoints; ++slot) {
      frame.delta[static_cast<std::size_t>(slot)] =
          static_cast<std::int8_t>(playback_.running_delta(joint, slot));
    }
    if (frame.node != 0) {
      send(can::encode(profile_, frame), slot_start_ns_ + kSlot_ns);
    }
  }
}

// Of the batch, or revision, that has not started. After its start the frame would be of no use.
void MessageController::send_waiting_trajectory(int joint) noexcept {
  const can::NodeId node = node_[static_cast<std::size_t>(joint)];
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
  send(can::encode(profile_, frame), slot_start_ns_ + slots_left * kSlot_ns);
}

void MessageController::send_stop() noexcept {
  const can::StopMode mode = stop_is_soft_ ? can::StopMode::soft : can::StopMode::hold;
  stop_sent_in_slot_ = slots_since_start_;
  if (profile_.has(can::MessageKind::emergency_stop)) {
    send(can::encode(profile_, can::EmergencyStop{mode}));
  } else {
    send(can::encode(profile_, can::UserCommand{.node = 0, .target_count = static_cast<std::int16_t>(mode)}));
  }
}

bool MessageController::next_finds_quiet_bus(std::int64_t now_ns) const noexcept {
  if (!profile_.has(can::MessageKind::sync) || queue_.next_id() <= feedback_id_) {
    return true;
  }
  if (now_ns - slot_start_ns_ >= kFeedbackInSlot_ns) {
    return true;
  }
  return feedback_.complete() && now_ns - last_heard_ns_ >= kQuietBus_ns;
}

void MessageController::on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept {
  last_heard_ns_ = now_ns;
  const NetworkWatch::Arrival arrival = watch_.take(frame);
  switch (arrival.heard) {
    case NetworkWatch::Heard::feedback:
      take_feedback(arrival, now_ns);
      break;
    case NetworkWatch::Heard::forged:
      on_forged(arrival);
      break;
    case NetworkWatch::Heard::fault_report:  // a restart shows in the next feedback, too
    case NetworkWatch::Heard::nothing:
      break;
  }
}

void MessageController::take_feedback(const NetworkWatch::Arrival& arrival, std::int64_t now_ns) noexcept {
  const int joint = arrival.joint;
  feedback_.take(joint, arrival.feedback, now_ns);
  feedback_.joint_states().reference_position[static_cast<std::size_t>(joint)] =
      expected_count(joint) * count_rad_[static_cast<std::size_t>(joint)];
  if (mode() == Mode::emergency_stop) {
    supervise_stop(arrival.feedback);
  } else {
    supervise(joint, arrival);
    if (profile_.has(can::MessageKind::sync) && watch_.has_second_sender(joint)) {
      stop_safely();
    }
  }
  if (feedback_.complete() && !feedback_published_) {
    publish_feedback(now_ns);
  }
}

// Nobody can tell on a bus who sent a frame, but it was not this controller: the joints may do anything now.
// What they hold is put right, and the robot stops.
void MessageController::on_forged(const NetworkWatch::Arrival& arrival) noexcept {
  if (arrival.message.kind == can::MessageKind::emergency_stop) {
    set_mode(Mode::emergency_stop);
    send_stop();
    return;
  }
  if (arrival.message.kind == can::MessageKind::trajectory && arrival.joint >= 0 &&
      playback_.waiting_segment() != nullptr && mode() != Mode::emergency_stop &&
      profile_.has(can::MessageKind::sync)) {
    ++state_.repaired;
    send_waiting_trajectory(arrival.joint);
  }
  stop_safely();
}

// The safe tail plays from the next batch on.
void MessageController::stop_safely() noexcept {
  stop_requested_ = stop_requested_ || mode() == Mode::batches;
}

void MessageController::supervise_stop(const can::Feedback& feedback) noexcept {
  const bool stopped = feedback.state == can::JointState::soft || feedback.state == can::JointState::stopped;
  // What was measured before the stop arrived says nothing.
  if (!stopped && stop_sent_in_slot_ < slots_since_start_) {
    watch_.count(Incident::stop_repeated, feedback.node);
    send_stop();
  }
}

bool MessageController::plays_as_expected(int joint, const can::Feedback& feedback) const noexcept {
  const Segment& running = playback_.running_segment();
  const bool toggles = profile_.row(can::MessageKind::trajectory).rule == can::IdRule::per_node_and_toggle;
  const bool plays_batch = !running.active || (feedback.state == can::JointState::running &&
                                               (!toggles || feedback.executing_toggle == running.toggle));
  const auto expected_low =
      static_cast<std::uint8_t>(static_cast<std::uint32_t>(expected_count(joint)) & 0xFU);
  return plays_batch && feedback.reference_low == expected_low;
}

void MessageController::supervise(int joint, const NetworkWatch::Arrival& arrival) noexcept {
  const can::Feedback& feedback = arrival.feedback;
  const auto j = static_cast<std::size_t>(joint);
  // The batch or revision that comes next must have arrived by the feedback of the slot before it starts; if
  // not, it is sent once more. A segment of the safe tail is sent within the last slot, after the joints have
  // answered its SYNC.
  const bool synchronised = profile_.has(can::MessageKind::sync);
  const Segment* const waiting = playback_.waiting_segment();
  if (synchronised && waits_for_next_slot_ && waiting != nullptr &&
      feedback.pending_toggle != waiting->toggle) {
    watch_.count(Incident::trajectory_lost, feedback.node);
    ++state_.repaired;
    send_waiting_trajectory(joint);
  }
  if (resync_until_[j] > slots_since_start_) {
    return;  // a repair is on its way, or a manual movement is under way
  }
  if (!synchronised && playback_.slot() == 0) {
    return;  // it may have answered before its batch, which starts as it arrives, was there
  }
  if (!plays_as_expected(joint, feedback) || arrival.returned) {
    const bool never_came = playback_.slot() <= playback_.running_from() + 1 &&
                            playback_.running_segment().active &&
                            feedback.executing_toggle != playback_.running_segment().toggle;
    watch_.count(never_came ? Incident::trajectory_lost : Incident::count_differed, feedback.node);
    resynchronise(joint);
  } else if (playback_.running_segment().active && covered_until_[j] < kLastSlot) {
    resynchronise(joint);  // the points that the last repair had no room for
  }
}

void MessageController::resynchronise(int joint) noexcept {
  if (!profile_.has(can::MessageKind::resynchronisation)) {
    restart_points(joint);
    return;
  }
  const int effective_slot = playback_.slot() + 1;
  if (effective_slot > kLastSlot) {
    return;  // the next cycle's first feedback shows whether it is still needed
  }
  const auto j = static_cast<std::size_t>(joint);
  resync_until_[j] = slots_since_start_ + 1;
  covered_until_[j] = std::min(kLastSlot, effective_slot + can::kResyncDeltas);
  can::Resynchronisation frame{
      .node = node_[j],
      .toggle = playback_.segment_in(effective_slot).toggle,
      .slot = static_cast<std::uint8_t>(effective_slot),
      .count = static_cast<std::int16_t>(playback_.expected_count(joint, effective_slot))};
  for (int k = 0; k < can::kResyncDeltas && effective_slot + k < kLastSlot; ++k) {
    frame.delta[static_cast<std::size_t>(k)] =
        static_cast<std::int8_t>(playback_.expected_count(joint, effective_slot + k + 1) -
                                 playback_.expected_count(joint, effective_slot + k));
  }
  ++state_.resynchronised;
  send(can::encode(profile_, frame), slot_start_ns_ + kSlot_ns);
}

// Repair in a profile without absolute frames: a joint that did not get its batch stands where the batch
// began, so the rest of it is sent as a batch of its own, with what was missed spread over its points.
void MessageController::restart_points(int joint) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  if (!playback_.running_segment().active || playback_.slot() == kLastSlot) {
    return;
  }
  can::Trajectory frame{.node = node_[j], .toggle = playback_.running_segment().toggle};
  std::int32_t count = playback_.expected_count(joint, 0) - playback_.running_delta(joint, 0);
  for (int point = 0; point < kBatchPoints; ++point) {
    const int slot = std::min(playback_.slot() + 1 + point, kLastSlot);
    const std::int32_t change = std::clamp(playback_.expected_count(joint, slot) - count,
                                           -facts::kLargestByte_counts, facts::kLargestByte_counts);
    frame.delta[static_cast<std::size_t>(point)] = static_cast<std::int8_t>(change);
    count += change;
  }
  // It starts as it arrives, so each of its points comes up to a slot early.
  resync_until_[j] = slots_since_start_ + static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  ++state_.resynchronised;
  send(can::encode(profile_, frame), slot_start_ns_ + kSlot_ns);
}

}  // namespace gaitway::msgcontroller
