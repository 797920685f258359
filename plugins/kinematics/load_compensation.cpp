// Accelerations by differences over the planned points, the ground's force from the planned ZMP.
#include "gaitway/kinematics/load_compensation.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::kinematics {
namespace {

using facts::kGravity_m_per_s2;
constexpr int kReach = 2;        // points to either side for a difference: smooths the solver's tolerance
constexpr int kLeadSpacing = 4;  // points of the tail from one lead that is computed to the next
constexpr double kFadePerPoint = 1.0 / 60.0;
// The ZMP moves between the feet from near one to near the other; beyond, one foot bears all.
constexpr double kOneFootShare = 0.12;

double smooth_share(double s) noexcept {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

LoadCompensation::LoadCompensation(const urdf::RobotModel& model)
    : model_(model),
      load_{LegLoad(model, urdf::Side::left), LegLoad(model, urdf::Side::right)},
      mass_kg_(model.total_mass_kg()),
      com_height_m_(urdf::home_com_height_m(model)) {}

void LoadCompensation::read_row(const JointPlan& joint_plan, int point) {
  Row& row = rows_[static_cast<std::size_t>(point)];
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      row.angle_rad[side][i] = static_cast<double>(joint_plan.position[point][model_.legs[side].joints[i]]);
    }
    row.places[side] = load_[side].places(base_[static_cast<std::size_t>(point)], row.angle_rad[side]);
  }
}

const LoadCompensation::Row& LoadCompensation::row(int point) const noexcept {
  return point < 0 ? past_.rows[static_cast<std::size_t>(kBefore + point)]
                   : rows_[static_cast<std::size_t>(point)];
}

std::array<GroundForce, 2> LoadCompensation::ground_forces(const MotionPlan& plan, int point) const noexcept {
  const Eigen::Vector2d com(plan.com[point][0], plan.com[point][1]);
  const Eigen::Vector2d zmp(plan.zmp[point][0], plan.zmp[point][1]);
  Eigen::Vector3d whole_N(0.0, 0.0, mass_kg_ * kGravity_m_per_s2);
  whole_N.head<2>() = mass_kg_ * kGravity_m_per_s2 / com_height_m_ * (com - zmp);
  std::array<Eigen::Vector2d, 2> foot;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Rotation2Dd turn(plan.foot_yaw[point][side]);
    foot[side] = Eigen::Map<const Eigen::Vector2d>(plan.foot_position[point][side]) +
                 turn * model_.feet[side].centre_m;
  }
  std::array<double, 2> share{plan.support[point] == 1 ? 0.0 : 1.0, plan.support[point] == 1 ? 1.0 : 0.0};
  if (plan.support[point] == 2) {
    const Eigen::Vector2d between = foot[1] - foot[0];
    const double s = (zmp - foot[0]).dot(between) / std::max(between.squaredNorm(), 1e-6);
    share[1] = smooth_share((s - kOneFootShare) / (1.0 - 2.0 * kOneFootShare));
    share[0] = 1.0 - share[1];
  }
  // Both feet's points are moved alike until the whole force acts at the ZMP.
  const Eigen::Vector2d moved = zmp - (share[0] * foot[0] + share[1] * foot[1]);
  std::array<GroundForce, 2> forces;
  for (std::size_t side = 0; side < 2; ++side) {
    forces[side].force_N = share[side] * whole_N;
    forces[side].point_m.head<2>() = foot[side] + moved;
    forces[side].point_m.z() = plan.foot_position[point][side][2];
  }
  return forces;
}

std::array<LoadCompensation::Angles, 2> LoadCompensation::lead_rad(const MotionPlan& plan, int point,
                                                                   const Neighbours& by) const {
  const Row& behind = row(by.middle - by.reach);
  const Row& here = row(by.middle);
  const Row& ahead = row(by.middle + by.reach);
  const double span_s = std::max(1, by.reach) * facts::kSlot_s;
  const std::array<GroundForce, 2> ground = ground_forces(plan, point);
  std::array<Angles, 2> lead{};
  for (std::size_t side = 0; side < 2; ++side) {
    std::array<Eigen::Vector3d, 6> acceleration;
    Angles speed{}, angular_acceleration{};
    for (std::size_t i = 0; i < 6; ++i) {
      acceleration[i] =
          (ahead.places[side].com_m[i] - 2.0 * here.places[side].com_m[i] + behind.places[side].com_m[i]) /
          (span_s * span_s);
      speed[i] = (ahead.angle_rad[side][i] - behind.angle_rad[side][i]) / (2.0 * span_s);
      angular_acceleration[i] =
          (ahead.angle_rad[side][i] - 2.0 * here.angle_rad[side][i] + behind.angle_rad[side][i]) /
          (span_s * span_s);
    }
    const Angles torque = load_[side].torque_Nm(row(point).places[side], acceleration, speed,
                                                angular_acceleration, ground[side]);
    for (std::size_t i = 0; i < 6; ++i) {
      const urdf::Joint& joint = model_.joints[static_cast<std::size_t>(model_.legs[side].joints[i])];
      lead[side][i] = torque[i] / joint.servo.stiffness_Nm_per_rad;
    }
  }
  return lead;
}

