// The simulated bus: its stations, and the course of whole frames (arbitration, timing) while nothing is
// wrong.
#include "gaitway/can/simulated/simulated_bus.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace gaitway::can {
SimulatedBus::SimulatedBus(std::int64_t bit_time_ns, Detail detail)
    : bit_time_ns_(bit_time_ns), detail_(detail), random_(faults_.seed) {
  stations_.reserve(kMaximumStations);
  detached_.reserve(kMaximumStations);
}

int SimulatedBus::attach() {
  int station = static_cast<int>(stations_.size());
  if (!detached_.empty()) {
    station = detached_.back();
    detached_.pop_back();
    at(station) = Station{};
  } else if (station == kMaximumStations) {
    throw std::length_error("simulated bus: a further station beside " + std::to_string(kMaximumStations) +
                            " others; detach one that is not needed");
  } else {
    stations_.emplace_back();
  }
  present_.insert(station);
  if (bitwise_) {
    at(station).controller.power_on();  // it gets in step first
  }
  return station;
}

void SimulatedBus::detach(int station) noexcept {
  remove(station);
  detached_.push_back(station);
}

void SimulatedBus::detach_sent(std::vector<int>& leaving) noexcept {
  std::erase_if(leaving, [this](int station) {
    abort(station);
    const bool done = !transmit_pending(station);
    if (done) {
      detach(station);
    }
    return done;
  });
}

bool SimulatedBus::transmit(int station, const Frame& frame, std::int64_t now_ns) noexcept {
  Station& sender = at(station);
  if (sender.pending || !sender.powered) {
    return false;
  }
  sender.pending = true;
  sender.since_ns = now_ns;
  sender.frame = frame;
  refresh(station);
  return true;
}

bool SimulatedBus::transmit_pending(int station) const noexcept {
  return at(station).pending;
}

bool SimulatedBus::abort(int station) noexcept {
  Station& sender = at(station);
  // A station that is still in an arbitration which it cannot win has nothing on the wire.
  const bool on_wire = bitwise_ ? sender.controller.sending() && arbitration_key(sender.controller.frame()) ==
                                                                     arbitration_key(attempt_.frame)
                                : on_wire_ && on_wire_->sender == station;
  if (!sender.pending || (on_wire && !sender.babble_on_wire)) {
    return false;
  }
  sender.pending = false;
  sender.destroyed = false;
  refresh(station);
  return true;
}

BusState SimulatedBus::state(int station) const noexcept {
  const Station& one = at(station);
  return one.powered ? one.controller.confinement().state() : BusState::down;
}

ErrorCounters SimulatedBus::error_counters(int station) const noexcept {
  return at(station).controller.confinement().counters();
}

void SimulatedBus::set_recovery(int station, Recovery recovery) noexcept {
  at(station).recovery = recovery;
}

void SimulatedBus::set_clock_drift(int station, double ppm) noexcept {
  at(station).drift = ppm * 1e-6;
}

bool SimulatedBus::recover(int station) noexcept {
  Station& one = at(station);
  if (state(station) != BusState::bus_off || one.controller.recovering()) {
    return false;
  }
  enter_bits(time_ns_);
  one.controller.recover();
  present_.insert(station);
  return true;
}

std::int64_t SimulatedBus::duration_ns(std::int64_t bits, double drift) const noexcept {
  const std::int64_t nominal_ns = bits * bit_time_ns_;
  return drift == 0.0 ? nominal_ns : nominal_ns + std::llround(static_cast<double>(nominal_ns) * drift);
}

void SimulatedBus::refresh(int station) noexcept {
  const Station& one = at(station);
  const bool able = one.powered && one.controller.confinement().state() != BusState::bus_off;
  if (!able || !(one.pending || one.babbling)) {
    contending_.erase(station);
    return;
  }
  const auto place = static_cast<std::size_t>(station);
  contending_.insert(station);
  key_[place] = arbitration_key(offered(one));
  ready_ns_[place] = std::max(one.babbling ? one.babble_since_ns : one.since_ns, one.not_before_ns);
}

void SimulatedBus::follow_state(int station, std::int64_t time_ns) noexcept {
  Station& one = at(station);
  const BusState now = state(station);
  if (now == one.told) {
    return;
  }
  one.told = now;
  state_changes_.push({station, now, error_counters(station), time_ns});
  statistics_.state_changes_dropped = state_changes_.dropped();
  if (now == BusState::bus_off) {
    ++statistics_.bus_offs;
    statistics_.injected.forced_bus_offs += one.forced ? 1U : 0U;
    one.forced = false;
    present_.erase(station);
    if (one.recovery == Recovery::automatic) {
      one.controller.recover();
      present_.insert(station);
    }
  }
  refresh(station);
}

std::optional<SimulatedBus::Delivery> SimulatedBus::advance(std::int64_t until_ns) noexcept {
  while (true) {
    const bool action_due = !actions_.empty() && actions_.front().at_ns <= until_ns;
    const std::int64_t stop_ns = action_due ? actions_.front().at_ns : until_ns;
    bool changed = true;
    while (changed) {
      const bool before = bitwise_;
      if (const auto delivery = bitwise_ ? advance_bits(stop_ns) : advance_frames(stop_ns)) {
        time_ns_ = std::max(time_ns_, delivery->end_ns);
        return delivery;
      }
      changed = bitwise_ != before;
    }
    time_ns_ = std::max(time_ns_, stop_ns);
    if (!action_due) {
      return std::nullopt;
    }
    const Action action = actions_.front();
    actions_.erase(actions_.begin());
    apply(action);
  }
}

