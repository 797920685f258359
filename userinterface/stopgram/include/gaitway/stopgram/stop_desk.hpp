// The robot's side of stop datagrams: takes each stop once, and answers who knows the token.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "gaitway/stopgram/datagrams.hpp"
#include "gaitway/stopgram/refusal_tally.hpp"
#include "gaitway/stopgram/stop_key.hpp"

namespace gaitway::stopgram {

// One stop that somebody asked for.
struct StopRequest {
  StopKind kind = StopKind::stop;
  std::uint64_t client = 0;
  std::uint32_t number = 0;
};

struct StopDeskCounts {
  std::uint64_t greetings = 0;
  std::uint64_t stops = 0;      // each once
  std::uint64_t repeats = 0;    // of the newest stop of its kind: answered, not carried out again
  std::uint64_t replays = 0;    // older than that: neither
  std::uint64_t strangers = 0;  // of another run of the desk, too old, or of a client that lost its place
};

// Passive: is told the time, and owns no thread. After its construction it throws nothing, and allocates
// nothing of its own but for take_refusal().
class StopDesk {
 public:
  static constexpr std::size_t kClients = 64;  // who have asked for stops; whose last is oldest gives way
  // A stop is taken so long after the welcome whose stamp it bears: that long could it be held back.
  static constexpr std::int64_t kFreshness_ns = 30 * facts::kSecond_ns;

  // `epoch`: random_identity().
  StopDesk(StopKey key, std::uint64_t epoch) noexcept : key_(std::move(key)), epoch_(epoch) {}

  // Returns what to send back to `peer`, mostly nothing; valid until the next call. Never longer than
  // `datagram`.
  Bytes on_datagram(Bytes datagram, const Peer& peer, std::int64_t now_ns) noexcept;
  // The next stop to carry out; to be asked for after each datagram until there is none. `asked`: the stops
  // of each kind that were asked for so far, by whomever; the caller adds this one, and obeyed() is in the
  // same counts.
  std::optional<StopRequest> next_stop(const link::StopCounts& asked) noexcept;
  void obeyed(const link::StopCounts& obeyed) noexcept { obeyed_ = obeyed; }

  [[nodiscard]] const StopDeskCounts& counts() const noexcept { return counts_; }
  [[nodiscard]] const RefusalTally& refusals() const noexcept { return refusals_; }
  // A line for people about who was refused; to be asked for until there is none.
  [[nodiscard]] std::optional<std::string> take_refusal(std::int64_t now_ns) {
    return refusals_.take(now_ns);
  }

 private:
  struct Latest {
    std::uint32_t number = 0;  // 0: none yet
    bool waits = false;        // for next_stop()
    std::uint32_t count = 0;   // which of its kind it became
  };
  struct Client {
    bool used = false;
    std::uint64_t id = 0;
    std::int64_t heard_ns = 0;
    std::int64_t newest_stamp_ns = -1;
    std::int64_t floor_ns = -1;  // what bears this stamp or an older one may have been taken before
    std::array<Latest, kStopKinds> latest{};
  };

  Bytes welcome(const Greeting& greeting) noexcept;
  Bytes on_stop(const Stop& stop) noexcept;
  Bytes acknowledge(const Stop& stop, const Latest& latest) noexcept;
  Bytes stranger(const Stop& stop) noexcept;
  Client* find(std::uint64_t id) noexcept;
  Client& make_place() noexcept;

  StopKey key_;
  std::uint64_t epoch_;
  std::int64_t now_ns_ = 0;
  std::int64_t floor_ns_ = -1;  // of all clients that have lost their places
  std::array<Client, kClients> clients_{};
  std::size_t waiting_ = 0;
  link::StopCounts obeyed_;
  StopDeskCounts counts_;
  RefusalTally refusals_;
  std::array<std::uint8_t, kMostDatagramBytes> answer_{};
};

}  // namespace gaitway::stopgram
