// A leaky integral, and the slow mean that it leaves out.
#include "gaitway/zmp/slip_observer.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::zmp {
namespace {

constexpr double kImpact_s = 0.030;              // after touchdown the sole rolls and strikes: no slip
constexpr double kLargestOffset_m_per_s2 = 0.5;  // three degrees of tilt

}  // namespace

SlipObserver::SlipObserver(const EstimatorParameters& parameters) noexcept
    : leak_s_(parameters.slip_leak_s), offset_time_s_(parameters.slip_offset_time_s) {}

void SlipObserver::update(bool in_contact, const Eigen::Vector2d& acceleration_m_per_s2,
                          double dt_s) noexcept {
  contact_s_ = in_contact ? std::min(contact_s_ + dt_s, offset_time_s_) : 0.0;
  if (contact_s_ <= kImpact_s) {
    velocity_.setZero();
    return;
  }
  velocity_ = (velocity_ + dt_s * (acceleration_m_per_s2 - offset_)) * std::exp(-dt_s / leak_s_);
  offset_ += dt_s / offset_time_s_ * (acceleration_m_per_s2.cwiseMax(-1.0).cwiseMin(1.0) - offset_);
  offset_ = offset_.cwiseMax(-kLargestOffset_m_per_s2).cwiseMin(kLargestOffset_m_per_s2);
}

}  // namespace gaitway::zmp
