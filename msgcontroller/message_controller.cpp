// Slot by slot: SYNC, batches, feedback, people's commands and the safe tail, each by the part that it
// belongs to.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kMillisecond_ns;
using facts::kSlot_ns;
using facts::kSlotsPerCycle;
using msgclient::Reason;

// Feedback that has not come by then is taken as missing for this slot; the main controller's tick follows.
constexpr std::int64_t kPublishInSlot_ns = 4 * kMillisecond_ns;
// Feedback that has not come by then, its deadline, does not come any more in this slot.
constexpr std::int64_t kFeedbackInSlot_ns = 7 * kMillisecond_ns;
// A tail has time. Jammed so near the slot's edge, its frame would still be there when all joints speak.
constexpr std::int64_t kTailBeforeEdge_ns = kJam_ns + 500'000;
// Longer than the longest frame with a station's time to react: nobody had anything more urgent to send.
constexpr std::int64_t kQuietBus_ns = 200'000;
// A leg whose joint has been silent for so long cannot be relied on: the robot stops.
constexpr std::uint32_t kSilentSlotsOfALeg = 10;

std::uint32_t least_urgent_feedback(const BusLink& link) {
  const can::NodeId last_node = link.node.empty() ? can::NodeId{0} : *std::ranges::max_element(link.node);
  return link.profile.id_of(can::MessageKind::feedback, last_node);
}

std::vector<std::int32_t> home_counts(const urdf::RobotModel& robot) {
  std::vector<std::int32_t> counts;
  counts.reserve(robot.joints.size());
  for (const urdf::Joint& joint : robot.joints) {
    counts.push_back(static_cast<std::int32_t>(std::lround(joint.home_rad / joint.count_rad)));
  }
  return counts;
}

}  // namespace

MessageController::MessageController(const urdf::RobotModel& robot, msgclient::Client& client,
                                     msgclient::EmiMessage& adapter)
    : link_(robot),
      playback_(home_counts(robot)),
      feedback_(robot, link_.node),
      emergency_stop_(link_),
      supervision_(link_, playback_),
      hand_(robot, link_, playback_, supervision_),
      intake_(robot, link_, playback_, supervision_, hand_, adapter),
      trims_(robot, link_),
      commands_(client, adapter),
      in_a_leg_(robot.joints.size(), false),
      feedback_id_(least_urgent_feedback(link_)),
      adapter_(adapter),
      joint_states_writer_(client.write<JointStates>("joint_states")),
      foot_forces_writer_(client.write<FootForces>("foot_forces")),
      imu_writer_(client.write<Imu>("imu")),
      state_writer_(client.write<NetworkState>("network_state")),
      health_writer_(client.write<NetworkHealth>("network_health")),
      slot_writer_(client.write<BusSlot>("bus_slot")),
      takeover_(robot, link_.node, home_counts(robot)) {
  for (const urdf::Leg& leg : robot.legs) {
    for (const int joint : leg.joints) {
      in_a_leg_[static_cast<std::size_t>(joint)] = true;
    }
  }
  state_writer_.publish(link_.state, 0);
  health_writer_.publish(link_.watch.health(), 0);
}

void MessageController::step(std::int64_t now_ns) noexcept {
  const std::int64_t in_slot_ns = now_ns % kSlot_ns;
  link_.watch.count(Incident::expired, 0, link_.queue.expire(now_ns));
  if (in_slot_ns == 0) {
    enter_slot(now_ns);
  } else if (last_slot_index_ >= 0) {
    pass_slots_until(now_ns / kSlot_ns);  // whose edge was missed: a SYNC that late would mislead the joints
  }
  commands_.take_mail(*this, now_ns);
  commands_.take_topics(*this, now_ns);
  take_plans(now_ns);
  if (now_ns % facts::kCycle_ns == facts::kCycle_ns - intake_.lead_ns()) {
    prepare_tail();
  }
  if (!feedback_published_ && in_slot_ns >= kPublishInSlot_ns) {
    publish_feedback(now_ns);
  }
  trims_.stand_in(in_slot_ns, feedback_published_, feedback_, playback_.support());
}

