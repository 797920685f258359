// A main controller's events on their way to others: what its network's counters have to tell, the stream
// `events` for other processes, lines on stderr for people, lines in a file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "gaitway/instance/event_log.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/background_log.hpp"

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

// When the message controller falls silent, and when it is back. Silence is counted in ticks: who was away
// itself has heard nobody.
class SilenceEvents {
 public:
  static constexpr int kSilentTicks = 5;

  // Once a tick, with the newest state that there is. Calls `report(kind, text)`. No allocation.
  template <class Report>
  void follow(const NetworkState& newest, std::int64_t now_ns, Report report) noexcept {
    std::array<char, 200> text{};
    const bool was_silent = is_silent();
    const std::size_t length = describe(newest, now_ns, text);
    if (length > 0) {
      report(was_silent ? EventKind::info : EventKind::warning, std::string_view(text.data(), length));
    }
  }

 private:
  [[nodiscard]] bool is_silent() const noexcept { return ticks_ >= kSilentTicks; }
  // Length of the text; 0: nothing new.
  std::size_t describe(const NetworkState& newest, std::int64_t now_ns, std::array<char, 200>& text) noexcept;

  std::int64_t stamp_ns_ = 0;  // of the newest state so far
  int ticks_ = 0;              // without a newer one
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

// An event as one line of JSON, for files: {"time_s":1.234,"kind":"fault","source":"zmp","text":"…"}.
void append_event_line(std::string& out, const Event& event);

// For binaries in virtual time: writes to stderr, which takes its time.
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

// The same for a process in real time, which neither terminal nor disk may hold: both are written by threads
// of their own.
class EventLines {
 public:
  // `file`: gets a line of JSON an event, after those that are there: a process that was started again goes
  // on. 16 MiB at most, and FILE.1 with those before them. Empty: none. `on_terminal`: lines on stderr, as
  // EventPrinter's, but with date and time. Throws std::runtime_error naming a file that cannot be written.
  EventLines(const std::string& program, const std::filesystem::path& file, bool on_terminal);

  // The ticks' thread, after each: the oldest that were not taken up yet, at most 20; true: there are more.
  bool step(const EventLog& events);
  // Takes up all that is left, and ends: what the file has got, and what was lost.
  process::LogCount end(const EventLog& events);

 private:
  std::string program_;
  std::unique_ptr<process::BackgroundLog> terminal_, file_;
  std::uint64_t next_ = 0, missed_ = 0;
};

}  // namespace gaitway::core
