// While a stop is open and the desk is known, nothing but stops is said.
#include "gaitway/stopgram/stop_sender.hpp"

#include <algorithm>
#include <limits>

namespace gaitway::stopgram {
namespace {

constexpr std::int64_t kAtOnce = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

}  // namespace

void StopSender::stop(StopKind kind) noexcept {
  stops_[static_cast<std::size_t>(kind)] = {
      .number = ++last_number_, .state = StopState::asked, .said_ns = {}};
}

Bytes StopSender::next(std::int64_t now_ns) noexcept {
  if (welcome_) {
    for (std::size_t kind = kStopKinds; kind-- > 0;) {  // what stops most first
      Asked& asked = stops_[kind];
      if (asked.open() && (!asked.said_ns || now_ns - *asked.said_ns >= kRepeat_ns)) {
        asked.said_ns = now_ns;
        asked_ns_ = asked_ns_.value_or(now_ns);
        const Stop stop{client_, welcome_->epoch, welcome_->stamp_ns, asked.number,
                        static_cast<StopKind>(kind)};
        return signed_datagram(key_, stop, datagram_);
      }
    }
  }
  if (greeting_due_ns() > now_ns) {
    return {};
  }
  greeted_ns_ = now_ns;
  asked_ns_ = asked_ns_.value_or(now_ns);
  return signed_datagram(key_, Greeting{client_, greeting_}, datagram_);
}

bool StopSender::any_open() const noexcept {
  return std::ranges::any_of(stops_, &Asked::open);
}

std::int64_t StopSender::greeting_due_ns() const noexcept {
  if (any_open() && welcome_) {
    return kNever;
  }
  return greeted_ns_ ? *greeted_ns_ + (any_open() ? kRepeat_ns : kGreet_ns) : kAtOnce;
}

std::int64_t StopSender::next_due_ns() const noexcept {
  std::int64_t due_ns = greeting_due_ns();
  for (const Asked& asked : stops_) {
    if (welcome_ && asked.open()) {
      due_ns = std::min(due_ns, asked.said_ns ? *asked.said_ns + kRepeat_ns : kAtOnce);
    }
  }
  return due_ns;
}

void StopSender::on_datagram(Bytes datagram, std::int64_t /*now_ns*/) noexcept {
  if (!key_.has_signed(datagram)) {
    return;
  }
  const Bytes content = datagram.first(datagram.size() - kMacBytes);
  Welcome welcome;
  Ack ack;
  Stranger stranger;
  if (decode(content, welcome) && welcome.client == client_ && welcome.number == greeting_) {
    welcome_ = welcome;
    ++greeting_;
    asked_ns_.reset();
    for (Asked& asked : stops_) {
      asked.said_ns.reset();
    }
  } else if (decode(content, ack) && ack.client == client_) {
    Asked& asked = stops_[static_cast<std::size_t>(ack.kind)];
    if (ack.number == asked.number && asked.open()) {
      asked.state = ack.obeyed ? StopState::obeyed : StopState::heard;
      asked_ns_.reset();
    }
  } else if (decode(content, stranger) && welcome_ && stranger.client == client_ &&
             stranger.epoch == welcome_->epoch && stranger.stamp_ns == welcome_->stamp_ns) {
    welcome_.reset();
    asked_ns_.reset();
  }
}

}  // namespace gaitway::stopgram