void MessageController::enter_slot(std::int64_t now_ns) noexcept {
  const std::int64_t slot_index = now_ns / kSlot_ns;
  if (!feedback_published_) {
    publish_feedback(now_ns);
  }
  if (const BusSlot* const seen = slot_record_.enter_slot(now_ns)) {
    slot_writer_.publish(*seen, now_ns);
  }
  pass_slots_until(slot_index);
  link_.state.stamp_ns = now_ns;
  follow_release(now_ns);
  recount();
  send_sync(now_ns);
  hand_.enter_slot();
  ++link_.slots_since_start;
  link_.watch.begin_slot(link_.slots_since_start);
  feedback_.begin_slot(link_.slots_since_start);
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    if (in_a_leg_[static_cast<std::size_t>(joint)] && link_.watch.silent_slots(joint) == kSilentSlotsOfALeg) {
      stop_safely();
    }
  }
  feedback_published_ = false;
  trims_.begin_slot();
  state_writer_.publish(link_.state, now_ns);
  link_.watch.health().stamp_ns = now_ns;
  health_writer_.publish(link_.watch.health(), now_ns);
}

void MessageController::begin_cycle() noexcept {
  const bool was_tail = mode() == Mode::safe_tail;
  const bool was_running = playback_.running_segment().active;
  supervision_.begin_cycle();
  playback_.begin_cycle();
  if (mode() == Mode::emergency_stop) {
    return;
  }
  // With nothing to follow their batch the joints go along its tail, whether this SYNC comes or not.
  if (was_running && !playback_.running_segment().active && named_tail_points_ > 0) {
    leave_to_joints();
  }
  if (stop_requested_) {
    prepare_tail();  // as early as can be
  }
  if (playback_.left_to_joints() || (playback_.tail_left() && !sync_gets_out())) {
    link_.set_mode(Mode::safe_tail);  // what is left of it follows when the joints are heard of again
  } else if (!playback_.running_segment().active) {
    link_.set_mode(Mode::holding);
    stop_requested_ = false;
  } else if (!was_tail && !stop_requested_) {
    link_.set_mode(Mode::batches);
  }
}

// The slot's edge on the bus. Without a SYNC in the profile, the trajectory frames themselves start the
// batch.
void MessageController::send_sync(std::int64_t now_ns) noexcept {
  const Segment& running = playback_.running_segment();
  const NetworkState& state = link_.state;
  const bool plays = running.active && mode() != Mode::emergency_stop;
  const int tail_points = plays ? supervision_.tail_points() : 0;
  link_.state.tail_points = static_cast<std::uint32_t>(tail_points);
  if (link_.synchronised()) {
    link_.send(can::encode(link_.profile, can::Sync{.cycle = static_cast<std::uint16_t>(state.cycle),
                                                    .slot = static_cast<std::uint8_t>(state.slot),
                                                    .batch_committed = plays,
                                                    .toggle = running.toggle,
                                                    .softness = trims_.softness(),
                                                    .tail_points = static_cast<std::uint8_t>(tail_points),
                                                    .tail_toggle = supervision_.tail_toggle()}),
               now_ns + kSlot_ns);
  } else if (state.slot == 0 && plays) {
    supervision_.send_running();
  }
  if (state.slot == 0 && link_.profile.has(can::MessageKind::heartbeat)) {
    link_.send(can::encode(link_.profile, can::Heartbeat{.mode = static_cast<std::uint8_t>(state.mode),
                                                         .cycle = state.cycle}),
               now_ns + facts::kCycle_ns);
  }
}

void MessageController::on_bus_state(can::BusState state, can::ErrorCounters errors,
                                     std::int64_t now_ns) noexcept {
  const bool was_off = link_.off_the_bus();
  link_.watch.on_bus_state(state, errors);
  const bool is_off = link_.off_the_bus();
  if (is_off && !was_off) {
    link_.watch.count(Incident::flushed, 0, link_.queue.clear());
  }
  if (was_off && !is_off) {
    if (mode() == Mode::emergency_stop) {
      emergency_stop_.repeat();
    } else if (link_.synchronised()) {
      supervision_.send_waiting();
    }
  }
  link_.watch.health().stamp_ns = now_ns;
}

bool MessageController::next_finds_quiet_bus(std::int64_t now_ns) const noexcept {
  if (!link_.synchronised() || link_.queue.next_id() <= feedback_id_) {
    return true;
  }
  const std::int64_t in_slot_ns = now_ns - link_.slot_start_ns;
  const can::Profile& profile = link_.profile;
  const bool is_tail = profile.has(can::MessageKind::tail) &&
                       link_.queue.next_id() >= profile.row(can::MessageKind::tail).base_id &&
                       link_.queue.next_id() <= profile.last_id(can::MessageKind::tail);
  if (is_tail && in_slot_ns > kSlot_ns - kTailBeforeEdge_ns) {
    return false;
  }
  if (in_slot_ns >= kFeedbackInSlot_ns) {
    return true;
  }
  return feedback_.complete() && now_ns - last_heard_ns_ >= kQuietBus_ns;
}

