// Soft, rising, upright.
#include "gaitway/stability/fall_reaction.hpp"

#include <algorithm>

namespace gaitway::stability {
namespace {

constexpr std::uint32_t kUpright = 0, kLies = 2;  // Estimate::fall
constexpr int kRisingTicks = 300;

}  // namespace

double FallReaction::update(std::uint32_t fall, bool on_ground) noexcept {
  if (fall == kUpright) {
    rising_ticks_ = 0;
    return 0.0;
  }
  // What is played in the moment of the fall, be it on the ground, does not keep the joints stiff.
  rising_ticks_ = fall != kLies ? 0 : on_ground ? kRisingTicks : std::max(rising_ticks_ - 1, 0);
  return rising_ticks_ > 0 ? 0.0 : softness_;
}

}  // namespace gaitway::stability
