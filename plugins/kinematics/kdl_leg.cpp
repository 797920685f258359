// Damped Newton iterations over a KDL chain.
#include "gaitway/kinematics/kdl_leg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "damped_step.hpp"

namespace gaitway::kinematics {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

KDL::Chain chain_to_sole(const urdf::RobotModel& model, urdf::Side side) {
  const urdf::Foot& foot = model.feet[static_cast<std::size_t>(side)];
  const std::string& base = model.links.at(0).name;
  const std::string& tip = model.links.at(static_cast<std::size_t>(foot.link)).name;
  KDL::Chain chain;
  if (!model.tree.getChain(base, tip, chain)) {
    throw urdf::RobotError(fmt::format("{}: the kinematic tree has no chain from link '{}' to link '{}'",
                                       model.name, base, tip));
  }
  const urdf::Leg& leg = model.legs[static_cast<std::size_t>(side)];
  std::size_t found = 0;
  for (const KDL::Segment& segment : chain.segments) {
    if (segment.getJoint().getType() == KDL::Joint::None) continue;
    const auto joint = static_cast<std::size_t>(leg.joints[std::min<std::size_t>(found, 5)]);
    if (found == 6 || segment.getJoint().getName() != model.joints.at(joint).name) {
      throw urdf::RobotError(
          fmt::format("{}: joint '{}' between '{}' and '{}' is not the leg's joint number {}; a leg "
                      "has six joints, from hip yaw to ankle roll",
                      model.name, segment.getJoint().getName(), base, tip, found + 1));
    }
    ++found;
  }
  if (found != 6) {
    throw urdf::RobotError(
        fmt::format("{}: {} joints between '{}' and '{}' where a leg has six", model.name, found, base, tip));
  }
  const Eigen::Matrix3d r = foot.sole.linear();
  const Eigen::Vector3d p = foot.sole.translation();
  const KDL::Rotation rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1),
                               r(2, 2));
  chain.addSegment(
      KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame(rotation, KDL::Vector(p.x(), p.y(), p.z()))));
  return chain;
}

// Rotation vector that takes `from` to `to`, base frame.
Eigen::Vector3d rotation_error(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) noexcept {
  const Eigen::Matrix3d turn = to * from.transpose();
  const Eigen::Vector3d sine_axis =
      0.5 * Eigen::Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double sine = sine_axis.norm();
  const double cosine = 0.5 * (turn.trace() - 1.0);
  if (sine < 1e-6 && cosine > 0.0) return sine_axis;
  return sine_axis * (std::atan2(sine, cosine) / std::max(sine, 1e-12));
}

}  // namespace

struct KdlLeg::State {
  State(const urdf::RobotModel& model, urdf::Side side)
      : chain(chain_to_sole(model, side)),
        forward(chain),
        jacobian_solver(chain),
        limits(leg_limits(model, side)) {
    for (std::size_t i = 0; i < 6; ++i) {
      const auto joint = static_cast<std::size_t>(model.legs[static_cast<std::size_t>(side)].joints[i]);
      home[static_cast<Eigen::Index>(i)] = model.joints[joint].home_rad;
    }
    start = home;
  }

  struct Attempt {
    Vector6 angle_rad;
    double position_error_m = 0.0;
    bool converged = false;
  };

  // Position over orientation error, base frame, of the sole at the joint angles `angle`.
  Vector6 error_to(const Eigen::Isometry3d& goal) {
    KDL::Frame frame;
    forward.JntToCart(angle, frame);
    Vector6 error;
    error.head<3>() = goal.translation() - Eigen::Map<const Eigen::Vector3d>(frame.p.data);
    error.tail<3>() = rotation_error(
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data), goal.linear());
    return error;
  }

  Vector6 newton_step(const Vector6& error) {
    jacobian_solver.JntToJac(angle, jacobian);
    return damped_step(jacobian.data, error.head<3>(), error.tail<3>());
  }

  Attempt iterate(const Eigen::Isometry3d& goal, const Vector6& from) {
    angle.data = from;
    Vector6 error = error_to(goal);
    for (int i = 0; i < kLegIterationLimit; ++i) {
      if (error.head<3>().norm() < kAccuracy_m && error.tail<3>().norm() < kAccuracy_rad) {
        return {angle.data, 0.0, true};
      }
      angle.data += newton_step(error);
      error = error_to(goal);
    }
    return {angle.data, error.head<3>().norm(), false};
  }

  LegSolution solution_of(const Attempt& attempt) const {
    if (!attempt.converged) return unreachable(LegStatus::not_converged, attempt.position_error_m);
    LegSolution solution;
    for (std::size_t i = 0; i < 6; ++i) {
      solution.angle_rad[i] = std::remainder(attempt.angle_rad[static_cast<Eigen::Index>(i)], 2.0 * M_PI);
    }
    check_limits(limits, solution);
    return solution;
  }

  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainJntToJacSolver jacobian_solver;
  LegLimits limits;
  KDL::JntArray angle{6};
  KDL::Jacobian jacobian{6};
  Vector6 home, start;
};

KdlLeg::KdlLeg(const urdf::RobotModel& model, urdf::Side side)
    : state_(std::make_unique<State>(model, side)) {}
KdlLeg::~KdlLeg() = default;
KdlLeg::KdlLeg(KdlLeg&&) noexcept = default;
KdlLeg& KdlLeg::operator=(KdlLeg&&) noexcept = default;

LegSolution KdlLeg::solve(const Eigen::Isometry3d& base_from_sole) {
  State::Attempt attempt = state_->iterate(base_from_sole, state_->start);
  LegSolution solution = state_->solution_of(attempt);
  if (!solution.reached()) {
    attempt = state_->iterate(base_from_sole, state_->home);
    const LegSolution again = state_->solution_of(attempt);
    const bool better =
        again.status != LegStatus::not_converged || solution.status == LegStatus::not_converged;
    if (better) solution = again;
  }
  if (solution.reached()) start_from(solution.angle_rad);
  return solution;
}

void KdlLeg::start_from(const std::array<double, 6>& angle_rad) noexcept {
  state_->start = Eigen::Map<const Vector6>(angle_rad.data());
}

}  // namespace gaitway::kinematics
