// Deadlines are looked at in every tick of the server; a timer of its own for each operation would cost more.
#include "client_link.hpp"

#include <algorithm>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::uint16_t kGoingAway = 1001, kPolicyViolation = 1008, kTryAgainLater = 1013;
constexpr std::size_t kLongestReason = 123;  // RFC 6455, 5.5.1, without the code
// Of one turn; then the others have theirs.
constexpr std::size_t kTurnBytes = std::size_t{64} * 1024;
constexpr std::size_t kTurnFrames = OutgoingQueue::kBuffers / 2;
constexpr int kTurns = 4;
// Pings and pongs that a client may send in a second.
constexpr unsigned kControlFrames = 100;
using facts::kSecond_ns;

std::string shortened(std::string_view reason) {
  std::size_t length = std::min(reason.size(), kLongestReason);
  while (length < reason.size() && length > 0 &&
         (static_cast<unsigned char>(reason[length]) & 0xC0U) == 0x80U) {
    --length;  // no half characters
  }
  return std::string(reason.substr(0, length));
}

std::string in_ms(std::int64_t duration_ns) {
  return std::to_string(duration_ns / 1'000'000) + " ms";
}

std::string text(const boost::asio::ip::tcp::endpoint& peer) {
  const std::string address = peer.address().to_string();
  return (peer.address().is_v6() ? "[" + address + "]" : address) + ":" + std::to_string(peer.port());
}

}  // namespace

ClientLink::ClientLink(ServerCore& core, const Endpoint& peer, bool surplus, std::int64_t now_ns)
    : core_(core),
      address_(peer.address()),
      peer_(text(peer)),
      since_ns_(now_ns),
      surplus_(surplus),
      inbox_(core.options.limits.message_bytes),
      deadline_ns_(now_ns + core.options.limits.handshake_ns) {}

void ClientLink::wake() noexcept {
  if (!std::exchange(woken_, true)) {
    core_.want_pump(shared_from_this());
  }
}

void ClientLink::close(std::uint16_t code, std::string_view reason) noexcept {
  if (!close_asked_ && phase_ != Phase::closing && phase_ != Phase::over) {
    close_asked_ = true;
    close_code_ = code;
    close_reason_ = shortened(reason);
    deadline_ns_ = std::max(wall_now_ns(), silent_until_ns_) + core_.options.closing_ns;
    wake();
  }
}

void ClientLink::pump_woken(std::int64_t now_ns) {
  woken_ = false;
  pump(now_ns);
}

void ClientLink::fill(std::int64_t now_ns) {
  while (phase_ == Phase::open && session_ && queue_.bytes() < kTurnBytes && queue_.frames() < kTurnFrames) {
    auto frame = session_->next_frame(now_ns);
    if (!frame) {
      return;
    }
    if (queue_.empty()) {
      front_ns_ = core_.listening.now_ns();
    }
    ++core_.statistics.messages_out;
    core_.statistics.bytes_out += frame->bytes->size();
    queue_.append(std::move(*frame));
  }
}

void ClientLink::pump(std::int64_t now_ns) {
  if (phase_ == Phase::open && now_ns < silent_until_ns_) {
    return;  // the sweep wakes it
  }
  for (int turn = 0; !blocked_ && phase_ != Phase::over; ++turn) {
    fill(now_ns);
    if (queue_.empty()) {
      break;
    }
    if (turn == kTurns) {
      wake();
      return;
    }
    ++core_.statistics.writes;
    write_queue();
  }
  if (close_asked_ && phase_ == Phase::open && !blocked_ && queue_.empty()) {
    end_conversation(cause_ == Closing::lost ? Closing::by_session : cause_, close_code_, close_reason_);
  }
}

void ClientLink::consumed(std::size_t bytes) {
  const auto progress = queue_.consume(bytes);
  if (progress.finished_any) {
    front_ns_ = core_.listening.now_ns();
  }
  if (progress.finished_raw) {
    raw_written();
  }
}

void ClientLink::refuse(Refusal cause, const std::string& detail) {
  core_.statistics.count(cause);
  const std::int64_t now_ns = wall_now_ns();
  phase_ = Phase::refused;
  deadline_ns_ = now_ns;
  const bool tries_to_get_in = cause == Refusal::wrong_token || cause == Refusal::foreign_origin;
  if (tries_to_get_in || cause == Refusal::other_page) {
    core_.refusal_log.note(cause, address_.to_string() + (detail.empty() ? "" : ", " + detail));
  }
  if (tries_to_get_in) {
    deadline_ns_ += core_.patience.refused(address_, now_ns);
  }
  if (deadline_ns_ == now_ns) {
    answer_refusal();
  }
}