void MessageController::on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept {
  last_heard_ns_ = now_ns;
  slot_record_.take(frame, now_ns);
  const NetworkWatch::Arrival arrival = link_.watch.take(frame);
  switch (arrival.heard) {
    case NetworkWatch::Heard::feedback:
      take_feedback(arrival, now_ns);
      break;
    case NetworkWatch::Heard::forged:
      on_forged(arrival, frame);
      break;
    case NetworkWatch::Heard::fault_report:
      take_fault_report(arrival);
      break;
    case NetworkWatch::Heard::nothing:
      break;
  }
}

void MessageController::take_feedback(const NetworkWatch::Arrival& arrival, std::int64_t now_ns) noexcept {
  const int joint = arrival.joint;
  const auto j = static_cast<std::size_t>(joint);
  const bool soft = arrival.feedback.state == can::JointState::soft;
  const bool stopped = soft || arrival.feedback.state == can::JointState::stopped;
  if (stopped && mode() == Mode::holding && link_.state.accepted_sequence == 0) {
    emergency_stop(soft);  // the joints were stopped before this controller started
    takeover_.give_up();
  }
  feedback_.take(joint, arrival.feedback, now_ns);
  feedback_.joint_states().reference_position[j] = expected_count(joint) * link_.count_rad[j];
  if (mode() == Mode::emergency_stop) {
    emergency_stop_.supervise(joint, arrival.feedback, feedback_.joint_states().position[j]);
  } else if (!joints_known()) {
    takeover_.take(joint, arrival.feedback, feedback_.joint_states().position[j]);
  } else if (!takeover_.knows(joint) && !playback_.running_segment().active && !playback_.prepared()) {
    takeover_.take(joint, arrival.feedback, feedback_.joint_states().position[j]);
    if (takeover_.knows(joint)) {
      playback_.hold(joint, takeover_.counts()[j]);
    }
  } else {
    supervision_.take_feedback(joint, arrival);
    if (link_.synchronised() && link_.watch.has_second_sender(joint)) {
      stop_safely();
    }
  }
  if (feedback_.complete() && !feedback_published_) {
    publish_feedback(now_ns);
  }
}

// A restart shows in the next feedback, too; but the joint has no tail any more.
void MessageController::take_fault_report(const NetworkWatch::Arrival& arrival) noexcept {
  if ((arrival.faults & static_cast<std::uint8_t>(can::Fault::tail_missing)) != 0) {
    supervision_.on_tail_missing(arrival.joint);
  } else if ((arrival.faults & static_cast<std::uint8_t>(can::Fault::restarted)) != 0) {
    supervision_.repair_tails(arrival.joint);
  }
}

// Nobody can tell on a bus who sent a frame, but it was not this controller: the joints may do anything now.
// What they hold is put right, and the robot stops.
void MessageController::on_forged(const NetworkWatch::Arrival& arrival, const can::Frame& frame) noexcept {
  // A profile without a message of its own for an emergency stop has a user command to all nodes instead.
  const auto command = can::decode_user_command(link_.profile, frame);
  if (arrival.message.kind == can::MessageKind::emergency_stop || (command && command->node == 0)) {
    if (emergency_stop_.holds()) {
      emergency_stop_.repeat();
    } else {
      emergency_stop(false);
    }
    return;
  }
  if (arrival.message.kind == can::MessageKind::trajectory && arrival.joint >= 0 &&
      playback_.waiting_segment() != nullptr && mode() != Mode::emergency_stop && link_.synchronised()) {
    supervision_.repair_waiting(arrival.joint);
  }
  stop_safely();
}

void MessageController::publish_feedback(std::int64_t now_ns) noexcept {
  if (!joints_known() && takeover_.end_slot()) {
    take_over();
  }
  if (!joints_known() && takeover_.anything_heard()) {
    feedback_published_ = true;  // nobody is to plan from what is not known
    return;
  }
  feedback_.joint_states().missing = feedback_.missing();
  joint_states_writer_.publish(feedback_.joint_states(), now_ns);
  foot_forces_writer_.publish(feedback_.foot_forces(), now_ns);
  imu_writer_.publish(feedback_.imu(), now_ns);
  feedback_published_ = true;
}

void MessageController::take_mails(std::int64_t now_ns) noexcept {
  commands_.take_mail(*this, now_ns);
  take_plans(now_ns);
}

void MessageController::take_plans(std::int64_t now_ns) noexcept {
  const bool on_their_own =
      playback_.left_to_joints() || !joints_known() || !sync_gets_out() || counts_first();
  if (const msgclient::TrimGains* const gains = intake_.take(now_ns, stop_requested_, on_their_own)) {
    trims_.set_gains(*gains);
  }
  msgclient::TrimUpdate update;
  if (adapter_.take_trim(update, now_ns) == msgclient::TakeStatus::mail && mode() != Mode::emergency_stop &&
      joints_known()) {
    trims_.take(update);
  }
}

