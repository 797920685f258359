// The message controller's side of the mailboxes: hand-overs, trims and user commands, each answered.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kSlotsPerCycle;

constexpr int kCommandsAMillisecond = 32;  // more than the queue holds: bounds the work, loses nothing

}  // namespace

void MessageController::take_mails(std::int64_t now_ns) noexcept {
  take_user_command(now_ns);
  take_hand_over(now_ns);
  msgclient::TrimUpdate update;
  if (adapter_.take_trim(update, now_ns) == msgclient::TakeStatus::mail && mode() != Mode::emergency_stop) {
    const std::span<const float> given = std::span(update.angle).first(update.channel_count);
    if (!std::all_of(given.begin(), given.end(), [](float angle) { return std::isfinite(angle); }) ||
        !std::isfinite(update.softness)) {
      return;  // as if none had come: the message controller's own trims follow
    }
    softness_ = static_cast<std::uint8_t>(
        std::lround(std::clamp(update.softness, 0.0F, 1.0F) * static_cast<float>(can::kMostSoftness)));
    std::array<double, kTrimChannels> angle{};
    std::copy(given.begin(), given.end(), angle.begin());
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
  if (mode() == Mode::emergency_stop) {
    return refuse(Reason::emergency_stopped);
  }
  if (stop_requested_) {
    return refuse(Reason::stopping);
  }
  if (const Reason reason = untimely(hand_over, now_ns); reason != Reason::none) {
    return refuse(reason);
  }
  const std::span<const std::int32_t> start =
      hand_over.first_slot == 0 ? playback_.next_start() : playback_.reached_before(hand_over.first_slot);
  CountPlanProblem problem = to_counts(hand_over, count_rad_, start, *incoming_);
  if (problem.reason == Reason::none) {
    problem = motion_without_node(*incoming_, start);
  }
  if (problem.reason == Reason::none) {
    problem = away_by_hand(*incoming_, start);
  }
  if (problem.reason != Reason::none) {
    refuse(problem.reason);
    answer.joint = problem.joint;
    answer.point = problem.point;
    answer.value = static_cast<float>(problem.counts);
  }
}

// Whether it comes at the wrong time: a batch for another cycle than the next, a revision of another batch
// than the running one, or one of them with too little time left to send it.
msgclient::Reason MessageController::untimely(const msgclient::HandOver& hand_over,
                                              std::int64_t now_ns) const noexcept {
  using msgclient::Reason;
  const bool revises = hand_over.first_slot != 0;
  const std::uint32_t cycle = revises ? state_.cycle : state_.cycle + 1;
  const std::uint32_t slot = state_.slot;
  const std::uint32_t slots_to_start = (revises ? hand_over.first_slot : kSlotsPerCycle) - slot;
  const std::int64_t start_ns =
      (std::int64_t{cycle} * kSlotsPerCycle + hand_over.first_slot) * facts::kSlot_ns;
  if (revises && (hand_over.first_slot != revision_slot_ || hand_over.sequence > cycle)) {
    return Reason::nothing_to_revise;
  }
  // A batch begins where its joints stand, so a joint that moves by hand must have arrived by then.
  if (moving_by_hand_until_ > slots_since_start_ + slots_to_start) {
    return Reason::moving_by_hand;
  }
  if (hand_over.sequence < cycle || now_ns > start_ns - hand_over_lead_ns_) {
    return Reason::too_late;
  }
  if (revises) {
    return playback_.revisable(cycle) ? Reason::none : Reason::nothing_to_revise;
  }
  if (hand_over.sequence > cycle) {
    return Reason::early_sequence;
  }
  return playback_.waiting_segment() != nullptr ? Reason::old_sequence : Reason::none;
}

// A joint that is not on the bus cannot move.
CountPlanProblem MessageController::motion_without_node(const CountPlan& plan,
                                                        std::span<const std::int32_t> start) const noexcept {
  for (int point = plan.first_point; point < plan.point_count; ++point) {
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

// Whoever moved a joint by hand brings it back before batches go on: none pulls it back in a time slot.
CountPlanProblem MessageController::away_by_hand(const CountPlan& plan,
                                                 std::span<const std::int32_t> start) const noexcept {
  constexpr std::int32_t kThere = 2;  // counts
  for (std::size_t j = 0; j < node_.size(); ++j) {
    const std::int32_t away = plan.count[static_cast<std::size_t>(plan.first_point)][j] - start[j];
    if (moved_by_hand_[j] && std::abs(away) > kThere) {
      return {msgclient::Reason::moving_by_hand, static_cast<std::int32_t>(j), plan.first_point,
              static_cast<double>(away)};
    }
  }
  return {};
}

void MessageController::play(const CountPlan& plan) noexcept {
  moved_by_hand_.fill(false);
  plan.first_point > 0 ? playback_.accept_revision(plan) : playback_.accept(plan);
  state_.accepted_sequence = plan.sequence;
  gains_ = hand_over_->trim;
  set_mode(Mode::batches);
  if (profile_.has(can::MessageKind::sync)) {
    send_waiting();
  }
}

void MessageController::answer(const msgclient::Answer& answer) noexcept {
  if (!adapter_.answer(answer)) {
    ++unanswered_;  // the main controller reads no answers: it has others to worry about than this one
  }
}

void MessageController::take_user_command(std::int64_t now_ns) noexcept {
  msgclient::UserCommandMail mail;
  if (adapter_.take_user_command(mail, now_ns) == msgclient::TakeStatus::mail) {
    const msgclient::Reason problem = obey(mail, now_ns);
    using msgclient::Reason;
    answer({.mail = msgclient::MailKind::user_command,
            .sequence = mail.sequence,
            .verdict = problem == Reason::none ? msgclient::Verdict::accepted : msgclient::Verdict::refused,
            .reason = problem});
  }
  // The same from processes that have no mailbox.
  UserCommand command;
  for (int i = 0; i < kCommandsAMillisecond && user_commands_.pop(command); ++i) {
    const msgclient::Reason problem = obey({.sequence = command.number,
                                            .kind = static_cast<msgclient::UserCommandKind>(command.kind),
                                            .joint = command.joint,
                                            .position = static_cast<float>(command.position),
                                            .duration_slots = command.duration_slots},
                                           now_ns);
    UserCommandAnswer answer{};
    answer.number = command.number;
    answer.reason = static_cast<std::uint32_t>(problem);
    answer.command = command.kind;
    answer.joint = command.joint;
    answer.duration_slots = command.duration_slots;
    answer.position = command.position;
    user_command_answers_.publish(answer, now_ns);
  }
}

msgclient::Reason MessageController::obey(const msgclient::UserCommandMail& mail,
                                          std::int64_t now_ns) noexcept {
  using Kind = msgclient::UserCommandKind;
  switch (mail.kind) {
    case Kind::stop:
      stop_early(now_ns);
      return msgclient::Reason::none;
    case Kind::emergency_stop_hold:
    case Kind::emergency_stop_soft:
      stop_at_once(mail.kind == Kind::emergency_stop_soft);
      return msgclient::Reason::none;
    case Kind::manual_joint:
      return move_joint(mail, now_ns);
  }
  return msgclient::Reason::unknown_command;
}

void MessageController::drop_waiting_trajectories() noexcept {
  queue_.drop_identifiers(profile_.row(can::MessageKind::trajectory).base_id,
                          profile_.id_of(can::MessageKind::trajectory, profile_.largest_node, true));
}

// Long enough before the next cycle, the running batch's tail takes the place of what is prepared; later,
// that plays, and its tail follows. On the joints 10 ms after the request, one way or the other.
void MessageController::stop_early(std::int64_t now_ns) noexcept {
  constexpr std::int64_t kSend_ns = 3'500'000;  // a batch to 22 joints while nobody else speaks takes 3 ms
  stop_safely();
  const std::int64_t left_ns = facts::kCycle_ns - now_ns % facts::kCycle_ns;
  if (!stop_requested_ || left_ns < kSend_ns || !profile_.has(can::MessageKind::sync)) {
    return;
  }
  if (playback_.return_to_running_tail()) {
    drop_waiting_trajectories();
    if (playback_.prepared()) {
      send_tail();
    }
  } else {
    prepare_tail();
  }
}

// A stop that holds already is repeated by the supervision, until each joint has confirmed it; many requests
// load the bus no more than one.
void MessageController::stop_at_once(bool soft) noexcept {
  const bool is_new = mode() != Mode::emergency_stop || (soft && !stop_is_soft_);
  stop_is_soft_ = stop_is_soft_ || soft;
  set_mode(Mode::emergency_stop);
  if (is_new) {
    send_stop();
  }
}

msgclient::Reason MessageController::move_joint(const msgclient::UserCommandMail& mail,
                                                std::int64_t now_ns) noexcept {
  using msgclient::Reason;
  if (mail.joint >= static_cast<std::uint32_t>(joint_count_)) {
    return Reason::unknown_joint;
  }
  if (node_[mail.joint] == 0) {
    return Reason::node_fault;
  }
  const auto j = static_cast<std::size_t>(mail.joint);
  const double position = static_cast<double>(mail.position);
  // A robot that stands plays batches that leave it where it is.
  const bool synchronised = profile_.has(can::MessageKind::sync);
  const bool stands = mode() == Mode::holding ? !playback_.prepared()
                                              : mode() == Mode::batches && synchronised && playback_.rests();
  if (!stands) {
    return Reason::not_standing;
  }
  // The proof of the bus counts on user commands keeping their distance.
  if (now_ns < next_user_command_ns_) {
    return Reason::moving_by_hand;
  }
  if (!(position >= lower_rad_[j] && position <= upper_rad_[j])) {
    return Reason::beyond_limits;
  }
  constexpr std::uint32_t kLongestMove_slots = 255;
  const std::uint32_t duration = std::clamp<std::uint32_t>(mail.duration_slots, 1, kLongestMove_slots);
  const std::int32_t count = static_cast<std::int32_t>(std::lround(position / count_rad_[j]));
  const std::int32_t from = playback_.next_start()[j];
  if (std::abs(count - from) > facts::kLargestByte_counts * static_cast<std::int32_t>(duration)) {
    return Reason::too_fast;
  }
  send(can::encode(profile_, can::UserCommand{.node = node_[j],
                                              .target_count = static_cast<std::int16_t>(count),
                                              .duration_slots = static_cast<std::uint8_t>(duration)}));
  next_user_command_ns_ = now_ns + profile_.row(can::MessageKind::user_command).period_ns;
  drop_waiting_trajectories();
  playback_.hold(static_cast<int>(mail.joint), count);
  moved_by_hand_[j] = true;
  // While it moves there, and while the batch that it has left still runs, its reference is its own affair.
  const std::uint32_t batch_left = static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  resync_until_[j] = slots_since_start_ + std::max(duration, batch_left) + 2U;
  moving_by_hand_until_ = std::max(moving_by_hand_until_, resync_until_[j]);
  return Reason::none;
}

}  // namespace gaitway::msgcontroller
