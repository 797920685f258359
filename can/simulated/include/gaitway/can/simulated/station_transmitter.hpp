// Keeps the most urgent frame of a station in its one transmit buffer on the simulated bus: a frame that
// waits there gives way to a more urgent one that comes later, so that a low priority never blocks a high one
// of the same station.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"

namespace gaitway::can {

// Frames that wait, the most urgent first.
template <class T>
concept FrameSource = requires(T& source, Frame& frame, const Frame& taken) {
  { source.next_id() } -> std::convertible_to<std::uint32_t>;  // past every identifier when none waits
  { source.take_frame(frame) } -> std::convertible_to<bool>;
  source.put_back(taken);  // before all others of its identifier
};
// One whose frames are not all data frames with an 11-bit identifier also tells the arbitration_key() of the
// next one, or kNoFrameKey.
template <class T>
concept KeyedFrameSource = FrameSource<T> && requires(T& source) {
  { source.next_key() } -> std::convertible_to<std::uint32_t>;
};
inline constexpr std::uint32_t kNoFrameKey = 0xFFFF'FFFF;

class StationTransmitter {
 public:
  explicit StationTransmitter(int station) noexcept : station_(station) {}

  // To be called when a frame may have been added to `source`, and after each of this station's deliveries.
  template <FrameSource Source>
  void offer(SimulatedBus& bus, Source& source, std::int64_t now_ns) noexcept {
    if (waiting_ && !bus.transmit_pending(station_)) {
      waiting_.reset();  // the station's power was off: what it had to send is gone
    }
    if (waiting_ && more_urgent(source)) {
      withdraw(bus, source);
    }
    Frame frame;
    if (!waiting_ && bus.powered(station_) && source.take_frame(frame)) {
      bus.transmit(station_, frame, now_ns);
      waiting_ = frame;
    }
  }
  // Puts the frame that waits in the transmit buffer back into `source`, for example when the station is
  // bus-off and what it has to send would be stale on its return. False: none waits, or it is on the wire.
  template <FrameSource Source>
  bool withdraw(SimulatedBus& bus, Source& source) noexcept {
    if (!waiting_ || !bus.abort(station_)) {
      return false;
    }
    source.put_back(*waiting_);
    waiting_.reset();
    return true;
  }
  // The bus has a delivery, of whatever station: this station's frame may have been sent with it.
  void on_delivery(const SimulatedBus::Delivery& delivery) noexcept {
    if (delivery.sent_by(station_)) {
      waiting_.reset();
    }
  }
  // The bus has sent this station's frame.
  void on_sent() noexcept { waiting_.reset(); }

  [[nodiscard]] int station() const noexcept { return station_; }
  [[nodiscard]] bool pending() const noexcept { return waiting_.has_value(); }

 private:
  template <FrameSource Source>
  [[nodiscard]] bool more_urgent(Source& source) const noexcept {
    if constexpr (KeyedFrameSource<Source>) {
      return source.next_key() < arbitration_key(*waiting_);
    } else {
      return source.next_id() < waiting_->id;
    }
  }

  int station_;
  std::optional<Frame> waiting_;
};

}  // namespace gaitway::can
