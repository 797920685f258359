// Walks over the points of a motion plan.
#include "gaitway/kinematics/batch_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::kinematics {
namespace {

constexpr std::uint8_t kBothFeet = 2;
// The hips turn twice as fast as a bow whose CoM stays where it is; something is left for all else.
constexpr double kBowShare = 0.47;
constexpr double kArmSpeedShare = 0.8;  // of the slower shoulder's limit
constexpr int kPlacementSpacing = 4;    // points of the tail from one placement of the base to the next

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
  result.base_attitude_rad =
      correction.attitude_rad + Eigen::Vector2d(correction.bow[0].angle_rad, correction.bow[1].angle_rad);
  result.com_m = {plan.com[point][0], plan.com[point][1]};
  result.com_offset_m = correction.com_m;
  for (std::size_t i = 0; i < 2; ++i) {
    const double* foot = plan.foot_position[point][i];
    result.foot_m[i] = {foot[0], foot[1], foot[2]};
    result.foot_yaw_rad[i] = plan.foot_yaw[point][i];
    result.toe_up_rad[i] = plan.toe_up * foot[2];
  }
  return result;
}

// The stand in which the motion begins and ends, at each point of the plan.
void stand_still(const MotionPlan& plan, const PosturePlan& posture, MotionPlan& stand) noexcept {
  stand.sequence = plan.sequence;
  stand.tail_count = plan.tail_count;
  stand.start_ns = plan.start_ns;
  for (std::size_t point = 0; point < kBatchPoints + plan.tail_count; ++point) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      stand.com[point][axis] = stand.zmp[point][axis] = posture.stand_com[axis];
    }
    stand.hip_height[point] = posture.stand_hip_height;
    stand.base_yaw[point] = stand.commanded_yaw[point] = posture.stand_yaw;
    for (std::size_t side = 0; side < 2; ++side) {
      stand.foot_position[point][side][0] = posture.stand_foot[side][0];
      stand.foot_position[point][side][1] = posture.stand_foot[side][1];
      stand.foot_position[point][side][2] = 0.0;
      stand.foot_yaw[point][side] = posture.stand_foot[side][2];
    }
    stand.support[point] = kBothFeet;
  }
}

// By which the left foot is ahead of the right one, along the base.
double left_ahead_m(const MotionPlan& plan, int point) noexcept {
  const double* const left = plan.foot_position[point][0];
  const double* const right = plan.foot_position[point][1];
  return std::cos(plan.base_yaw[point]) * (left[0] - right[0]) +
         std::sin(plan.base_yaw[point]) * (left[1] - right[1]);
}

BatchOutcome leg_failure(int point, const BothLegs& legs) noexcept {
  const bool left = !legs[0].reached();
  return {BatchOutcome::Kind::leg_unreachable, point, left ? urdf::Side::left : urdf::Side::right,
          left ? legs[0] : legs[1]};
}

LegAngles angles_of(const BothLegs& legs) noexcept {
  return {legs[0].angle_rad, legs[1].angle_rad};
}

}  // namespace

struct BatchSolver::Run {
  const MotionPlan& plan;
  JointPlan& joint_plan;
  const Past& past;
  CorrectionFade fade;
  std::array<Knot, kBatchPoints> batch{};
  double arm_back_rad = 0.0;  // the left arm at the batch's end

  [[nodiscard]] PlanPoint at(int point) const noexcept {
    return point_of(plan, point, fade.at(static_cast<std::uint64_t>(point)));
  }
};

BatchSolver::BatchSolver(const urdf::RobotModel& model, SolverChoice choice, bool compensate_load)
    : model_(model),
      placement_(model_, choice),
      leg_speed_(model_),
      fade_(kBowShare * urdf::slowest_leg_joint_rad_per_s(model)),
      fade_before_(fade_) {
  if (compensate_load) load_compensation_ = std::make_unique<LoadCompensation>(model_);
  if (model_.joints.size() > static_cast<std::size_t>(kMaxJoints)) {
    throw urdf::RobotError(fmt::format("{}: {} joints; a joint plan holds at most {}", model_.name,
                                       model_.joints.size(), kMaxJoints));
  }
  for (const urdf::Joint& joint : model_.joints) home_rad_.push_back(static_cast<float>(joint.home_rad));
  const urdf::ForwardKinematics home(model_);
  arms_ = urdf::arm_swing(model_, home);
  neck_ = urdf::neck_of(model_, home);
}

