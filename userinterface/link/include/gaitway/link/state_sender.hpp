// The robot's state on its way out: the newest value of each channel, in fragments, the longest unserved
// first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/link/link_settings.hpp"
#include "gaitway/link/messages.hpp"

namespace gaitway::link {

// One kind of state. Both ends have the same list; a channel's number is its place there.
struct Channel {
  std::string_view name;
  std::size_t most_bytes = 0;
};

inline constexpr std::size_t kMostChannels = 256;
inline constexpr std::size_t kStampBytes = 8;  // in front of each value

// At most `state_window` frames are under way, so that no buffer of the carrier fills with what is old
// already. A fragment that was lost is sent again; a value that was overtaken before its first fragment left
// is not sent at all. A value of several fragments is sent to its end though newer ones come, else it would
// never arrive. Allocates in the constructor only.
class StateSender {
 public:
  // Throws std::invalid_argument for more than kMostChannels, or one with more fragments than a frame can
  // count.
  StateSender(std::span<const Channel> channels, const LinkSettings& settings);

  // `stamp_ns`: of the value, in the robot's time. False: no such channel, or too many bytes; nothing
  // changed.
  bool publish(std::size_t channel, Bytes value, std::int64_t stamp_ns) noexcept;
  // The next fragment for the wire, valid until the next publish() or next().
  std::optional<StateFragment> next(std::int64_t now_ns) noexcept;
  void confirm(const Status& status, std::int64_t now_ns) noexcept;
  // For a new session: the newest value of every channel is sent anew.
  void reset() noexcept;

  [[nodiscard]] std::uint64_t lost_frames() const noexcept { return lost_frames_; }
  // True: the other end has the newest value of every channel, and has said so.
  [[nodiscard]] bool settled() const noexcept;

 private:
  enum class Progress : std::uint8_t { waiting, under_way, arrived };
  struct State {
    std::vector<std::uint8_t> newest, sent;  // stamp and value; `sent` is what the fragments are cut from
    std::size_t newest_bytes = 0, sent_bytes = 0;
    std::vector<Progress> fragments;  // of `sent`
    std::size_t fragment_count = 0;
    std::size_t waiting = 0, missing = 0;  // fragments: to be sent (again); not known to have arrived
    std::uint16_t version = 0;
    bool dirty = false;        // `newest` is not `sent`
    std::uint64_t served = 0;  // when it was its turn
    [[nodiscard]] bool may_begin() const noexcept { return dirty && (missing == 0 || fragment_count == 1); }
    [[nodiscard]] bool wants_turn() const noexcept { return waiting > 0 || may_begin(); }
  };
  struct UnderWay {
    std::size_t channel = 0;
    std::uint16_t version = 0;
    std::uint16_t fragment = 0;
  };

  void begin(State& state) const noexcept;
  void settle(std::uint16_t sequence, bool arrived) noexcept;
  void expire(std::int64_t now_ns) noexcept;
  [[nodiscard]] std::uint16_t under_way() const noexcept {
    return static_cast<std::uint16_t>(next_sequence_ - oldest_sequence_);
  }

  std::size_t fragment_bytes_, window_;
  std::int64_t resend_after_ns_;
  std::vector<State> states_;
  std::array<UnderWay, kMostStateWindow> frames_{};
  std::uint16_t oldest_sequence_ = 0, next_sequence_ = 0;
  std::int64_t progress_ns_ = 0;
  std::uint64_t turns_ = 0;
  std::uint64_t lost_frames_ = 0;
};

}  // namespace gaitway::link
