// Walks over the points of a motion plan.
#include "gaitway/kinematics/batch_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace gaitway::kinematics {
namespace {

constexpr int kKnotSpacing = 4;  // points of the tail from one placement of the base to the next

// Quadratic through three values at the points a, b, c, evaluated at t; they may be equal or lie anywhere.
struct QuadraticWeights {
  QuadraticWeights(double a, double b, double c, double t) noexcept
      : first((t - b) * (t - c) / ((a - b) * (a - c))),
        second((t - a) * (t - c) / ((b - a) * (b - c))),
        third((t - a) * (t - b) / ((c - a) * (c - b))) {}
  double first, second, third;
};

PlanPoint point_of(const MotionPlan& plan, int point, const BaseOffset& correction) noexcept {
  PlanPoint result;
  result.hip_height_m = plan.hip_height[point];
  result.base_yaw_rad = plan.base_yaw[point];
  result.base_attitude_rad = correction.attitude_rad;
  result.com_m = {plan.com[point][0], plan.com[point][1]};
  result.com_offset_m = correction.com_m;
  for (std::size_t i = 0; i < 2; ++i) {
    const double* foot = plan.foot_position[point][i];
    result.foot_m[i] = {foot[0], foot[1], foot[2]};
    result.foot_yaw_rad[i] = plan.foot_yaw[point][i];
  }
  return result;
}

BatchOutcome leg_failure(int point, const BothLegs& legs) noexcept {
  const bool left = !legs[0].reached();
  return {BatchOutcome::Kind::leg_unreachable, point, left ? urdf::Side::left : urdf::Side::right,
          left ? legs[0] : legs[1]};
}

}  // namespace

struct BatchSolver::Run {
  const MotionPlan& plan;
  JointPlan& joint_plan;
  CorrectionFade fade;
  std::array<Knot, kBatchPoints> batch{};

  [[nodiscard]] PlanPoint at(int point) const noexcept {
    return point_of(plan, point, fade.at(static_cast<std::uint64_t>(point)));
  }
};

BatchSolver::BatchSolver(const urdf::RobotModel& model, SolverChoice choice)
    : model_(model), placement_(model_, choice) {
  if (model_.joints.size() > static_cast<std::size_t>(kMaxJoints)) {
    throw urdf::RobotError(fmt::format("{}: {} joints; a joint plan holds at most {}", model_.name,
                                       model_.joints.size(), kMaxJoints));
  }
  for (const urdf::Joint& joint : model_.joints) home_rad_.push_back(static_cast<float>(joint.home_rad));
}

BatchOutcome BatchSolver::solve(const MotionPlan& plan, const BaseOffset& correction, JointPlan& joint_plan) {
  if (plan.tail_count > static_cast<std::uint32_t>(kMaxTailPoints)) {
    return {BatchOutcome::Kind::too_many_points, static_cast<int>(plan.tail_count), urdf::Side::left, {}};
  }
  Run run{plan, joint_plan, fade_};
  run.fade.begin(plan.sequence, kBatchPoints, plan.tail_count, correction);
  if (const BatchOutcome outcome = solve_batch(run); !outcome.solved()) return outcome;
  if (const BatchOutcome outcome = solve_tail(run); !outcome.solved()) return outcome;

  joint_plan.sequence = plan.sequence;
  joint_plan.joint_count = static_cast<std::uint32_t>(home_rad_.size());
  joint_plan.tail_count = plan.tail_count;
  joint_plan.reserved = 0;
  std::memcpy(joint_plan.support, plan.support, kBatchPoints + plan.tail_count);
  fade_ = run.fade;
  sequence_ = plan.sequence;
  std::copy(run.batch.end() - 3, run.batch.end(), last_.begin());
  return {};
}

BatchOutcome BatchSolver::solve_point(Run& run, int point, const Eigen::Vector2d& guess_m, double tolerance_m,
                                      Knot& knot) {
  const PointFrames frames = placement_.frames(run.at(point));
  const WholeBodyPlacement::Result result = placement_.place_com(frames, guess_m, tolerance_m);
  if (!result.converged) {
    if (!result.legs[0].reached() || !result.legs[1].reached()) return leg_failure(point, result.legs);
    return {BatchOutcome::Kind::com_not_placed, point, urdf::Side::left, {}};
  }
  knot = {static_cast<double>(point), result.offset_m, result.refined_m};
  write(run.joint_plan, point, result.legs);
  return {};
}