void ClientLink::shown_wrong_token() noexcept {
  const std::int64_t now_ns = wall_now_ns();
  core_.statistics.count(Refusal::wrong_token);
  core_.refusal_log.note(Refusal::wrong_token, address_.to_string());
  silent_until_ns_ = now_ns + core_.patience.refused(address_, now_ns);
}

void ClientLink::refusing() {
  phase_ = Phase::refusing;
  deadline_ns_ = wall_now_ns() + core_.options.closing_ns;
}

void ClientLink::giving_page() {
  ++core_.statistics.pages;
  phase_ = Phase::refusing;
  deadline_ns_ = wall_now_ns() + core_.options.page_ns;
}

void ClientLink::opened(bool authorised, bool view) {
  const std::int64_t now_ns = wall_now_ns();
  ++core_.statistics.opened;
  was_open_ = true;
  phase_ = Phase::open;
  pinged_ns_ = second_ns_ = answered_ns_ = sent_after_ns_ = now_ns;
  heard_ns_ = core_.listening.now_ns();
  view_ = view;
  session_ = (view ? *core_.page.view : core_.hub).open(*this, peer_, authorised, now_ns);
  if (!session_) {
    end_conversation(Closing::refused, kTryAgainLater,
                     "the robot has no place for another client: try again later");
  }
}

void ClientLink::received(std::string_view message, bool binary) {
  ++core_.statistics.messages_in;
  core_.statistics.bytes_in += message.size();
  if (!session_ || close_asked_) {
    return;
  }
  const Urgency urgency = session_->urgency(message, binary);
  if (urgent_share_.may_overtake(urgency, core_.urgent_beyond)) {
    inbox_.overtake();
    sent_after_ns_ = answered_ns_;
    session_->take(message, binary, wall_now_ns());
    return;
  }
  inbox_.put(message, binary, answered_ns_, urgency != Urgency::none);
  if (!std::exchange(in_line_, true)) {
    core_.want_work(shared_from_this());
  }
}

void ClientLink::read_on() {
  reading_rests_ = phase_ == Phase::open && !inbox_.has_room();
  if (phase_ == Phase::open && !reading_rests_) {
    read();
  }
}

bool ClientLink::work() {
  if (session_ && !inbox_.empty()) {
    const ClientInbox::Message message = inbox_.take();
    sent_after_ns_ = message.sent_after_ns;
    if (message.overtaken) {
      session_->take_overtaken(message.text, message.binary, wall_now_ns());
    } else {
      session_->take(message.text, message.binary, wall_now_ns());
    }
  }
  if (close_asked_) {
    inbox_.clear();
  }
  if (phase_ != Phase::open) {
    let_session_finish();
  } else if (reading_rests_) {
    read_on();
  }
  in_line_ = !inbox_.empty();
  return in_line_;
}

void ClientLink::drop_session() noexcept {
  inbox_.clear();
  session_.reset();
}

void ClientLink::let_session_finish() noexcept {
  if (inbox_.empty()) {
    session_.reset();
  }
}

void ClientLink::heard(std::size_t bytes) {
  if (bytes > 0) {
    heard_ns_ = core_.listening.now_ns();
  }
}

void ClientLink::control_frame() {
  ++core_.statistics.control_frames;
  heard_ns_ = core_.listening.now_ns();
  if (++control_frames_ == kControlFrames) {
    cause_ = Closing::flood;
    close(kPolicyViolation, "more than " + std::to_string(kControlFrames) + " pings and pongs in a second");
  } else if (control_frames_ == 2 * kControlFrames) {
    cut(Closing::flood);
  }
}

void ClientLink::answered_ping(std::int64_t pinged_ns) noexcept {
  if (pinged_ns > answered_ns_ && pinged_ns <= pinged_ns_) {
    answered_ns_ = pinged_ns;
  }
}

void ClientLink::client_closes() {
  if (phase_ == Phase::open) {
    let_session_finish();
    enter_closing(Closing::by_client);
  }
}

void ClientLink::library_closes() {
  if (phase_ == Phase::open) {
    let_session_finish();
    enter_closing(Closing::protocol_error);
  }
}

