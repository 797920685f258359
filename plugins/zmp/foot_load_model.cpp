// Heights first, then the ZMP, then its shares.
#include "gaitway/zmp/foot_load_model.hpp"

#include <algorithm>
#include <limits>

#include "gaitway/facts/facts.hpp"

namespace gaitway::zmp {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kForceTime_s = 0.02;  // in which the accelerometer's noise and the impacts' ringing settle
// Of a sole's lowest corner above the other sole's, for humanoid22's size: joint zeros and servos that give
// way make less, steps more.
constexpr double kRaised_m = 0.008, kOnGround_m = 0.005;
constexpr double kZmpDeviation_m = 0.010;
constexpr double kLeastShare = 0.1;  // of gravity: with less, the body flies

}  // namespace

FootLoadModel::FootLoadModel(const urdf::RobotModel& model) noexcept
    : feet_(model.feet),
      mass_kg_(model.total_mass_kg()),
      on_ground_m_(kOnGround_m * model.body_scale().factor("m")),
      raised_m_(kRaised_m * model.body_scale().factor("m")),
      zmp_deviation_m_(kZmpDeviation_m * model.body_scale().factor("m")),
      specific_force_(0.0, 0.0, kGravity_m_per_s2) {}

void FootLoadModel::find_raised_feet(const SupportKinematics& kinematics) noexcept {
  std::array<double, 2> height_m{};
  for (const urdf::Side side : urdf::kSides) {
    double& lowest_m = height_m[index_of(side)];
    lowest_m = std::numeric_limits<double>::max();
    for (const Eigen::Vector2d& corner : feet_[index_of(side)].corners_m()) {
      lowest_m = std::min(lowest_m, kinematics.sole_point_m(urdf::Side::left, side, corner).z());
    }
  }
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const double above_other_m = height_m[foot] - height_m[1 - foot];
    raised_[foot] = above_other_m > (raised_[foot] ? on_ground_m_ : raised_m_);
  }
}

void FootLoadModel::update(const SupportKinematics& kinematics,
                           const Eigen::Vector3d& specific_force_m_per_s2, double dt_s) noexcept {
  specific_force_ += dt_s / (kForceTime_s + dt_s) * (specific_force_m_per_s2 - specific_force_);
  find_raised_feet(kinematics);
  force_N_ = CellForces{};
  if (specific_force_.z() < kLeastShare * kGravity_m_per_s2) return;

  const urdf::Side seen_from = urdf::Side::left;
  const Eigen::Vector3d force =
      Eigen::AngleAxisd(-kinematics.heading_rad(seen_from), Eigen::Vector3d::UnitZ()) * specific_force_;
  const Eigen::Vector3d com_m = kinematics.com_m(seen_from);
  std::array<Eigen::Vector3d, 2> middle_m;
  for (const urdf::Side side : urdf::kSides) {
    middle_m[index_of(side)] = kinematics.sole_point_m(seen_from, side, feet_[index_of(side)].centre_m);
  }
  const double ground_m = std::min(middle_m[0].z(), middle_m[1].z());
  const Eigen::Vector2d zmp_m = com_m.head<2>() - (com_m.z() - ground_m) / force.z() * force.head<2>();
  const Eigen::Vector2d apart_m = (middle_m[1] - middle_m[0]).head<2>();
  const double between =
      std::clamp((zmp_m - middle_m[0].head<2>()).dot(apart_m) / apart_m.squaredNorm(), 0.0, 1.0);
  const double on_right = raised_[0] ? 1.0 : raised_[1] ? 0.0 : between;
  const Eigen::Vector2d off_m = zmp_m - ((1.0 - on_right) * middle_m[0] + on_right * middle_m[1]).head<2>();
  for (const urdf::Side side : urdf::kSides) {
    const std::size_t i = index_of(side);
    const Eigen::Vector2d own_m = (kinematics.sole_tilt(side).transpose() * kinematics.turn(side, seen_from) *
                                   Eigen::Vector3d(off_m.x(), off_m.y(), 0.0))
                                      .head<2>();
    const Eigen::Vector2d half_m = 0.5 * feet_[i].size_m;
    const Eigen::Vector2d place_m = feet_[i].centre_m + own_m.cwiseMax(-half_m).cwiseMin(half_m);
    const double share = i == 0 ? 1.0 - on_right : on_right;
    force_N_[i] = feet_[i].cell_forces_N(share * mass_kg_ * force.z(), place_m);
  }
}

}  // namespace gaitway::zmp
