// Takes the message controller through its milliseconds in order, each with the frames that were on the bus
// before it, however late its process wakes: what it does depends on the robot's time alone, not on when it
// gets round to it.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/msgcontroller/message_controller.hpp"

namespace gaitway::msgcontroller {

class BusTimeline {
 public:
  // Starts with the first millisecond after `now_ns`. Both references outlive it.
  BusTimeline(MessageController& controller, can::BusPort& port, std::int64_t now_ns);

  // All milliseconds up to `now_ns`, which may not run backwards; what waits to be sent is offered to the
  // bus, each frame with its own millisecond. Frames that are later than the bus waits for them, and a slot
  // at least, are dropped and counted: an old SYNC would set the joints' clocks wrong, and whatever else is
  // lost the supervision repairs. Who comes later than a cycle was away: the controller is told that its
  // station was off the bus until now, and lives through that time in a few milliseconds, however long it
  // was. Throws what the port throws.
  void advance_to(std::int64_t now_ns);

  // Waits for a bus that lags behind the clock: advance_to() goes no further before its frames have come.
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  [[nodiscard]] std::int64_t next_ns() const noexcept { return next_ns_; }
  // Milliseconds that were made up for, since advance_to() came too late for them.
  [[nodiscard]] std::uint64_t missed() const noexcept { return missed_; }
  [[nodiscard]] std::uint64_t stale() const noexcept { return stale_; }
  // Times that advance_to() came later than a cycle.
  [[nodiscard]] std::uint64_t absences() const noexcept { return absences_; }

 private:
  void catch_up(std::int64_t now_ns);
  [[nodiscard]] bool is_stale(std::int64_t now_ns) const noexcept;
  void take_frames(std::int64_t until_ns);
  void take_notices(std::int64_t until_ns) noexcept;
  void watch_station(std::int64_t now_ns) noexcept;
  void offer(std::int64_t now_ns, std::int64_t flushed_until_ns);
  [[nodiscard]] bool may_offer(std::int64_t now_ns) const noexcept;
  void drop_frames() noexcept;

  MessageController& controller_;
  can::BusPort& port_;
  std::optional<can::TimedFrame> arrived_;             // its millisecond has not come yet
  std::optional<can::BusNotice> noticed_;              // likewise
  can::BusState state_ = can::BusState::error_active;  // of this station, as the controller knows it
  can::ErrorCounters errors_;
  std::int64_t next_ns_;
  bool waits_ = false;
  bool off_ = false;  // the controller was told that its station is off the bus, whatever the port says
  std::uint64_t missed_ = 0;
  std::uint64_t stale_ = 0;
  std::uint64_t absences_ = 0;
};

}  // namespace gaitway::msgcontroller
