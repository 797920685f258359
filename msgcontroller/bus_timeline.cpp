// Frames in, millisecond, frames out; and what becomes of milliseconds that nobody lived through.
#include "gaitway/msgcontroller/bus_timeline.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kCycle_ns;
using facts::kMillisecond_ns;

constexpr std::uint16_t kLargestId = 0x7FF;
// Then no batch can have gone out in time: the joints have gone on by themselves.
constexpr std::int64_t kAway_ns = kCycle_ns;
// After so many cycles whatever was handed over has been played to its end, and one cycle is like the other.
constexpr std::int64_t kLongestPlan_ns = (kMaxPoints / kBatchPoints + 2) * kCycle_ns;

}  // namespace

BusTimeline::BusTimeline(MessageController& controller, can::BusPort& port, std::int64_t now_ns)
    : controller_(controller), port_(port), next_ns_((now_ns / kMillisecond_ns + 1) * kMillisecond_ns) {}

void BusTimeline::advance_to(std::int64_t now_ns) {
  if (next_ns_ <= now_ns && !waits_) {
    missed_ += static_cast<std::uint64_t>((now_ns - next_ns_) / kMillisecond_ns);
  }
  waits_ = false;
  if (now_ns - next_ns_ > kAway_ns) {
    catch_up(now_ns);
  }
  for (; next_ns_ <= now_ns; next_ns_ += kMillisecond_ns) {
    take_frames(next_ns_);
    // Feedback that is judged in another time slot than its own looks wrong, and would be repaired for
    // nothing.
    if (!port_.caught_up(next_ns_ - kMillisecond_ns) && now_ns - next_ns_ < can::kLongestWait_ns) {
      waits_ = true;
      break;
    }
    controller_.on_bus_state(port_.state(), port_.error_counters(), next_ns_);
    controller_.step(next_ns_);
    if (is_stale(now_ns)) {
      drop_frames();
    }
    offer(next_ns_, next_ns_);
  }
  if (!waits_) {
    take_frames(now_ns);
  }
  if (controller_.next_id() <= kLargestId) {
    offer(now_ns, next_ns_ - kMillisecond_ns);  // a repair goes out at once
  }
}

// This process was stopped, or its computer had no time for it. Its station was off the bus then, as far as
// the joints could tell, and so the controller is told; it lives through what the joints have lived through
// without it, and nothing of that goes out.
void BusTimeline::catch_up(std::int64_t now_ns) {
  ++absences_;
  controller_.take_mails(now_ns);  // judged by the clock: a batch that has waited all the while is late
  controller_.on_bus_state(can::BusState::down, {}, next_ns_);
  off_ = true;
  const std::int64_t over_ns = next_ns_ + kLongestPlan_ns;
  while (is_stale(now_ns)) {
    take_frames(next_ns_);
    controller_.step(next_ns_);
    next_ns_ += kMillisecond_ns;
    if (next_ns_ == over_ns) {
      next_ns_ += std::max<std::int64_t>((now_ns - next_ns_) / kCycle_ns - 1, 0) * kCycle_ns;
    }
  }
  off_ = false;
  state_ = port_.state();
  errors_ = port_.error_counters();
  controller_.on_bus_state(state_, errors_, next_ns_);
}

bool BusTimeline::is_stale(std::int64_t now_ns) const noexcept {
  return now_ns - next_ns_ > std::max(port_.longest_wait_ns(), facts::kSlot_ns);
}

void BusTimeline::take_frames(std::int64_t until_ns) {
  while (true) {
    if (!arrived_) {
      arrived_ = port_.receive();
    }
    watch_station(until_ns);
    if (!arrived_ || arrived_->end_ns > until_ns) {
      take_notices(until_ns);
      return;
    }
    controller_.on_frame(arrived_->frame, arrived_->end_ns);
    arrived_.reset();
  }
}

void BusTimeline::take_notices(std::int64_t until_ns) noexcept {
  while (true) {
    if (!noticed_) {
      noticed_ = port_.next_notice();
    }
    if (!noticed_ || noticed_->frame.end_ns > until_ns) {
      return;
    }
    controller_.on_notice(*noticed_);
    noticed_.reset();
  }
}

void BusTimeline::watch_station(std::int64_t now_ns) noexcept {
  const can::BusState state = port_.state();
  const can::ErrorCounters errors = port_.error_counters();
  if (!off_ && (state != state_ || errors != errors_)) {
    state_ = state;
    errors_ = errors;
    controller_.on_bus_state(state, errors, now_ns);
  }
}

// Some ports confirm a frame at once, and can take the next one then.
void BusTimeline::offer(std::int64_t now_ns, std::int64_t flushed_until_ns) {
  bool accepted = true;
  do {
    can::Frame frame;
    accepted = false;
    while (may_offer(now_ns) && controller_.take_frame(frame)) {
      if (!port_.transmit(frame, now_ns)) {
        controller_.put_back(frame);
        break;
      }
      accepted = true;
    }
    port_.flush(flushed_until_ns);
  } while (accepted && controller_.next_id() <= kLargestId && !port_.transmit_pending());
}

bool BusTimeline::may_offer(std::int64_t now_ns) const noexcept {
  return port_.takes_back() || controller_.next_finds_quiet_bus(now_ns);
}

void BusTimeline::drop_frames() noexcept {
  can::Frame frame;
  while (controller_.take_frame(frame)) {
    ++stale_;
  }
}

}  // namespace gaitway::msgcontroller
