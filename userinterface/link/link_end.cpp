// Frames to their receivers, and the order in which frames leave.
#include "gaitway/link/link_end.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::link {

LinkEnd::LinkEnd(const LinkIdentity& identity, const LinkSettings& settings)
    : status_period_ns_(settings.status_period_ns),
      session_(identity, settings),
      outgoing_(settings.fragment_bytes, settings.resend_after_ns) {}

void LinkEnd::step(std::int64_t now_ns) noexcept {
  session_.step(now_ns);
  follow_session();
}

void LinkEnd::on_bytes(Bytes bytes, std::int64_t now_ns) noexcept {
  for (const std::uint8_t byte : bytes) {
    if (const std::optional<Bytes> content = decoder_.take(byte)) {
      on_content(*content, now_ns);
    }
  }
}

void LinkEnd::cut(std::int64_t now_ns) noexcept {
  session_.step(now_ns);
  session_.end(SessionEnd::cut);
  follow_session();
  decoder_.reset();
  wire_size_ = wire_taken_ = 0;
}

void LinkEnd::on_content(Bytes content, std::int64_t now_ns) noexcept {
  session_.step(now_ns);  // what comes after too long a silence belongs to no session any more
  follow_session();
  const std::optional<FrameKind> kind = kind_of(content);
  if (kind == FrameKind::hello) {
    const std::optional<std::uint16_t> version = version_of_hello(content);
    if (version && *version != kProtocolVersion) {
      session_.on_hello_of_version(*version);
      follow_session();
      return;
    }
    Hello hello;
    if (!decode(content, hello)) {
      ++counts_.unexpected;
      return;
    }
    session_.on_hello(hello, now_ns);
    follow_session();
    on_peer_time(hello.time_ns, now_ns);
  } else if (kind && session_.admits(session_of(content), now_ns)) {
    counts_.unexpected += on_session_frame(*kind, content, now_ns) ? 0U : 1U;
  }
}

bool LinkEnd::on_session_frame(FrameKind kind, Bytes content, std::int64_t now_ns) noexcept {
  if (Status status; decode(content, status)) {
    on_peer_time(status.time_ns, now_ns);
    outgoing_.confirm({status.message + 1, status.part}, status.message_limit, now_ns);
    on_status(status, now_ns);
    return true;
  }
  if (Part part; decode(content, part)) {
    part_came_ = true;
    if (const std::optional<Bytes> message = incoming_.take(part, message_limit())) {
      on_message(*message, now_ns);
    }
    return true;
  }
  return on_frame(kind, content, now_ns);
}

void LinkEnd::follow_session() noexcept {
  const std::uint32_t current = session_.open() ? session_.count() : 0;
  if (current == followed_session_) {
    return;
  }
  const bool ended = std::exchange(followed_session_, current) != 0;
  if (ended) {
    on_session_end();
  }
  outgoing_.reset();
  incoming_.reset();
  part_came_ = false;
  if (current != 0) {
    told_limit_ = 0;  // the first status tells it
    on_session_begin();
  }
}

Bytes LinkEnd::pending(std::int64_t now_ns) noexcept {
  if (wire_taken_ == wire_size_) {
    std::array<std::uint8_t, kMostContentBytes> content{};
    const std::size_t size = make_content(content, now_ns);
    wire_size_ = encode_frame(Bytes(content).first(size), wire_);
    wire_taken_ = 0;
    counts_.sent_frames += size > 0 ? 1U : 0U;
  }
  return Bytes(wire_).subspan(wire_taken_, wire_size_ - wire_taken_);
}

void LinkEnd::taken(std::size_t count) noexcept {
  const std::size_t most = std::min(count, wire_size_ - wire_taken_);
  wire_taken_ += most;
  counts_.sent_bytes += most;
}

std::size_t LinkEnd::make_content(Room room, std::int64_t now_ns) noexcept {
  step(now_ns);
  if (session_.open()) {
    if (const std::size_t size = make_urgent(room, now_ns); size > 0) return size;
  }
  if (session_.hello_due(now_ns)) {
    Hello hello = session_.hello(now_ns);
    hello.time_ns = shown_ns(now_ns);
    return encode(hello, room);
  }
  return session_.open() ? make_session_content(room, now_ns) : 0;
}

std::size_t LinkEnd::make_session_content(Room room, std::int64_t now_ns) noexcept {
  if (status_due(now_ns)) {
    return encode(make_status(now_ns), session_.tag(), room);
  }
  if (const std::optional<Part> part = outgoing_.next(now_ns)) {
    return encode(*part, session_.tag(), room);
  }
  return make_state(room, now_ns);
}

bool LinkEnd::status_due(std::int64_t now_ns) const noexcept {
  const std::int64_t since_ns = now_ns - status_sent_ns_;
  return part_came_ || message_limit() != told_limit_ || since_ns >= status_period_ns_ ||
         confirmation_due(since_ns);
}

Status LinkEnd::make_status(std::int64_t now_ns) noexcept {
  status_sent_ns_ = now_ns;
  part_came_ = false;
  told_limit_ = message_limit();
  const LanePosition received = incoming_.position();
  Status status{.time_ns = shown_ns(now_ns),
                .message = received.message - 1,
                .part = received.part,
                .message_limit = told_limit_};
  fill(status);
  return status;
}

void LinkEnd::on_peer_time(std::int64_t peer_time_ns, std::int64_t now_ns) noexcept {
  peer_time_ns_ = peer_time_ns;
  peer_heard_ns_ = now_ns;
}

std::optional<std::int64_t> LinkEnd::peer_time_ns(std::int64_t now_ns) const noexcept {
  return session_.open() ? std::optional(peer_time_ns_ + (now_ns - peer_heard_ns_)) : std::nullopt;
}

LinkStatistics LinkEnd::statistics() const noexcept {
  LinkStatistics all = counts_;
  all.frames = decoder_.counts();
  all.strangers = session_.strangers();
  all.resent_parts = outgoing_.resends();
  return all;
}

}  // namespace gaitway::link