BatchOutcome BatchSolver::solve(const MotionPlan& plan, const BaseOffset& correction, JointPlan& joint_plan,
                                std::span<const double> reference_rad, const PosturePlan* posture) {
  if (plan.tail_count > static_cast<std::uint32_t>(kMaxTailPoints)) {
    return {BatchOutcome::Kind::too_many_points, static_cast<int>(plan.tail_count), urdf::Side::left, {}};
  }
  if (posture == nullptr) {
    const BatchOutcome outcome = solve_standing_or_walking(plan, correction, joint_plan, reference_rad);
    if (outcome.solved()) turn_head(plan, joint_plan);
    return outcome;
  }
  if (posture->sequence != plan.sequence || posture->tail_count != plan.tail_count ||
      posture->joint_count != home_rad_.size()) {
    return {BatchOutcome::Kind::no_posture, 0, urdf::Side::left, {}};
  }
  if (posture->from_home != 0) {
    stand_at_home(plan, joint_plan);
  } else {
    stand_still(plan, *posture, *stand_);
    const BatchOutcome outcome = solve_standing_or_walking(*stand_, correction, joint_plan, reference_rad);
    if (!outcome.solved()) return outcome;
  }
  for (std::size_t point = 0; point < kBatchPoints + plan.tail_count; ++point) {
    for (std::size_t joint = 0; joint < home_rad_.size(); ++joint) {
      joint_plan.position[point][joint] += posture->offset[point][joint];
    }
    joint_plan.support[point] = std::min<std::uint8_t>(plan.support[point], kBothFeet);
  }
  turn_head(plan, joint_plan);
  return {};
}

// A robot that gets up has no stand whose references could be held: it is at the home angles, and what is
// known of the batch before is forgotten.
void BatchSolver::stand_at_home(const MotionPlan& plan, JointPlan& joint_plan) noexcept {
  for (std::size_t point = 0; point < kBatchPoints + plan.tail_count; ++point) {
    std::memcpy(joint_plan.position[point], home_rad_.data(), home_rad_.size() * sizeof(float));
  }
  joint_plan.sequence = plan.sequence;
  joint_plan.joint_count = static_cast<std::uint32_t>(home_rad_.size());
  joint_plan.tail_count = plan.tail_count;
  joint_plan.reserved = 0;
  fade_.forget();
  past_ = Past{};
  if (load_compensation_) load_compensation_->begin_anew();
}

BatchOutcome BatchSolver::solve_standing_or_walking(const MotionPlan& plan, const BaseOffset& correction,
                                                    JointPlan& joint_plan,
                                                    std::span<const double> reference_rad) {
  Run run{plan, joint_plan, past_, fade_};
  run.fade.begin(plan.sequence, kBatchPoints, plan.tail_count, correction);
  if (const BatchOutcome outcome = solve_batch(run); !outcome.solved()) return outcome;
  if (const BatchOutcome outcome = solve_tail(run); !outcome.solved()) return outcome;
  swing_arms(run);
  if (load_compensation_) load_compensation_->apply(plan, past_.precedes(plan), reference_rad, joint_plan);
  leg_speed_.keep(joint_plan, kBatchPoints + static_cast<int>(plan.tail_count),
                  past_.precedes(plan) ? &past_.reference_rad : nullptr);

  joint_plan.sequence = plan.sequence;
  joint_plan.joint_count = static_cast<std::uint32_t>(home_rad_.size());
  joint_plan.tail_count = plan.tail_count;
  joint_plan.reserved = 0;
  std::memcpy(joint_plan.support, plan.support, kBatchPoints + plan.tail_count);
  fade_before_ = fade_;
  fade_ = run.fade;
  past_before_ = past_;
  past_.sequence = plan.sequence;
  std::copy(run.batch.end() - 3, run.batch.end(), past_.last.begin());
  past_.arm_back_rad = run.arm_back_rad;
  past_.reference_rad = leg_speed_.references_rad(joint_plan, kBatchPoints - 1);
  return {};
}

void BatchSolver::go_on_from(std::uint32_t accepted_sequence) noexcept {
  if (past_.sequence == 0 || past_.sequence == accepted_sequence) return;
  fade_ = fade_before_;
  past_ = past_before_;
  if (load_compensation_) load_compensation_->take_back();
}