BatchOutcome BatchSolver::solve_batch(Run& run) {
  // The points before this batch, if the last batch was the one before; else the newest offset must do.
  std::array<Knot, 3> before = last_;
  const bool successor = sequence_ != 0 && run.plan.sequence == sequence_ + 1;
  for (Knot& knot : before) {
    knot.point -= kBatchPoints;
    if (!successor) knot.refined_m = sequence_ != 0 ? last_[2].refined_m : placement_.standing_offset_m();
  }
  for (int point = 0; point < kBatchPoints; ++point) {
    // Equidistant points: the quadratic through three of them goes on with 1, -3, 3.
    const Eigen::Vector2d guess = before[0].refined_m + 3.0 * (before[2].refined_m - before[1].refined_m);
    Knot& knot = run.batch[static_cast<std::size_t>(point)];
    if (const BatchOutcome outcome = solve_point(run, point, guess, kBatchTolerance_m, knot);
        !outcome.solved()) {
      return outcome;
    }
    before = {before[1], before[2], knot};
  }
  return {};
}

BatchOutcome BatchSolver::solve_tail(Run& run) {
  const int end = kBatchPoints + static_cast<int>(run.plan.tail_count);
  // Quadratics through three knots: from the past ones to guess the next, from it to fill the points between.
  std::array<Knot, 3> knots{run.batch[0], run.batch[3], run.batch[7]};
  while (static_cast<int>(knots[2].point) < end - 1) {
    const int last = static_cast<int>(knots[2].point);
    const int next = std::min(last + kKnotSpacing, end - 1);
    const QuadraticWeights w(knots[0].point, knots[1].point, knots[2].point, next);
    const Eigen::Vector2d guess =
        w.first * knots[0].refined_m + w.second * knots[1].refined_m + w.third * knots[2].refined_m;
    Knot knot;
    if (const BatchOutcome outcome = solve_point(run, next, guess, kTailTolerance_m, knot);
        !outcome.solved()) {
      return outcome;
    }
    for (int point = last + 1; point < next; ++point) {
      const QuadraticWeights between(knots[1].point, knots[2].point, knot.point, point);
      const Eigen::Vector2d offset =
          between.first * knots[1].used_m + between.second * knots[2].used_m + between.third * knot.used_m;
      const BothLegs legs = placement_.place(placement_.frames(run.at(point)), offset);
      if (!legs[0].reached() || !legs[1].reached()) return leg_failure(point, legs);
      write(run.joint_plan, point, legs);
    }
    knots = {knots[1], knots[2], knot};
  }
  return {};
}

void BatchSolver::write(JointPlan& joint_plan, int point, const BothLegs& legs) const noexcept {
  float* row = joint_plan.position[point];
  std::memcpy(row, home_rad_.data(), home_rad_.size() * sizeof(float));
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      row[model_.legs[side].joints[i]] = static_cast<float>(legs[side].angle_rad[i]);
    }
  }
}

bool BatchSolver::plan_batch(std::uint32_t sequence, const MotionPlan& plan, const Correction& correction,
                             JointPlan& joint_plan) {
  if (plan.sequence != sequence) {
    joint_plan.sequence = 0;
    joint_plan.joint_count = 0;
    joint_plan.tail_count = 0;
    return false;
  }
  const BaseOffset offset{{correction.com_offset[0], correction.com_offset[1]},
                          {correction.base_attitude_offset[0], correction.base_attitude_offset[1]}};
  const BatchOutcome outcome = solve(plan, offset, joint_plan);
  if (!outcome.solved()) {
    throw std::runtime_error("batch " + std::to_string(sequence) + ": " + describe(outcome));
  }
  return true;
}

std::string BatchSolver::describe(const BatchOutcome& outcome) const {
  const auto where = [](int point) {
    return point < kBatchPoints ? fmt::format("point {} of the batch", point + 1)
                                : fmt::format("point {} of the tail", point - kBatchPoints + 1);
  };
  switch (outcome.kind) {
    case BatchOutcome::Kind::solved:
      return "solved";
    case BatchOutcome::Kind::too_many_points:
      return fmt::format("motion_plan: tail_count is {}; at most {} points are allowed", outcome.point,
                         kMaxTailPoints);
    case BatchOutcome::Kind::com_not_placed:
      return fmt::format("{}: no base position brings the centre of mass to the planned point",
                         where(outcome.point));
    case BatchOutcome::Kind::leg_unreachable:
      break;
  }
  return fmt::format("{}, {} foot: {}", where(outcome.point),
                     outcome.side == urdf::Side::left ? "left" : "right",
                     kinematics::describe(outcome.leg, model_, outcome.side));
}

}  // namespace gaitway::kinematics
