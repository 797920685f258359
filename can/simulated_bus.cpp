// Arbitration and timing of the simulated bus.
#include "gaitway/can/simulated_bus.hpp"

#include <algorithm>

#include "gaitway/can/frame_length.hpp"

namespace gaitway::can {

SimulatedBus::SimulatedBus(std::int64_t bit_time_ns) : bit_time_ns_(bit_time_ns) {}

int SimulatedBus::attach() {
  stations_.emplace_back();
  return static_cast<int>(stations_.size()) - 1;
}

bool SimulatedBus::transmit(int station, const Frame& frame, std::int64_t now_ns) noexcept {
  Station& sender = stations_[static_cast<std::size_t>(station)];
  if (sender.pending) {
    return false;
  }
  sender = {true, now_ns, frame};
  ++waiting_;
  return true;
}

bool SimulatedBus::transmit_pending(int station) const noexcept {
  return stations_[static_cast<std::size_t>(station)].pending;
}

bool SimulatedBus::abort(int station) noexcept {
  Station& sender = stations_[static_cast<std::size_t>(station)];
  if (!sender.pending || (on_wire_ && on_wire_->sender == station)) {
    return false;
  }
  sender.pending = false;
  --waiting_;
  return true;
}

std::optional<SimulatedBus::Delivery> SimulatedBus::advance(std::int64_t until_ns) noexcept {
  if (!on_wire_) {
    start_next(until_ns);
  }
  if (!on_wire_ || on_wire_->end_ns > until_ns) {
    return std::nullopt;
  }
  const Delivery delivery = *on_wire_;
  on_wire_.reset();
  stations_[static_cast<std::size_t>(delivery.sender)].pending = false;
  free_from_ns_ = delivery.end_ns + kInterframeBits * bit_time_ns_;
  count(delivery);
  return delivery;
}

void SimulatedBus::start_next(std::int64_t until_ns) noexcept {
  if (waiting_ == 0) {
    return;
  }
  std::int64_t earliest_ns = std::numeric_limits<std::int64_t>::max();
  for (const Station& station : stations_) {
    if (station.pending) {
      earliest_ns = std::min(earliest_ns, station.since_ns);
    }
  }
  // Bits start on the bus's own raster.
  const std::int64_t wanted_ns = std::max(earliest_ns, free_from_ns_);
  const std::int64_t start_ns = (wanted_ns + bit_time_ns_ - 1) / bit_time_ns_ * bit_time_ns_;
  if (start_ns >= until_ns) {
    return;  // a more urgent frame may still be offered until then
  }
  int winner = -1;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const Station& station = stations_[i];
    if (station.pending && station.since_ns <= start_ns &&
        (winner < 0 || arbitration_key(station.frame) <
                           arbitration_key(stations_[static_cast<std::size_t>(winner)].frame))) {
      winner = static_cast<int>(i);
    }
  }
  const Frame& frame = stations_[static_cast<std::size_t>(winner)].frame;
  const int bits = frame_bits(frame);
  --waiting_;
  on_wire_ = Delivery{.frame = frame,
                      .sender = winner,
                      .start_ns = start_ns,
                      .end_ns = start_ns + bits * bit_time_ns_,
                      .bits = bits,
                      .lost = loss_ && loss_(frame, start_ns)};
}

void SimulatedBus::count(const Delivery& delivery) noexcept {
  const std::int64_t occupied_ns = (delivery.bits + kInterframeBits) * bit_time_ns_;
  ++statistics_.frames;
  statistics_.lost += delivery.lost ? 1U : 0U;
  statistics_.busy_ns += occupied_ns;
  if (delivery.frame.size == 8) {
    const double length_us = static_cast<double>(occupied_ns) * 1e-3;
    LengthStatistics& lengths = statistics_.eight_byte_us;
    ++lengths.count;
    lengths.sum += length_us;
    lengths.min = std::min(lengths.min, length_us);
    lengths.max = std::max(lengths.max, length_us);
  }
}

}  // namespace gaitway::can
