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

#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"
#include "gaitway/can/simulated/station_transmitter.hpp"

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
  [[nodiscard]] std::uint32_t next_id() const { return frames_.empty() ? kNoFrameKey : most_urgent()->id; }
  // Nothing overtakes in a FIFO queue.
  [[nodiscard]] std::uint32_t next_key() const {
    return fifo_ || frames_.empty() ? kNoFrameKey : arbitration_key(*most_urgent());
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
    return std::min_element(frames_.begin(), frames_.end(), [](const Frame& a, const Frame& b) {
      return arbitration_key(a) < arbitration_key(b);
    });
  }
  bool fifo_;
  std::deque<Frame> frames_;
};

// Corrupts frames and jams the bus as soon and as often as an error model allows, from a given instant on.
class ErrorInjector {
 public:
  ErrorInjector(const ErrorModel& model, std::int64_t from_ns, std::uint64_t seed)
      : model_(model), from_ns_(from_ns), seed_(seed) {}

  void schedule_jams(SimulatedBus& bus, std::int64_t until_ns) const {
    for (const ErrorSource& source : model_) {
      if (source.duration_ns == 0) {
        continue;
      }
      std::int64_t at_ns = from_ns_;
      do {
        bus.jam(JamKind::noise, at_ns, source.duration_ns);
        at_ns += source.interval_ns;
      } while (source.interval_ns > 0 && at_ns < until_ns);
    }
  }
  // To be called more often than frames can follow each other. Whether errors have been signalled since.
  bool step(SimulatedBus& bus, std::int64_t now_ns) {
    bool signalled = false;
    while (const auto error = bus.next_error_frame()) {
      signalled = true;
      if (error->cause == FaultCause::corruption) {
        corrupted_ns_.push_back(error->error_ns);
      }
    }
    while (const auto change = bus.next_state_change()) {
      all_active_ = all_active_ && change->state == BusState::error_active;
    }
    const bool corrupt = now_ns >= from_ns_ && another_is_allowed(now_ns);
    if (corrupt != corrupting_) {
      corrupting_ = corrupt;
      bus.set_random_faults({.seed = ++seed_, .corruption = corrupt ? 1.0 : 0.0});
    }
    return signalled;
  }
  [[nodiscard]] std::size_t corrupted() const { return corrupted_ns_.size(); }
  // No station has become error-passive, which the bounds count on.
  [[nodiscard]] bool all_active() const { return all_active_; }

 private:
  [[nodiscard]] bool another_is_allowed(std::int64_t now_ns) const {
    for (const ErrorSource& source : model_) {
      if (source.duration_ns > 0) {
        continue;
      }
      for (std::size_t k = 0; k < corrupted_ns_.size(); ++k) {
        const auto with_it = static_cast<std::int64_t>(corrupted_ns_.size() - k) + 1;
        if (with_it > source.hits(now_ns - corrupted_ns_[k] + 1)) {
          return false;
        }
      }
      return source.burst > 0;
    }
    return false;
  }

  ErrorModel model_;  // at most one source of corruption and one of jams
  std::int64_t from_ns_;
  std::uint64_t seed_;
  bool corrupting_ = false;
  bool all_active_ = true;
  std::vector<std::int64_t> corrupted_ns_;
};

class BusTraffic {
 public:
  // `station[i]` sends messages[i]; those of one FIFO queue share one station.
  BusTraffic(std::span<const AnalysedMessage> messages, std::span<const int> station,
             std::int64_t bit_time_ns)
      : bus_(bit_time_ns),
        bit_time_ns_(bit_time_ns),
        station_(station.begin(), station.end()),
        nominal_ns_(messages.size()) {
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
  void play(std::span<const Release> releases, ErrorInjector* errors = nullptr) {
    errors_ = errors;
    now_ns_ = releases.front().at_ns;
    if (errors_ != nullptr) {
      errors_->schedule_jams(bus_, releases.back().at_ns);
    }
    for (const Release& release : releases) {
      run_to(release.at_ns);
      const auto station = static_cast<std::size_t>(station_[release.message]);
      nominal_ns_[release.message].push_back(release.nominal_ns);
      stations_[station].waiting.push(release.frame);
      stations_[station].transmitter.offer(bus_, stations_[station].waiting, release.at_ns);
      ++on_their_way_;
    }
    constexpr int kPatience_bits = 10'000;
    while (on_their_way_ > 0) {
      run_to(now_ns_ + kPatience_bits * bit_time_ns_);
    }
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
    constexpr int kStep_bits = 8;  // shorter than an error frame
    while (errors_ != nullptr && now_ns_ < until_ns) {
      deliver(now_ns_);
      if (errors_->step(bus_, now_ns_)) {
        offer_all();
      }
      now_ns_ += kStep_bits * bit_time_ns_;
    }
    deliver(until_ns);
    now_ns_ = until_ns;
  }
  void deliver(std::int64_t until_ns) {
    while (const auto delivery = bus_.advance(until_ns)) {
      if (!delivery->sent_by(delivery->sender)) {
        continue;
      }
      finish(*delivery);
      Station& station = stations_[static_cast<std::size_t>(delivery->sender)];
      station.transmitter.on_sent();
      station.transmitter.offer(bus_, station.waiting, delivery->end_ns);
    }
  }
  // A destroyed frame gives way to a more urgent one of its station that came while it was on the wire.
  void offer_all() {
    for (Station& station : stations_) {
      station.transmitter.offer(bus_, station.waiting, now_ns_);
    }
  }
  void finish(const SimulatedBus::Delivery& delivery) {
    ++delivered_;
    --on_their_way_;
    const auto key = std::find(keys_.begin(), keys_.end(), arbitration_key(delivery.frame));
    const auto message = static_cast<std::size_t>(key - keys_.begin());
    std::deque<std::int64_t>& nominal_ns = nominal_ns_[message];
    std::optional<std::int64_t>& worst_ns = worst_ns_[message];
    worst_ns = std::max(worst_ns.value_or(0), delivery.end_ns - nominal_ns.front());
    nominal_ns.pop_front();
  }

  SimulatedBus bus_;
  std::int64_t bit_time_ns_;
  std::vector<int> station_;
  std::vector<Station> stations_;
  std::vector<std::uint32_t> keys_;                   // of each message
  std::vector<std::deque<std::int64_t>> nominal_ns_;  // of each message's instances that are not sent yet
  std::vector<std::optional<std::int64_t>> worst_ns_;
  std::int64_t delivered_ = 0, on_their_way_ = 0;
  std::int64_t now_ns_ = 0;
  ErrorInjector* errors_ = nullptr;
};

}  // namespace gaitway::can::test
