// Keeps the most urgent frame of a station in its one transmit buffer on the simulated bus: a frame that
// waits there gives way to a more urgent one that comes later, so that a low priority never blocks a high one
// of the same station.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated_bus.hpp"

namespace gaitway::can {

// Frames that wait, the most urgent first.
template <class T>
concept FrameSource = requires(T& source, Frame& frame, const Frame& taken) {
  { source.next_id() } -> std::convertible_to<std::uint32_t>;  // past every identifier when none waits
  { source.take_frame(frame) } -> std::convertible_to<bool>;
  source.put_back(taken);  // before all others of its identifier
};

class StationTransmitter {
 public:
  explicit StationTransmitter(int station) noexcept : station_(station) {}

  // To be called when a frame may have been added to `source`, and after each of this station's deliveries.
  template <FrameSource Source>
  void offer(SimulatedBus& bus, Source& source, std::int64_t now_ns) noexcept {
    if (waiting_ && source.next_id() < waiting_->id && bus.abort(station_)) {
      source.put_back(*waiting_);
      waiting_.reset();
    }
    Frame frame;
    if (!waiting_ && source.take_frame(frame)) {
      bus.transmit(station_, frame, now_ns);
      waiting_ = frame;
    }
  }
  // The bus has delivered this station's frame.
  void on_sent() noexcept { waiting_.reset(); }

  [[nodiscard]] int station() const noexcept { return station_; }
  [[nodiscard]] bool pending() const noexcept { return waiting_.has_value(); }

 private:
  int station_;
  std::optional<Frame> waiting_;
};

}  // namespace gaitway::can
