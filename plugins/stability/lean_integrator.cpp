// offset' = -gain (attitude - reference), limited.
#include "gaitway/stability/lean_integrator.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr double kFadePerTick = 0.995;  // half in 1.4 s

}  // namespace

void LeanIntegrator::update(double roll_rad, double pitch_rad, bool walking) noexcept {
  const double gain_per_s = walking ? walking_gain_per_s_ : gain_per_s_;
  const std::array<double, 2> lean{roll_rad - reference_rad_[0], pitch_rad - reference_rad_[1]};
  for (std::size_t axis = 0; axis < lean.size(); ++axis) {
    offset_rad_[axis] =
        std::clamp(offset_rad_[axis] - gain_per_s * facts::kSlot_s * lean[axis], -limit_rad_, limit_rad_);
  }
}

void LeanIntegrator::fade() noexcept {
  for (double& offset : offset_rad_) offset *= kFadePerTick;
}

}  // namespace gaitway::stability
