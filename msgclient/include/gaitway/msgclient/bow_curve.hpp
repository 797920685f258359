// What becomes of Correction::bow in a batch and after it: one curve for who asks for a bow and for who
// plans it.
#pragma once

#include <algorithm>
#include <cstdint>

namespace gaitway::msgclient {

// Of one axis.
struct Bow {
  double angle_rad = 0.0;
  double rate_rad_per_s = 0.0;
};

// Up to the batch's end the cubic that begins as `from` and ends as `to`; a batch without successor then
// brings it to rest with constant deceleration, as long again. time_s: since the batch's start.
[[nodiscard]] inline Bow bow_at(const Bow& from, const Bow& to, double time_s, double batch_s) noexcept {
  if (time_s < batch_s) {
    const double s = std::max(time_s, 0.0) / batch_s;
    const double change_rad = to.angle_rad - from.angle_rad;
    const double from_rad = from.rate_rad_per_s * batch_s, to_rad = to.rate_rad_per_s * batch_s;
    const double square = 3.0 * change_rad - 2.0 * from_rad - to_rad;
    const double cube = from_rad + to_rad - 2.0 * change_rad;
    return {from.angle_rad + s * (from_rad + s * (square + s * cube)),
            (from_rad + s * (2.0 * square + 3.0 * s * cube)) / batch_s};
  }
  const double s = std::min(time_s / batch_s - 1.0, 1.0);
  return {to.angle_rad + to.rate_rad_per_s * batch_s * s * (1.0 - 0.5 * s), to.rate_rad_per_s * (1.0 - s)};
}

// What is left of all offsets at a point of the safe tail, 1 its first: over the first half they stay, over
// the second they go smoothly to zero.
[[nodiscard]] inline double tail_share(std::uint64_t tail_point, std::uint64_t tail_count) noexcept {
  const std::uint64_t held = tail_count / 2;
  if (tail_count == 0 || tail_point <= held) return 1.0;
  if (tail_point >= tail_count) return 0.0;
  const double phase = static_cast<double>(tail_point - held) / static_cast<double>(tail_count - held);
  return 1.0 - phase * phase * (3.0 - 2.0 * phase);
}

}  // namespace gaitway::msgclient
