// A low-pass of the difference.
#include "gaitway/stability/speed_feedback.hpp"

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {

Eigen::Vector2d SpeedFeedback::update(const Eigen::Vector2d& planned_m_per_s,
                                      const Eigen::Vector2d& estimated_m_per_s, bool walking) noexcept {
  const double filter_s = parameters_.speed_filter_s, limit_m_per_s = parameters_.speed_limit_m_per_s;
  if (filter_s <= 0.0) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d slower =
      walking ? (planned_m_per_s - estimated_m_per_s).eval() : Eigen::Vector2d::Zero().eval();
  offset_m_per_s_ += facts::kSlot_s / (filter_s + facts::kSlot_s) * (slower - offset_m_per_s_);
  offset_m_per_s_ = offset_m_per_s_.cwiseMax(-limit_m_per_s).cwiseMin(limit_m_per_s);
  return offset_m_per_s_;
}

}  // namespace gaitway::stability
