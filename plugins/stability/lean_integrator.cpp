// offset' = -gain (attitude - reference), limited.
#include "gaitway/stability/lean_integrator.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr double kFadePerTick = 0.995;  // half in 1.4 s

}  // namespace

void LeanIntegrator::update(double roll_rad, double pitch_rad, bool walking) noexcept {
  const double gain_per_s = walking ? parameters_.walking_lean_gain_per_s : parameters_.lean_gain_per_s;
  const std::array<double, 2>& reference_rad = parameters_.attitude_reference_rad;
  const std::array<double, 2> lean{roll_rad - reference_rad[0], pitch_rad - reference_rad[1]};
  const double limit_rad = parameters_.lean_limit_rad;
  for (std::size_t axis = 0; axis < lean.size(); ++axis) {
    offset_rad_[axis] =
        std::clamp(offset_rad_[axis] - gain_per_s * facts::kSlot_s * lean[axis], -limit_rad, limit_rad);
  }
}

void LeanIntegrator::fade() noexcept {
  for (double& offset : offset_rad_) offset *= kFadePerTick;
}

}  // namespace gaitway::stability
