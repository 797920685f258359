// Plays a joint's points: which slot of which batch, or of its tail, is on, and what a repair or a lost SYNC
// changes.
#include "gaitway/localcontroller/point_player.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr int kLastSlot = can::kBatchPoints - 1;
// A segment is not made shorter than this, so that making up for lost time is no jump.
constexpr std::int64_t kShortestSegment_ns = facts::kMillisecond_ns;
// Until the joint takes the next slot without SYNC: it does so in a servo step, and those are 1 ms apart.
constexpr std::int64_t kLongestCoast_ns = kSyncGrace_ns + facts::kMillisecond_ns;
// The message controller gives a batch up whose SYNC has not left after four slots. One that comes later has
// waited in a port that could not take it back, for as long as the bus was gone.
constexpr std::int64_t kGivenUp_ns = 4 * facts::kSlot_ns + facts::kSlot_ns / 2;

}  // namespace

void PointPlayer::on_trajectory(const can::Trajectory& batch) noexcept {
  const bool repetition = running_ && batch.toggle == executing_toggle_;
  if (repetition || frozen_) {
    return;
  }
  pending_ = batch.delta;
  pending_toggle_ = batch.toggle;
  has_pending_ = true;
  pending_is_stale_ = false;
}

bool PointPlayer::start(const can::Trajectory& batch, std::int64_t now_ns) noexcept {
  // CAN may deliver a frame twice, at once after each other; no toggle tells in a profile without SYNC.
  const bool repetition =
      running_ && slot_ == 0 && now_ns - slot_start_ns_ < facts::kSlot_ns / 2 && batch.delta == executing_;
  if (frozen_ || repetition) {
    return false;
  }
  if (running_) {
    make_up_until(can::kBatchPoints);
  }
  const bool answered = synchronised_ && now_ns - slot_start_ns_ < facts::kSlot_ns / 2;
  executing_ = batch.delta;
  running_ = true;
  synchronised_ = true;
  reference_confirmed_ = true;
  begin_slot(0, now_ns, now_ns);
  return !answered;
}

void PointPlayer::on_resynchronisation(const can::Resynchronisation& repair) noexcept {
  if (!frozen_ && repair.slot > slot_) {
    repair_ = repair;
    has_repair_ = true;
  }
}

bool PointPlayer::on_sync(const can::Sync& sync, std::int64_t now_ns) noexcept {
  if (synchronised_ && sync.cycle == sync_cycle_ && sync.slot == sync_slot_) {
    return false;  // CAN may deliver a frame twice
  }
  synchronised_ = true;
  sync_cycle_ = sync.cycle;
  sync_slot_ = sync.slot;
  if (running_ && !in_tail_ && sync.cycle != batch_cycle_) {
    make_up_until(can::kBatchPoints);  // where the SYNC that ended the batch was lost
    running_ = take_up_tail();
  }
  tail_.on_sync(sync);
  drop_stale_batch(sync, now_ns);
  if (sync.slot == 0) {
    if (!start_batch(sync) && in_tail_) {
      return follow_tail(sync, now_ns);
    }
    begin_slot(0, now_ns, now_ns);
    return true;
  }
  if (apply_repair(sync, now_ns)) {
    return true;
  }
  if (in_tail_) {
    return follow_tail(sync, now_ns);
  }
  if (running_) {
    if (sync.slot <= slot_) {
      return false;  // taken already, when the SYNC was overdue
    }
    make_up_until(sync.slot);
  }
  begin_slot(sync.slot, now_ns, now_ns);
  return true;
}

// Slots whose SYNC was lost count, too: their points are made up for within the slot that begins.
void PointPlayer::make_up_until(int slot) noexcept {
  for (int missed = slot_ + 1; missed < slot; ++missed) {
    count_ = within_limits(count_ + executing_[static_cast<std::size_t>(missed)]);
  }
}

bool PointPlayer::apply_repair(const can::Sync& sync, std::int64_t now_ns) noexcept {
  if (!has_repair_ || sync.slot != repair_.slot) {
    return false;
  }
  has_repair_ = false;
  if (sync.batch_committed && sync.toggle != repair_.toggle) {
    return false;  // it was for a batch that is over
  }
  running_ = sync.batch_committed;
  in_tail_ = left_by_tail_ = false;
  reference_confirmed_ = true;
  executing_toggle_ = repair_.toggle;
  batch_cycle_ = sync.cycle;
  if (pending_toggle_ == repair_.toggle) {
    has_pending_ = false;  // the batch that is repaired came too late to be started
  } else if (!has_pending_) {
    pending_toggle_ = repair_.toggle;  // else the loss of the next batch's frame would look like its arrival
  }
  executing_[repair_.slot] = 0;  // the way to the repair's count is none of the batch's points
  std::size_t slot = std::size_t{repair_.slot} + 1;
  for (std::size_t k = 0; k < repair_.delta.size() && slot < executing_.size(); ++k, ++slot) {
    executing_[slot] = repair_.delta[k];
  }
  enter_slot(sync.slot, now_ns);
  begin_segment(repair_.count, now_ns, facts::kSlot_ns);
  return true;
}

