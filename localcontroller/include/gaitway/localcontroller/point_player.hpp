// Plays the eight points of a batch: one change of the reference count a time slot, interpolated in between.
// Where the profile has a SYNC, batches start on it only, so that all joints start together, and the joint
// goes on alone when a SYNC is lost: to the batch's end, and along the tail that it holds. Without one, a
// batch starts as it arrives and the joint's own clock counts its slots.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/can/messages.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/localcontroller/held_tail.hpp"

namespace gaitway::localcontroller {

// How long a SYNC may be overdue, by the joint's own clock, before the joint takes the next slot without it.
inline constexpr std::int64_t kSyncGrace_ns = 1'500'000;

enum class BatchStart : std::uint8_t { on_sync, on_arrival };

class PointPlayer {
 public:
  PointPlayer(std::int32_t initial_count, std::int32_t lowest_count, std::int32_t highest_count,
              BatchStart batch_start = BatchStart::on_sync) noexcept
      : batch_start_(batch_start),
        count_(initial_count),
        from_(initial_count),
        lowest_(lowest_count),
        highest_(highest_count) {}

  // A new batch, to be started by a SYNC that names its toggle. A repeated frame changes nothing.
  void on_trajectory(const can::Trajectory& batch) noexcept;
  // Points for the time after a batch.
  void on_tail(const can::Tail& tail) noexcept {
    if (!frozen_) {
      tail_.on_tail(tail);
    }
  }
  // Starts a batch now, as where there is no SYNC. A repeated frame changes nothing. True when a time slot
  // has begun that is to be answered: false also when the joint has just begun one by its own clock.
  bool start(const can::Trajectory& batch, std::int64_t now_ns) noexcept;
  // A repair; takes effect at the SYNC of its slot. One for a slot that has begun does nothing: the next
  // feedback shows the message controller that it came too late.
  void on_resynchronisation(const can::Resynchronisation& repair) noexcept;
  // Begins a slot. False, and nothing changes, for a repetition of the last SYNC. A batch starts on slot 0
  // only, and one that was passed over there (another one was committed) is dropped. After the end of a batch
  // of which it holds a tail the joint goes on along that, SYNC or not, until a batch starts, a repair comes,
  // or the tail has ended.
  bool on_sync(const can::Sync& sync, std::int64_t now_ns) noexcept;
  // Moves to a count over some slots; only while no batch runs, or the rest of one leaves the joint where it
  // is, which is then over for it. False otherwise.
  bool move_to(std::int32_t count, int duration_slots, std::int64_t now_ns) noexcept;
  // Freezes the reference where it is now; batches are ignored from then on.
  void freeze(std::int64_t now_ns) noexcept;
  // Leaves all that behind, as after a restart, with `count` (kept within the limits) as the reference. Slots
  // and batches begin again with the next SYNC.
  void restart(std::int32_t count) noexcept;
  // Takes the next slot when SYNC is overdue (at once where there is none), whether a batch runs or not. True
  // when it did. A batch is played to its end in this way, and its tail after it; none is started.
  bool advance_without_sync(std::int64_t now_ns) noexcept;

  // Reference at the end of the running slot.
  [[nodiscard]] std::int32_t count() const noexcept { return count_; }
  // Interpolated reference, in counts, and its rate in counts per second. While a batch runs and the next
  // SYNC is late, the reference coasts on towards the next point (past the last one at that point's rate),
  // within the limits and until the joint takes the next slot alone.
  struct Reference {
    double count = 0.0;
    double rate_per_s = 0.0;
  };
  [[nodiscard]] Reference reference(std::int64_t now_ns) const noexcept;
  [[nodiscard]] bool running() const noexcept { return running_; }
  [[nodiscard]] bool pending_toggle() const noexcept { return pending_toggle_; }
  [[nodiscard]] bool executing_toggle() const noexcept { return executing_toggle_; }
  [[nodiscard]] bool at_limit() const noexcept { return at_limit_; }
  [[nodiscard]] bool frozen() const noexcept { return frozen_; }
  [[nodiscard]] bool tail_missing() const noexcept { return tail_.missing(); }
  // A batch has been started or a repair has set the count since the start: it is one that was asked for.
  [[nodiscard]] bool reference_confirmed() const noexcept { return reference_confirmed_; }

 private:
  // The slot began at `start_ns`; its segment ends with it.
  void begin_slot(int slot, std::int64_t start_ns, std::int64_t now_ns) noexcept;
  void begin_segment(std::int32_t count, std::int64_t now_ns, std::int64_t duration_ns) noexcept;
  [[nodiscard]] bool start_batch(const can::Sync& sync) noexcept;
  [[nodiscard]] bool take_up_tail() noexcept;
  void drop_stale_batch(const can::Sync& sync, std::int64_t now_ns) noexcept;
  void begin_tail_slot(int point, std::int64_t start_ns, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool follow_tail(const can::Sync& sync, std::int64_t now_ns) noexcept;
  [[nodiscard]] std::int32_t count_before_tail_point(int point) const noexcept;
  [[nodiscard]] int slots_since_batch(const can::Sync& sync) const noexcept;
  void make_up_until(int slot) noexcept;
  [[nodiscard]] bool rests() const noexcept;
  void enter_slot(int slot, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool apply_repair(const can::Sync& sync, std::int64_t now_ns) noexcept;
  [[nodiscard]] double coasting_rate_per_s() const noexcept;
  [[nodiscard]] std::int32_t within_limits(std::int32_t count) const noexcept;

  BatchStart batch_start_;
  std::int32_t count_;
  double from_;  // where the interpolation of this segment began, in counts
  std::int32_t lowest_, highest_;
  std::int64_t segment_start_ns_ = 0;
  std::int64_t segment_duration_ns_ = facts::kSlot_ns;
  bool moves_by_hand_ = false;  // this segment is a manual movement
  bool started_ = false;        // the first segment has begun
  int slot_ = 0;                // running slot of the cycle
  std::int64_t slot_start_ns_ = 0;
  bool synchronised_ = false;     // a SYNC has come
  std::uint16_t sync_cycle_ = 0;  // of the last SYNC
  int sync_slot_ = 0;
  std::uint16_t batch_cycle_ = 0;  // in which the executing batch runs
  bool running_ = false;           // a batch is being played
  bool frozen_ = false;
  bool reference_confirmed_ = false;
  bool has_pending_ = false;
  bool pending_toggle_ = false;
  bool executing_toggle_ = false;
  std::array<std::int8_t, can::kBatchPoints> pending_{}, executing_{};
  HeldTail tail_;
  bool in_tail_ = false;           // running_: along these points
  bool left_by_tail_ = false;      // since the last batch it has gone along a tail
  bool pending_is_stale_ = false;  // it was there when a batch ended to which no SYNC had it follow
  int tail_point_ = 0;             // that is being played
  int tail_points_ = 0;
  std::array<std::int8_t, can::kTailPoints> tail_delta_{};
  std::int32_t batch_end_count_ = 0;
  std::int64_t batch_end_ns_ = 0;
  bool has_repair_ = false;
  can::Resynchronisation repair_;
  bool at_limit_ = false;
};

}  // namespace gaitway::localcontroller
