// Fixed-size copies of events: a ring of the tick's thread, and a bounded queue of many writers in front of
// it.
#include "gaitway/instance/event_log.hpp"

namespace gaitway::core {
namespace {

void fill(Event& event, std::int64_t stamp_ns, std::uint32_t tick, EventKind kind, std::string_view source,
          std::string_view text) noexcept {
  event.stamp_ns = stamp_ns;
  event.tick = tick;
  event.kind = kind;
  copy_text(source, event.source_text);
  copy_text(text, event.message_text);
}

}  // namespace

std::string_view event_kind_name(EventKind kind) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"info", "warning", "error", "fault", "refusal"};
  return kNames[static_cast<std::size_t>(kind)];
}

EventLog::EventLog() noexcept {
  static std::atomic<std::uint64_t> logs{0};
  serial_ = ++logs;
  for (std::size_t i = 0; i < kPosts; ++i) {
    cells_[i].turn.store(i, std::memory_order_relaxed);
  }
}

void EventLog::add(std::int64_t stamp_ns, std::uint32_t tick, EventKind kind, std::string_view source,
                   std::string_view text) noexcept {
  collect();
  fill(ring_[total_ % kCapacity], stamp_ns, tick, kind, source, text);
  ++total_;
}

void EventLog::post(EventKind kind, std::string_view source, std::string_view text) noexcept {
  std::uint64_t number = posted_.load(std::memory_order_relaxed);
  while (true) {
    const std::uint64_t turn = cells_[number % kPosts].turn.load(std::memory_order_acquire);
    if (turn < number) {  // not collected yet
      lost_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    if (turn > number) {  // somebody else took it
      number = posted_.load(std::memory_order_relaxed);
    } else if (posted_.compare_exchange_weak(number, number + 1, std::memory_order_relaxed)) {
      break;
    }
  }
  Cell& cell = cells_[number % kPosts];
  fill(cell.event, now_ns(), tick_.load(std::memory_order_relaxed), kind, source, text);
  cell.turn.store(number + 1, std::memory_order_release);
}

void EventLog::collect() noexcept {
  // No more than the queue holds: whoever posts without end must not keep the tick, nor run over its ring.
  for (std::size_t i = 0; i < kPosts; ++i) {
    Cell& cell = cells_[collected_ % kPosts];
    if (cell.turn.load(std::memory_order_acquire) != collected_ + 1) {
      break;
    }
    ring_[total_ % kCapacity] = cell.event;
    ++total_;
    cell.turn.store(collected_ + kPosts, std::memory_order_release);
    ++collected_;
  }
  if (lost_.load(std::memory_order_relaxed) == 0) {
    return;
  }
  std::array<char, 80> text{};
  fill(ring_[total_ % kCapacity], now_ns(), tick_.load(std::memory_order_relaxed), EventKind::warning,
       "main_controller",
       format_into(text, "{} reports lost: too many between two ticks",
                   lost_.exchange(0, std::memory_order_relaxed)));
  ++total_;
}

}  // namespace gaitway::core
