// The points that a joint holds for the time after its batch, sent ahead: with them it ends the step by
// itself, together with all others, when no SYNC comes any more. Two tails have room, so that the next one
// can come while the last one counts; which of them is whole for all joints, SYNC says.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/can/messages.hpp"

namespace gaitway::localcontroller {

class HeldTail {
 public:
  // A part of a tail has come. Each tail bears another toggle than the one before.
  void on_tail(const can::Tail& tail) noexcept;
  // What a SYNC says of the tails: it is the word on the batch that it commits. One that commits none changes
  // nothing: what was said of the batch before holds, until the joint has been through it.
  void on_sync(const can::Sync& sync) noexcept;
  // The batch is over and the joint goes along what points() and delta() said: another tail may come.
  void take() noexcept;
  void clear() noexcept { *this = HeldTail(); }

  // How many points follow the batch; 0: the joint holds where the batch ends.
  [[nodiscard]] int points() const noexcept { return points_; }
  // Change of the reference count in a slot after the batch, 0..points()-1.
  [[nodiscard]] std::int32_t delta(int point) const noexcept {
    return tails_[named_ ? 1 : 0].delta[static_cast<std::size_t>(point)];
  }
  // SYNC names a tail of which some point is not here.
  [[nodiscard]] bool missing() const noexcept { return missing_; }

 private:
  struct Buffer {
    std::array<std::int8_t, can::kTailPoints> delta{};
    std::uint8_t parts = 0;  // bit mask of those that have come
  };
  std::array<Buffer, 2> tails_{};  // by toggle
  bool coming_ = false;            // toggle of the part that came last
  bool named_ = false;             // toggle of the tail that counts, if points_ > 0
  bool is_named_ = false;          // by the last SYNC that committed a batch
  bool missing_ = false;
  int points_ = 0;
};

}  // namespace gaitway::localcontroller
