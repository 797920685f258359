// Fixed-size copies of events.
#include "gaitway/manager/event_log.hpp"

#include <algorithm>

namespace gaitway::core {
namespace {

template <std::size_t size>
void copy_text(std::string_view text, std::array<char, size>& to) noexcept {
  const std::size_t length = std::min(text.size(), size - 1);
  std::copy_n(text.begin(), length, to.begin());
  to[length] = '\0';
}

}  // namespace

std::string_view event_kind_name(EventKind kind) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"info", "warning", "error", "fault", "refusal"};
  return kNames[static_cast<std::size_t>(kind)];
}

void EventLog::add(std::int64_t stamp_ns, std::uint32_t tick, EventKind kind, std::string_view source,
                   std::string_view text) noexcept {
  Event& event = ring_[total_ % kCapacity];
  event.stamp_ns = stamp_ns;
  event.tick = tick;
  event.kind = kind;
  copy_text(source, event.source_text);
  copy_text(text, event.message_text);
  ++total_;
}

}  // namespace gaitway::core
