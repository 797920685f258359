// Stiff into the posture, soft, rising, upright.
#include "gaitway/stability/fall_reaction.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr std::uint32_t kUpright = 0, kFalls = 1;  // Estimate::fall
constexpr int kRisingTicks = 300, kMostTicks = 1000;

}  // namespace

double FallReaction::update(std::uint32_t fall, const Plays& plays) noexcept {
  if (fall != kFalls) falling_ticks_ = 0;
  if (fall == kUpright) {
    rising_ticks_ = 0;
    return 0.0;
  }
  if (fall == kFalls) {
    // What is played in the moment of the fall, be it on the ground, does not keep the joints stiff.
    rising_ticks_ = 0;
    falling_ticks_ = std::min(falling_ticks_ + 1, kMostTicks);
    const bool waits = falling_ticks_ <= std::lround(softness_.wait_s / facts::kSlot_s);
    return plays.fall_posture || waits ? std::min(softness_.posture, softness_.lying) : softness_.lying;
  }
  rising_ticks_ = plays.on_ground ? kRisingTicks : std::max(rising_ticks_ - 1, 0);
  return rising_ticks_ > 0 ? 0.0 : softness_.lying;
}

}  // namespace gaitway::stability
