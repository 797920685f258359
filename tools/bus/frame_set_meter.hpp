// How long the bus needs for one message of every node: the published experiment's "12 messages". A set is
// one frame of each node, in whatever order. A node that comes again before the others have, or a frame that
// comes half a period after the first, begins a new set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "gaitway/can/messages.hpp"
#include "tools/bus/spread.hpp"

namespace gaitway::tools {

class FrameSetMeter {
 public:
  // `nodes`: how many frames make a set. `period_ns`: from set to set.
  FrameSetMeter(std::size_t nodes, std::int64_t period_ns) : nodes_(nodes), period_ns_(period_ns) {}

  // One frame of the message that is metered: its first bit's start, and its length with interframe space.
  void take(can::NodeId node, std::int64_t start_ns, std::int64_t length_ns);

  // Bus time of a set: the sum of its frames, interframe spaces included.
  [[nodiscard]] const Spread& bus_time_ms() const noexcept { return bus_time_ms_; }
  // From the first bit of a set to the end of its last interframe space, of the sets whose frames followed
  // each other without a gap: the same, read from the bus's clock.
  [[nodiscard]] const Spread& back_to_back_ms() const noexcept { return back_to_back_ms_; }
  // From the first bit of a set to the end of its last interframe space, whatever lies in between.
  [[nodiscard]] const Spread& span_ms() const noexcept { return span_ms_; }
  [[nodiscard]] std::uint64_t incomplete() const noexcept { return incomplete_; }

 private:
  std::size_t nodes_;
  std::int64_t period_ns_;
  std::set<can::NodeId> seen_;  // of the set that is under way
  std::int64_t first_ns_ = 0, last_ns_ = 0;
  std::int64_t bus_time_ns_ = 0;
  Spread bus_time_ms_, back_to_back_ms_, span_ms_;
  std::uint64_t incomplete_ = 0;
};

}  // namespace gaitway::tools
