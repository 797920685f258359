// Optimises a path with Ceres, cuts it into points and has every point checked.
#include "gaitway/motion/motion_planner.hpp"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/body_load.hpp"
#include "segment_cost.hpp"

namespace gaitway::motion {
namespace {

// Penalties are tightened twice; what they leave open is closed by aiming a little inside of the limits.
constexpr std::array kPenalties{10.0, 60.0};
constexpr double kAim = 0.99;
constexpr double kShortestSegment_s = 0.06;
constexpr double kSlowerStep = 0.003, kMostSlower = 3.0;
constexpr int kIterations = 60;

MotionLimits aimed_at(MotionLimits limits) {
  limits.speed_share *= kAim;
  limits.torque_share *= kAim;
  limits.acceleration_limit_rad_per_s2 *= kAim;
  limits.zmp_margin_m += 0.0005;
  limits.friction_share *= kAim;
  limits.least_weight_share /= kAim;
  return limits;
}

// The numbers that Ceres changes: velocities, then accelerations of what moves at a knot.
std::vector<double> block_of(const Knot& knot) {
  std::vector<double> block;
  for (const Eigen::VectorXd* const from : {&knot.velocity, &knot.acceleration}) {
    for (const Eigen::Index i : knot.moving) block.push_back((*from)[i]);
  }
  return block;
}

void put_block(const std::vector<double>& block, Knot& knot) {
  for (std::size_t i = 0; i < knot.moving.size(); ++i) {
    knot.velocity[knot.moving[i]] = block[i];
    knot.acceleration[knot.moving[i]] = block[knot.moving.size() + i];
  }
}

void optimise(const urdf::RobotModel& robot, const MotionLimits& limits, const CostWeights& weights,
              MotionPath& path) {
  ceres::Problem problem;
  std::vector<std::vector<double>> blocks;
  for (const Knot& knot : path.knots) blocks.push_back(block_of(knot));
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    Segment& segment = path.segments[i];
    auto cost =
        std::make_unique<SegmentCost>(robot, limits, segment, path.knots[i], path.knots[i + 1], weights);
    const int residuals = cost->residual_count();
    auto function =
        std::make_unique<ceres::DynamicNumericDiffCostFunction<SegmentCost, ceres::FORWARD>>(cost.release());
    std::vector<double*> parameters{&segment.duration_s};
    function->AddParameterBlock(1);
    for (std::vector<double>* const block : {&blocks[i], &blocks[i + 1]}) {
      if (block->empty()) continue;
      parameters.push_back(block->data());
      function->AddParameterBlock(static_cast<int>(block->size()));
    }
    function->SetNumResiduals(residuals);
    problem.AddResidualBlock(function.release(), nullptr, parameters);
    problem.SetParameterLowerBound(&segment.duration_s, 0, std::max(segment.min_time_s, kShortestSegment_s));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = kIterations;
  options.function_tolerance = 1e-5;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (std::size_t i = 0; i < blocks.size(); ++i) put_block(blocks[i], path.knots[i]);
}

// Appends points; knows where it is.
class PointWriter {
 public:
  PointWriter(const urdf::RobotModel& robot, MotionPlan& plan) : sampler_(robot), plan_(plan) {}

  void add(const Segment& segment, const std::vector<trajectory::Quintic>& spline, double time_s) {
    const double reach_m = sampler_.posture(segment, spline, time_s, posture_);
    if (reach_m > 0.0) {
      throw MotionError(fmt::format(
          "motion '{}': at {:.2f} s, between two keys, a leg is out of reach by {:.1f} mm. Choose a "
          "lower hip_height_m or smaller steps between the keys",
          plan_.name, static_cast<double>(plan_.contact.size()) * facts::kSlot_s, 1000.0 * reach_m));
    }
    plan_.joint_rad.insert(plan_.joint_rad.end(), posture_.joint_rad.begin(), posture_.joint_rad.end());
    plan_.contact.push_back(segment.contact);
    plan_.pelvis.push_back(segment.standing ? posture_.pelvis : Eigen::Isometry3d::Identity());
  }

 private:
  SegmentSampler sampler_;
  MotionPlan& plan_;
  BodyPosture posture_;
};

// The path's durations are whole points.
MotionPlan points_of(const urdf::RobotModel& robot, const Motion& motion, const MotionPath& path) {
  MotionPlan plan{.name = motion.name, .joint_count = robot.joints.size()};
  PointWriter writer(robot, plan);
  const std::size_t first_key = motion.starts_at_first_key ? 1 : 0;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    const auto spline = polynomials(segment, path.knots[i], path.knots[i + 1]);
    const long moving = std::lround(segment.duration_s / facts::kSlot_s);
    const long held = std::lround(segment.hold_s / facts::kSlot_s);
    for (long k = 0; k < moving; ++k) writer.add(segment, spline, static_cast<double>(k) * facts::kSlot_s);
    const std::size_t reached = plan.point_count();
    for (long k = 0; k < held; ++k) writer.add(segment, spline, segment.duration_s);
    plan.keys.push_back({motion.keys[i + first_key].name, reached, reached + static_cast<std::size_t>(held)});
    if (i + 1 == path.segments.size()) writer.add(segment, spline, segment.duration_s);
  }
  plan.reference_rad = leading_references(robot, plan);
  return plan;
}

}  // namespace

PlannedMotion plan_motion(const urdf::RobotModel& robot, const Motion& motion,
                          const PlannerOptions& options) {
  const MotionLimits limits = limits_of(motion, options.limits);
  MotionPath path = first_path(robot, motion, key_postures(robot, motion, limits), limits);
  PlannedMotion result;
  for (const Segment& segment : path.segments) result.first_duration_s += segment.duration_s + segment.hold_s;
  for (const double penalty : kPenalties) {
    optimise(robot, aimed_at(limits), {options.smoothness, penalty}, path);
  }
  // In growing steps: most often little or nothing is missing.
  for (double slower = 0.0; slower <= kMostSlower; slower = slower == 0.0 ? kSlowerStep : 1.6 * slower) {
    MotionPath slow = path;
    slow.stretch(1.0 + slower);
    slow.round_up_to_points();
    result.plan = points_of(robot, motion, slow);
    result.report = check_plan(robot, result.plan, limits);
    result.stretch = 1.0 + slower;
    if (result.report.broken() == nullptr) return result;
  }
  throw MotionError(fmt::format(
      "motion '{}': even at a third of its optimum's speed it breaks a limit: {}. Change the keys "
      "around that time, or give one in between",
      motion.name, describe(*result.report.broken())));
}

}  // namespace gaitway::motion