void ClientLink::failed(Closing cause) {
  if (phase_ == Phase::open || (phase_ == Phase::closing && cause_ == Closing::protocol_error)) {
    cause_ = cause;
  }
  end();
}

void ClientLink::left(Refusal cause) {
  if (phase_ == Phase::handshake) {
    core_.statistics.count(cause);
  }
  end();
}

void ClientLink::sweep(std::int64_t now_ns) {
  urgent_share_.begin_anew();
  if (phase_ == Phase::open) {
    sweep_open(now_ns);
  } else if (phase_ == Phase::refused) {
    if (now_ns >= deadline_ns_) {
      answer_refusal();
    }
  } else if (now_ns > deadline_ns_) {
    left(Refusal::handshake_time);
  }
}

void ClientLink::sweep_open(std::int64_t now_ns) {
  const Limits& limits = core_.options.limits;
  if (now_ns - second_ns_ >= kSecond_ns) {
    second_ns_ = now_ns;
    control_frames_ = 0;
  }
  const std::int64_t listened_ns = core_.listening.now_ns();
  if (reading_rests_) {
    heard_ns_ = listened_ns;  // it has sent more than has been read
  }
  const bool silent = listened_ns - heard_ns_ > limits.silence_ns;
  if (blocked_ && (silent || listened_ns - front_ns_ > limits.write_ns)) {
    end_conversation(Closing::slow, kTryAgainLater,
                     "too slow: did not take within " + in_ms(silent ? limits.silence_ns : limits.write_ns) +
                         " what was written; subscribe to less, or more slowly");
  } else if (silent) {
    end_conversation(Closing::silent, kPolicyViolation,
                     "no sign of life within " + in_ms(limits.silence_ns) + ": answer pings");
  } else if (close_asked_ && now_ns > deadline_ns_) {
    end_conversation(cause_ == Closing::lost ? Closing::by_session : cause_, close_code_, close_reason_);
  } else if (now_ns < silent_until_ns_) {
    return;
  } else if (silent_until_ns_ != 0) {
    silent_until_ns_ = 0;
    wake();
  } else if (!pinging_ && now_ns - pinged_ns_ >= ping_period_ns() && !acknowledges(listened_ns)) {
    pinged_ns_ = now_ns;
    pinging_ = true;
    begin_ping(now_ns);
  }
}

// What a client sends tells that it lives; how old its orders are only the answer to a ping.
bool ClientLink::acknowledges(std::int64_t listened_ns) const noexcept {
  return session_ && !session_->may_give_orders() && listened_ns - heard_ns_ < core_.options.ping_ns;
}

std::int64_t ClientLink::ping_period_ns() const noexcept {
  return session_ && session_->gives_orders() ? core_.options.order_ping_ns : core_.options.ping_ns;
}

void ClientLink::shut_down() {
  if (phase_ == Phase::open) {
    end_conversation(Closing::shut_down, kGoingAway, "the robot API stops");
  } else if (phase_ == Phase::handshake || phase_ == Phase::refused) {
    left(Refusal::left);
  }
}

void ClientLink::cut(Closing cause) {
  drop_session();
  if (phase_ == Phase::open) {
    cause_ = cause;
  }
  left(Refusal::left);
}

bool ClientLink::may_give_way() const noexcept {
  return !surplus_ && !(phase_ == Phase::open && session_ && session_->authorised());
}

void ClientLink::give_way() {
  drop_session();
  if (phase_ == Phase::open) {
    cause_ = Closing::refused;
  }
  left(Refusal::too_many);
}

// What waits is dropped, but for what the client has seen in part: the close frame must reach it soon, if at
// all. A full send buffer is widened for that, and goes on to its end in the kernel after the cut.
void ClientLink::end_conversation(Closing cause, std::uint16_t code, const std::string& reason) {
  drop_session();
  enter_closing(cause);
  if (blocked_) {
    queue_.drop_messages(holds_gathered());
    widen_send_buffer();
  }
  begin_close(code, shortened(reason));
}

void ClientLink::enter_closing(Closing cause) {
  cause_ = cause;
  phase_ = Phase::closing;
  deadline_ns_ = wall_now_ns() + core_.options.closing_ns;
}

void ClientLink::end() {
  if (phase_ == Phase::over) {
    return;
  }
  if (was_open_) {
    core_.statistics.count(cause_);
  }
  const auto self = shared_from_this();
  phase_ = Phase::over;
  let_session_finish();
  cut_socket();
  core_.remove(*this);
}

}  // namespace gaitway::api
