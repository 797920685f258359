// The last things that happened in the main controller, in fixed memory: faults, refusals, what plug-ins
// report.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

// Texts in fixed memory, cut off where it ends, and ended by NUL.
inline void copy_text(std::string_view text, std::span<char> to) noexcept {
  const std::size_t length = std::min(text.size(), to.size() - 1);
  std::copy_n(text.begin(), length, to.begin());
  to[length] = '\0';
}
template <std::size_t size, class... Values>
std::string_view format_into(std::array<char, size>& text, fmt::format_string<Values...> form,
                             const Values&... values) noexcept {
  char* const end =
      fmt::format_to_n(text.data(), size - 1, fmt::runtime(fmt::string_view(form)), values...).out;
  *end = '\0';
  return {text.data(), end};
}

enum class EventKind : std::uint8_t { info, warning, error, fault, refusal };
[[nodiscard]] std::string_view event_kind_name(EventKind kind) noexcept;

struct Event {
  std::int64_t stamp_ns = 0;
  std::uint32_t tick = 0;
  EventKind kind = EventKind::info;
  std::array<char, 48> source_text{};  // the plug-in's name, or "main_controller"
  std::array<char, 256> message_text{};

  [[nodiscard]] std::string_view source() const noexcept { return source_text.data(); }
  [[nodiscard]] std::string_view text() const noexcept { return message_text.data(); }
};

// One thread, that of the ticks, adds and reads; any thread posts. Events are copied into fixed memory: no
// allocation, no lock, and nobody waits for anybody. Longer texts are cut off.
class EventLog {
 public:
  static constexpr std::size_t kCapacity = 256;
  static constexpr std::size_t kPosts = 128;  // between two collect()s

  EventLog() noexcept;

  // The tick's thread.
  void add(std::int64_t stamp_ns, std::uint32_t tick, EventKind kind, std::string_view source,
           std::string_view text) noexcept;
  void add(const Tick& tick, EventKind kind, std::string_view source, std::string_view text) noexcept {
    add(tick.now_ns, tick.tick, kind, source, text);
  }
  // Takes up what was posted; add() does so, too. What had no room is counted, and the count becomes an
  // event.
  void collect() noexcept;
  // What is posted from now on bears this time.
  void set_time(const Tick& tick) noexcept {
    now_ns_.store(tick.now_ns, std::memory_order_relaxed);
    tick_.store(tick.tick, std::memory_order_relaxed);
  }
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_.load(std::memory_order_relaxed); }

  // Any thread, several at once.
  void post(EventKind kind, std::string_view source, std::string_view text) noexcept;

  // Of no other log in this process: whoever follows one sees that it is another.
  [[nodiscard]] std::uint64_t serial() const noexcept { return serial_; }
  // The tick's thread: events since start, and which of them are still here: [first(), total()).
  [[nodiscard]] std::uint64_t total() const noexcept { return total_; }
  [[nodiscard]] std::uint64_t first() const noexcept { return total_ > kCapacity ? total_ - kCapacity : 0; }
  [[nodiscard]] const Event& operator[](std::uint64_t number) const noexcept {
    return ring_[number % kCapacity];
  }

 private:
  // Post number n lies in cell n % kPosts. `turn` says whose turn it is there: n, its poster's; n + 1, the
  // collector's, who passes it on to post n + kPosts. Each writes the event before it stores the next turn
  // (release), and reads it after it has seen its own (acquire).
  struct Cell {
    std::atomic<std::uint64_t> turn;
    Event event;
  };

  std::uint64_t serial_;
  std::array<Event, kCapacity> ring_{};
  std::uint64_t total_ = 0;
  std::array<Cell, kPosts> cells_{};
  std::atomic<std::uint64_t> posted_{0};  // relaxed: the cell's turn orders what matters
  std::uint64_t collected_ = 0;
  std::atomic<std::uint64_t> lost_{0};
  std::atomic<std::int64_t> now_ns_{0};
  std::atomic<std::uint32_t> tick_{0};
};

}  // namespace gaitway::core
