// Messages with given releases on the simulated bus: how long each really took.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/can/response_time.hpp"
#include "gaitway/can/simulated_bus.hpp"
#include "gaitway/can/station_transmitter.hpp"

namespace gaitway::can::test {

// One instance of a message becomes ready to be sent.
struct Release {
  std::int64_t at_ns = 0;
  std::int64_t nominal_ns = 0;  // before its jitter
  std::size_t message = 0;
  Frame frame;
};

// What waits in a station: by identifier, or in the order of releases.
class WaitingFrames {
 public:
  explicit WaitingFrames(bool fifo) : fifo_(fifo) {}
  void push(const Frame& frame) { frames_.push_back(frame); }
  [[nodiscard]] std::uint32_t next_id() const {
    return fifo_ || frames_.empty() ? std::numeric_limits<std::uint32_t>::max() : most_urgent()->id;
  }
  bool take_frame(Frame& frame) {
    if (frames_.empty()) {
      return false;
    }
    const auto next = fifo_ ? frames_.begin() : most_urgent();
    frame = *next;
    frames_.erase(next);
    return true;
  }
  void put_back(const Frame& frame) { frames_.push_front(frame); }

 private:
  [[nodiscard]] std::deque<Frame>::const_iterator most_urgent() const {
    return std::min_element(frames_.begin(), frames_.end(),
                            [](const Frame& a, const Frame& b) { return a.id < b.id; });
  }
  bool fifo_;
  std::deque<Frame> frames_;
};

class BusTraffic {
 public:
  // `station[i]` sends messages[i]; those of one FIFO queue share one station.
  BusTraffic(std::span<const AnalysedMessage> messages, std::span<const int> station,
             std::int64_t bit_time_ns)
      : bus_(bit_time_ns), station_(station.begin(), station.end()), nominal_ns_(messages.size()) {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      keys_.push_back(arbitration_key({.id = messages[i].id, .extended = messages[i].extended}));
      const auto number = static_cast<std::size_t>(station[i]);
      while (stations_.size() <= number) {
        stations_.push_back({StationTransmitter(bus_.attach()), WaitingFrames(false)});
      }
      if (messages[i].fifo) {
        stations_[number].waiting = WaitingFrames(true);
      }
    }
    bus_.attach();  // somebody has to acknowledge
    worst_ns_.assign(messages.size(), std::nullopt);
  }

  SimulatedBus& bus() { return bus_; }

  // Plays the releases, which are ordered by time, and everything that still waits after the last one.
  void play(std::span<const Release> releases) {
    for (const Release& release : releases) {
      run_to(release.at_ns);
      const auto station = static_cast<std::size_t>(station_[release.message]);
      nominal_ns_[release.message].push_back(release.nominal_ns);
      stations_[station].waiting.push(release.frame);
      stations_[station].transmitter.offer(bus_, stations_[station].waiting, release.at_ns);
    }
    run_to(std::numeric_limits<std::int64_t>::max() / 4);
  }

  // From the nominal release to the last bit of end of frame; nothing for messages that never came.
  [[nodiscard]] std::span<const std::optional<std::int64_t>> worst_ns() const { return worst_ns_; }
  [[nodiscard]] std::int64_t delivered() const { return delivered_; }

 private:
  struct Station {
    StationTransmitter transmitter;
    WaitingFrames waiting;
  };
  void run_to(std::int64_t until_ns) {
    while (const auto delivery = bus_.advance(until_ns)) {
      Station& station = stations_[static_cast<std::size_t>(delivery->sender)];
      if (delivery->sent_by(delivery->sender)) {
        finish(*delivery);
      }
      station.transmitter.on_delivery(*delivery);
      station.transmitter.offer(bus_, station.waiting, delivery->end_ns);
    }
  }
  void finish(const SimulatedBus::Delivery& delivery) {
    ++delivered_;
    const auto key = std::find(keys_.begin(), keys_.end(), arbitration_key(delivery.frame));
    const auto message = static_cast<std::size_t>(key - keys_.begin());
    std::deque<std::int64_t>& nominal_ns = nominal_ns_[message];
    std::optional<std::int64_t>& worst_ns = worst_ns_[message];
    worst_ns = std::max(worst_ns.value_or(0), delivery.end_ns - nominal_ns.front());
    nominal_ns.pop_front();
  }

  SimulatedBus bus_;
  std::vector<int> station_;
  std::vector<Station> stations_;
  std::vector<std::uint32_t> keys_;                   // of each message
  std::vector<std::deque<std::int64_t>> nominal_ns_;  // of each message's instances that are not sent yet
  std::vector<std::optional<std::int64_t>> worst_ns_;
  std::int64_t delivered_ = 0;
};

}  // namespace gaitway::can::test
