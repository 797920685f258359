// Two thresholds a foot, and a margin for the change of support: noise at a threshold changes nothing.
#include "gaitway/zmp/contact_detector.hpp"

namespace gaitway::zmp {

void ContactDetector::update(const std::array<double, 2>& force_N) noexcept {
  for (std::size_t side = 0; side < contact_.size(); ++side) {
    contact_[side] = force_N[side] >= (contact_[side] ? thresholds_.off_N : thresholds_.on_N);
  }
  const std::size_t support = static_cast<std::size_t>(support_);
  const std::size_t other = 1 - support;
  if (!contact_[other]) return;
  const double change_at = (0.5 + thresholds_.support_margin) * (force_N[0] + force_N[1]);
  if (!contact_[support] || force_N[other] > change_at) support_ = static_cast<urdf::Side>(other);
}

}  // namespace gaitway::zmp
