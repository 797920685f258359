// Slots, batches and repairs of one joint.
#include "gaitway/localcontroller/point_player.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr int kLastSlot = can::kBatchPoints - 1;

}  // namespace

void PointPlayer::on_trajectory(const can::Trajectory& batch) noexcept {
  const bool repetition = running_ && batch.toggle == executing_toggle_;
  if (repetition || frozen_) {
    return;
  }
  pending_ = batch.delta;
  pending_toggle_ = batch.toggle;
  has_pending_ = true;
}

void PointPlayer::on_resynchronisation(const can::Resynchronisation& repair) noexcept {
  repair_ = repair;
  has_repair_ = repair.slot > slot_;
}

void PointPlayer::on_sync(const can::Sync& sync, std::int64_t now_ns) noexcept {
  if (frozen_) {
    return;
  }
  if (apply_repair(sync, now_ns)) {
    return;
  }
  if (sync.slot == 0) {
    start_batch(sync);
    begin_slot(0, now_ns);
    return;
  }
  if (sync.slot == slot_) {
    return;  // taken already, when the SYNC was overdue
  }
  // Slots whose SYNC was lost count, too: their points are made up for within this one.
  if (running_) {
    for (int missed = slot_ + 1; missed < sync.slot; ++missed) {
      count_ += executing_[static_cast<std::size_t>(missed)];
    }
  }
  begin_slot(sync.slot, now_ns);
}

bool PointPlayer::apply_repair(const can::Sync& sync, std::int64_t now_ns) noexcept {
  if (!has_repair_ || sync.slot != repair_.slot) {
    return false;
  }
  has_repair_ = false;
  slot_ = sync.slot;
  running_ = sync.batch_committed;
  executing_toggle_ = repair_.toggle;
  for (int k = 0; k < can::kResyncDeltas && slot_ + 1 + k <= kLastSlot; ++k) {
    executing_[static_cast<std::size_t>(slot_ + 1 + k)] = repair_.delta[static_cast<std::size_t>(k)];
  }
  begin_segment(repair_.count, now_ns, kSlot_ns);
  return true;
}

void PointPlayer::start_batch(const can::Sync& sync) noexcept {
  // Only a SYNC says that every joint's frame was sent and which toggle it bears; without it this joint would
  // move alone.
  has_repair_ = false;
  running_ = sync.batch_committed && has_pending_ && pending_toggle_ == sync.toggle;
  if (running_) {
    executing_ = pending_;
    executing_toggle_ = pending_toggle_;
    has_pending_ = false;
  }
}

void PointPlayer::begin_slot(int slot, std::int64_t now_ns) noexcept {
  slot_ = slot;
  const bool moving_by_hand =
      !running_ && segment_duration_ns_ != kSlot_ns && now_ns < segment_start_ns_ + segment_duration_ns_;
  if (moving_by_hand) {
    return;
  }
  begin_segment(running_ ? count_ + executing_[static_cast<std::size_t>(slot)] : count_, now_ns, kSlot_ns);
}

void PointPlayer::begin_segment(std::int32_t count, std::int64_t now_ns, std::int64_t duration_ns) noexcept {
  from_ = started_ ? reference(now_ns).count : static_cast<double>(count_);
  started_ = true;
  at_limit_ = count < lowest_ || count > highest_;
  count_ = count < lowest_ ? lowest_ : count > highest_ ? highest_ : count;
  segment_start_ns_ = now_ns;
  segment_duration_ns_ = duration_ns;
}

bool PointPlayer::move_to(std::int32_t count, int duration_slots, std::int64_t now_ns) noexcept {
  if (running_ || frozen_ || duration_slots <= 0) {
    return false;
  }
  begin_segment(count, now_ns, duration_slots * kSlot_ns);
  return true;
}

void PointPlayer::freeze(std::int64_t now_ns) noexcept {
  const double here = reference(now_ns).count;
  begin_segment(static_cast<std::int32_t>(here < 0.0 ? here - 0.5 : here + 0.5), now_ns, kSlot_ns);
  running_ = false;
  has_pending_ = false;
  frozen_ = true;
}

bool PointPlayer::advance_without_sync(std::int64_t now_ns) noexcept {
  if (!running_ || now_ns - segment_start_ns_ < kSlot_ns + kSyncGrace_ns) {
    return false;
  }
  if (slot_ == kLastSlot) {
    running_ = false;  // played out: holds
    return false;
  }
  begin_slot(slot_ + 1, segment_start_ns_ + kSlot_ns);
  return true;
}

PointPlayer::Reference PointPlayer::reference(std::int64_t now_ns) const noexcept {
  const std::int64_t elapsed_ns = now_ns - segment_start_ns_;
  const double target = static_cast<double>(count_);
  if (elapsed_ns >= segment_duration_ns_) {
    return {target, 0.0};
  }
  const double duration_s = static_cast<double>(segment_duration_ns_) * 1e-9;
  const double rate = (target - from_) / duration_s;
  const double elapsed_s = elapsed_ns > 0 ? static_cast<double>(elapsed_ns) * 1e-9 : 0.0;
  return {from_ + rate * elapsed_s, rate};
}

}  // namespace gaitway::localcontroller
