// Newton's iteration over the leg's own chain. Vectors are in the base frame unless said otherwise.
#include "gaitway/kinematics/general_leg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "damped_step.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::kinematics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double kLongestStep_rad = 0.5;   // that is not damped
constexpr double kNear_rad = 0.2;          // largest error for which the step is not damped
constexpr double kLeastHipVolume = 0.05;   // spanned by the hip's axes
constexpr double kLeastLegVolume = 0.005;  // spanned by what the other joints move, in cubes of the reach

// Unit vector at right angles to both; if these are parallel, to the first.
Vector3d across(const Vector3d& first, const Vector3d& second) {
  const Vector3d normal = first.cross(second);
  return normal.norm() > 1e-12 ? Vector3d(normal.normalized()) : first.unitOrthogonal();
}

// The frame whose z is `axis` and whose x is `x` as nearly as it can be.
Matrix3d frame_about(const Vector3d& axis, const Vector3d& x) {
  Matrix3d frame;
  frame.col(2) = axis;
  frame.col(1) = axis.cross(x).normalized();
  frame.col(0) = frame.col(1).cross(axis);
  return frame;
}

// Rotation vector from the sum of the products of the frames' axes, cross and dot.
Vector3d rotation_vector(const Vector3d& sine_axis, double cosine) noexcept {
  const double square = sine_axis.squaredNorm();
  if (square < 1e-4 && cosine > 0.0) return sine_axis * (1.0 + square * (1.0 / 6.0 + square * (3.0 / 40.0)));
  const double sine = std::sqrt(square);
  return sine_axis * (std::atan2(sine, cosine) / std::max(sine, 1e-12));
}

}  // namespace

struct GeneralLeg::Posture {
  std::array<Vector3d, 6> joint_m, axis;
  Vector3d sole_m;
  Matrix3d last_frame;

  [[nodiscard]] Matrix6d jacobian() const noexcept {  // of the sole, position above rotation
    Matrix6d columns;
    for (std::size_t i = 0; i < 6; ++i) {
      columns.col(static_cast<Eigen::Index>(i)) << axis[i].cross(sole_m - joint_m[i]), axis[i];
    }
    return columns;
  }
};

struct GeneralLeg::Error {
  Vector3d position_m, rotation_rad;
  Error(const Posture& is, const Vector3d& sole_m, const Matrix3d& last_frame) noexcept
      : position_m(sole_m - is.sole_m) {
    Vector3d sine_axis = Vector3d::Zero();
    double cosine = -1.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      sine_axis += is.last_frame.col(axis).cross(last_frame.col(axis));
      cosine += is.last_frame.col(axis).dot(last_frame.col(axis));
    }
    rotation_rad = rotation_vector(0.5 * sine_axis, 0.5 * cosine);
  }
  [[nodiscard]] bool small() const noexcept {
    return position_m.squaredNorm() < kAccuracy_m * kAccuracy_m &&
           rotation_rad.squaredNorm() < kAccuracy_rad * kAccuracy_rad;
  }
};

struct GeneralLeg::Attempt {
  Vector6d angle_rad;
  double position_error_m = 0.0;
  bool converged = false;
};

namespace {

// Rows of the inverse of the matrix with these columns, times its determinant.
struct Adjugate {
  Adjugate(const Vector3d& a, const Vector3d& b, const Vector3d& c) noexcept
      : row{b.cross(c), c.cross(a), a.cross(b)}, determinant(a.dot(row[0])) {}
  [[nodiscard]] Vector3d times(const Vector3d& v) const noexcept {
    return {row[0].dot(v), row[1].dot(v), row[2].dot(v)};
  }
  std::array<Vector3d, 3> row;
  double determinant;
};

}  // namespace

// The step that takes the posture to the goal, to first order: with H and K the axes of the hip's three
// joints and of the others, E and P what they move the hip's third joint by,
//   [ E P ] [ hip    ]   [ position ]
//   [ H K ] [ others ] = [ rotation ].
struct GeneralLeg::NewtonStep {
  Vector6d rad;
  bool regular = false;  // neither is the leg nearly straight nor the hip at its gimbal lock

