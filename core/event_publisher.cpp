// A few events a tick, so that a flood of them costs no tick.
#include "gaitway/core/event_publisher.hpp"

#include <algorithm>
#include <cstring>

namespace gaitway::core {
namespace {

constexpr std::string_view kTopic = "events";

msgclient::Writer<gaitway::Event> claim(msgclient::Client& client) {
  const auto declared = client.find(kTopic);
  return client.write_stream<gaitway::Event>(kTopic, declared ? 0 : EventPublisher::kStreamCapacity);
}

template <std::size_t size>
void copy_text(std::string_view text, std::uint8_t (&field)[size]) noexcept {
  std::memcpy(field, text.data(), std::min(text.size(), size - 1));
}

gaitway::Event published_form(const Event& event) noexcept {
  gaitway::Event result{};
  result.stamp_ns = event.stamp_ns;
  result.kind = static_cast<std::uint32_t>(event.kind);
  copy_text(event.source(), result.source);
  copy_text(event.text(), result.text);
  return result;
}

}  // namespace

EventPublisher::EventPublisher(msgclient::Client& client) : writer_(claim(client)) {}

void EventPublisher::step(const EventLog& events, std::int64_t now_ns) noexcept {
  if (next_ < events.first()) {
    missed_ += events.first() - next_;
    next_ = events.first();
  }
  for (std::uint32_t i = 0; i < kEventsAStep && next_ < events.total(); ++i, ++next_) {
    writer_.publish(published_form(events[next_]), now_ns);
  }
}

}  // namespace gaitway::core
