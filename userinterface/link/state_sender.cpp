// Which fragment is next, and what became of those under way.
#include "gaitway/link/state_sender.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "gaitway/link/byte_order.hpp"

namespace gaitway::link {

StateSender::StateSender(std::span<const Channel> channels, const LinkSettings& settings)
    : fragment_bytes_(settings.fragment_bytes),
      window_(settings.state_window),
      resend_after_ns_(settings.resend_after_ns) {
  if (channels.size() > kMostChannels) {
    throw std::invalid_argument("link: " + std::to_string(channels.size()) + " channels, at most " +
                                std::to_string(kMostChannels) + " are possible");
  }
  for (const Channel& channel : channels) {
    const std::size_t bytes = channel.most_bytes + kStampBytes;
    const std::size_t fragments = fragments_of(bytes, fragment_bytes_);
    if (fragments > std::numeric_limits<std::uint16_t>::max()) {
      throw std::invalid_argument("link channel '" + std::string(channel.name) +
                                  "': " + std::to_string(channel.most_bytes) +
                                  " bytes are too many for fragments of " + std::to_string(fragment_bytes_));
    }
    State& state = states_.emplace_back();
    state.newest.resize(bytes);
    state.sent.resize(bytes);
    state.fragments.resize(fragments);
  }
}

bool StateSender::publish(std::size_t channel, Bytes value, std::int64_t stamp_ns) noexcept {
  if (channel >= states_.size() || value.size() + kStampBytes > states_[channel].newest.size()) {
    return false;
  }
  State& state = states_[channel];
  state.newest_bytes = ByteWriter(state.newest).put(stamp_ns).put(value).size();
  state.dirty = true;
  return true;
}

std::optional<StateFragment> StateSender::next(std::int64_t now_ns) noexcept {
  expire(now_ns);
  if (under_way() >= window_) {
    return std::nullopt;
  }
  State* chosen = nullptr;
  for (State& state : states_) {
    if (state.wants_turn() && (chosen == nullptr || state.served < chosen->served)) {
      chosen = &state;
    }
  }
  if (chosen == nullptr) {
    return std::nullopt;
  }
  if (chosen->may_begin()) {
    begin(*chosen);
  }
  const auto end = chosen->fragments.begin() + static_cast<std::ptrdiff_t>(chosen->fragment_count);
  const auto place = std::find(chosen->fragments.begin(), end, Progress::waiting);
  *place = Progress::under_way;
  --chosen->waiting;
  chosen->served = ++turns_;
  if (under_way() == 0) {
    progress_ns_ = now_ns;
  }
  const auto fragment = static_cast<std::uint16_t>(place - chosen->fragments.begin());
  const auto channel = static_cast<std::size_t>(chosen - states_.data());
  frames_[next_sequence_ % kMostStateWindow] = {channel, chosen->version, fragment};
  const std::size_t offset = fragment * fragment_bytes_;
  return StateFragment{
      .sequence = next_sequence_++,
      .channel = static_cast<std::uint8_t>(channel),
      .version = chosen->version,
      .total_bytes = static_cast<std::uint32_t>(chosen->sent_bytes),
      .fragment = fragment,
      .fragment_bytes = static_cast<std::uint8_t>(fragment_bytes_),
      .payload = Bytes(chosen->sent).subspan(offset, std::min(fragment_bytes_, chosen->sent_bytes - offset))};
}

void StateSender::begin(State& state) const noexcept {
  std::copy_n(state.newest.begin(), state.newest_bytes, state.sent.begin());
  state.sent_bytes = state.newest_bytes;
  state.fragment_count = fragments_of(state.sent_bytes, fragment_bytes_);
  std::fill_n(state.fragments.begin(), state.fragment_count, Progress::waiting);
  state.waiting = state.missing = state.fragment_count;
  ++state.version;
  state.dirty = false;
}

void StateSender::confirm(const Status& status, std::int64_t now_ns) noexcept {
  const auto ahead = static_cast<std::uint16_t>(status.state_sequence - oldest_sequence_);
  if ((status.state_received & 1U) == 0 || ahead >= under_way()) {
    return;  // nothing has arrived yet, or nothing new
  }
  // The carrier keeps the order: what was sent before something that arrived, and has not arrived, is lost.
  for (std::uint16_t behind = ahead;
       oldest_sequence_ != static_cast<std::uint16_t>(status.state_sequence + 1);
       ++oldest_sequence_, --behind) {
    settle(oldest_sequence_, (status.state_received >> behind & 1U) != 0);
  }
  progress_ns_ = now_ns;
}

void StateSender::settle(std::uint16_t sequence, bool arrived) noexcept {
  const UnderWay& frame = frames_[sequence % kMostStateWindow];
  State& state = states_[frame.channel];
  lost_frames_ += arrived ? 0U : 1U;
  if (frame.version != state.version || state.fragments[frame.fragment] != Progress::under_way) {
    return;  // overtaken by a newer value
  }
  state.fragments[frame.fragment] = arrived ? Progress::arrived : Progress::waiting;
  state.missing -= arrived ? 1U : 0U;
  state.waiting += arrived ? 0U : 1U;
}

void StateSender::expire(std::int64_t now_ns) noexcept {
  if (under_way() == 0 || now_ns - progress_ns_ < resend_after_ns_) {
    return;
  }
  for (; under_way() > 0; ++oldest_sequence_) {
    settle(oldest_sequence_, false);
  }
}

void StateSender::reset() noexcept {
  oldest_sequence_ = next_sequence_;
  for (State& state : states_) {
    state.waiting = state.missing = state.fragment_count = 0;
    state.dirty = state.newest_bytes > 0;
  }
}

bool StateSender::settled() const noexcept {
  return std::ranges::none_of(states_, [](const State& state) { return state.dirty || state.missing > 0; });
}

}  // namespace gaitway::link
