// One slot at a time, in the form in which it is published.
#include "gaitway/msgcontroller/slot_record.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr std::int64_t kMicrosecond_ns = 1'000;

}  // namespace

const BusSlot* SlotRecord::enter_slot(std::int64_t edge_ns) noexcept {
  const bool recorded = records_;
  const std::int64_t index = edge_ns / facts::kSlot_ns;
  records_ = index % kSlotsBetweenRecords == 0;
  if (records_) {
    slot_ = {};
    slot_.stamp_ns = edge_ns;
    slot_.cycle = static_cast<std::uint32_t>(index / facts::kSlotsPerCycle);
    slot_.slot = static_cast<std::uint32_t>(index % facts::kSlotsPerCycle);
  }
  return recorded ? &slot_ : nullptr;  // never two in a row
}

void SlotRecord::take(const can::Frame& frame, std::int64_t end_ns) noexcept {
  if (records_) {
    add(frame.id | (frame.extended ? kExtendedFrame : 0U) | (frame.remote ? kRemoteFrame : 0U), end_ns,
        can::frame_bits(frame));
  }
}

void SlotRecord::take(const can::BusNotice& notice) noexcept {
  if (notice.kind == can::BusNotice::Kind::sent) {
    take(notice.frame.frame, notice.frame.end_ns);
  } else if (records_) {
    add(kErrorOnTheBus, notice.frame.end_ns, 0);
  }
}

void SlotRecord::add(std::uint32_t id, std::int64_t end_ns, int bits) noexcept {
  const std::int64_t since_edge_ns = end_ns - slot_.stamp_ns;
  if (since_edge_ns < 0 || since_edge_ns > facts::kSlot_ns) {
    return;  // of another slot: its news came late
  }
  if (slot_.frame_count == kSlotFrames) {
    ++slot_.left_out;
    return;
  }
  const std::uint32_t entry = slot_.frame_count++;
  slot_.id[entry] = id;
  slot_.end_us[entry] = static_cast<std::uint16_t>(since_edge_ns / kMicrosecond_ns);
  slot_.length_us[entry] = static_cast<std::uint16_t>(bits * facts::kBitTime_ns / kMicrosecond_ns);
}

}  // namespace gaitway::msgcontroller