bool PointPlayer::start_batch(const can::Sync& sync) noexcept {
  // Only a SYNC says that every joint's frame was sent and which toggle it bears; without it this joint would
  // move alone.
  has_repair_ = false;
  const bool starts = sync.batch_committed && has_pending_ && pending_toggle_ == sync.toggle;
  if (starts && left_by_tail_) {
    count_ = count_before_tail_point(slots_since_batch(sync));  // however late this SYNC is
    in_tail_ = left_by_tail_ = false;
  }
  running_ = starts || in_tail_;
  if (starts) {
    executing_ = pending_;
    executing_toggle_ = pending_toggle_;
    batch_cycle_ = sync.cycle;
    reference_confirmed_ = true;
  }
  if (sync.batch_committed) {
    // Started, or passed over: toggles alternate, so a later commit of this toggle would mean another batch.
    has_pending_ = false;
    pending_toggle_ = sync.toggle;
  }
  return starts;
}

// The batch is over. True when points follow it that this joint has.
bool PointPlayer::take_up_tail() noexcept {
  tail_points_ = frozen_ ? 0 : tail_.points();
  for (int point = 0; point < tail_points_; ++point) {
    tail_delta_[static_cast<std::size_t>(point)] = static_cast<std::int8_t>(tail_.delta(point));
  }
  tail_.take();
  batch_end_count_ = count_;
  batch_end_ns_ = slot_start_ns_ + (can::kBatchPoints - slot_) * facts::kSlot_ns;
  tail_point_ = -1;
  in_tail_ = left_by_tail_ = tail_points_ > 0;
  pending_is_stale_ = has_pending_;
  return in_tail_;
}

// A batch that the joint held when it was to go on by itself, and that nobody has committed, or too late:
// another one may bear its toggle, and must be seen to be missing.
void PointPlayer::drop_stale_batch(const can::Sync& sync, std::int64_t now_ns) noexcept {
  const bool given_up = now_ns - batch_end_ns_ > kGivenUp_ns;
  if (pending_is_stale_ && (!sync.batch_committed || given_up)) {
    has_pending_ = pending_is_stale_ = false;
    pending_toggle_ = executing_toggle_;
  }
}

std::int32_t PointPlayer::count_before_tail_point(int point) const noexcept {
  std::int32_t count = batch_end_count_;
  for (int taken = 0; taken < point && taken < tail_points_; ++taken) {
    count = within_limits(count + tail_delta_[static_cast<std::size_t>(taken)]);
  }
  return count;
}

// From the batch's end to the edge that a SYNC marks. Where the cycles have been numbered anew, the joint's
// own slots count.
int PointPlayer::slots_since_batch(const can::Sync& sync) const noexcept {
  constexpr int kMostCycles = can::kTailParts + 1;
  const auto cycles = static_cast<std::uint16_t>(sync.cycle - batch_cycle_);
  return cycles >= 1 && cycles <= kMostCycles ? (cycles - 1) * can::kBatchPoints + sync.slot
                                              : tail_point_ + 1;
}

// Past the last point the joint holds. False when it is in that slot already, because the SYNC was overdue,
// or past it: a SYNC that waited for long somewhere tells nothing.
bool PointPlayer::follow_tail(const can::Sync& sync, std::int64_t now_ns) noexcept {
  const int point = slots_since_batch(sync);
  if (point <= tail_point_ || sync.cycle == batch_cycle_) {
    return false;
  }
  begin_tail_slot(point, now_ns, now_ns);
  return true;
}

void PointPlayer::begin_tail_slot(int point, std::int64_t start_ns, std::int64_t now_ns) noexcept {
  tail_point_ = point;
  count_ = count_before_tail_point(point);
  running_ = in_tail_ = point < tail_points_;
  const int first = point / can::kBatchPoints * can::kBatchPoints;
  for (int slot = 0; slot < can::kBatchPoints; ++slot) {
    executing_[static_cast<std::size_t>(slot)] =
        first + slot < tail_points_ ? tail_delta_[static_cast<std::size_t>(first + slot)] : std::int8_t{0};
  }
  begin_slot(point % can::kBatchPoints, start_ns, now_ns);
}

void PointPlayer::enter_slot(int slot, std::int64_t now_ns) noexcept {
  slot_ = slot;
  slot_start_ns_ = now_ns;
}

void PointPlayer::begin_slot(int slot, std::int64_t start_ns, std::int64_t now_ns) noexcept {
  enter_slot(slot, start_ns);
  const bool arrives_by_hand =
      !running_ && moves_by_hand_ && now_ns < segment_start_ns_ + segment_duration_ns_;
  if (arrives_by_hand || frozen_) {
    return;
  }
  const std::int64_t remaining_ns = start_ns + facts::kSlot_ns - now_ns;
  begin_segment(running_ ? count_ + executing_[static_cast<std::size_t>(slot)] : count_, now_ns,
                remaining_ns > kShortestSegment_ns ? remaining_ns : kShortestSegment_ns);
}

