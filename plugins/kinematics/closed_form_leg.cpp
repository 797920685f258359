// From the foot to the hip, joint by joint. Notation: c_ and s_ are cosine and sine, all vectors are along
// the leg's axes.
#include "gaitway/kinematics/closed_form_leg.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::kinematics {
namespace {

double wrapped(double angle_rad) noexcept {
  if (angle_rad > M_PI) return angle_rad - 2.0 * M_PI;
  if (angle_rad < -M_PI) return angle_rad + 2.0 * M_PI;
  return angle_rad;
}

constexpr std::array<Eigen::Index, 3> kUsualHipOrder{2, 0,
                                                     1};  // yaw, roll, pitch: less is needed to decompose it

struct HipAngles {
  double yaw_rad, roll_rad;
  double pitch_sum_rad;  // hip pitch + knee + ankle pitch
};

// Decomposes N = R R6ᵀ = Rz(yaw) Rx(roll) Ry(pitch sum), where R is the foot's rotation and R6 that of the
// ankle roll about the axis (ex, 0, ez). Only a row and a column of N are needed.
HipAngles hip_angles(const Eigen::Matrix3d& rotation, double ex, double ez, double c_roll,
                     double s_roll) noexcept {
  const double row_e = ex * rotation(2, 0) + ez * rotation(2, 2);
  const double row_n = ex * rotation(2, 2) - ez * rotation(2, 0);
  const double turned_n = c_roll * row_n + s_roll * rotation(2, 1);
  const double n20 = ex * row_e - ez * turned_n;
  const double n22 = ez * row_e + ex * turned_n;
  const double n21 = c_roll * rotation(2, 1) - s_roll * row_n;
  const double n01 = c_roll * rotation(0, 1) - s_roll * (ex * rotation(0, 2) - ez * rotation(0, 0));
  const double n11 = c_roll * rotation(1, 1) - s_roll * (ex * rotation(1, 2) - ez * rotation(1, 0));
  return {std::atan2(-n01, n11), std::atan2(n21, std::sqrt(n20 * n20 + n22 * n22)), std::atan2(-n20, n22)};
}

// Decomposes a rotation into turns about three different axes i, j, k (0 x, 1 y, 2 z): R = R_i(first)
// R_j(second) R_k(third), the second within a quarter turn.
std::array<double, 3> turns_about(const std::array<Eigen::Index, 3>& axes,
                                  const Eigen::Matrix3d& r) noexcept {
  const auto [i, j, k] = axes;
  const double parity = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  return {std::atan2(-parity * r(j, k), r(k, k)), std::atan2(parity * r(i, k), std::hypot(r(i, i), r(i, j))),
          std::atan2(-parity * r(i, j), r(i, i))};
}

}  // namespace

ClosedFormLeg::ClosedFormLeg(const LegGeometry& geometry) noexcept
    : geometry_(geometry), thigh_length_m_(geometry.thigh_m.norm()), shin_length_m_(geometry.shin_m.norm()) {
  const Eigen::Vector2d& thigh = geometry.thigh_m;
  const Eigen::Vector2d& shin = geometry.shin_m;
  const double scale = 1.0 / (thigh_length_m_ * shin_length_m_);
  knee_zero_cos_ = thigh.dot(shin) * scale;
  knee_zero_sin_ = (thigh.y() * shin.x() - thigh.x() * shin.y()) * scale;
}

LegSolution ClosedFormLeg::solve(const Eigen::Isometry3d& base_from_sole) const noexcept {
  const auto solve_branch =
      geometry_.ankle_rolls_first ? &ClosedFormLeg::solve_roll_first : &ClosedFormLeg::solve_pitch_first;
  const LegSolution upright = (this->*solve_branch)(base_from_sole, 1.0);
  if (upright.status != LegStatus::joint_limit) return upright;
  const LegSolution folded = (this->*solve_branch)(base_from_sole, -1.0);
  return folded.reached() ? folded : upright;
}

