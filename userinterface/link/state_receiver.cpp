// Puts fragments together, each version apart, and keeps the last whole one until the next is whole.
#include "gaitway/link/state_receiver.hpp"

#include <algorithm>
#include <utility>

#include "gaitway/link/byte_order.hpp"

namespace gaitway::link {
namespace {

constexpr std::size_t kLeastFragmentBytes = 8;

}  // namespace

StateReceiver::StateReceiver(std::span<const Channel> channels) : states_(channels.size()) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::size_t bytes = channels[i].most_bytes + kStampBytes;
    states_[i].whole.resize(bytes);
    states_[i].partial.resize(bytes);
    states_[i].arrived.resize(fragments_of(bytes, kLeastFragmentBytes));
  }
}

bool StateReceiver::take(const StateFragment& fragment, std::int64_t now_ns) noexcept {
  if (fragment.channel >= states_.size()) {
    return false;
  }
  State& state = states_[fragment.channel];
  if (fragment.total_bytes < kStampBytes || fragment.total_bytes > state.partial.size() ||
      fragment.fragment_bytes < kLeastFragmentBytes) {
    return false;
  }
  note(fragment.sequence);
  if (!state.begun || static_cast<std::int16_t>(fragment.version - state.version) > 0) {
    begin(state, fragment);
  }
  const bool of_this = fragment.version == state.version && fragment.total_bytes == state.total_bytes &&
                       fragment.fragment_bytes == state.fragment_bytes;
  if (!of_this || state.missing == 0 || state.arrived[fragment.fragment]) {
    return true;  // late or repeated: nothing new
  }
  const std::size_t offset = std::size_t{fragment.fragment} * fragment.fragment_bytes;
  std::ranges::copy(fragment.payload, state.partial.begin() + static_cast<std::ptrdiff_t>(offset));
  state.arrived[fragment.fragment] = true;
  if (--state.missing == 0) {
    finish(state, now_ns);
  }
  return true;
}

void StateReceiver::note(std::uint16_t sequence) noexcept {
  ++unconfirmed_;
  if (received_ == 0) {
    newest_sequence_ = sequence;
    received_ = 1;
    return;
  }
  const auto ahead = static_cast<std::int16_t>(sequence - newest_sequence_);
  if (ahead > 0) {
    received_ = ahead >= 32 ? 0 : received_ << static_cast<unsigned>(ahead);
    received_ |= 1U;
    newest_sequence_ = sequence;
  } else if (ahead > -32) {
    received_ |= 1U << static_cast<unsigned>(-ahead);
  }
}

void StateReceiver::begin(State& state, const StateFragment& fragment) const noexcept {
  state.begun = true;
  state.version = fragment.version;
  state.total_bytes = fragment.total_bytes;
  state.fragment_bytes = fragment.fragment_bytes;
  state.missing = fragments_of(fragment.total_bytes, fragment.fragment_bytes);
  std::fill_n(state.arrived.begin(), state.missing, false);
}

void StateReceiver::finish(State& state, std::int64_t now_ns) noexcept {
  std::swap(state.whole, state.partial);
  const Bytes all = Bytes(state.whole).first(state.total_bytes);
  state.value = {.bytes = all.subspan(kStampBytes),
                 .stamp_ns = ByteReader(all).get<std::int64_t>(),
                 .received_ns = now_ns,
                 .updates = state.value.updates + 1};
  state.changed = true;
}

void StateReceiver::confirm_in(Status& status) noexcept {
  status.state_sequence = newest_sequence_;
  status.state_received = received_;
  unconfirmed_ = 0;
}

void StateReceiver::reset() noexcept {
  received_ = 0;
  unconfirmed_ = 0;
  for (State& state : states_) {
    state.begun = false;
    state.missing = 0;
  }
}

std::optional<std::size_t> StateReceiver::next_changed() noexcept {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const std::size_t channel = turn_;
    turn_ = turn_ + 1 == states_.size() ? 0 : turn_ + 1;
    if (std::exchange(states_[channel].changed, false)) {
      return channel;
    }
  }
  return std::nullopt;
}

}  // namespace gaitway::link
