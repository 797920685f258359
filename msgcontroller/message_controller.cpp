// Slot by slot: SYNC, trajectory frames of the next cycle, feedback, repairs, trims and the safe tail.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/msgclient/cycle.hpp"
#include "gaitway/msgclient/trim_law.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::msgcontroller {
namespace {

using msgclient::kMillisecond_ns;
using msgclient::kSlot_ns;
using msgclient::kSlotsPerCycle;

constexpr int kLastSlot = kSlotsPerCycle - 1;
// Latest hand-over: 8 ms before its cycle begins. Trajectory frames of 22 joints need at most 6.075 ms in the
// deadline-monotonic order, whatever else is on the bus.
constexpr std::int64_t kDeadlineInLastSlot_ns = 2 * kMillisecond_ns;
// Feedback that has not come by then is taken as missing for this slot; the main controller's tick follows.
constexpr std::int64_t kPublishInSlot_ns = 4 * kMillisecond_ns;
// No trim from the main controller by then: the message controller makes its own. Once the main controller
// has been silent for two slots, it does so as soon as the feedback is in, since every millisecond costs
// stability.
constexpr std::int64_t kOwnTrimInSlot_ns = 7 * kMillisecond_ns;
constexpr std::uint32_t kSilentSlots = 2;
// A leg whose joint has been silent for so long cannot be relied on: the robot stops.
constexpr std::uint32_t kSilentSlotsOfALeg = 10;

std::vector<can::NodeId> joint_nodes(const urdf::RobotModel& robot, const can::Profile& profile) {
  std::vector<can::NodeId> nodes;
  nodes.reserve(robot.joints.size());
  for (const urdf::Joint& joint : robot.joints) {
    nodes.push_back(is_on_bus(profile, joint) ? joint.node : can::NodeId{0});
  }
  return nodes;
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
    : profile_(network_profile(robot)),
      joint_count_(static_cast<int>(robot.joints.size())),
      node_(joint_nodes(robot, profile_)),
      in_a_leg_(robot.joints.size(), false),
      trim_settings_(robot.trim),
      adapter_(adapter),
      joint_states_writer_(client.write<JointStates>("joint_states")),
      foot_forces_writer_(client.write<FootForces>("foot_forces")),
      imu_writer_(client.write<Imu>("imu")),
      state_writer_(client.write<NetworkState>("network_state")),
      health_writer_(client.write<NetworkHealth>("network_health")),
      watch_(profile_, node_),
      playback_(home_counts(robot)),
      feedback_(robot, node_),
      hand_over_(std::make_unique<msgclient::HandOver>()),
      incoming_(std::make_unique<CountPlan>()) {
  for (int joint = 0; joint < joint_count_; ++joint) {
    const urdf::Joint& description = robot.joints[static_cast<std::size_t>(joint)];
    count_rad_.push_back(description.count_rad);
    lower_rad_.push_back(description.lower_rad);
    upper_rad_.push_back(description.upper_rad);
  }
  for (const urdf::Leg& leg : robot.legs) {
    for (const int joint : leg.joints) {
      in_a_leg_[static_cast<std::size_t>(joint)] = true;
    }
  }
  set_mode(Mode::holding);
  state_writer_.publish(state_, 0);
  health_writer_.publish(watch_.health(), 0);
}

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
    } else if (playback_.prepared() && profile_.has(can::MessageKind::sync)) {
      send_prepared();
    }
  }
  watch_.health().stamp_ns = now_ns;
}