LegSolution ClosedFormLeg::out_of_reach(double distance_m) const noexcept {
  const double stretched = distance_m - thigh_length_m_ - shin_length_m_;
  if (stretched > 0.0) return unreachable(LegStatus::over_stretched, stretched);
  return unreachable(LegStatus::over_folded, std::abs(thigh_length_m_ - shin_length_m_) - distance_m);
}

// Law of cosines. distance_squared: from ankle to hip in the leg's plane.
ClosedFormLeg::Knee ClosedFormLeg::knee_at(double distance_squared) const noexcept {
  const LegGeometry& g = geometry_;
  const double c_bend =
      (distance_squared - thigh_length_m_ * thigh_length_m_ - shin_length_m_ * shin_length_m_) /
      (2.0 * thigh_length_m_ * shin_length_m_);
  if (!(std::abs(c_bend) <= 1.0)) return {};
  const double s_bend = g.knee_sign * std::sqrt(1.0 - c_bend * c_bend);
  const double c_knee = c_bend * knee_zero_cos_ + s_bend * knee_zero_sin_;
  const double s_knee = s_bend * knee_zero_cos_ - c_bend * knee_zero_sin_;
  return {true, std::atan2(s_knee, c_knee), s_knee * g.thigh_m.y() - c_knee * g.thigh_m.x() - g.shin_m.x(),
          -s_knee * g.thigh_m.x() - c_knee * g.thigh_m.y() - g.shin_m.y()};
}

void ClosedFormLeg::set_hip(const Eigen::Matrix3d& hip, LegSolution& solution) const noexcept {
  const auto turns = turns_about(geometry_.hip_order, hip);
  constexpr std::array<std::size_t, 3> kSignOfAxis{1, 2,
                                                   0};  // LegJoint: roll about x, pitch about y, yaw about z
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto axis = static_cast<std::size_t>(geometry_.hip_order[i]);
    solution.angle_rad[i] = turns[i] * geometry_.axis_sign[kSignOfAxis[axis]];
  }
}

ClosedFormLeg::Seen ClosedFormLeg::seen_from(const Eigen::Isometry3d& base_from_sole) const noexcept {
  const LegGeometry& g = geometry_;
  const Eigen::Matrix3d base_from_foot = base_from_sole.linear() * g.sole_from_leg;
  return {g.base_from_leg.transpose() * base_from_foot,
          base_from_foot.transpose() * (g.hip_m - base_from_sole.translation()) - g.ankle_m};
}

LegSolution ClosedFormLeg::solve_pitch_first(const Eigen::Isometry3d& base_from_sole,
                                             double hip_above) const noexcept {
  const LegGeometry& g = geometry_;
  const auto [rotation, to_hip] = seen_from(base_from_sole);
  // Ankle roll: turns the hip until it is `lateral` off the leg's plane. The axes e (roll), y, n = e × y.
  const double ex = g.ankle_roll_axis.x();
  const double ez = g.ankle_roll_axis.y();
  const double hip_e = ex * to_hip.x() + ez * to_hip.z();
  const double hip_n = ex * to_hip.z() - ez * to_hip.x();
  const double radius = std::sqrt(to_hip.y() * to_hip.y() + hip_n * hip_n);
  if (!(radius > std::abs(g.lateral_m))) {
    return unreachable(LegStatus::over_folded, std::abs(g.lateral_m) - radius);
  }
  const double in_plane = hip_above * std::sqrt(radius * radius - g.lateral_m * g.lateral_m);
  const double scale = 1.0 / (radius * radius);
  const double s_roll = (to_hip.y() * in_plane + hip_n * g.lateral_m) * scale;
  const double c_roll = (hip_n * in_plane - to_hip.y() * g.lateral_m) * scale;

  const double hip_x = ex * hip_e - ez * in_plane;
  const double hip_z = ez * hip_e + ex * in_plane;
  const double distance_squared = hip_x * hip_x + hip_z * hip_z;
  const Knee bent = knee_at(distance_squared);
  if (!bent.in_reach) return out_of_reach(std::sqrt(distance_squared));

  // Ankle pitch: from where the hip is seen, to where the shin has it.
  const double knee = bent.rad, shin_x = bent.ankle_to_hip_x, shin_z = bent.ankle_to_hip_z;
  const double ankle = std::atan2(hip_z * shin_x - hip_x * shin_z, hip_x * shin_x + hip_z * shin_z);

  const double roll = std::atan2(s_roll, c_roll);
  LegSolution solution;
  solution.angle_rad = {0.0, 0.0, 0.0, knee * g.axis_sign[3], ankle * g.axis_sign[4], roll * g.axis_sign[5]};
  if (g.hip_order == kUsualHipOrder) {
    const HipAngles hip = hip_angles(rotation, ex, ez, c_roll, s_roll);
    solution.angle_rad[0] = hip.yaw_rad * g.axis_sign[0];
    solution.angle_rad[1] = hip.roll_rad * g.axis_sign[1];
    solution.angle_rad[2] = wrapped(wrapped(hip.pitch_sum_rad - knee) - ankle) * g.axis_sign[2];
  } else {
    const Eigen::AngleAxisd ankle_roll(roll, Eigen::Vector3d(ex, 0.0, ez)),
        pitch(knee + ankle, Eigen::Vector3d::UnitY());
    set_hip(rotation * ankle_roll.inverse() * pitch.inverse(), solution);
  }
  check_limits(g.limits, solution);
  return solution;
}

