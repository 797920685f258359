// Slot by slot: SYNC, trajectory frames of the next cycle, feedback, repairs, trims and the safe tail.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/msgclient/cycle.hpp"
#include "gaitway/msgclient/trim_law.hpp"

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
// A resynchronisation carries the absolute point and five more, so it must not take effect before slot 2.
constexpr int kEarliestResyncSlot = kSlotsPerCycle - 1 - can::kResyncDeltas;

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
    : profile_(can::kFullProfile),
      joint_count_(static_cast<int>(robot.joints.size())),
      trim_settings_(robot.trim),
      adapter_(adapter),
      joint_states_writer_(client.write<JointStates>("joint_states")),
      foot_forces_writer_(client.write<FootForces>("foot_forces")),
      imu_writer_(client.write<Imu>("imu")),
      state_writer_(client.write<NetworkState>("network_state")),
      playback_(home_counts(robot)),
      feedback_(robot),
      hand_over_(std::make_unique<msgclient::HandOver>()),
      incoming_(std::make_unique<CountPlan>()) {
  joint_of_node_.fill(-1);
  for (int joint = 0; joint < joint_count_; ++joint) {
    const urdf::Joint& description = robot.joints[static_cast<std::size_t>(joint)];
    count_rad_.push_back(description.count_rad);
    lower_rad_.push_back(description.lower_rad);
    upper_rad_.push_back(description.upper_rad);
    node_.push_back(description.node);
    joint_of_node_[description.node] = joint;
  }
  set_mode(Mode::holding);
  state_writer_.publish(state_, 0);
}

void MessageController::step(std::int64_t now_ns) noexcept {
  const std::int64_t in_slot_ns = now_ns % kSlot_ns;
  if (in_slot_ns == 0) {
    enter_slot(now_ns);
  }
  take_mails(now_ns);
  if (playback_.slot() == kLastSlot && in_slot_ns == kDeadlineInLastSlot_ns && !playback_.prepared() &&
      mode() != Mode::emergency_stop && playback_.prepare_from_tail()) {
    set_mode(Mode::safe_tail);
    ++state_.tail_played;
    send_prepared();
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
  const Segment& running = playback_.running_segment();
  queue_.push(can::encode(profile_, can::Sync{.cycle = static_cast<std::uint16_t>(state_.cycle),
                                              .slot = static_cast<std::uint8_t>(slot),
                                              .batch_committed = running.active,
                                              .toggle = running.toggle}));
  if (slot == 0) {
    queue_.push(can::encode(
        profile_, can::Heartbeat{.mode = static_cast<std::uint8_t>(state_.mode), .cycle = state_.cycle}));
  }
  ++slots_since_start_;
  feedback_.begin_slot(slots_since_start_);
  feedback_published_ = false;
  trim_sent_this_slot_ = false;
  state_writer_.publish(state_, now_ns);
}

void MessageController::begin_cycle() noexcept {
  const bool was_tail = mode() == Mode::safe_tail;
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
    send_trajectory(joint);
  }
}

void MessageController::send_trajectory(int joint) noexcept {
  can::Trajectory frame{.node = node_[static_cast<std::size_t>(joint)],
                        .toggle = playback_.prepared_segment().toggle};
  for (int slot = 0; slot < kBatchPoints; ++slot) {
    frame.delta[static_cast<std::size_t>(slot)] =
        static_cast<std::int8_t>(playback_.prepared_delta(joint, slot));
  }
  queue_.push(can::encode(profile_, frame));
}

void MessageController::on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept {
  const auto feedback = can::decode_feedback(profile_, frame);
  if (!feedback || joint_of_node_[feedback->node] < 0) {
    return;
  }
  const int joint = joint_of_node_[feedback->node];
  const auto j = static_cast<std::size_t>(joint);
  feedback_.take(joint, *feedback, now_ns);
  feedback_.joint_states().reference_position[j] = expected_count(joint) * count_rad_[j];
  supervise(joint, *feedback);
  if (feedback_.complete() && !feedback_published_) {
    publish_feedback(now_ns);
  }
}

void MessageController::supervise(int joint, const can::Feedback& feedback) noexcept {
  if (feedback.state == can::JointState::soft || mode() == Mode::emergency_stop) {
    return;
  }
  // The prepared batch must have arrived by the feedback of the last slot; if not, it is sent once more.
  // A segment of the safe tail is sent within the last slot, after the joints have answered its SYNC.
  if (playback_.slot() == kLastSlot && prepared_before_last_slot_ && playback_.prepared() &&
      feedback.pending_toggle != playback_.prepared_segment().toggle) {
    ++state_.repaired;
    send_trajectory(joint);
  }
  if (resync_until_[static_cast<std::size_t>(joint)] > slots_since_start_) {
    return;  // a repair is on its way, or a manual movement is under way
  }
  const Segment& running = playback_.running_segment();
  const auto expected_low =
      static_cast<std::uint8_t>(static_cast<std::uint32_t>(expected_count(joint)) & 0xFU);
  const bool plays_batch = !running.active || (feedback.state == can::JointState::running &&
                                               feedback.executing_toggle == running.toggle);
  if (plays_batch && feedback.reference_low == expected_low) {
    return;
  }
  resynchronise(joint);
}

void MessageController::resynchronise(int joint) noexcept {
  const int effective_slot = std::max(playback_.slot() + 1, kEarliestResyncSlot);
  if (effective_slot > kLastSlot) {
    return;  // the next cycle's first feedback shows whether it is still needed
  }
  const auto j = static_cast<std::size_t>(joint);
  resync_until_[j] = slots_since_start_ + static_cast<std::uint32_t>(effective_slot - playback_.slot());
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
  queue_.push(can::encode(profile_, frame));
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
  const CountPlanProblem problem = to_counts(hand_over, count_rad_, playback_.next_start(), *incoming_);
  if (problem.reason != Reason::none) {
    refuse(problem.reason);
    answer.joint = problem.joint;
    answer.point = problem.point;
    answer.value = static_cast<float>(problem.counts);
  }
}

void MessageController::play(const CountPlan& plan) noexcept {
  playback_.accept(plan);
  state_.accepted_sequence = plan.sequence;
  gains_ = hand_over_->trim;
  set_mode(Mode::batches);
  send_prepared();
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
      stop_requested_ = mode() == Mode::batches;
      break;
    case Kind::emergency_stop_hold:
    case Kind::emergency_stop_soft:
      queue_.push(can::encode(
          profile_, can::EmergencyStop{mail.kind == Kind::emergency_stop_soft ? can::StopMode::soft
                                                                              : can::StopMode::hold}));
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
  queue_.push(can::encode(profile_, can::UserCommand{.node = node_[j],
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
  can::Trim trim;
  for (std::size_t channel = 0; channel < trim.count.size(); ++channel) {
    const double limited =
        std::clamp(angle_rad[channel], -trim_settings_.limit_rad, trim_settings_.limit_rad);
    trim.count[channel] =
        static_cast<std::int8_t>(std::clamp(std::lround(limited / trim_settings_.count_rad), -127L, 127L));
  }
  queue_.push(can::encode(profile_, trim));
  trim_sent_this_slot_ = true;
}

void MessageController::send_own_trim() noexcept {
  if (gains_.channel_count == 0 || mode() == Mode::emergency_stop) {
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