void MessageController::step(std::int64_t now_ns) noexcept {
  const std::int64_t in_slot_ns = now_ns % kSlot_ns;
  watch_.count(Incident::expired, 0, queue_.expire(now_ns));
  if (in_slot_ns == 0) {
    enter_slot(now_ns);
  }
  take_mails(now_ns);
  if (playback_.slot() == kLastSlot && in_slot_ns == kDeadlineInLastSlot_ns && !playback_.prepared() &&
      mode() != Mode::emergency_stop && playback_.prepare_from_tail()) {
    set_mode(Mode::safe_tail);
    ++state_.tail_played;
    if (profile_.has(can::MessageKind::sync)) {
      send_prepared();
    }
  }
  if (!feedback_published_ && in_slot_ns >= kPublishInSlot_ns) {
    publish_feedback(now_ns);
  }
  const bool host_is_silent = slots_since_start_ - last_host_trim_slot_ > kSilentSlots;
  if (!trim_sent_this_slot_ && (host_is_silent ? feedback_published_ : in_slot_ns == kOwnTrimInSlot_ns)) {
    send_own_trim();
  }
}

void MessageController::enter_slot(std::int64_t now_ns) noexcept {
  const std::int64_t slot_index = now_ns / kSlot_ns;
  const int slot = static_cast<int>(slot_index % kSlotsPerCycle);
  if (!feedback_published_) {
    publish_feedback(now_ns);
  }
  if (slot == 0) {
    begin_cycle();
  }
  playback_.enter_slot(slot);
  prepared_before_last_slot_ = slot == kLastSlot && playback_.prepared();
  state_.cycle = static_cast<std::uint32_t>(slot_index / kSlotsPerCycle);
  state_.slot = static_cast<std::uint32_t>(slot);
  state_.stamp_ns = now_ns;
  slot_start_ns_ = now_ns;
  send_sync(now_ns);
  ++slots_since_start_;
  watch_.begin_slot(slots_since_start_);
  feedback_.begin_slot(slots_since_start_);
  for (int joint = 0; joint < joint_count_; ++joint) {
    if (in_a_leg_[static_cast<std::size_t>(joint)] && watch_.silent_slots(joint) == kSilentSlotsOfALeg) {
      stop_safely();
    }
  }
  feedback_published_ = false;
  trim_sent_this_slot_ = false;
  state_writer_.publish(state_, now_ns);
  watch_.health().stamp_ns = now_ns;
  health_writer_.publish(watch_.health(), now_ns);
}

// The slot's edge on the bus. Without a SYNC in the profile, the trajectory frames themselves start the
// batch.
void MessageController::send_sync(std::int64_t now_ns) noexcept {
  const Segment& running = playback_.running_segment();
  if (profile_.has(can::MessageKind::sync)) {
    send(can::encode(profile_, can::Sync{.cycle = static_cast<std::uint16_t>(state_.cycle),
                                         .slot = static_cast<std::uint8_t>(state_.slot),
                                         .batch_committed = running.active,
                                         .toggle = running.toggle}),
         now_ns + kSlot_ns);
  } else if (state_.slot == 0 && running.active) {
    send_running();
  }
  if (state_.slot == 0 && profile_.has(can::MessageKind::heartbeat)) {
    send(can::encode(profile_,
                     can::Heartbeat{.mode = static_cast<std::uint8_t>(state_.mode), .cycle = state_.cycle}),
         now_ns + msgclient::kCycle_ns);
  }
}

void MessageController::begin_cycle() noexcept {
  const bool was_tail = mode() == Mode::safe_tail;
  covered_until_.fill(kLastSlot);
  playback_.begin_cycle();
  if (mode() == Mode::emergency_stop) {
    return;
  }
  if (!playback_.running_segment().active) {
    set_mode(Mode::holding);
    stop_requested_ = false;
  } else if (!was_tail) {
    set_mode(Mode::batches);
  }
}

void MessageController::send_prepared() noexcept {
  for (int joint = 0; joint < joint_count_; ++joint) {
    send_trajectory(joint, false);
  }
}

void MessageController::send_running() noexcept {
  for (int joint = 0; joint < joint_count_; ++joint) {
    send_trajectory(joint, true);
  }
}