// The distance from ankle to hip gives the knee; as the shin sees it, the hip is then at a known place. The
// ankle pitch turns the hip until it is as far along the roll axis as there, the roll does the rest.
LegSolution ClosedFormLeg::solve_roll_first(const Eigen::Isometry3d& base_from_sole,
                                            double hip_above) const noexcept {
  const LegGeometry& g = geometry_;
  const auto [rotation, to_hip] = seen_from(base_from_sole);
  const double in_plane_squared = to_hip.squaredNorm() - g.lateral_m * g.lateral_m;
  const Knee bent = knee_at(in_plane_squared);
  if (!bent.in_reach) return out_of_reach(std::sqrt(std::max(in_plane_squared, 0.0)));

  // The axes e (roll), y, n = e × y; of the hip as the foot sees it, and as the shin does.
  const double ex = g.ankle_roll_axis.x();
  const double ez = g.ankle_roll_axis.y();
  const double foot_e = ex * to_hip.x() + ez * to_hip.z();
  const double foot_n = ex * to_hip.z() - ez * to_hip.x();
  const double shin_e = ex * bent.ankle_to_hip_x + ez * bent.ankle_to_hip_z;
  const double shin_n = ex * bent.ankle_to_hip_z - ez * bent.ankle_to_hip_x;
  const double radius_squared = foot_e * foot_e + foot_n * foot_n;
  const double between_squared = radius_squared - shin_e * shin_e;
  if (!(between_squared > 0.0)) {
    return unreachable(LegStatus::over_folded, std::abs(shin_e) - std::sqrt(radius_squared));
  }
  const double between_n = hip_above * std::sqrt(between_squared);  // pitched, not yet rolled; y is to_hip's
  const double pitch = std::atan2(foot_n * shin_e - foot_e * between_n, foot_e * shin_e + foot_n * between_n);
  const double roll = std::atan2(to_hip.y() * shin_n + between_n * g.lateral_m,
                                 between_n * shin_n - to_hip.y() * g.lateral_m);

  LegSolution solution;
  solution.angle_rad = {
      0.0, 0.0, 0.0, bent.rad * g.axis_sign[3], roll * g.axis_sign[5], pitch * g.axis_sign[4]};
  const Eigen::AngleAxisd knee(bent.rad, Eigen::Vector3d::UnitY()),
      ankle_roll(roll, Eigen::Vector3d(ex, 0.0, ez)), ankle_pitch(pitch, Eigen::Vector3d::UnitY());
  set_hip(rotation * (knee * ankle_roll * ankle_pitch).inverse().toRotationMatrix(), solution);
  check_limits(g.limits, solution);
  return solution;
}

}  // namespace gaitway::kinematics
