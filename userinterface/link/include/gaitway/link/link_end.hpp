// One end of the link: bytes in, bytes out, told the time. What module and controller have in common.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/link/frame_codec.hpp"
#include "gaitway/link/link_settings.hpp"
#include "gaitway/link/message_lane.hpp"
#include "gaitway/link/messages.hpp"
#include "gaitway/link/session.hpp"

namespace gaitway::link {

struct LinkStatistics {
  FrameCounts frames;           // received
  std::uint64_t strangers = 0;  // whole frames of no session of now
  std::uint64_t unexpected =
      0;  // frames of the session that this end has no use for, or that contradict themselves
  std::uint64_t sent_frames = 0;
  std::uint64_t sent_bytes = 0;
  std::uint64_t resent_parts = 0;  // how often a lane went back
};

// For one thread. Neither allocates nor throws once it is made. What goes out, and in which order:
//
//   stop ► hello ► status, if one is due ► parts of messages ► fragments of state
//
// The next frame is made when the last one has left, so that nothing waits longer than for one frame.
class LinkEnd {
 public:
  virtual ~LinkEnd() = default;
  LinkEnd(const LinkEnd&) = delete;
  LinkEnd& operator=(const LinkEnd&) = delete;

  // Notices silence. At least as often as the smallest of the periods in LinkSettings.
  void step(std::int64_t now_ns) noexcept;
  // Whatever came from the carrier, cut wherever it likes.
  void on_bytes(Bytes bytes, std::int64_t now_ns) noexcept;
  // What the carrier is to send next: the rest of a frame, or nothing. Valid until anything else is called.
  [[nodiscard]] Bytes pending(std::int64_t now_ns) noexcept;
  // The carrier has taken so many of them.
  void taken(std::size_t count) noexcept;
  // There is nobody at the other end of the carrier any more: the session is over, what was not sent is
  // forgotten.
  void cut(std::int64_t now_ns) noexcept;

  [[nodiscard]] const Session& session() const noexcept { return session_; }
  [[nodiscard]] LinkStatistics statistics() const noexcept;

 protected:
  using Room = std::span<std::uint8_t>;

  LinkEnd(const LinkIdentity& identity, const LinkSettings& settings);

  // Content of a frame that goes ahead of all others; 0: none.
  virtual std::size_t make_urgent(Room room, std::int64_t now_ns) noexcept = 0;
  // Content of a frame that goes behind all messages; 0: none.
  virtual std::size_t make_state(Room /*room*/, std::int64_t /*now_ns*/) noexcept { return 0; }
  // Adds to the status what this side knows beside the messages.
  virtual void fill(Status& /*status*/) noexcept {}
  // Beside messages something was received that is to be confirmed now.
  [[nodiscard]] virtual bool confirmation_due(std::int64_t /*since_status_ns*/) const noexcept {
    return false;
  }
  // A frame of the session that only this side understands; false: it has no use for it.
  virtual bool on_frame(FrameKind kind, Bytes content, std::int64_t now_ns) noexcept = 0;
  virtual void on_message(Bytes message, std::int64_t now_ns) noexcept = 0;
  virtual void on_status(const Status& /*status*/, std::int64_t /*now_ns*/) noexcept {}
  virtual void on_session_begin() noexcept = 0;
  virtual void on_session_end() noexcept = 0;
  // Its times go out this much later than its own clock has them.
  void set_shown_clock(std::int64_t shown_ns, std::int64_t now_ns) noexcept {
    shown_ahead_ns_ = shown_ns - now_ns;
  }
  [[nodiscard]] std::int64_t shown_ns(std::int64_t now_ns) const noexcept { return now_ns + shown_ahead_ns_; }
  // The last message for which there is room.
  [[nodiscard]] virtual std::uint32_t message_limit() const noexcept = 0;

  // At most what the other end's clock shows: its last time that came, and what has passed here since.
  // Nothing without a session.
  [[nodiscard]] std::optional<std::int64_t> peer_time_ns(std::int64_t now_ns) const noexcept;
  [[nodiscard]] std::optional<std::int64_t> peer_clock_ns() const noexcept {
    return session_.open() ? std::optional(peer_time_ns_) : std::nullopt;
  }
  [[nodiscard]] MessageSender& outgoing() noexcept { return outgoing_; }
  [[nodiscard]] const MessageSender& outgoing() const noexcept { return outgoing_; }

 private:
  void on_content(Bytes content, std::int64_t now_ns) noexcept;
  bool on_session_frame(FrameKind kind, Bytes content, std::int64_t now_ns) noexcept;
  void follow_session() noexcept;
  std::size_t make_content(Room room, std::int64_t now_ns) noexcept;
  std::size_t make_session_content(Room room, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool status_due(std::int64_t now_ns) const noexcept;
  void on_peer_time(std::int64_t peer_time_ns, std::int64_t now_ns) noexcept;
  Status make_status(std::int64_t now_ns) noexcept;

  std::int64_t status_period_ns_;
  Session session_;
  std::uint32_t followed_session_ = 0;  // 0: none
  FrameDecoder decoder_;
  MessageSender outgoing_;
  MessageReceiver incoming_;
  std::array<std::uint8_t, kMostFrameBytes> wire_{};
  std::size_t wire_size_ = 0, wire_taken_ = 0;
  std::int64_t status_sent_ns_ = 0;
  std::int64_t shown_ahead_ns_ = 0;
  std::int64_t peer_time_ns_ = 0, peer_heard_ns_ = 0;
  bool part_came_ = false;  // or a repeated one: its sender lacks the confirmation
  std::uint32_t told_limit_ = 0;
  LinkStatistics counts_;
};

}  // namespace gaitway::link