  NewtonStep(const Posture& is, const Error& error, double least_volume_m3) noexcept {
    const Vector3d& pivot = is.joint_m[2];
    const Adjugate hip(is.axis[0], is.axis[1], is.axis[2]);
    const double per_volume = 1.0 / hip.determinant;
    const Vector3d first = is.axis[0].cross(pivot - is.joint_m[0]);
    const Vector3d second = is.axis[1].cross(pivot - is.joint_m[1]);
    // What the hip moves the pivot by when it turns by `turn` as a whole, E H⁻¹.
    const auto moved = [&](const Vector3d& turn) -> Vector3d {
      return first * (per_volume * hip.row[0].dot(turn)) + second * (per_volume * hip.row[1].dot(turn));
    };
    std::array<Vector3d, 3> column;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& axis = is.axis[i + 3];
      column[i] = axis.cross(pivot - is.joint_m[i + 3]) - moved(axis);
    }
    const Adjugate leg(column[0], column[1], column[2]);
    regular = std::abs(hip.determinant) > kLeastHipVolume && std::abs(leg.determinant) > least_volume_m3;
    const Vector3d& turn = error.rotation_rad;
    const Vector3d way = error.position_m + turn.cross(pivot - is.sole_m) - moved(turn);
    rad.tail<3>() = leg.times(way) / leg.determinant;
    rad.head<3>() =
        per_volume * hip.times(turn - is.axis[3] * rad[3] - is.axis[4] * rad[4] - is.axis[5] * rad[5]);
  }
};

namespace {

// Of a solution that is none yet, and one that was sought for that.
LegSolution better_of(const LegSolution& so_far, const LegSolution& again) noexcept {
  const bool found_none = again.status == LegStatus::not_converged;
  return found_none && so_far.status != LegStatus::not_converged ? so_far : again;
}

}  // namespace

GeneralLeg::GeneralLeg(const urdf::RobotModel& model, urdf::Side side) : limits_(leg_limits(model, side)) {
  if (const std::string fault = leg_chain_fault(model, side); !fault.empty()) {
    throw urdf::RobotError(
        fmt::format("{}: {}; a leg has six joints, from the hip to the sole", model.name, fault));
  }
  if (const std::optional<LegGeometry> geometry = nearest_closed_form(model, side))
    nearest_.emplace(*geometry);
  urdf::ForwardKinematics zero(model);
  zero.compute(std::vector<double>(model.joints.size(), 0.0));
  std::array<Vector3d, 7> place_m;  // of the joints and the sole, zero posture
  std::array<Vector3d, 6> axis;
  for (std::size_t i = 0; i < 6; ++i) {
    const int joint = model.legs[urdf::index_of(side)].joints[i];
    place_m[i] = zero.link_position_m(model.joints[static_cast<std::size_t>(joint)].child_link);
    axis[i] = zero.joint_axis(model, joint).normalized();
    home_rad_[i] = model.joints[static_cast<std::size_t>(joint)].home_rad;
  }
  place_m[6] = zero.sole_pose(side).translation();
  first_joint_m_ = place_m[0];
  first_frame_ = frame_about(axis[0], axis[0].unitOrthogonal());
  Matrix3d frame = first_frame_;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector3d& next = axis[std::min<std::size_t>(i + 1, 5)];
    const Matrix3d turned = frame_about(axis[i], across(axis[i], next));
    Link& link = links_[i];
    link.zero_rad = std::atan2(turned.col(0).dot(frame.col(1)), turned.col(0).dot(frame.col(0)));
    link.m = turned.transpose() * (place_m[i + 1] - place_m[i]);
    link.twist_cos = next.dot(turned.col(2));
    link.twist_sin = -next.dot(turned.col(1));
    frame = frame_about(next, turned.col(0));
    reach_m_ += link.m.norm();
  }
  last_from_sole_ = frame.transpose() * zero.sole_pose(side).linear();
}

