// A main controller's events on their way to others: what its network's counters have to tell, the stream
// `events` for other processes, lines on stderr for people.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "gaitway/instance/event_log.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

// What the message controller found wrong on its network: each cause when it is new, and then whenever its
// count has doubled, so that a bad bus fills no log.
class NetworkEvents {
 public:
  static constexpr std::size_t kCauses = 15;

  // Calls `report(text)` for each cause that is worth an event since the last call. No allocation.
  template <class Report>
  void compare(const NetworkHealth& health, Report report) noexcept {
    for (std::size_t cause = 0; cause < kCauses; ++cause) {
      std::array<char, 160> text{};
      if (const std::size_t length = describe(cause, health, text); length > 0) {
        report(std::string_view(text.data(), length));
      }
    }
  }

 private:
  // Length of the text; 0: nothing new.
  std::size_t describe(std::size_t cause, const NetworkHealth& health, std::array<char, 160>& text) noexcept;

  std::array<std::uint64_t, kCauses> next_{};  // count at which the cause is told again; 0: not told yet
};

class EventPublisher {
 public:
  static constexpr std::uint32_t kEventsAStep = 16;
  // Of the stream, unless a reader declared another one before.
  static constexpr std::uint32_t kStreamCapacity = 64;

  // Claims the stream. Throws msgclient::TopicError: somebody else writes it.
  explicit EventPublisher(msgclient::Client& client);

  // Off the tick, once after each: publishes what is new, oldest first. No allocation or lock.
  void step(const EventLog& events, std::int64_t now_ns) noexcept;

  // Events that the log gave up before they could be published.
  [[nodiscard]] std::uint64_t missed() const noexcept { return missed_; }

 private:
  msgclient::Writer<gaitway::Event> writer_;
  std::uint64_t next_ = 0;
  std::uint64_t missed_ = 0;
};

// For binaries: writes to stderr, which takes its time.
class EventPrinter {
 public:
  // `program`: what each line begins with.
  explicit EventPrinter(std::string program) : program_(std::move(program)) {}
  // The oldest ones that were not printed yet, at most 20; true: there are more. Those that the log gave up
  // in the meantime are counted.
  bool print(const EventLog& events);

 private:
  std::string program_;
  std::uint64_t next_ = 0;
};

}  // namespace gaitway::core
