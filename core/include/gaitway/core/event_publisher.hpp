// The main controller's list of events as the stream `events`, for whoever is not in its process.
#pragma once

#include <cstdint>

#include "gaitway/manager/event_log.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {

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

}  // namespace gaitway::core