void PointPlayer::begin_segment(std::int32_t count, std::int64_t now_ns, std::int64_t duration_ns) noexcept {
  from_ = started_ ? reference(now_ns).count : static_cast<double>(count_);
  started_ = true;
  count_ = within_limits(count);
  at_limit_ = count_ != count;
  segment_start_ns_ = now_ns;
  segment_duration_ns_ = duration_ns;
  moves_by_hand_ = false;
}

std::int32_t PointPlayer::within_limits(std::int32_t count) const noexcept {
  return count < lowest_ ? lowest_ : count > highest_ ? highest_ : count;
}

// What is left of the batch leaves the joint where it is.
bool PointPlayer::rests() const noexcept {
  for (int slot = slot_; slot < can::kBatchPoints; ++slot) {
    if (executing_[static_cast<std::size_t>(slot)] != 0) {
      return false;
    }
  }
  return true;
}

bool PointPlayer::move_to(std::int32_t count, int duration_slots, std::int64_t now_ns) noexcept {
  if ((running_ && (in_tail_ || !rests())) || frozen_ || duration_slots <= 0) {
    return false;
  }
  running_ = left_by_tail_ = false;
  begin_segment(count, now_ns, duration_slots * facts::kSlot_ns);
  moves_by_hand_ = true;
  return true;
}

void PointPlayer::freeze(std::int64_t now_ns) noexcept {
  if (frozen_) {
    return;
  }
  const double here = reference(now_ns).count;
  begin_segment(static_cast<std::int32_t>(here < 0.0 ? here - 0.5 : here + 0.5), now_ns, facts::kSlot_ns);
  running_ = false;
  in_tail_ = left_by_tail_ = false;
  tail_.clear();
  has_pending_ = false;
  has_repair_ = false;
  frozen_ = true;
}

void PointPlayer::restart(std::int32_t count) noexcept {
  *this = PointPlayer(within_limits(count), lowest_, highest_, batch_start_);
}

bool PointPlayer::advance_without_sync(std::int64_t now_ns) noexcept {
  const bool alone = batch_start_ == BatchStart::on_arrival;
  if (!synchronised_) {
    if (!alone) {
      return false;
    }
    synchronised_ = true;  // the joint's own slots begin
    begin_slot(0, now_ns, now_ns);
    return true;
  }
  // Alone, only the end of a batch waits for what may come: the next batch, a little later than its own clock
  // says.
  const bool waits = !alone || (running_ && slot_ == kLastSlot);
  if (now_ns - slot_start_ns_ < facts::kSlot_ns + (waits ? kSyncGrace_ns : 0)) {
    return false;
  }
  // A batch is played point by point; while holding, slots that nobody asked for are skipped.
  const std::int64_t slots = running_ ? 1 : (now_ns - slot_start_ns_) / facts::kSlot_ns;
  const std::int64_t next = slot_ + slots;
  const std::int64_t start_ns = slot_start_ns_ + slots * facts::kSlot_ns;
  if (next > kLastSlot) {
    has_repair_ = false;
    running_ = running_ && (in_tail_ || take_up_tail());  // else played out: holds
  }
  if (in_tail_) {
    begin_tail_slot(tail_point_ + 1, start_ns, now_ns);
    return true;
  }
  begin_slot(static_cast<int>(next % can::kBatchPoints), start_ns, now_ns);
  return true;
}

PointPlayer::Reference PointPlayer::reference(std::int64_t now_ns) const noexcept {
  const std::int64_t elapsed_ns = now_ns - segment_start_ns_;
  const double target = static_cast<double>(count_);
  const std::int64_t beyond_ns = elapsed_ns - segment_duration_ns_;
  if (beyond_ns < 0) {
    const double rate = (target - from_) / (static_cast<double>(segment_duration_ns_) * 1e-9);
    return {from_ + rate * (elapsed_ns > 0 ? static_cast<double>(elapsed_ns) * 1e-9 : 0.0), rate};
  }
  // The next SYNC is due: at a stall here the servo would brake with all its torque, and then catch up.
  const double rate = coasting_rate_per_s();
  const double coasting = target + rate * (static_cast<double>(beyond_ns) * 1e-9);
  if (running_ && beyond_ns < kLongestCoast_ns && coasting >= lowest_ && coasting <= highest_) {
    return {coasting, rate};
  }
  return {target, 0.0};
}

double PointPlayer::coasting_rate_per_s() const noexcept {
  const int next = slot_ < kLastSlot ? slot_ + 1 : kLastSlot;
  return executing_[static_cast<std::size_t>(next)] / facts::kSlot_s;
}

}  // namespace gaitway::localcontroller
