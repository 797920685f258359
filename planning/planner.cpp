// From a request to a plan: is there something wrong with start or goal, is the plan that is being walked
// still good, what does the search find, and if nothing, why.
#include "gaitway/planning/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "body_field.hpp"
#include "diagnosis.hpp"
#include "distance_field.hpp"
#include "footstep_search.hpp"
#include "step_check.hpp"
#include "step_lattice.hpp"
#include "terrain.hpp"

namespace gaitway::planning {
namespace {

constexpr double kPitchPerSoleWidth = 0.24;  // of the lattice: 20 mm for a sole of 85 mm
constexpr double kThere = 1e-6;
// A foot that is so near to a footstep stands on it, in sole lengths and as a turn.
constexpr double kOnStep = 0.2, kOnStep_rad = 0.15;
constexpr int kLessForKept = 4;  // so many times less is searched beside a plan that may be kept
// A new plan is worth it when it saves more than this share of what is left, or this many steps.
constexpr double kKeepShare = 0.10, kKeepSteps = 1.0;

bool is_finite(const Pose& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}
bool is_there(const Pose& a, const Pose& b) {
  return way_m(a, b) < kThere && turn_rad(a, b) < kThere;
}

int pitch_for(const Limits& limits, double cell_m) {
  limits.validate();
  if (!(cell_m > 0.0) || cell_m > 0.25 * limits.sole.width_m) {
    throw std::invalid_argument(fmt::format(
        "planner: cell_m = {:g}: must be above 0 and at most a quarter of the sole's width, {:g} m", cell_m,
        0.25 * limits.sole.width_m));
  }
  return std::max(1, static_cast<int>(std::floor(kPitchPerSoleWidth * limits.sole.width_m / cell_m + 1e-6)));
}

// What is left of the previous plan from where the feet are; empty: the feet are on none of its steps, or it
// leads elsewhere.
std::span<const Footstep> rest_of(const Request& request, const Limits& limits,
                                  const std::array<Pose, 2>& goal) {
  const std::span<const Footstep> previous = request.previous;
  const auto stands_on = [&](const Footstep& step) {
    const Pose& foot = step.side == Side::left ? request.left : request.right;
    return way_m(foot, step.pose) <= kOnStep * limits.sole.length_m &&
           turn_rad(foot, step.pose) <= kOnStep_rad;
  };
  if (previous.size() < 2) return {};
  for (const Footstep& last : previous.last(2)) {
    if (!is_there(last.pose, goal[static_cast<std::size_t>(last.side)])) return {};
  }
  for (std::size_t done = previous.size() - 1; done >= 2; --done) {
    if (stands_on(previous[done - 1]) && stands_on(previous[done - 2])) return previous.subspan(done);
  }
  if (stands_on(previous[0])) return previous.subspan(1);
  // Nothing of it is walked yet: its first step must be one from here.
  return previous;
}

// Whether steps can be walked, by the same rules as the search's.
bool can_walk(std::span<const Footstep> steps, const Limits& limits, const StepCheck& check,
              std::array<Standing, 2> feet, double start_clearance_m) {
  constexpr std::size_t kTightSteps = 4;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Footstep& step = steps[i];
    const Standing stance = feet[static_cast<std::size_t>(other(step.side))];
    Standing& swing = feet[static_cast<std::size_t>(step.side)];
    const auto height_m = check.height_at(step.pose);
    if (!height_m || !check.is_step_height(stance.height_m, *height_m)) return false;
    if (!(limits.effort(stance.pose.relative_of(step.pose), step.side) <= kMostEffort)) return false;
    const double clearance_m = i < kTightSteps ? start_clearance_m : limits.clearance_m;
    if (!check.has_room(stance.pose, other(step.side), step.pose, clearance_m)) return false;
    const Standing landed{step.pose, *height_m};
    if (!check.can_swing(swing, landed, i < 2)) return false;
    swing = landed;
  }
  return true;
}

// The body's clearance, or as much of it as there is where the robot stands: a cell, which is what the map
// can tell, or nothing.
double clearance_at_start(const StepCheck& check, const Request& request, const Limits& limits,
                          double cell_m) {
  for (const double clearance_m : {limits.clearance_m, std::min(limits.clearance_m, cell_m)}) {
    if (check.has_room(request.left, request.right, clearance_m)) return clearance_m;
  }
  return 0.0;
}

Plan refused(const Diagnosis& diagnosis) {
  Plan plan;
  plan.reason = diagnosis.reason;
  plan.explanation = diagnosis.explanation;
  plan.cost = std::numeric_limits<double>::infinity();
  return plan;
}

}  // namespace

const char* name(Reason reason) noexcept {
  constexpr std::array kNames{
      "found",         "start_outside_map",    "start_in_obstacle", "goal_outside_map", "goal_in_obstacle",
      "goal_too_high", "goal_without_footing", "goal_without_room", "too_high",         "too_low",
      "too_narrow",    "no_footing",           "enclosed",          "no_footsteps",     "out_of_budget"};
  return kNames[static_cast<std::size_t>(reason)];
}

