// offset' = -gain (estimated - planned), both limited.
#include "gaitway/stability/com_centring.hpp"

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr double kMostError_m = 0.005;  // of the CoM at a time: a body that is off by more is pushed
constexpr double kCalm_m = 0.020;       // of the DCM: a body that is off by more is being caught

}  // namespace

void ComCentring::learn(const Eigen::Vector2d& com_error_m, const Eigen::Vector2d& dcm_error_m) noexcept {
  if (!com_error_m.allFinite() || !(dcm_error_m.norm() < kCalm_m)) return;
  offset_m_ -= parameters_.centring_gain_per_s * facts::kSlot_s *
               com_error_m.cwiseMax(-kMostError_m).cwiseMin(kMostError_m);
  const double limit_m = parameters_.centring_limit_m;
  offset_m_ = offset_m_.cwiseMax(-limit_m).cwiseMin(limit_m);
}

}  // namespace gaitway::stability
