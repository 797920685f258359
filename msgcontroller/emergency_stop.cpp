// Stops, confirmations and releases, slot by slot.
#include "gaitway/msgcontroller/emergency_stop.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr std::uint32_t kReleaseSlots = 10;  // in which every joint must have confirmed a release
constexpr std::uint32_t kSilentSlots = 2;    // from then on a joint is missing

}  // namespace

void EmergencyStop::stop(bool soft) noexcept {
  const bool is_new = phase_ != Phase::stopped || (soft && !soft_);
  failed_ = failed_ || phase_ == Phase::releasing;
  phase_ = Phase::stopped;
  soft_ = soft_ || soft;
  link_.set_mode(Mode::emergency_stop);
  if (is_new) {
    repeat();
  }
}

void EmergencyStop::repeat() noexcept {
  send(soft_ ? can::StopMode::soft : can::StopMode::hold);
}

void EmergencyStop::send(can::StopMode mode) noexcept {
  sent_in_slot_ = link_.slots_since_start;
  if (link_.profile.has(can::MessageKind::emergency_stop)) {
    link_.send(can::encode(link_.profile, can::EmergencyStop{mode}));
  } else {
    link_.send(can::encode(link_.profile,
                           can::UserCommand{.node = 0, .target_count = static_cast<std::int16_t>(mode)}));
  }
}

msgclient::Reason EmergencyStop::release() noexcept {
  if (phase_ != Phase::stopped) {
    return phase_ == Phase::free ? msgclient::Reason::not_stopped : msgclient::Reason::releasing;
  }
  for (int joint = 0; joint < link_.joint_count; ++joint) {
    const bool on_bus = link_.node[static_cast<std::size_t>(joint)] != 0;
    if (link_.off_the_bus() || (on_bus && link_.watch.silent_slots(joint) > kSilentSlots)) {
      return msgclient::Reason::node_fault;
    }
  }
  phase_ = Phase::releasing;
  failed_ = false;
  confirmed_.fill(false);
  release_until_ = link_.slots_since_start + kReleaseSlots;
  send(can::StopMode::release);
  return msgclient::Reason::none;
}

void EmergencyStop::supervise(int joint, const can::Feedback& feedback) noexcept {
  const bool stopped = feedback.state == can::JointState::soft || feedback.state == can::JointState::stopped;
  if (sent_in_slot_ >= link_.slots_since_start) {
    return;  // what was measured before the frame arrived says nothing
  }
  if (phase_ == Phase::releasing) {
    confirmed_[static_cast<std::size_t>(joint)] = !stopped;
    reference_low_[static_cast<std::size_t>(joint)] = feedback.reference_low;
    if (stopped) {
      send(can::StopMode::release);
    }
  } else if (!stopped || (soft_ && feedback.state != can::JointState::soft)) {
    link_.watch.count(Incident::stop_repeated, feedback.node);
    repeat();
  }
}

bool EmergencyStop::all_confirmed() const noexcept {
  for (std::size_t joint = 0; joint < link_.node.size(); ++joint) {
    if (link_.node[joint] != 0 && !confirmed_[joint]) {
      return false;
    }
  }
  return true;
}

EmergencyStop::Outcome EmergencyStop::take_outcome() noexcept {
  if (failed_) {
    failed_ = false;
    return Outcome::failed;
  }
  if (phase_ != Phase::releasing) {
    return Outcome::none;
  }
  if (all_confirmed()) {
    phase_ = Phase::free;
    soft_ = false;
    return Outcome::released;
  }
  if (link_.slots_since_start >= release_until_) {
    stop(soft_);
    failed_ = false;
    return Outcome::failed;
  }
  return Outcome::none;
}

}  // namespace gaitway::msgcontroller