BatchOutcome BatchSolver::solve_point(Run& run, int point, const Eigen::Vector2d& guess_m, double tolerance_m,
                                      const std::optional<LegAngles>& start_rad, Knot& knot) {
  const PointFrames frames = placement_.frames(run.at(point));
  const WholeBodyPlacement::Result result = placement_.place_com(frames, guess_m, tolerance_m, start_rad);
  if (!result.converged) {
    if (!result.legs[0].reached() || !result.legs[1].reached()) return leg_failure(point, result.legs);
    return {BatchOutcome::Kind::com_not_placed, point, urdf::Side::left, {}};
  }
  knot = {static_cast<double>(point), result.offset_m, result.refined_m, angles_of(result.legs)};
  write(run.joint_plan, point, result.legs);
  note_base(run.at(point), frames, result.offset_m, point);
  return {};
}

std::optional<LegAngles> BatchSolver::start_at(int point, const Knot& first, const Knot& second,
                                               const Knot& third) const noexcept {
  if (!placement_.wants_start()) return std::nullopt;
  const QuadraticWeights w(first.point, second.point, third.point, point);
  LegAngles start_rad;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      start_rad[side][i] = w.first * first.angle_rad[side][i] + w.second * second.angle_rad[side][i] +
                           w.third * third.angle_rad[side][i];
    }
  }
  return start_rad;
}

BatchOutcome BatchSolver::solve_batch(Run& run) {
  // The points before this batch, if the last batch was the one before; else the newest offset must do.
  const Past& past = run.past;
  std::array<Knot, 3> before = past.last;
  for (Knot& knot : before) {
    knot.point -= kBatchPoints;
    // After a safe tail the robot stands, whatever the last batch did.
    if (!past.precedes(run.plan)) {
      knot.refined_m = placement_.standing_offset_m();
      knot.angle_rad = past.last[2].angle_rad;
    }
  }
  for (int point = 0; point < kBatchPoints; ++point) {
    // Equidistant points: the quadratic through three of them goes on with 1, -3, 3.
    const Eigen::Vector2d guess = before[0].refined_m + 3.0 * (before[2].refined_m - before[1].refined_m);
    const bool first_ever = point == 0 && past.sequence == 0;
    const auto start = first_ever ? std::nullopt : start_at(point, before[0], before[1], before[2]);
    Knot& knot = run.batch[static_cast<std::size_t>(point)];
    if (const BatchOutcome outcome = solve_point(run, point, guess, kBatchTolerance_m, start, knot);
        !outcome.solved()) {
      return outcome;
    }
    if (first_ever) before[1].angle_rad = before[2].angle_rad = knot.angle_rad;
    before = {before[1], before[2], knot};
  }
  return {};
}

BatchOutcome BatchSolver::solve_tail(Run& run) {
  const int end = kBatchPoints + static_cast<int>(run.plan.tail_count);
  // Quadratics through three knots: from the past ones to guess the next, from it to fill the points between.
  std::array<Knot, 3> knots{run.batch[0], run.batch[3], run.batch[7]};
  std::array<Knot, 3> recent{run.batch[5], run.batch[6], run.batch[7]};
  while (static_cast<int>(knots[2].point) < end - 1) {
    const int last = static_cast<int>(knots[2].point);
    const int next = std::min(last + kPlacementSpacing, end - 1);
    const QuadraticWeights w(knots[0].point, knots[1].point, knots[2].point, next);
    const Eigen::Vector2d guess =
        w.first * knots[0].refined_m + w.second * knots[1].refined_m + w.third * knots[2].refined_m;
    const auto start = start_at(next, recent[0], recent[1], recent[2]);
    Knot knot;
    if (const BatchOutcome outcome = solve_point(run, next, guess, kTailTolerance_m, start, knot);
        !outcome.solved()) {
      return outcome;
    }
    knots = {knots[1], knots[2], knot};
    if (const BatchOutcome outcome = solve_between(run, knots, recent); !outcome.solved()) return outcome;
    recent = {recent[1], recent[2], knot};
  }
  return {};
}

BatchOutcome BatchSolver::solve_between(Run& run, const std::array<Knot, 3>& knots,
                                        std::array<Knot, 3>& recent) {
  const int last = static_cast<int>(knots[1].point), next = static_cast<int>(knots[2].point);
  for (int point = last + 1; point < next; ++point) {
    const QuadraticWeights between(knots[0].point, knots[1].point, knots[2].point, point);
    const Eigen::Vector2d offset =
        between.first * knots[0].used_m + between.second * knots[1].used_m + between.third * knots[2].used_m;
    const PlanPoint planned = run.at(point);
    const PointFrames frames = placement_.frames(planned);
    const BothLegs legs = placement_.place(frames, offset, start_at(point, recent[1], recent[2], knots[2]));
    if (!legs[0].reached() || !legs[1].reached()) return leg_failure(point, legs);
    write(run.joint_plan, point, legs);
    note_base(planned, frames, offset, point);
    recent = {recent[1], recent[2], {static_cast<double>(point), offset, offset, angles_of(legs)}};
  }
  return {};
}

