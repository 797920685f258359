// Hand-overs, each answered.
#include "gaitway/msgcontroller/batch_intake.hpp"

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::msgcontroller {

using facts::kSlotsPerCycle;

BatchIntake::BatchIntake(const urdf::RobotModel& robot, BusLink& link, Playback& playback,
                         JointSupervision& supervision, HandMovement& hand, msgclient::EmiMessage& adapter)
    : link_(link),
      playback_(playback),
      supervision_(supervision),
      hand_(hand),
      adapter_(adapter),
      lead_ns_(hand_over_lead_ns(robot)),
      hand_over_(std::make_unique<msgclient::HandOver>()),
      plan_(std::make_unique<CountPlan>()) {}

const msgclient::TrimGains* BatchIntake::take(std::int64_t now_ns, bool stopping,
                                              bool on_their_own) noexcept {
  NetworkState& state = link_.state;
  const msgclient::TakeStatus taken = adapter_.take_hand_over(*hand_over_, now_ns);
  if (taken == msgclient::TakeStatus::none) {
    return nullptr;
  }
  ++state.handed_over;
  if (taken == msgclient::TakeStatus::corrupt) {
    ++state.refused;  // the adapter has answered
    return nullptr;
  }
  msgclient::Answer answer{.mail = msgclient::MailKind::hand_over, .sequence = hand_over_->sequence};
  judge(now_ns, stopping, on_their_own, answer);
  state.late += answer.verdict == msgclient::Verdict::late ? 1U : 0U;
  state.refused += answer.verdict == msgclient::Verdict::refused ? 1U : 0U;
  refused_by_a_stop_ += answer.reason == msgclient::Reason::stopping ? 1U : 0U;
  const bool accepted = answer.verdict == msgclient::Verdict::accepted;
  if (accepted) {
    hand_.forget();
    playback_.accept(*plan_);
    state.accepted_sequence = plan_->sequence;
    link_.set_mode(Mode::batches);
    if (link_.synchronised()) {
      supervision_.send_waiting();
    }
  }
  // A main controller that reads no answers has others to worry about than this one.
  static_cast<void>(adapter_.answer(answer));
  return accepted ? &hand_over_->trim : nullptr;
}

void BatchIntake::judge(std::int64_t now_ns, bool stopping, bool on_their_own,
                        msgclient::Answer& answer) noexcept {
  using msgclient::Reason;
  using msgclient::Verdict;
  const auto refuse = [&answer](Reason reason) {
    answer.verdict = reason == Reason::too_late ? Verdict::late : Verdict::refused;
    answer.reason = reason;
  };
  if (link_.mode() == Mode::emergency_stop) {
    return refuse(Reason::emergency_stopped);
  }
  if (stopping) {
    return refuse(Reason::stopping);
  }
  const Reason time = untimely(now_ns);
  if (on_their_own && time != Reason::too_late) {
    return refuse(Reason::stopping);
  }
  if (time != Reason::none) {
    return refuse(time);
  }
  const std::span<const std::int32_t> start = playback_.next_start();
  CountPlanProblem problem = to_counts(*hand_over_, link_.count_rad, start, *plan_);
  if (problem.reason == Reason::none) {
    problem = motion_without_node(start);
  }
  if (problem.reason == Reason::none) {
    problem = hand_.pulled_back_by(*plan_, start);
  }
  if (problem.reason != Reason::none) {
    refuse(problem.reason);
    answer.joint = problem.joint;
    answer.point = problem.point;
    answer.value = static_cast<float>(problem.counts);
  }
}

// Whether it comes at the wrong time: for another cycle than the next, or with too little time left to send
// it.
msgclient::Reason BatchIntake::untimely(std::int64_t now_ns) const noexcept {
  using msgclient::Reason;
  const msgclient::HandOver& hand_over = *hand_over_;
  const std::uint32_t cycle = link_.state.cycle + 1;
  const std::uint32_t slots_to_start = kSlotsPerCycle - link_.state.slot;
  const std::int64_t start_ns = std::int64_t{cycle} * facts::kCycle_ns;
  // A batch begins where its joints stand, so a joint that moves by hand must have arrived by then.
  if (hand_.moves_in(slots_to_start)) {
    return Reason::moving_by_hand;
  }
  if (hand_over.sequence < cycle || now_ns > start_ns - lead_ns_) {
    return Reason::too_late;
  }
  if (hand_over.sequence > cycle) {
    return Reason::early_sequence;
  }
  return playback_.waiting_segment() != nullptr ? Reason::old_sequence : Reason::none;
}

// A joint that is not on the bus cannot move.
CountPlanProblem BatchIntake::motion_without_node(std::span<const std::int32_t> start) const noexcept {
  for (int point = 0; point < plan_->point_count; ++point) {
    for (std::size_t j = 0; j < link_.node.size(); ++j) {
      const std::int32_t moved = plan_->count[static_cast<std::size_t>(point)][j] - start[j];
      if (link_.node[j] == 0 && moved != 0) {
        return {msgclient::Reason::node_fault, static_cast<std::int32_t>(j), point,
                static_cast<double>(moved)};
      }
    }
  }
  return {};
}

}  // namespace gaitway::msgcontroller