GeneralLeg::Posture GeneralLeg::forward(const Vector6& angle_rad) const noexcept {
  Posture posture;
  Vector3d x = first_frame_.col(0), y = first_frame_.col(1), z = first_frame_.col(2),
           place_m = first_joint_m_;
  for (std::size_t i = 0; i < 6; ++i) {
    const Link& link = links_[i];
    posture.joint_m[i] = place_m;
    posture.axis[i] = z;
    const double angle = angle_rad[static_cast<Eigen::Index>(i)] + link.zero_rad;
    const double c = std::cos(angle), s = std::sin(angle);
    const Vector3d turned_y = c * y - s * x;
    x = c * x + s * y;
    place_m += x * link.m.x() + turned_y * link.m.y() + z * link.m.z();
    y = link.twist_cos * turned_y + link.twist_sin * z;
    z = link.twist_cos * z - link.twist_sin * turned_y;
  }
  posture.sole_m = place_m;
  posture.last_frame << x, y, z;
  return posture;
}

GeneralLeg::Attempt GeneralLeg::iterate(const Eigen::Isometry3d& goal, Vector6 angle_rad) const noexcept {
  const Matrix3d last_frame = goal.linear() * last_from_sole_.transpose();
  const double least_volume_m3 = kLeastLegVolume * reach_m_ * reach_m_ * reach_m_;
  // A step so short leaves an error of second order that is smaller than the accuracy.
  const double last_step_rad = std::sqrt(kAccuracy_m / std::max(1.0, reach_m_));
  double position_error_m = 0.0;
  for (int i = 0; i <= kLegIterationLimit; ++i) {
    const Posture is = forward(angle_rad);
    const Error error(is, goal.translation(), last_frame);
    if (error.small()) return {angle_rad, 0.0, true};
    position_error_m = error.position_m.norm();
    if (!std::isfinite(position_error_m)) break;
    const bool near =
        position_error_m < kNear_rad * reach_m_ && error.rotation_rad.squaredNorm() < kNear_rad * kNear_rad;
    if (near) {
      const NewtonStep step(is, error, least_volume_m3);
      const double length_rad = step.rad.lpNorm<1>();
      if (step.regular && length_rad < kLongestStep_rad) {
        angle_rad += step.rad;
        if (length_rad < last_step_rad) return {angle_rad, 0.0, true};
        continue;
      }
    }
    angle_rad += damped_step(is.jacobian(), error.position_m, error.rotation_rad);
  }
  return {angle_rad, position_error_m, false};
}

LegSolution GeneralLeg::solution_from(const std::array<double, 6>& start_rad,
                                      const Eigen::Isometry3d& goal) const noexcept {
  const Attempt attempt = iterate(goal, Eigen::Map<const Vector6d>(start_rad.data()));
  if (!attempt.converged) return unreachable(LegStatus::not_converged, attempt.position_error_m);
  LegSolution solution;
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle_rad = attempt.angle_rad[static_cast<Eigen::Index>(i)];
    solution.angle_rad[i] = std::abs(angle_rad) > M_PI ? std::remainder(angle_rad, 2.0 * M_PI) : angle_rad;
  }
  check_limits(limits_, solution);
  return solution;
}

LegSolution GeneralLeg::solve(const Eigen::Isometry3d& base_from_sole,
                              const std::array<double, 6>& start_rad) const noexcept {
  const LegSolution solution = solution_from(start_rad, base_from_sole);
  return solution.reached() ? solution : better_of(solution, solve(base_from_sole));
}

LegSolution GeneralLeg::solve(const Eigen::Isometry3d& base_from_sole) const noexcept {
  LegSolution solution = unreachable(LegStatus::not_converged, 0.0);
  if (nearest_) {
    const LegSolution nearest = nearest_->solve(base_from_sole);
    if (nearest.reached() || nearest.status == LegStatus::joint_limit) {
      solution = solution_from(nearest.angle_rad, base_from_sole);
    }
  }
  return solution.reached() ? solution : better_of(solution, solution_from(home_rad_, base_from_sole));
}

}  // namespace gaitway::kinematics