// Of the running or the prepared segment. After its start, a prepared batch's frame would be of no use.
void MessageController::send_trajectory(int joint, bool running) noexcept {
  const can::NodeId node = node_[static_cast<std::size_t>(joint)];
  if (node == 0) {
    return;
  }
  can::Trajectory frame{
      .node = node,
      .toggle = running ? playback_.running_segment().toggle : playback_.prepared_segment().toggle};
  for (int slot = 0; slot < kBatchPoints; ++slot) {
    frame.delta[static_cast<std::size_t>(slot)] = static_cast<std::int8_t>(
        running ? playback_.running_delta(joint, slot) : playback_.prepared_delta(joint, slot));
  }
  const int slots_left = running ? 1 : kSlotsPerCycle - playback_.slot();
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

void MessageController::on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept {
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
  if (arrival.message.kind == can::MessageKind::trajectory && arrival.joint >= 0 && playback_.prepared() &&
      mode() != Mode::emergency_stop && profile_.has(can::MessageKind::sync)) {
    ++state_.repaired;
    send_trajectory(arrival.joint, false);
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
  // The prepared batch must have arrived by the feedback of the last slot; if not, it is sent once more.
  // A segment of the safe tail is sent within the last slot, after the joints have answered its SYNC.
  const bool synchronised = profile_.has(can::MessageKind::sync);
  if (synchronised && playback_.slot() == kLastSlot && prepared_before_last_slot_ && playback_.prepared() &&
      feedback.pending_toggle != playback_.prepared_segment().toggle) {
    watch_.count(Incident::trajectory_lost, feedback.node);
    ++state_.repaired;
    send_trajectory(joint, false);
  }
  if (resync_until_[j] > slots_since_start_) {
    return;  // a repair is on its way, or a manual movement is under way
  }
  if (!synchronised && playback_.slot() == 0) {
    return;  // it may have answered before its batch, which starts as it arrives, was there
  }
  if (!plays_as_expected(joint, feedback) || arrival.returned) {
    const bool never_came = playback_.slot() <= 1 && playback_.running_segment().active &&
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
      .toggle = playback_.running_segment().toggle,
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
  constexpr std::int32_t kLargestDelta = 127;
  const auto j = static_cast<std::size_t>(joint);
  if (!playback_.running_segment().active || playback_.slot() == kLastSlot) {
    return;
  }
  can::Trajectory frame{.node = node_[j], .toggle = playback_.running_segment().toggle};
  std::int32_t count = playback_.expected_count(joint, 0) - playback_.running_delta(joint, 0);
  for (int point = 0; point < kBatchPoints; ++point) {
    const int slot = std::min(playback_.slot() + 1 + point, kLastSlot);
    const std::int32_t change =
        std::clamp(playback_.expected_count(joint, slot) - count, -kLargestDelta, kLargestDelta);
    frame.delta[static_cast<std::size_t>(point)] = static_cast<std::int8_t>(change);
    count += change;
  }
  // It starts as it arrives, so each of its points comes up to a slot early.
  resync_until_[j] = slots_since_start_ + static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  ++state_.resynchronised;
  send(can::encode(profile_, frame), slot_start_ns_ + kSlot_ns);
}

void MessageController::take_mails(std::int64_t now_ns) noexcept {
  take_user_command(now_ns);
  take_hand_over(now_ns);
  msgclient::TrimUpdate update;
  if (adapter_.take_trim(update, now_ns) == msgclient::TakeStatus::mail && mode() != Mode::emergency_stop) {
    std::array<double, kTrimChannels> angle{};
    std::copy(update.angle.begin(), update.angle.end(), angle.begin());
    send_trim(angle);
    last_host_trim_slot_ = slots_since_start_;
  }
}

void MessageController::take_hand_over(std::int64_t now_ns) noexcept {
  const msgclient::TakeStatus taken = adapter_.take_hand_over(*hand_over_, now_ns);
  if (taken == msgclient::TakeStatus::none) {
    return;
  }
  ++state_.handed_over;
  if (taken == msgclient::TakeStatus::corrupt) {
    ++state_.refused;  // the adapter has answered
    return;
  }
  msgclient::Answer answer{.mail = msgclient::MailKind::hand_over, .sequence = hand_over_->sequence};
  judge(*hand_over_, now_ns, answer);
  if (answer.verdict == msgclient::Verdict::accepted) {
    play(*incoming_);
  }
  state_.late += answer.verdict == msgclient::Verdict::late ? 1U : 0U;
  state_.refused += answer.verdict == msgclient::Verdict::refused ? 1U : 0U;
  this->answer(answer);
}

void MessageController::judge(const msgclient::HandOver& hand_over, std::int64_t now_ns,
                              msgclient::Answer& answer) noexcept {
  using msgclient::Reason;
  using msgclient::Verdict;
  const auto refuse = [&answer](Reason reason) {
    answer.verdict = reason == Reason::too_late ? Verdict::late : Verdict::refused;
    answer.reason = reason;
  };
  const std::uint32_t next_cycle = state_.cycle + 1;
  const std::int64_t deadline_ns =
      std::int64_t{next_cycle} * msgclient::kCycle_ns - kSlot_ns + kDeadlineInLastSlot_ns;
  if (mode() == Mode::emergency_stop) {
    return refuse(Reason::emergency_stopped);
  }
  if (stop_requested_) {
    return refuse(Reason::stopping);
  }
  // A batch begins where its joints stand, so a joint that moves by hand must have arrived by then.
  const std::uint32_t slots_to_start = static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  if (moving_by_hand_until_ > slots_since_start_ + slots_to_start) {
    return refuse(Reason::moving_by_hand);
  }
  if (hand_over.sequence < next_cycle || now_ns > deadline_ns) {
    return refuse(Reason::too_late);
  }
  if (hand_over.sequence > next_cycle) {
    return refuse(Reason::early_sequence);
  }
  if (playback_.prepared()) {
    return refuse(Reason::old_sequence);
  }
  CountPlanProblem problem = to_counts(hand_over, count_rad_, playback_.next_start(), *incoming_);
  if (problem.reason == Reason::none) {
    problem = motion_without_node(*incoming_, playback_.next_start());
  }
  if (problem.reason != Reason::none) {
    refuse(problem.reason);
    answer.joint = problem.joint;
    answer.point = problem.point;
    answer.value = static_cast<float>(problem.counts);
  }
}

// A joint that is not on the bus cannot move.
CountPlanProblem MessageController::motion_without_node(const CountPlan& plan,
                                                        std::span<const std::int32_t> start) const noexcept {
  for (int point = 0; point < plan.point_count; ++point) {
    for (std::size_t j = 0; j < node_.size(); ++j) {
      const std::int32_t moved = plan.count[static_cast<std::size_t>(point)][j] - start[j];
      if (node_[j] == 0 && moved != 0) {
        return {msgclient::Reason::node_fault, static_cast<std::int32_t>(j), point,
                static_cast<double>(moved)};
      }
    }
  }
  return {};
}

void MessageController::play(const CountPlan& plan) noexcept {
  playback_.accept(plan);
  state_.accepted_sequence = plan.sequence;
  gains_ = hand_over_->trim;
  set_mode(Mode::batches);
  if (profile_.has(can::MessageKind::sync)) {
    send_prepared();
  }
}

void MessageController::answer(const msgclient::Answer& answer) noexcept {
  if (!adapter_.answer(answer)) {
    ++unanswered_;  // the main controller reads no answers: it has others to worry about than this one
  }
}

void MessageController::take_user_command(std::int64_t now_ns) noexcept {
  msgclient::UserCommandMail mail;
  if (adapter_.take_user_command(mail, now_ns) != msgclient::TakeStatus::mail) {
    return;
  }
  using Kind = msgclient::UserCommandKind;
  using msgclient::Reason;
  Reason problem = Reason::none;
  switch (mail.kind) {
    case Kind::stop:
      // What was prepared is already with the joints: it plays, and its tail follows.
      stop_safely();
      break;
    case Kind::emergency_stop_hold:
    case Kind::emergency_stop_soft:
      stop_is_soft_ = stop_is_soft_ || mail.kind == Kind::emergency_stop_soft;
      send_stop();
      set_mode(Mode::emergency_stop);
      break;
    case Kind::manual_joint:
      problem = move_joint(mail);
      break;
    default:
      problem = Reason::unknown_command;
  }
  answer({.mail = msgclient::MailKind::user_command,
          .sequence = mail.sequence,
          .verdict = problem == Reason::none ? msgclient::Verdict::accepted : msgclient::Verdict::refused,
          .reason = problem});
}

msgclient::Reason MessageController::move_joint(const msgclient::UserCommandMail& mail) noexcept {
  using msgclient::Reason;
  if (mail.joint >= static_cast<std::uint32_t>(joint_count_)) {
    return Reason::unknown_joint;
  }
  if (node_[mail.joint] == 0) {
    return Reason::node_fault;
  }
  const auto j = static_cast<std::size_t>(mail.joint);
  const double position = static_cast<double>(mail.position);
  if (mode() != Mode::holding || playback_.prepared()) {
    return Reason::not_standing;
  }
  if (!(position >= lower_rad_[j] && position <= upper_rad_[j])) {
    return Reason::beyond_limits;
  }
  constexpr std::uint32_t kLongestMove_slots = 255;
  const std::uint32_t duration = std::clamp<std::uint32_t>(mail.duration_slots, 1, kLongestMove_slots);
  const std::int32_t count = static_cast<std::int32_t>(std::lround(position / count_rad_[j]));
  const std::int32_t from = playback_.next_start()[j];
  constexpr std::int32_t kLargestDelta = 127;
  if (std::abs(count - from) > kLargestDelta * static_cast<std::int32_t>(duration)) {
    return Reason::too_fast;
  }
  send(can::encode(profile_, can::UserCommand{.node = node_[j],
                                              .target_count = static_cast<std::int16_t>(count),
                                              .duration_slots = static_cast<std::uint8_t>(duration)}));
  playback_.hold(static_cast<int>(mail.joint), count);
  // While it moves there, its reference is its own affair.
  resync_until_[j] = slots_since_start_ + duration + 2U;
  moving_by_hand_until_ = std::max(moving_by_hand_until_, resync_until_[j]);
  return Reason::none;
}

void MessageController::publish_feedback(std::int64_t now_ns) noexcept {
  feedback_.joint_states().missing = feedback_.missing();
  joint_states_writer_.publish(feedback_.joint_states(), now_ns);
  foot_forces_writer_.publish(feedback_.foot_forces(), now_ns);
  imu_writer_.publish(feedback_.imu(), now_ns);
  feedback_published_ = true;
}

void MessageController::send_trim(std::span<const double> angle_rad) noexcept {
  if (!profile_.has(can::MessageKind::trim)) {
    return;
  }
  can::Trim trim;
  for (std::size_t channel = 0; channel < trim.count.size(); ++channel) {
    const double limited =
        std::clamp(angle_rad[channel], -trim_settings_.limit_rad, trim_settings_.limit_rad);
    trim.count[channel] =
        static_cast<std::int8_t>(std::clamp(std::lround(limited / trim_settings_.count_rad), -127L, 127L));
  }
  send(can::encode(profile_, trim), slot_start_ns_ + 2 * kSlot_ns);
  trim_sent_this_slot_ = true;
}

void MessageController::send_own_trim() noexcept {
  if (!profile_.has(can::MessageKind::trim) || gains_.channel_count == 0 || mode() == Mode::emergency_stop) {
    return;
  }
  const Imu& imu = feedback_.imu();
  const msgclient::TrunkMotion motion{.roll = imu.inclination[0],
                                      .pitch = imu.inclination[1],
                                      .roll_rate = imu.angular_velocity[0],
                                      .pitch_rate = imu.angular_velocity[1]};
  send_trim(msgclient::trim_angles(gains_, playback_.support(), motion, trim_settings_.limit_rad));
}

}  // namespace gaitway::msgcontroller
