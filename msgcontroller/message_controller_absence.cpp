// What passes while the joints hear nothing of the message controller, because it was stopped or its bus was
// gone: which SYNCs have reached them, where they have gone by themselves, and what they are told when it is
// back.
#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/message_controller.hpp"

namespace gaitway::msgcontroller {
namespace {

// Joints that got no SYNC until then have gone on alone for so long that their way and that of the batch
// which they have not begun have parted; until then they are brought to it, joint by joint.
constexpr int kSlotsToMakeUp = 4;
// Longer than joints move by themselves: a batch, another one that is prepared, and a tail.
constexpr std::int64_t kSlotsUntilRest = (3 + can::kTailParts) * facts::kSlotsPerCycle;

}  // namespace

// Slots that this process was not there for, because it was stopped, have passed for the joints all the same.
void MessageController::pass_slots_until(std::int64_t slot_index) noexcept {
  if (last_slot_index_ < 0) {
    last_slot_index_ = slot_index - 1;
  }
  const std::int64_t at_rest = std::min(slot_index, last_slot_index_ + kSlotsUntilRest);
  for (std::int64_t passed = last_slot_index_ + 1; passed < at_rest; ++passed) {
    pass_slot(passed);
  }
  if (slot_index > last_slot_index_) {
    pass_slot(slot_index);
  }
  last_slot_index_ = slot_index;
}

void MessageController::pass_slot(std::int64_t slot_index) noexcept {
  const int slot = static_cast<int>(slot_index % facts::kSlotsPerCycle);
  link_.slot_start_ns = slot_index * facts::kSlot_ns;
  link_.state.cycle = static_cast<std::uint32_t>(slot_index / facts::kSlotsPerCycle);
  link_.state.slot = static_cast<std::uint32_t>(slot);
  if (slot == 0) {
    begin_cycle();
  }
  playback_.enter_slot(slot);
  supervision_.enter_slot(slot);
  const bool begun = last_sync_index_ >= slot_index - slot;
  if (slot == kSlotsToMakeUp && !begun && last_sync_index_ >= 0 && link_.synchronised() &&
      mode() != Mode::emergency_stop && playback_.running_segment().active) {
    leave_to_joints();
  }
}

// No joint has begun the batch of this cycle: each has gone on by itself.
void MessageController::leave_to_joints() noexcept {
  ++link_.state.left_to_joints;
  supervision_.drop_waiting();
  supervision_.drop(can::MessageKind::resynchronisation);
  playback_.leave_to_joints(named_tail_points_);
  named_tail_points_ = 0;
  recount_waits_ = true;
  supervision_.forget_tails();
  link_.set_mode(Mode::safe_tail);
}

void MessageController::on_notice(const can::BusNotice& notice) noexcept {
  slot_record_.take(notice);
  if (notice.kind == can::BusNotice::Kind::sent) {
    port_tells_sent_ = true;
    on_sent(notice.frame.frame);
  }
}

bool MessageController::take_frame(can::Frame& frame) noexcept {
  if (!link_.queue.pop(frame)) {
    return false;
  }
  if (!port_tells_sent_) {
    on_sent(frame);
  }
  return true;
}

void MessageController::on_sent(const can::Frame& frame) noexcept {
  const can::Profile& profile = link_.profile;
  if (profile.has(can::MessageKind::sync) && frame.id == profile.id_of(can::MessageKind::sync)) {
    if (const auto sync = can::decode_sync(profile, frame)) {
      note_sync(*sync);
    }
  } else if (const auto sent = profile.identify(frame.id); sent && sent->kind == can::MessageKind::tail) {
    supervision_.on_tail_sent(sent->toggle);
  }
}

// It may have waited for long in a port that cannot give it back.
void MessageController::note_sync(const can::Sync& sync) noexcept {
  constexpr std::int64_t kNumbered = (std::int64_t{1} << 16U) * facts::kSlotsPerCycle;
  const std::int64_t number = std::int64_t{sync.cycle} * facts::kSlotsPerCycle + sync.slot;
  last_sync_index_ = last_slot_index_ - (last_slot_index_ - number) % kNumbered;
  if (sync.batch_committed) {
    named_tail_points_ = sync.tail_points;
  }
}

bool MessageController::sync_gets_out() const noexcept {
  return !link_.synchronised() || last_sync_index_ < 0 ||
         last_sync_index_ >= last_slot_index_ - kSlotsToMakeUp;
}

// After an outage each joint is told its count once it rests: of a difference of sixteen counts its feedback
// tells nothing. Until then nothing is to be played.
bool MessageController::counts_first() const noexcept {
  return recount_waits_ && !playback_.running_segment().active && !playback_.prepared() &&
         !playback_.left_to_joints();
}

// Not in the last slot of a cycle, in which no count can be given.
void MessageController::recount() noexcept {
  if (counts_first() && sync_gets_out() && link_.state.slot < facts::kSlotsPerCycle - 1 &&
      mode() != Mode::emergency_stop && joints_known()) {
    supervision_.set_counts();
    recount_waits_ = false;
  }
}

}  // namespace gaitway::msgcontroller
