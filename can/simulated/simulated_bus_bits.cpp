// The simulated bus while something is wrong: all stations bit by bit, until all of them are idle again.
#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"

namespace gaitway::can {
std::optional<SimulatedBus::Delivery> SimulatedBus::advance_bits(std::int64_t stop_ns) noexcept {
  while (true) {
    const std::int64_t start_ns = edge_ns(bit_);
    if (quiet(start_ns)) {
      leave_bits(start_ns);
      return std::nullopt;
    }
    if (start_ns < stop_ns) {
      begin_attempts(start_ns);
    }
    if (edge_ns(bit_ + 1) > stop_ns) {
      return std::nullopt;
    }
    if (const auto delivery = step_bit()) {
      return delivery;
    }
  }
}

bool SimulatedBus::quiet(std::int64_t start_ns) const noexcept {
  bool quiet = jam_until_ns_ <= start_ns;
  present_.for_each([&](int station) { quiet = quiet && at(station).controller.idle(); });
  return quiet;
}

// The bit that contains `now_ns` is the next; what came before has happened.
void SimulatedBus::enter_bits(std::int64_t now_ns) noexcept {
  if (bitwise_) {
    return;
  }
  bitwise_ = true;
  if (on_wire_) {
    const auto winner = static_cast<std::size_t>(on_wire_->sender);
    const Contest contest{on_wire_->sender, StationSet::of(on_wire_->sender)};
    StationSet starters = contest.tied;
    contending_.for_each([&](int station) {
      const auto place = static_cast<std::size_t>(station);
      if (ready_ns_[place] <= on_wire_->start_ns && key_[place] > key_[winner]) {
        starters.insert(station);  // it has lost, or is about to
      }
    });
    const bool babble = at(on_wire_->sender).babble_on_wire;
    begin_attempt(contest, starters, on_wire_->start_ns, on_wire_plan_);
    // What the sender has to send may be something else by now.
    at(on_wire_->sender).babble_on_wire = babble;
    at(on_wire_->sender).controller.start_sending(on_wire_->frame);
    attempt_.frame = on_wire_->frame;
    on_wire_.reset();
    while (edge_ns(bit_ + 1) <= now_ns) {
      step_bit();  // delivers nothing: the frame's end is still to come
    }
    return;
  }
  if (now_ns >= free_from_ns_) {
    anchor_ns_ = free_from_ns_ + (now_ns - free_from_ns_) / bit_time_ns_ * bit_time_ns_;
    anchor_drift_ = 0.0;
    bit_ = 0;
    return;
  }
  anchor_ns_ = last_start_ns_;
  anchor_drift_ = last_drift_;
  bit_ = last_bits_;
  while (edge_ns(bit_ + 1) <= now_ns) {
    ++bit_;
  }
  statistics_.busy_ns -= free_from_ns_ - edge_ns(bit_);  // is counted again, bit by bit
  const int passed = static_cast<int>(bit_) - last_bits_;
  present_.for_each(
      [&](int station) { at(station).controller.enter_intermission(passed, station == last_sender_); });
}

void SimulatedBus::leave_bits(std::int64_t now_ns) noexcept {
  bitwise_ = false;
  free_from_ns_ = now_ns;
  attempt_.open = false;
  error_open_ = false;
  counting_ = unclean(present_);
}

void SimulatedBus::begin_attempts(std::int64_t start_ns) noexcept {
  if (attempt_.open && bit_ == 0) {
    return;  // it has begun with this bit
  }
  const StationSet starters = (contending_ & present_).where([&](int station) {
    return at(station).controller.idle() && ready_ns_[static_cast<std::size_t>(station)] <= start_ns;
  });
  if (!starters.empty()) {
    const Contest round = contest(starters, start_ns);
    begin_attempt(round, starters, start_ns, plan_attempt(round, start_ns));
  }
}

void SimulatedBus::begin_attempt(const Contest& contest, StationSet starters, std::int64_t start_ns,
                                 const Plan& plan) noexcept {
  starters.for_each([&](int station) {
    Station& sender = at(station);
    sender.babble_on_wire = sender.babbling;
    sender.controller.start_sending(offered(sender));
    if (contest.tied.contains(station)) {
      statistics_.retransmissions += sender.destroyed ? 1U : 0U;
      sender.destroyed = false;
    }
  });
  attempt_ = Attempt{.open = true,
                     .flipped = false,
                     .collides = !(contest.tied == StationSet::of(contest.winner)),
                     .sender = contest.winner,
                     .frame = at(contest.winner).controller.frame(),
                     .start_ns = start_ns,
                     .plan = plan};
  error_open_ = false;
  anchor_ns_ = start_ns;
  anchor_drift_ = at(contest.winner).drift;
  bit_ = 0;
}

void SimulatedBus::skip_to_flip(std::int64_t stop_ns) noexcept {
  BitStation& sender = at(attempt_.sender).controller;
  const int flip_bit = attempt_.plan.flip_bit;
  if (detail_ == Detail::bits || attempt_.collides || flip_bit <= sender.wire().arbitration_end() ||
      edge_ns(flip_bit) > stop_ns) {
    return;
  }
  FrameReader reader;
  for (int bit = 0; bit < flip_bit; ++bit) {
    reader.take(sender.wire().dominant(bit));
  }
  sender.skip_sending(flip_bit);
  (present_ - StationSet::of(attempt_.sender)).for_each([&](int station) {
    at(station).controller.follow(reader);
  });
  bit_ = flip_bit;
  statistics_.busy_ns += edge_ns(flip_bit) - attempt_.start_ns;
}

bool SimulatedBus::drive(std::int64_t start_ns, std::int64_t end_ns) noexcept {
  bool dominant = jam_until_ns_ > start_ns;
  bool busy = dominant;
  present_.for_each([&](int station) {
    const BitStation& controller = at(station).controller;
    dominant = dominant || controller.drives_dominant();
    busy = busy || !(controller.idle() || controller.waits_for_silence());
  });
  statistics_.busy_ns += busy ? end_ns - start_ns : 0;
  return dominant;
}

bool SimulatedBus::flip_due() noexcept {
  if (!attempt_.open || bit_ != attempt_.plan.flip_bit) {
    return false;
  }
  attempt_.flipped = true;
  InjectedFaults& injected = statistics_.injected;
  injected.corruptions += attempt_.plan.cause == FaultCause::corruption ? 1U : 0U;
  injected.forced_failures += attempt_.plan.cause == FaultCause::forced_bus_off ? 1U : 0U;
  return true;
}

std::optional<SimulatedBus::Delivery> SimulatedBus::step_bit() noexcept {
  const std::int64_t end_ns = edge_ns(bit_ + 1);
  const bool dominant = drive(edge_ns(bit_), end_ns);
  const StationSet inverted = flip_due() ? attempt_.plan.flipped : StationSet{};
  const bool last_bit = !valid_.empty();
  bool goes_on = false;  // a frame, or an error
  StationSet sent, failed, failed_senders;
  StationSet counted;  // stations whose error counters may have changed
  const StationSet present = present_;
  present.for_each([&](int station) {
    Station& one = at(station);
    const bool sending = one.controller.sending();
    const bool in_frame = one.controller.in_frame();
    const bool signalled = one.controller.signals_error();
    const BitStation::Event event = one.controller.sample(dominant != inverted.contains(station));
    goes_on = goes_on || one.controller.signals_error() || one.controller.in_frame();
    if (signalled || event != BitStation::Event::none) {
      counted.insert(station);
    }
    if (event == BitStation::Event::valid) {
      valid_.insert(station);
    } else if (event == BitStation::Event::sent) {
      sent.insert(station);
    } else if (event == BitStation::Event::suspend) {
      one.not_before_ns = end_ns + duration_ns(kSuspendBits, one.drift);
      refresh(station);
    } else if (event == BitStation::Event::recovered) {
      ++statistics_.recoveries;
    } else if (event == BitStation::Event::error && in_frame) {
      failed.insert(station);
      if (sending) {
        failed_senders.insert(station);
      }
    }
  });
  if (!failed.empty()) {
    note_errors(failed, failed_senders, end_ns);
  }
  counted.for_each([&](int station) { follow_state(station, end_ns); });
  error_open_ = error_open_ && goes_on;
  ++bit_;
  follow_sender();
  if (last_bit || !sent.empty()) {
    return deliver(sent, end_ns);
  }
  return std::nullopt;
}

FaultCause SimulatedBus::cause_of(ErrorKind kind, StationSet senders) noexcept {
  if (jam_until_ns_ > edge_ns(bit_)) {
    statistics_.injected.jammed_frames += attempt_.open ? 1U : 0U;
    return FaultCause::jam;
  }
  if (attempt_.open && attempt_.flipped) {
    return attempt_.plan.cause;
  }
  if (kind == ErrorKind::acknowledge && !senders.empty()) {
    ++statistics_.unacknowledged;
    return FaultCause::no_acknowledge;
  }
  if (attempt_.open && attempt_.collides && !senders.empty()) {
    ++statistics_.collisions;
    return FaultCause::collision;
  }
  return FaultCause::consequence;
}

void SimulatedBus::note_errors(StationSet failed, StationSet senders, std::int64_t end_ns) noexcept {
  senders.for_each([&](int station) { at(station).destroyed = at(station).pending || at(station).babbling; });
  if (error_open_) {
    return;
  }
  error_open_ = true;
  const bool told_by_sender = attempt_.sender >= 0 && senders.contains(attempt_.sender);
  const int witness = told_by_sender ? attempt_.sender : senders.empty() ? failed.lowest() : senders.lowest();
  ErrorFrame error;
  error.kind = at(witness).controller.error_kind();
  error.cause = cause_of(error.kind, senders);
  error.detected_by = failed.lowest();
  error.error_ns = end_ns;
  error.start_ns = end_ns;
  if (attempt_.open) {
    error.frame = attempt_.frame;
    error.sender = attempt_.sender;
    error.sender_counters = error_counters(attempt_.sender);
    error.start_ns = attempt_.start_ns;
    error.bit = static_cast<int>(bit_);
  }
  attempt_.open = false;
  ++statistics_.error_frames;
  error_frames_.push(error);
  statistics_.error_frames_dropped = error_frames_.dropped();
}

// A frame whose first sender failed may go on: a passive station cannot stop the others.
void SimulatedBus::follow_sender() noexcept {
  if (attempt_.sender < 0 || at(attempt_.sender).controller.sending()) {
    return;
  }
  int other = -1;
  present_.for_each(
      [&](int station) { other = other < 0 && at(station).controller.sending() ? station : other; });
  if (other >= 0) {
    attempt_.sender = other;
    attempt_.frame = at(other).controller.frame();
  }
}

SimulatedBus::Delivery SimulatedBus::deliver(StationSet sent, std::int64_t end_ns) noexcept {
  Delivery delivery{.frame = attempt_.frame,
                    .sender = sent.empty() ? attempt_.sender : sent.lowest(),
                    .start_ns = attempt_.start_ns,
                    .end_ns = end_ns,
                    .bits = static_cast<int>(bit_),
                    .lost = attempt_.plan.lost,
                    .receivers = valid_,
                    .senders = {}};
  valid_ = {};
  attempt_.open = false;
  take_away(attempt_.plan, delivery);
  if (sent.empty()) {
    statistics_.injected.duplicates += at(attempt_.sender).destroyed ? 1U : 0U;
    return delivery;
  }
  sent.for_each([&](int station) { settle_sender(station, delivery); });
  statistics_.merged += sent.size() > 1 ? 1U : 0U;
  count_sent(delivery, edge_ns(bit_ + kInterframeBits) - delivery.start_ns);
  return delivery;
}

}  // namespace gaitway::can