std::optional<SimulatedBus::Delivery> SimulatedBus::advance_frames(std::int64_t stop_ns) noexcept {
  if (!on_wire_) {
    start_next(stop_ns);
  }
  if (!on_wire_ || on_wire_->end_ns > stop_ns) {
    return std::nullopt;
  }
  return finish_frame();
}

SimulatedBus::Contest SimulatedBus::contest(StationSet candidates, std::int64_t start_ns) const noexcept {
  Contest contest;
  std::uint32_t best = std::numeric_limits<std::uint32_t>::max();
  bool tie = false;
  candidates.for_each([&](int station) {
    const auto place = static_cast<std::size_t>(station);
    if (ready_ns_[place] <= start_ns && key_[place] <= best) {
      tie = contest.winner >= 0 && key_[place] == best;
      contest.winner = tie ? contest.winner : station;
      best = key_[place];
    }
  });
  if (tie) {
    contest.tied = candidates.where([&](int station) {
      const auto place = static_cast<std::size_t>(station);
      return ready_ns_[place] <= start_ns && key_[place] == best;
    });
  } else if (contest.winner >= 0) {
    contest.tied.insert(contest.winner);
  }
  return contest;
}

void SimulatedBus::start_next(std::int64_t stop_ns) noexcept {
  if (contending_.empty()) {
    return;
  }
  std::int64_t start_ns = free_from_ns_;
  Contest round = contest(contending_, start_ns);
  if (round.winner < 0) {
    // An idle bus: bits begin on the raster of the last ones.
    std::int64_t earliest_ns = std::numeric_limits<std::int64_t>::max();
    contending_.for_each([&](int station) {
      earliest_ns = std::min(earliest_ns, ready_ns_[static_cast<std::size_t>(station)]);
    });
    start_ns += (earliest_ns - free_from_ns_ + bit_time_ns_ - 1) / bit_time_ns_ * bit_time_ns_;
  }
  if (start_ns >= stop_ns) {
    return;  // a more urgent frame may still be offered until then
  }
  if (round.winner < 0) {
    round = contest(contending_, start_ns);
  }
  Station& sender = at(round.winner);
  const Plan plan = plan_attempt(round, start_ns);
  const StationSet receivers = present_ - round.tied;
  if (!(round.tied == StationSet::of(round.winner)) || receivers.empty() || plan.flip_bit >= 0 ||
      detail_ == Detail::bits) {
    const StationSet starters = contending_.where(
        [&](int station) { return ready_ns_[static_cast<std::size_t>(station)] <= start_ns; });
    bitwise_ = true;
    begin_attempt(round, starters, start_ns, plan);
    skip_to_flip(stop_ns);
    return;
  }
  const Frame& frame = offered(sender);
  const int bits = frame_bits(frame);
  statistics_.retransmissions += sender.destroyed ? 1U : 0U;
  sender.destroyed = false;
  sender.babble_on_wire = sender.babbling;
  on_wire_ = Delivery{.frame = frame,
                      .sender = round.winner,
                      .start_ns = start_ns,
                      .end_ns = start_ns + duration_ns(bits, sender.drift),
                      .bits = bits,
                      .lost = plan.lost,
                      .receivers = receivers,
                      .senders = {}};
  on_wire_plan_ = plan;
}

StationSet SimulatedBus::unclean(StationSet stations) const noexcept {
  return stations.where([&](int station) { return !at(station).controller.confinement().clean(); });
}

SimulatedBus::Delivery SimulatedBus::finish_frame() noexcept {
  Delivery delivery = *on_wire_;
  on_wire_.reset();
  Station& sender = at(delivery.sender);
  free_from_ns_ = delivery.start_ns + duration_ns(delivery.bits + kInterframeBits, sender.drift);
  last_start_ns_ = delivery.start_ns;
  last_sender_ = delivery.sender;
  last_bits_ = delivery.bits;
  last_drift_ = sender.drift;
  if (!counting_.empty()) {
    // Receivers have the frame with the last but one bit.
    const std::int64_t valid_ns = delivery.start_ns + duration_ns(delivery.bits - 1, sender.drift);
    (counting_ & delivery.receivers).for_each([&](int station) {
      at(station).controller.count_received();
      follow_state(station, valid_ns);
    });
    sender.controller.count_sent();
    follow_state(delivery.sender, delivery.end_ns);
    counting_ = unclean(counting_);
    if (state(delivery.sender) == BusState::error_passive) {
      sender.not_before_ns = free_from_ns_ + duration_ns(kSuspendBits, sender.drift);
    }
  }
  take_away(on_wire_plan_, delivery);
  settle_sender(delivery.sender, delivery);
  const std::int64_t occupied_ns = free_from_ns_ - delivery.start_ns;
  statistics_.busy_ns += occupied_ns;
  count_sent(delivery, occupied_ns);
  return delivery;
}

void SimulatedBus::settle_sender(int station, Delivery& delivery) noexcept {
  Station& sender = at(station);
  sender.destroyed = false;
  if (sender.babble_on_wire) {
    sender.babble_on_wire = false;
    ++statistics_.injected.babbled_frames;
  } else {
    sender.pending = false;
    delivery.senders.insert(station);
  }
  refresh(station);
}

void SimulatedBus::count_sent(const Delivery& delivery, std::int64_t occupied_ns) noexcept {
  ++statistics_.frames;
  statistics_.lost += delivery.lost ? 1U : 0U;
  if (delivery.frame.size == 8 && !delivery.frame.remote) {
    const double length_us = static_cast<double>(occupied_ns) * 1e-3;
    LengthStatistics& lengths = statistics_.eight_byte_us;
    ++lengths.count;
    lengths.sum += length_us;
    lengths.min = std::min(lengths.min, length_us);
    lengths.max = std::max(lengths.max, length_us);
  }
}

}  // namespace gaitway::can
