// Stops, confirmations and releases, slot by slot.
#include "gaitway/msgcontroller/emergency_stop.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/msgcontroller/joint_takeover.hpp"

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
  if (phase_ == Phase::releasing) {
    confirmed_.fill(false);
    send(can::StopMode::release);
    return;
  }
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

void EmergencyStop::supervise(int joint, const can::Feedback& feedback, double measured_rad) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  const bool stopped = feedback.state == can::JointState::soft || feedback.state == can::JointState::stopped;
  if (sent_in_slot_ >= link_.slots_since_start) {
    return;  // what was measured before the frame arrived says nothing
  }
  if (phase_ == Phase::releasing) {
    if (stopped) {
      confirmed_[j] = false;
      send(can::StopMode::release);
    } else if (!confirmed_[j]) {
      confirm(j, feedback.reference_low, measured_rad);
    }
  } else if (!stopped || (soft_ && feedback.state != can::JointState::soft)) {
    link_.watch.count(Incident::stop_repeated, feedback.node);
    repeat();
  }
}

// It holds where it was measured at its release, within its limits; later it may sag. Of its count it tells
// the low four bits.
void EmergencyStop::confirm(std::size_t joint, std::uint8_t reference_low, double measured_rad) noexcept {
  const double held_rad = std::clamp(measured_rad, link_.lower_rad[joint], link_.upper_rad[joint]);
  const auto nearest = static_cast<std::int32_t>(std::lround(held_rad / link_.count_rad[joint]));
  released_count_[joint] = nearest_with_low_bits(nearest, reference_low);
  confirmed_[joint] = true;
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