// Which share of the lead the references have now, as least squares see it.
double LoadCompensation::share_of(std::span<const double> reference_rad,
                                  const std::array<Angles, 2>& lead) const {
  if (reference_rad.size() < model_.joints.size()) return 0.0;
  double together = 0.0, square = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      const double reference = reference_rad[static_cast<std::size_t>(model_.legs[side].joints[i])];
      together += lead[side][i] * (reference - rows_[0].angle_rad[side][i]);
      square += lead[side][i] * lead[side][i];
    }
  }
  return square > 0.0 && std::isfinite(together) ? std::clamp(together / square, 0.0, 1.0) : 0.0;
}

void LoadCompensation::add(const std::array<Angles, 2>& lead, JointPlan& joint_plan,
                           int point) const noexcept {
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      joint_plan.position[point][model_.legs[side].joints[i]] +=
          static_cast<float>(past_.share * lead[side][i]);
    }
  }
}

void LoadCompensation::apply(const MotionPlan& plan, bool goes_on, std::span<const double> reference_rad,
                             JointPlan& joint_plan) {
  past_before_ = past_;
  const int points = static_cast<int>(kBatchPoints) + static_cast<int>(plan.tail_count);
  const int known = std::min(points, static_cast<int>(kBatchPoints) + kReach);
  for (int point = 0; point < known; ++point) read_row(joint_plan, point);
  // At either end of what is known, the nearest point that has neighbours on both sides stands in.
  const int first = goes_on && past_.started ? 0 : kReach;
  const auto neighbours = [&](int point) {
    return Neighbours{std::clamp(point, first, known - 1 - kReach), kReach};
  };
  if (!past_.started) {
    past_.share = share_of(reference_rad, lead_rad(plan, 0, neighbours(0)));
    past_.started = true;
  }
  std::array<Angles, 2> lead{};
  for (int point = 0; point < static_cast<int>(kBatchPoints); ++point) {
    lead = lead_rad(plan, point, neighbours(point));
    past_.share = std::min(1.0, past_.share + kFadePerPoint);
    add(lead, joint_plan, point);
  }
  add_to_tail(plan, points, lead, joint_plan);
  for (int k = 0; k < kBefore; ++k) {
    past_.rows[static_cast<std::size_t>(k)] = rows_[kBatchPoints - kBefore + static_cast<std::size_t>(k)];
  }
}

// The tail is rarely played: its leads are computed at every fourth point and drawn straight between.
void LoadCompensation::add_to_tail(const MotionPlan& plan, int points, std::array<Angles, 2> lead,
                                   JointPlan& joint_plan) {
  for (int point = kBatchPoints; point < points + kLeadSpacing; point += kLeadSpacing) {
    read_row(joint_plan, std::min(point, points - 1));
  }
  for (int last = kBatchPoints - 1; last < points - 1;) {
    const int knot =
        std::min(last < kBatchPoints ? static_cast<int>(kBatchPoints) + kLeadSpacing : last + kLeadSpacing,
                 points - 1);
    const bool has_neighbours =
        knot + kLeadSpacing < points && knot - kLeadSpacing >= static_cast<int>(kBatchPoints);
    const std::array<Angles, 2> next = lead_rad(
        plan, knot, has_neighbours ? Neighbours{knot, kLeadSpacing} : Neighbours{knot, 0});  // 0: at rest
    for (int point = last + 1; point <= knot; ++point) {
      const double s = static_cast<double>(point - last) / (knot - last);
      std::array<Angles, 2> between = lead;
      for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < 6; ++i) between[side][i] += s * (next[side][i] - lead[side][i]);
      }
      add(between, joint_plan, point);
    }
    lead = next;
    last = knot;
  }
}

}  // namespace gaitway::kinematics
