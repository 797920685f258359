// Integrators of the centres of pressure.
#include "gaitway/stability/sole_alignment.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/stability/trim_feedback.hpp"

namespace gaitway::stability {
namespace {

constexpr double kLeastShare = 0.25;  // of the load, on either foot

}  // namespace

SoleAlignment::SoleAlignment(const urdf::RobotModel& model, const BalanceParameters& parameters)
    : parameters_(parameters), robot_limit_rad_(model.trim.limit_rad) {
  const urdf::ForwardKinematics home(model);
  for (const urdf::Side side : urdf::kSides) {
    const urdf::LegJoints leg(model, home, side);
    const TrimJoint pitch = trim_joint(model, home, leg[urdf::LegJoint::ankle_pitch]);
    const TrimJoint roll = trim_joint(model, home, leg[urdf::LegJoint::ankle_roll]);
    ankles_[urdf::index_of(side)] = {pitch.channel, roll.channel, pitch.axis.y(), roll.axis.x()};
  }
}

void SoleAlignment::learn(const Estimate& standing) noexcept {
  const double load_N = standing.foot_force[0] + standing.foot_force[1];
  const double least_N = std::min(standing.foot_force[0], standing.foot_force[1]);
  const auto& zmp = standing.foot_zmp;
  const bool finite = std::isfinite(zmp[0][0] + zmp[0][1] + zmp[1][0] + zmp[1][1]);
  if (!finite || !(least_N > kLeastShare * load_N)) return;
  const auto turn = [this](double& angle_rad, double zmp_m) {
    const double limit_rad = parameters_.sole_limit_rad;
    angle_rad = std::clamp(angle_rad + parameters_.sole_gain_rad_per_m_s * facts::kSlot_s * zmp_m, -limit_rad,
                           limit_rad);
  };
  turn(roll_rad_[0], zmp[0][1]);  // pressed on its left edge: that edge goes up
  turn(roll_rad_[1], zmp[1][1]);
  turn(pitch_rad_, -0.5 * (zmp[0][0] - zmp[1][0]));  // pressed on its toes: they go up
}

void SoleAlignment::add_to(TrimCommand& trim) const noexcept {
  const double limit_rad = std::min(parameters_.trim_limit_rad, robot_limit_rad_);
  const auto add = [&](int channel, double angle_rad) {
    if (channel < 0) return;
    double& sum_rad = trim.angle[channel];
    sum_rad = std::clamp(sum_rad + angle_rad, -limit_rad, limit_rad);
  };
  for (std::size_t side = 0; side < ankles_.size(); ++side) {
    add(ankles_[side].pitch_channel, ankles_[side].pitch_about_y * pitch_rad(side));
    add(ankles_[side].roll_channel, ankles_[side].roll_about_x * roll_rad(side));
  }
}

}  // namespace gaitway::stability
