// What is done to the simulated bus: faults drawn for each frame, and those that have their time.
#include <algorithm>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"

namespace gaitway::can {

void SimulatedBus::set_random_faults(const RandomFaults& faults) noexcept {
  faults_ = faults;
  random_.seed(faults.seed);
}

double SimulatedBus::draw_unit() noexcept {
  return static_cast<double>(random_() >> 11U) * 0x1.0p-53;
}

int SimulatedBus::draw_bit(int first, int last) noexcept {
  return first + static_cast<int>(random_() % static_cast<std::uint64_t>(last - first + 1));
}

StationSet SimulatedBus::draw_some(StationSet from, StationSet all) noexcept {
  StationSet some;
  if (from.empty() || all.size() < 2) {
    return some;
  }
  while (some.empty() || some == all) {
    some = {};
    std::uint64_t bits = 0;
    int left = 0;
    from.for_each([&](int station) {
      if (left == 0) {
        bits = random_();
        left = 64;
      }
      if ((bits & 1U) != 0) {
        some.insert(station);
      }
      bits >>= 1U;
      --left;
    });
  }
  return some;
}

StationSet SimulatedBus::receivers_of(StationSet senders) const noexcept {
  return (present_ - senders).where([&](int station) { return !bitwise_ || at(station).controller.idle(); });
}

SimulatedBus::Plan SimulatedBus::plan_attempt(const Contest& contest, std::int64_t start_ns) noexcept {
  Plan plan;
  const Station& sender = at(contest.winner);
  const Frame& frame = offered(sender);
  plan.lost = loss_ && loss_(frame, start_ns);
  if (sender.forced) {
    const WireFrame wire(frame);
    plan.cause = FaultCause::forced_bus_off;
    plan.flip_bit = draw_bit(wire.arbitration_end(), wire.length() - 2);
    plan.flipped = present_;
  } else if (!plan.lost && (faults_.corruption > 0.0 || faults_.duplicate > 0.0 || faults_.omission > 0.0)) {
    plan_random_fault(plan, frame, receivers_of(contest.tied));
  }
  return plan;
}

void SimulatedBus::plan_random_fault(Plan& plan, const Frame& frame, StationSet receivers) noexcept {
  if (faults_.corruption > 0.0 && draw_unit() < faults_.corruption) {
    plan.cause = FaultCause::corruption;
    plan.flip_bit = draw_bit(1, frame_bits(frame) - 2);
    plan.flipped = present_;
    return;
  }
  if (faults_.duplicate > 0.0 && draw_unit() < faults_.duplicate) {
    // A passive station could not make the sender repeat the frame.
    const StationSet active =
        receivers.where([&](int station) { return state(station) == BusState::error_active; });
    plan.flipped = draw_some(active, receivers);
    if (!plan.flipped.empty()) {
      plan.cause = FaultCause::duplicate;
      plan.flip_bit = frame_bits(frame) - 2;
    }
    return;
  }
  if (faults_.omission > 0.0 && draw_unit() < faults_.omission) {
    plan.omitted = faults_.victims.empty() ? draw_some(receivers, receivers) : faults_.victims & receivers;
  }
}

void SimulatedBus::take_away(const Plan& plan, Delivery& delivery) noexcept {
  if (plan.lost) {
    delivery.receivers = {};
    return;
  }
  const StationSet omitted = delivery.receivers & plan.omitted;
  if (!omitted.empty()) {
    delivery.receivers = delivery.receivers - omitted;
    delivery.lost = delivery.receivers.empty();
    ++statistics_.injected.omissions;
    statistics_.injected.omitted_receptions += static_cast<std::uint64_t>(omitted.size());
  }
}

void SimulatedBus::jam(JamKind kind, std::int64_t from_ns, std::int64_t duration_ns) {
  schedule({.at_ns = from_ns,
            .kind = Action::Kind::jam,
            .station = -1,
            .jam = kind,
            .until_ns = from_ns + duration_ns,
            .frame = {}});
}

void SimulatedBus::babble(int station, const Frame& frame, std::int64_t from_ns, std::int64_t until_ns) {
  Action action{.at_ns = from_ns, .kind = Action::Kind::babble, .station = station, .frame = frame};
  schedule(action);
  action.at_ns = until_ns;
  action.kind = Action::Kind::babble_end;
  schedule(action);
}

void SimulatedBus::force_bus_off(int station, std::int64_t from_ns) {
  schedule({.at_ns = from_ns, .kind = Action::Kind::force_bus_off, .station = station, .frame = {}});
}

void SimulatedBus::power_off(int station, std::int64_t at_ns) {
  schedule({.at_ns = at_ns, .kind = Action::Kind::power_off, .station = station, .frame = {}});
}

void SimulatedBus::power_on(int station, std::int64_t at_ns) {
  schedule({.at_ns = at_ns, .kind = Action::Kind::power_on, .station = station, .frame = {}});
}

void SimulatedBus::schedule(const Action& action) {
  if (action.at_ns <= time_ns_) {
    apply(action);
    return;
  }
  const auto place = std::upper_bound(actions_.begin(), actions_.end(), action.at_ns,
                                      [](std::int64_t at_ns, const Action& a) { return at_ns < a.at_ns; });
  actions_.insert(place, action);
}

void SimulatedBus::apply(const Action& action) noexcept {
  switch (action.kind) {
    case Action::Kind::jam:
      begin_jam(action);
      break;
    case Action::Kind::babble:
      at(action.station).babbling = true;
      at(action.station).babble = action.frame;
      at(action.station).babble_since_ns = time_ns_;
      refresh(action.station);
      break;
    case Action::Kind::babble_end:
      at(action.station).babbling = false;
      refresh(action.station);
      break;
    case Action::Kind::force_bus_off:
      at(action.station).forced = state(action.station) != BusState::bus_off;
      break;
    case Action::Kind::power_off:
      switch_off(action.station);
      break;
    case Action::Kind::power_on:
      switch_on(action.station);
      break;
  }
}

void SimulatedBus::begin_jam(const Action& action) noexcept {
  if (action.until_ns <= time_ns_) {
    return;  // it was over before anybody told
  }
  ++statistics_.injected.jams;
  enter_bits(time_ns_);
  jam_until_ns_ = std::max(jam_until_ns_, action.until_ns);
  if (action.jam == JamKind::stuck_dominant) {
    return;
  }
  StationSet broken, senders;
  const StationSet present = present_;
  present.for_each([&](int station) {
    const bool sending = at(station).controller.sending();
    if (at(station).controller.drown()) {
      broken.insert(station);
      if (sending) {
        senders.insert(station);
      }
    }
  });
  valid_ = {};
  if (!broken.empty()) {
    note_errors(broken, senders, time_ns_);
  }
  present.for_each([&](int station) { follow_state(station, time_ns_); });
}

void SimulatedBus::remove(int station) noexcept {
  enter_bits(time_ns_);
  Station& one = at(station);
  one.powered = false;
  one.pending = false;
  one.babbling = false;
  one.forced = false;
  one.destroyed = false;
  one.babble_on_wire = false;
  one.controller.power_on();  // as it will be
  present_.erase(station);
  valid_.erase(station);
  follow_state(station, time_ns_);
}

void SimulatedBus::switch_off(int station) noexcept {
  if (at(station).powered) {
    ++statistics_.injected.power_offs;
    remove(station);
  }
}

void SimulatedBus::switch_on(int station) noexcept {
  Station& one = at(station);
  if (one.powered) {
    return;
  }
  enter_bits(time_ns_);
  ++statistics_.injected.power_ons;
  one.powered = true;
  one.not_before_ns = time_ns_;
  one.controller.power_on();
  present_.insert(station);
  follow_state(station, time_ns_);
}

}  // namespace gaitway::can
