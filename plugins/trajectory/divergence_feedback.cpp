// A ring of planned points, and the comparison from the support foot.
#include "gaitway/trajectory/divergence_feedback.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

constexpr std::int64_t kOldest_ns = 60'000'000;

}  // namespace

DivergenceFeedback::DivergenceFeedback(const GaitParameters& parameters) noexcept
    : com_above_hips_m_(parameters.com_height_m - parameters.hip_height_m),
      lag_ns_(std::llround(parameters.response_lag_s * 1e9)) {}

// The estimate's pendulum is as high as the body is, so the planned one must be.
double DivergenceFeedback::omega_per_s(double hip_height_m) const noexcept {
  return std::sqrt(facts::kGravity_m_per_s2 / (hip_height_m + com_above_hips_m_));
}

void DivergenceFeedback::take(const MotionPlan& plan) noexcept {
  const bool planned_anew = points_[newest_].time_ns > plan.start_ns;
  if (planned_anew) newest_ = (newest_ + kKept - kBatchPoints) % kKept;
  for (std::size_t i = 0; i < kBatchPoints; ++i) {
    newest_ = (newest_ + 1) % kKept;
    Point& point = points_[newest_];
    point.time_ns = plan.start_ns + static_cast<std::int64_t>(i + 1) * facts::kSlot_ns;
    point.omega_per_s = omega_per_s(plan.hip_height[i]);
    point.dcm_m = Eigen::Vector2d(plan.com[i]) + Eigen::Vector2d(plan.com_velocity[i]) / point.omega_per_s;
    point.zmp_m = Eigen::Vector2d(plan.zmp[i]);
    for (std::size_t side = 0; side < point.foot_m.size(); ++side) {
      point.foot_m[side] = Eigen::Vector2d(plan.foot_position[i][side]);
      point.foot_yaw_rad[side] = plan.foot_yaw[i][side];
    }
  }
}

const DivergenceFeedback::Point* DivergenceFeedback::planned_for(std::int64_t time_ns) const noexcept {
  for (const Point& point : points_) {
    if (point.time_ns >= 0 && std::abs(point.time_ns - time_ns) <= facts::kSlot_ns / 2) return &point;
  }
  return nullptr;
}

Eigen::Vector2d DivergenceFeedback::deviation_m(const Estimate& estimate,
                                                std::int64_t start_ns) const noexcept {
  const std::int64_t ahead_ns = start_ns - estimate.stamp_ns;
  const Point* const planned = planned_for(estimate.stamp_ns - lag_ns_);
  if (planned == nullptr || estimate.fall != 0 || ahead_ns < 0 || ahead_ns > kOldest_ns ||
      estimate.support >= planned->foot_m.size())
    return Eigen::Vector2d::Zero();
  const Eigen::Vector2d& foot = planned->foot_m[estimate.support];
  const Eigen::Rotation2Dd to_plan(planned->foot_yaw_rad[estimate.support]);
  const Eigen::Vector2d dcm = foot + to_plan * Eigen::Vector2d(estimate.dcm) - planned->dcm_m;
  const Eigen::Vector2d zmp = foot + to_plan * Eigen::Vector2d(estimate.zmp) - planned->zmp_m;
  const auto growth_over = [planned](std::int64_t time_ns) {
    return std::exp(planned->omega_per_s * static_cast<double>(time_ns) * 1e-9);
  };
  Eigen::Vector2d deviation = zmp + growth_over(ahead_ns) * (dcm - zmp);
  if (planned->time_ns <= answered_ns_) deviation -= growth_over(start_ns - answered_ns_) * answered_m_;
  return deviation.allFinite() ? deviation : Eigen::Vector2d::Zero().eval();
}

}  // namespace gaitway::trajectory
