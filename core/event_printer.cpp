// One line an event.
#include "gaitway/core/event_printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "gaitway/input/text.hpp"

namespace gaitway::core {
namespace {

constexpr std::uint64_t kEventsPerPrint = 5;

}  // namespace

void EventPrinter::print(const EventLog& events) {
  next_ = std::max(next_, events.first());
  for (std::uint64_t printed = 0; next_ < events.total() && printed < kEventsPerPrint; ++printed, ++next_) {
    const Event& event = events[next_];
    fmt::print(stderr, "{}: {:.3f} s: {}: {}: {}\n", program_, static_cast<double>(event.stamp_ns) * 1e-9,
               event_kind_name(event.kind), input::terminal_text(event.source()),
               input::terminal_text(event.text()));
  }
  if (next_ < events.total()) {
    fmt::print(stderr, "{}: {} more events\n", program_, events.total() - next_);
    next_ = events.total();
  }
}

}  // namespace gaitway::core