Reason MessageController::obey(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept {
  using Kind = msgclient::UserCommandKind;
  switch (mail.kind) {
    case Kind::stop:
      stop_early(now_ns);
      return Reason::none;
    case Kind::emergency_stop_hold:
    case Kind::emergency_stop_soft:
      emergency_stop(mail.kind == Kind::emergency_stop_soft);
      return Reason::none;
    case Kind::manual_joint:
      return hand_.move(mail, now_ns);
    case Kind::release:
      return emergency_stop_.release();
  }
  return Reason::unknown_command;
}

void MessageController::emergency_stop(bool soft) noexcept {
  ++link_.state.stops;
  hand_.stop();
  // A joint that is released soon would play them.
  supervision_.drop_waiting();
  supervision_.forget_tails();
  named_tail_points_ = 0;
  recount_waits_ = false;
  supervision_.drop(can::MessageKind::resynchronisation);
  if (link_.profile.has(can::MessageKind::emergency_stop)) {  // else a user command is the stop itself
    supervision_.drop(can::MessageKind::user_command);
  }
  emergency_stop_.stop(soft);
}

// Whoever asked for a release is answered when every joint has confirmed it, or when it has failed.
void MessageController::follow_release(std::int64_t now_ns) noexcept {
  const bool last_slot = link_.state.slot == kSlotsPerCycle - 1;
  if (last_slot && mode() == Mode::emergency_stop) {
    return;  // in it no joint can be given its count
  }
  const EmergencyStop::Outcome outcome = emergency_stop_.take_outcome();
  if (outcome == EmergencyStop::Outcome::none) {
    return;
  }
  const bool released = outcome == EmergencyStop::Outcome::released;
  if (released) {
    start_from_measured();
  }
  commands_.answer_release(released ? Reason::none : Reason::emergency_stopped, now_ns);
}

// As at the start, but where the joints are: nothing of before the stop is played on.
void MessageController::start_from_measured() noexcept {
  JointStates& states = feedback_.joint_states();
  std::array<std::int32_t, kMaxJoints> counts{};
  for (std::size_t j = 0; j < link_.node.size(); ++j) {
    const int joint = static_cast<int>(j);
    counts[j] = link_.node[j] == 0 ? expected_count(joint) : emergency_stop_.released_count(joint);
    states.reference_position[j] = counts[j] * link_.count_rad[j];
  }
  playback_.restart(std::span(counts).first(link_.node.size()));
  supervision_.set_counts();
  hand_.forget();
  trims_.forget();
  stop_requested_ = false;
  link_.set_mode(Mode::holding);
}

// Where the joints have come to rest.
void MessageController::take_over() noexcept {
  playback_.restart(takeover_.counts());
  for (std::size_t j = 0; j < link_.node.size(); ++j) {
    feedback_.joint_states().reference_position[j] = takeover_.counts()[j] * link_.count_rad[j];
  }
}

// Long enough before the next cycle, the running batch's tail takes the place of what is prepared; later,
// that plays, and its tail follows. On the joints 10 ms after the request, one way or the other.
void MessageController::stop_early(std::int64_t now_ns) noexcept {
  ++link_.state.stops;
  constexpr std::int64_t kSend_ns = 3'500'000;  // a batch to 22 joints while nobody else speaks takes 3 ms
  hand_.stop();
  if (mode() == Mode::emergency_stop) {
    return;
  }
  stop_safely();
  const std::int64_t left_ns = facts::kCycle_ns - now_ns % facts::kCycle_ns;
  if (!stop_requested_ || left_ns < kSend_ns || !link_.synchronised()) {
    return;
  }
  if (playback_.return_to_running_tail()) {
    supervision_.drop_waiting();
    if (playback_.prepared()) {
      send_tail();
    }
  } else {
    prepare_tail();
  }
}

// While nothing gets onto the bus, nothing would come of it; and joints at rest are counted first.
void MessageController::prepare_tail() noexcept {
  if (sync_gets_out() && !counts_first() && !playback_.prepared() && mode() != Mode::emergency_stop &&
      playback_.prepare_from_tail()) {
    send_tail();
  }
}

void MessageController::send_tail() noexcept {
  link_.set_mode(Mode::safe_tail);
  ++link_.state.tail_played;
  if (link_.synchronised()) {
    supervision_.send_waiting();
  }
}

}  // namespace gaitway::msgcontroller
