// Which addresses send what is refused, and how often, in words: each at once, then one line in ten seconds.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stopgram {

// Where a datagram came from.
struct Peer {
  std::array<std::uint8_t, 16> address{};  // IPv6; of IPv4 the mapped one (::ffff:a.b.c.d)
  std::uint16_t port = 0;
  std::uint32_t scope = 0;  // of a link-local address
  bool operator==(const Peer&) const = default;
};

[[nodiscard]] std::string text_of(const Peer& peer);

// None of these is answered.
enum class Refusal : std::uint8_t {
  foreign,        // no datagram of ours
  other_version,  // of ours, of another version
  forged,         // its code is wrong: another token, or changed on its way
  misplaced,      // its code is right, but it is nothing that a client says
};
inline constexpr std::size_t kRefusals = 4;

// Bounded, whoever sends from however many addresses: so many are told apart, the others are told together.
class RefusalTally {
 public:
  static constexpr std::int64_t kPeriod_ns = 10 * facts::kSecond_ns;
  static constexpr std::size_t kAddresses = 16;

  // An address whatever its port. Does not allocate.
  void note(Refusal cause, const Peer& peer, std::int64_t now_ns) noexcept;
  // A line for people, if one is due; to be asked for until there is none.
  [[nodiscard]] std::optional<std::string> take(std::int64_t now_ns);
  [[nodiscard]] std::uint64_t count(Refusal cause) const noexcept {
    return counts_[static_cast<std::size_t>(cause)];
  }

 private:
  struct Entry {
    Peer latest{};
    Refusal cause{};
    std::uint64_t count = 0;  // since it was told of
    std::optional<std::int64_t> told_ns;
    [[nodiscard]] bool rests(std::int64_t now_ns) const noexcept {
      return told_ns && now_ns - *told_ns < kPeriod_ns;
    }
  };
  Entry& entry_of(const Peer& peer, std::int64_t now_ns) noexcept;

  std::array<std::uint64_t, kRefusals> counts_{};
  std::array<Entry, kAddresses + 1> entries_{};  // the last: of all addresses for which there is no place
};

}  // namespace gaitway::stopgram
