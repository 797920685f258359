// Dead reckoning over the feet that stand; headings are the attitude filter's.
#include "gaitway/zmp/foot_odometry.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gaitway::zmp {
namespace {

// The turn of `angle_rad` that is next to `near_rad`.
double next_to(double angle_rad, double near_rad) noexcept {
  return near_rad + std::remainder(angle_rad - near_rad, 2.0 * std::numbers::pi);
}

urdf::Side other(urdf::Side side) noexcept {
  return side == urdf::Side::left ? urdf::Side::right : urdf::Side::left;
}

}  // namespace

void FootOdometry::update(const SupportKinematics& kinematics, urdf::Side support) noexcept {
  if (!started_) {
    started_ = true;
    support_ = support;
    const double left_rad = kinematics.world_heading_rad(urdf::Side::left);
    first_heading_rad_ =
        left_rad + 0.5 * (next_to(kinematics.world_heading_rad(urdf::Side::right), left_rad) - left_rad);
    turn(kinematics);
    place_others(kinematics);
    const Eigen::Vector2d middle_m = 0.5 * (foot_[0].place_m + foot_[1].place_m);
    for (Pose* const pose : {&foot_[0], &foot_[1], &base_}) pose->place_m -= middle_m;
    return;
  }
  turn(kinematics);
  place_others(kinematics);
  support_ = support;
}

void FootOdometry::turn(const SupportKinematics& kinematics) noexcept {
  for (const urdf::Side side : urdf::kSides) {
    Pose& foot = foot_[static_cast<std::size_t>(side)];
    foot.yaw_rad = next_to(kinematics.world_heading_rad(side) - first_heading_rad_, foot.yaw_rad);
  }
}

void FootOdometry::place_others(const SupportKinematics& kinematics) noexcept {
  const Pose& stands = foot_[static_cast<std::size_t>(support_)];
  const Eigen::Rotation2Dd turned(stands.yaw_rad);
  const urdf::Side moves = other(support_);
  foot_[static_cast<std::size_t>(moves)].place_m =
      stands.place_m + turned * kinematics.sole_point_m(support_, moves, Eigen::Vector2d::Zero()).head<2>();
  const SupportKinematics::BasePlace base = kinematics.base(support_);
  base_.place_m = stands.place_m + turned * base.place_m;
  base_.yaw_rad = next_to(stands.yaw_rad + base.yaw_rad, base_.yaw_rad);
}

}  // namespace gaitway::zmp
