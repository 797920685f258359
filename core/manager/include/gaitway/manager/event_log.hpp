// The last things that happened in the main controller, in fixed memory: faults, refusals, what plug-ins
// report.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gaitway::core {

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

// add() copies into a ring: no allocation. Longer texts are cut off.
class EventLog {
 public:
  static constexpr std::size_t kCapacity = 256;

  void add(std::int64_t stamp_ns, std::uint32_t tick, EventKind kind, std::string_view source,
           std::string_view text) noexcept;

  // Events since start, and which of them are still here: [first(), total()).
  [[nodiscard]] std::uint64_t total() const noexcept { return total_; }
  [[nodiscard]] std::uint64_t first() const noexcept { return total_ > kCapacity ? total_ - kCapacity : 0; }
  [[nodiscard]] const Event& operator[](std::uint64_t number) const noexcept {
    return ring_[number % kCapacity];
  }

 private:
  std::array<Event, kCapacity> ring_{};
  std::uint64_t total_ = 0;
};

}  // namespace gaitway::core