double cost_of(const Limits& limits, const Pose& left, const Pose& right,
               std::span<const Footstep> steps) noexcept {
  std::array<Pose, 2> feet{left, right};
  double cost = 0.0;
  for (const Footstep& step : steps) {
    const double effort =
        limits.effort(feet[static_cast<std::size_t>(other(step.side))].relative_of(step.pose), step.side);
    cost += effort <= kMostEffort ? cost_of(effort) : std::numeric_limits<double>::infinity();
    feet[static_cast<std::size_t>(step.side)] = step.pose;
  }
  return cost;
}

Planner::Planner(const Limits& limits, double cell_m)
    : limits_(limits),
      lattice_(std::make_unique<const StepLattice>(limits, cell_m, pitch_for(limits, cell_m))),
      moves_(std::make_unique<const BodyMoves>(limits, cell_m, lattice_->fastest().cost_per_norm)) {}

Planner::~Planner() = default;

double Planner::cell_m() const noexcept {
  return lattice_->cell_m();
}

Plan Planner::plan(const GroundMap& map, const Request& request) const {
  map.validate();
  if (std::abs(map.grid.cell_m - lattice_->cell_m()) > 1e-9) {
    throw std::invalid_argument(
        fmt::format("planner: the map's cells of {:g} m: must be of {:g} m, as the planner's",
                    map.grid.cell_m, lattice_->cell_m()));
  }
  if (!is_finite(request.left) || !is_finite(request.right) || !is_finite(request.goal)) {
    throw std::invalid_argument("planner: the feet and the goal must be finite");
  }
  const Question question{
      map,
      limits_,
      *lattice_,
      {request.left, request.right},
      {limits_.foot_of(request.goal, Side::left), limits_.foot_of(request.goal, Side::right)},
      middle_of(request.left, request.right),
      request.goal};
  const Terrain terrain(map, limits_, {question.start_middle.x_m, question.start_middle.y_m},
                        lattice_->reach_m());
  const StepCheck check(limits_, *lattice_, terrain);
  if (const Diagnosis start = judge_start(question, terrain, check); start.reason != Reason::found)
    return refused(start);
  if (is_there(request.left, question.goal[0]) && is_there(request.right, question.goal[1])) return {};
  if (const Diagnosis goal = judge_goal(question, terrain, check); goal.reason != Reason::found)
    return refused(goal);

  std::array<Standing, 2> feet, goal;
  for (std::size_t side = 0; side < 2; ++side) {
    const Pose& foot = question.feet[side];
    feet[side] = {foot, check.height_at(foot).value_or(check.surface_below_m(foot))};
    goal[side] = {question.goal[side], *check.height_at(question.goal[side])};
  }
  const double start_clearance_m = clearance_at_start(check, request, limits_, lattice_->cell_m());
  const DistanceField field(terrain, limits_, request.goal, lattice_->pitch());
  if (!std::isfinite(field.to_goal_from_around_m(question.start_middle.x_m, question.start_middle.y_m))) {
    return refused(judge_way(question, terrain, 0));
  }
  Plan plan;
  const BodyField guide(terrain, limits_, *moves_, request.goal, question.start_middle);
  Budget budget = request.budget;
  const auto search = [&](std::span<const Footstep> along) {
    FootstepSearch one(limits_, *lattice_, terrain, check, field, guide, feet, goal, start_clearance_m,
                       request.first, along);
    FootstepSearch::Result result = one.run(budget);
    plan.expansions += result.expansions;
    return result;
  };
  const std::span<const Footstep> rest = rest_of(request, limits_, question.goal);
  const bool walkable = !rest.empty() && rest.front().side == request.first.value_or(rest.front().side) &&
                        can_walk(rest, limits_, check, feet, start_clearance_m);
  if (walkable) budget.improvements /= kLessForKept;
  FootstepSearch::Result result = search({});
  if (!rest.empty()) {
    const auto hardly_saves = [&result](double cost) {
      return !result.found || cost <= result.cost + std::max(kKeepShare * cost, kKeepSteps);
    };
    const double cost = cost_of(limits_, request.left, request.right, rest);
    if (walkable && hardly_saves(cost)) {
      plan.kept = true;
      plan.cost = cost;
      plan.bound = result.found ? std::max(cost * result.bound / result.cost, 1.0)
                                : std::numeric_limits<double>::infinity();
      plan.steps.assign(rest.begin(), rest.end());
      return plan;
    }
    if (result.found) {  // the same way, with other steps
      FootstepSearch::Result along = search(rest);
      if (along.found && hardly_saves(along.cost)) {
        along.bound = std::max(along.cost * result.bound / result.cost, 1.0);
        result = std::move(along);
      }
    }
  }
  if (!result.found) {
    Plan none = refused(judge_way(question, terrain, result.exhausted ? 0 : result.expansions));
    none.expansions = plan.expansions;
    return none;
  }
  plan.steps = std::move(result.steps);
  plan.cost = result.cost;
  plan.bound = result.bound;
  return plan;
}

}  // namespace gaitway::planning
