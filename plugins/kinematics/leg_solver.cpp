// The closed form, and the choice between it and the general solver. Notation: c_ and s_ are cosine and
// sine, all vectors are along the leg's axes.
#include "gaitway/kinematics/leg_solver.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

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

std::variant<ClosedFormLeg, KdlLeg> make_leg(const urdf::RobotModel& model, urdf::Side side,
                                             SolverChoice choice, std::string& reason) {
  if (choice == SolverChoice::kdl) return KdlLeg(model, side);
  LegRecognition recognition = recognise_leg(model, side);
  if (recognition.geometry) return ClosedFormLeg(*recognition.geometry);
  if (choice == SolverChoice::closed_form) {
    throw urdf::RobotError(
        fmt::format("{}: the {} leg has no closed-form inverse kinematics: {}; choose solver 'auto' "
                    "or 'kdl'",
                    model.name, side == urdf::Side::left ? "left" : "right", recognition.reason));
  }
  reason = std::move(recognition.reason);
  return KdlLeg(model, side);
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
  const LegSolution upright = solve_branch(base_from_sole, 1.0);
  if (upright.status != LegStatus::joint_limit) return upright;
  const LegSolution folded = solve_branch(base_from_sole, -1.0);
  return folded.reached() ? folded : upright;
}

LegSolution ClosedFormLeg::out_of_reach(double distance_m) const noexcept {
  const double stretched = distance_m - thigh_length_m_ - shin_length_m_;
  if (stretched > 0.0) return unreachable(LegStatus::over_stretched, stretched);
  return unreachable(LegStatus::over_folded, std::abs(thigh_length_m_ - shin_length_m_) - distance_m);
}

LegSolution ClosedFormLeg::solve_branch(const Eigen::Isometry3d& base_from_sole,
                                        double hip_above) const noexcept {
  const LegGeometry& g = geometry_;
  const Eigen::Matrix3d base_from_foot = base_from_sole.linear() * g.sole_from_leg;
  // Rotation of the foot since the zero posture: R = Rz(yaw) Rx(roll) Ry(hip pitch + knee + ankle) R6.
  const Eigen::Matrix3d rotation = g.base_from_leg.transpose() * base_from_foot;
  const Eigen::Vector3d to_hip =  // from the ankle to the hip, as the foot sees it
      base_from_foot.transpose() * (g.hip_m - base_from_sole.translation()) - g.ankle_m;

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

  // Knee: law of cosines.
  const double hip_x = ex * hip_e - ez * in_plane;
  const double hip_z = ez * hip_e + ex * in_plane;
  const double distance_squared = hip_x * hip_x + hip_z * hip_z;
  const double c_bend =
      (distance_squared - thigh_length_m_ * thigh_length_m_ - shin_length_m_ * shin_length_m_) /
      (2.0 * thigh_length_m_ * shin_length_m_);
  if (!(std::abs(c_bend) <= 1.0)) return out_of_reach(std::sqrt(distance_squared));
  const double s_bend = g.knee_sign * std::sqrt(1.0 - c_bend * c_bend);
  const double c_knee = c_bend * knee_zero_cos_ + s_bend * knee_zero_sin_;
  const double s_knee = s_bend * knee_zero_cos_ - c_bend * knee_zero_sin_;
  const double knee = std::atan2(s_knee, c_knee);

  // Ankle pitch: from where the hip is seen, to where the shin has it.
  const double shin_x = s_knee * g.thigh_m.y() - c_knee * g.thigh_m.x() - g.shin_m.x();
  const double shin_z = -s_knee * g.thigh_m.x() - c_knee * g.thigh_m.y() - g.shin_m.y();
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
    const auto turns = turns_about(g.hip_order, rotation * ankle_roll.inverse() * pitch.inverse());
    constexpr std::array<std::size_t, 3> kSignOfAxis{
        1, 2, 0};  // LegJoint: roll about x, pitch about y, yaw about z
    for (std::size_t i = 0; i < turns.size(); ++i) {
      solution.angle_rad[i] = turns[i] * g.axis_sign[kSignOfAxis[static_cast<std::size_t>(g.hip_order[i])]];
    }
  }
  check_limits(g.limits, solution);
  return solution;
}

SolverChoice solver_choice(const std::string& name) {
  if (name == "auto") return SolverChoice::automatic;
  if (name == "closed_form") return SolverChoice::closed_form;
  if (name == "kdl") return SolverChoice::kdl;
  throw std::invalid_argument(fmt::format("solver: '{}' is none of 'auto', 'closed_form', 'kdl'", name));
}

LegSolver::LegSolver(const urdf::RobotModel& model, urdf::Side side, SolverChoice choice)
    : leg_(make_leg(model, side, choice, reason_)) {}

}  // namespace gaitway::kinematics