void BatchSolver::note_base(const PlanPoint& planned, const PointFrames& frames,
                            const Eigen::Vector2d& offset_m, int point) noexcept {
  if (!load_compensation_) return;
  const Eigen::AngleAxisd heading(planned.base_yaw_rad, Eigen::Vector3d::UnitZ());
  const Eigen::Vector2d beside = planned.com_offset_m + offset_m;
  Eigen::Isometry3d& base = load_compensation_->base(point);
  base.linear() = heading * frames.heading_from_base;
  base.translation() = heading * Eigen::Vector3d(beside.x(), beside.y(), frames.base_height_m) +
                       Eigen::Vector3d(planned.com_m.x(), planned.com_m.y(), 0.0);
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

// Each arm against the leg of its side: both masses together turn the body as little as may be. A step that a
// push makes quicker than the shoulders are is followed later: no batch is to be refused for its arms.
void BatchSolver::swing_arms(Run& run) const noexcept {
  if (!arms_ || run.plan.arm_swing == 0.0) return;
  const double most_step_rad = kArmSpeedShare * arms_->most_rad_per_s * facts::kSlot_s;
  double back_rad = run.past.arm_back_rad;
  for (int point = 0; point < kBatchPoints + static_cast<int>(run.plan.tail_count); ++point) {
    const double asked_rad = arms_->limited_rad(run.plan.arm_swing * left_ahead_m(run.plan, point));
    const bool begins = point == 0 && !run.past.precedes(run.plan);
    back_rad =
        begins ? asked_rad : back_rad + std::clamp(asked_rad - back_rad, -most_step_rad, most_step_rad);
    for (std::size_t side = 0; side < 2; ++side) {
      const double way = side == 0 ? back_rad : -back_rad;
      run.joint_plan.position[point][arms_->joint[side]] += static_cast<float>(arms_->sign[side] * way);
    }
    if (point == kBatchPoints - 1) run.arm_back_rad = back_rad;
  }
}

// Beside what a motion does with the neck, and never beyond its limits.
void BatchSolver::turn_head(const MotionPlan& plan, JointPlan& joint_plan) const noexcept {
  const auto turn = [&](const std::optional<urdf::NeckJoint>& neck, std::size_t axis) {
    if (!neck) return;
    const urdf::Joint& joint = model_.joints[static_cast<std::size_t>(neck->joint)];
    const auto lower = static_cast<float>(joint.lower_rad), upper = static_cast<float>(joint.upper_rad);
    for (std::size_t point = 0; point < kBatchPoints + plan.tail_count; ++point) {
      if (plan.head[point][axis] == 0.0) continue;
      float& angle = joint_plan.position[point][neck->joint];
      angle = std::clamp(angle + static_cast<float>(neck->sign * plan.head[point][axis]), lower, upper);
    }
  };
  turn(neck_.yaw, 0);
  turn(neck_.pitch, 1);
}

bool BatchSolver::plan_batch(std::uint32_t sequence, const MotionPlan& plan, const Correction& correction,
                             JointPlan& joint_plan, std::span<const double> reference_rad,
                             const PosturePlan* posture) {
  if (plan.sequence != sequence) {
    joint_plan.sequence = 0;
    joint_plan.joint_count = 0;
    joint_plan.tail_count = 0;
    return false;
  }
  const BaseOffset offset{
      {correction.com_offset[0], correction.com_offset[1]},
      {correction.base_attitude_offset[0], correction.base_attitude_offset[1]},
      {{{correction.bow[0], correction.bow_rate[0]}, {correction.bow[1], correction.bow_rate[1]}}}};
  const BatchOutcome outcome = solve(plan, offset, joint_plan, reference_rad, posture);
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
    case BatchOutcome::Kind::no_posture:
      return "motion_plan: a motion plays, but posture_plan is not of the same batch, tail and robot";
    case BatchOutcome::Kind::leg_unreachable:
      break;
  }
  return fmt::format("{}, {} foot: {}", where(outcome.point),
                     outcome.side == urdf::Side::left ? "left" : "right",
                     kinematics::describe(outcome.leg, model_, outcome.side));
}

}  // namespace gaitway::kinematics
