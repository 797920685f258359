// Collects the parts of tails, and keeps what is left of an older one from passing for a newer one's.
#include "gaitway/localcontroller/held_tail.hpp"

namespace gaitway::localcontroller {

void HeldTail::on_tail(const can::Tail& tail) noexcept {
  Buffer& buffer = tails_[tail.toggle ? 1 : 0];
  const bool counts = is_named_ && named_ == tail.toggle;
  if (tail.toggle != coming_ && !counts) {
    buffer.parts = 0;  // of two tails ago
  }
  coming_ = counts ? coming_ : tail.toggle;  // what counts may be sent again while the next one comes
  for (std::size_t k = 0; k < tail.delta.size(); ++k) {
    buffer.delta[tail.part * tail.delta.size() + k] = tail.delta[k];
  }
  buffer.parts = static_cast<std::uint8_t>(buffer.parts | (1U << tail.part));
}

void HeldTail::take() noexcept {
  tails_[named_ ? 1 : 0].parts = 0;
  is_named_ = missing_ = false;
  points_ = 0;
}

void HeldTail::on_sync(const can::Sync& sync) noexcept {
  if (!sync.batch_committed) {
    return;
  }
  const bool names = sync.tail_points > 0;
  if (is_named_ && (!names || sync.tail_toggle != named_)) {
    tails_[named_ ? 1 : 0].parts = 0;
  }
  is_named_ = names;
  named_ = sync.tail_toggle;
  const int parts = (sync.tail_points + can::kBatchPoints - 1) / can::kBatchPoints;
  const unsigned wanted = (1U << static_cast<unsigned>(parts)) - 1U;
  missing_ = names && (tails_[named_ ? 1 : 0].parts & wanted) != wanted;
  points_ = missing_ ? 0 : sync.tail_points;
}

}  // namespace gaitway::localcontroller
