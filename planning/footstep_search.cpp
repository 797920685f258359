// Expands pairs of feet in the order of what they and the way from them cost.
#include "footstep_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitway::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kWeights{2.5, 1.4, 1.2, 1.1, 1.05,
                              1.0, 0.9, 0.8, 0.6, 0.0};  // below 1: the guide may be too dear
constexpr int kAskEvery = 64;
constexpr double kWholeBudget = 10.0;  // steps; the longer a plan is beyond, the fewer are its improvements
constexpr double kAlong = 2.0;         // sole lengths from a step
constexpr double kSamePlace = 1e-9;
constexpr double kTightFor_m = 0.5;  // from a start that is close to something the clearance is less

// With a plan at hand. Of a long way only the beginning is walked before the next plan.
int most_expansions(const Budget& budget, double cost, int found_after) {
  constexpr int kShare = 4;
  const int improvements = static_cast<int>(budget.improvements * std::min(kWholeBudget / cost, 1.0));
  return std::max(improvements, found_after + improvements / kShare);
}
bool is_same(const Pose& a, const Pose& b) {
  return way_m(a, b) < kSamePlace && turn_rad(a, b) < kSamePlace;
}

}  // namespace

FootstepSearch::FootstepSearch(const Limits& limits, const StepLattice& lattice, const Terrain& terrain,
                               const StepCheck& check, const DistanceField& field, const BodyField& guide,
                               const std::array<Standing, 2>& feet, const std::array<Standing, 2>& goal,
                               double start_clearance_m, std::optional<Side> first,
                               std::span<const Footstep> along)
    : limits_(limits),
      lattice_(lattice),
      terrain_(terrain),
      check_(check),
      field_(field),
      guide_(guide),
      goal_(goal),
      goal_middle_(middle_of(goal[0].pose, goal[1].pose)),
      start_clearance_m_(start_clearance_m),
      start_m_(0.5 * (feet[0].pose.x_m + feet[1].pose.x_m), 0.5 * (feet[0].pose.y_m + feet[1].pose.y_m)),
      first_(first),
      along_(along),
      tight_(start_clearance_m < limits.clearance_m),
      goal_cost_(kInfinity) {
  for (const Side side : {Side::left, Side::right}) {
    Stand stand;
    stand.side = side;
    stand.is_start = stand.is_footing = true;
    stand.standing = feet[static_cast<std::size_t>(side)];
    stand.clean_cost = kInfinity;
    stands_.push_back(stand);
  }
  for (std::uint32_t side = 0; side < 2; ++side) {  // their own parents
    nodes_.push_back(
        {.stand = side, .partner = 1 - side, .parent = side, .cost = 0.0, .closed = -1, .waits = false});
  }
}

bool FootstepSearch::is_later(const Entry& a, const Entry& b) noexcept {
  if (a.estimate != b.estimate) return a.estimate > b.estimate;
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.node > b.node;
}

// The way and the turn together: no step has more of both than norm 1 for its cost.
double FootstepSearch::at_least(const Pose& foot, Side side) const {
  const Pose middle = limits_.middle_beside(foot, side);
  const double left_m = field_.to_goal_m(middle.x_m, middle.y_m);
  if (!std::isfinite(left_m)) return kInfinity;
  const StepLattice::Fastest& fastest = lattice_.fastest();
  const double estimate = fastest.cost_per_norm * fastest.norm(left_m, turn_rad(middle, goal_middle_));
  return std::max(estimate, is_same(foot, goal_[static_cast<std::size_t>(side)].pose) ? 1.0 : 2.0);
}

std::uint32_t FootstepSearch::stand_at(const Place& place, Side side) {
  const std::uint64_t key = (static_cast<std::uint64_t>(place.cell.row) << 32U) |
                            (static_cast<std::uint64_t>(place.cell.column) << 8U) |
                            (static_cast<std::uint64_t>(place.direction) << 1U) |
                            static_cast<std::uint64_t>(side);
  std::uint32_t id = 0;
  if (!stand_ids_.find_or_add(key, static_cast<std::uint32_t>(stands_.size()), id)) return id;
  Stand stand;
  stand.place = place;
  stand.side = side;
  stand.clean_cost = kInfinity;
  const Eigen::Vector2d at = terrain_.corner_m(place.cell);
  stand.standing.pose = {at.x(), at.y(), lattice_.yaw_rad(place.direction)};
  stand.at_least = is_along(stand.standing.pose) ? at_least(stand.standing.pose, side) : kInfinity;
  if (std::isfinite(stand.at_least)) {
    stand.about = std::max(about(stand.standing.pose, side), stand.at_least);
    const auto height_m = check_.height_at(place);
    stand.is_footing = height_m.has_value();
    stand.standing.height_m = height_m.value_or(0.0);
  }
  stands_.push_back(stand);
  return id;
}

// By the guide; along a plan, which may go another way than the guide would, by what is left of that plan.
double FootstepSearch::about(const Pose& foot, Side side) const {
  if (along_.empty()) return guide_.to_goal(limits_.middle_beside(foot, side));
  constexpr double kStepCost = 1.1;  // between one on the spot and one at the limits
  double least = kInfinity;
  for (std::size_t i = 0; i < along_.size(); ++i) {
    const double left = static_cast<double>(along_.size() - 1 - i);
    least =
        std::min(least, kStepCost * (left + 2.0 * way_m(foot, along_[i].pose) / lattice_.fastest().way_m));
  }
  return least;
}

bool FootstepSearch::is_along(const Pose& foot) const noexcept {
  const double near_m = kAlong * limits_.sole.length_m;
  return along_.empty() ||
         std::ranges::any_of(along_, [&](const Footstep& step) { return way_m(foot, step.pose) < near_m; });
}

double FootstepSearch::estimate(const Stand& stand) const noexcept {
  return std::max(weight_ * stand.about, stand.at_least);
}

void FootstepSearch::push(std::uint32_t node) {
  const Node& one = nodes_[node];
  open_.push_back({one.cost + estimate(stands_[one.stand]), one.cost, node});
  std::ranges::push_heap(open_, is_later);
}

void FootstepSearch::relax(std::uint32_t stand, std::uint32_t partner, std::uint32_t parent, double cost) {
  if (stands_[stand].clean_cost <= cost || cost + stands_[stand].at_least >= goal_cost_) return;
  std::uint32_t id = 0;
  const std::uint64_t key = (static_cast<std::uint64_t>(stand) << 32U) | partner;
  if (node_ids_.find_or_add(key, static_cast<std::uint32_t>(nodes_.size()), id)) {
    nodes_.push_back(
        {.stand = stand, .partner = partner, .parent = parent, .cost = cost, .closed = -1, .waits = false});
  } else {
    Node& node = nodes_[id];
    if (node.cost <= cost) return;
    node.cost = cost;
    node.parent = parent;
    if (node.closed == round_) {
      if (!node.waits) waiting_.push_back(id);
      node.waits = true;
      return;
    }
  }
  push(id);
}

bool FootstepSearch::has_room(const Stand& stance, const Pose& landing) const {
  if (check_.has_room(stance.standing.pose, stance.side, landing, limits_.clearance_m)) return true;
  const bool near = (Eigen::Vector2d(landing.x_m, landing.y_m) - start_m_).norm() < kTightFor_m;
  return tight_ && near && check_.has_room(stance.standing.pose, stance.side, landing, start_clearance_m_);
}

// Both feet, or the second one alone where the first has been there already.
double FootstepSearch::cost_to_goal(const Stand& stand) const {
  const Side swing = other(stand.side);
  const Standing& first = goal_[static_cast<std::size_t>(swing)];
  const Pose& foot = stand.standing.pose;
  const Pose middle = limits_.middle_beside(foot, stand.side);
  if (lattice_.fastest().norm(way_m(middle, goal_middle_), turn_rad(middle, goal_middle_)) > kMostEffort) {
    return kInfinity;
  }
  const double effort = limits_.effort(foot.relative_of(first.pose), swing);
  if (!(effort <= kMostEffort) || !check_.is_step_height(stand.standing.height_m, first.height_m) ||
      !has_room(stand, first.pose)) {
    return kInfinity;
  }
  const Pose& own = goal_[static_cast<std::size_t>(stand.side)].pose;
  if (is_same(foot, own)) return cost_of(effort);
  Stand at_goal;
  at_goal.side = swing;
  at_goal.standing = first;
  if (!has_room(at_goal, own)) return kInfinity;
  return cost_of(effort) + cost_of(limits_.effort(first.pose.relative_of(own), stand.side));
}

// Returns whether nothing was in the way of a swing.
bool FootstepSearch::reach_goal(std::uint32_t node) {
  const Stand& stand = stands_[nodes_[node].stand];
  if (!std::isfinite(stand.cost_to_goal)) return true;
  const double cost = nodes_[node].cost + stand.cost_to_goal;
  if (cost >= goal_cost_) return true;
  const Stand& partner = stands_[nodes_[node].partner];
  const Standing& first = goal_[static_cast<std::size_t>(partner.side)];
  const Standing& own = goal_[static_cast<std::size_t>(stand.side)];
  if (!check_.can_swing(partner.standing, first, partner.is_start)) return false;
  if (!is_same(stand.standing.pose, own.pose) && !check_.can_swing(stand.standing, own, stand.is_start))
    return false;
  goal_cost_ = cost;
  goal_parent_ = node;
  return true;
}

void FootstepSearch::expand(std::uint32_t node) {
  nodes_[node].closed = round_;
  const std::uint32_t at = nodes_[node].stand;
  const double cost = nodes_[node].cost;
  if (stands_[at].clean_cost <= cost) return;
  ++expansions_;
  if (stands_[at].is_start) {
    expand_start(node);
    return;
  }
  const Place place = stands_[at].place;
  const Side side = stands_[at].side;
  const auto landings = lattice_.landings(side, place.direction);
  const bool tried = stands_[at].tried;
  if (!tried) {
    stands_[at].tried = true;
    stands_[at].cost_to_goal = cost_to_goal(stands_[at]);
  }
  bool clean = reach_goal(node);
  const unsigned crowded = tried ? 0 : check_.crowded_bands(place.cell);
  for (std::size_t i = 0; i < landings.size(); ++i) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (tried && (stands_[at].possible & bit) == 0) continue;
    const Landing& landing = landings[i];
    const Place there{{place.cell.column + landing.columns, place.cell.row + landing.rows},
                      (place.direction + landing.turn + kDirections) % kDirections};
    if (!terrain_.contains(there.cell)) continue;
    const std::uint32_t next = stand_at(there, other(side));
    const Stand& landed = stands_[next];
    if (!tried) {
      if (!landed.is_footing ||
          !check_.is_step_height(stands_[at].standing.height_m, landed.standing.height_m))
        continue;
      if (!check_.has_room(place, side, i, crowded) &&
          !(tight_ && has_room(stands_[at], landed.standing.pose)))
        continue;
      stands_[at].possible |= bit;
    }
    if (landed.clean_cost <= cost + landing.cost) continue;
    const Stand& partner = stands_[nodes_[node].partner];
    if (!check_.can_swing(partner.standing, landed.standing, partner.is_start)) {
      clean = false;
      continue;
    }
    relax(next, at, node, cost + landing.cost);
  }
  if (clean) stands_[at].clean_cost = cost;
}

// The first step leads from wherever the feet are onto the lattice.
void FootstepSearch::expand_start(std::uint32_t node) {
  const Stand start = stands_[nodes_[node].stand];
  const Standing partner = stands_[nodes_[node].partner].standing;
  const StepLattice::Fastest& fastest = lattice_.fastest();
  stands_[nodes_[node].stand].cost_to_goal = cost_to_goal(start);
  reach_goal(node);
  const Pose before = limits_.middle_beside(start.standing.pose, start.side);
  for (const Place& place :
       lattice_.places_from(start.standing.pose, start.side, terrain_.corner_m({0, 0}))) {
    if (!terrain_.contains(place.cell)) continue;
    const std::uint32_t next = stand_at(place, other(start.side));
    const Stand landed = stands_[next];
    if (!landed.is_footing || !check_.is_step_height(start.standing.height_m, landed.standing.height_m))
      continue;
    const Pose after = limits_.middle_beside(landed.standing.pose, landed.side);
    if (fastest.norm(way_m(before, after), turn_rad(before, after)) > kMostEffort) continue;
    if (!has_room(start, landed.standing.pose) || !check_.can_swing(partner, landed.standing, true)) continue;
    const double effort = limits_.effort(start.standing.pose.relative_of(landed.standing.pose), landed.side);
    relax(next, nodes_[node].stand, node, nodes_[node].cost + cost_of(effort));
  }
}

bool FootstepSearch::improve(const Budget& budget) {
  while (!open_.empty() && open_.front().estimate < goal_cost_) {
    if (!std::isfinite(goal_cost_)) {
      if (expansions_ >= budget.expansions) return false;
      found_after_ = expansions_;
    } else if (expansions_ >= most_expansions(budget, goal_cost_, found_after_)) {
      return false;
    }
    std::ranges::pop_heap(open_, is_later);
    const Entry entry = open_.back();
    open_.pop_back();
    if (nodes_[entry.node].closed == round_ || nodes_[entry.node].cost != entry.cost) continue;
    expand(entry.node);
    if (expansions_ % kAskEvery == 0 && budget.stop && budget.stop()) return false;
  }
  return true;
}

// Takes over what is open and what waits, with another weight; returns the least that a plan may cost.
double FootstepSearch::next_round(double weight) {
  double least = goal_cost_;
  std::vector<std::uint32_t> nodes = std::move(waiting_);
  waiting_.clear();
  for (const Entry& entry : open_) {
    if (nodes_[entry.node].closed != round_ && nodes_[entry.node].cost == entry.cost)
      nodes.push_back(entry.node);
  }
  open_.clear();
  ++round_;
  weight_ = weight;
  for (const std::uint32_t node : nodes) {
    nodes_[node].waits = false;
    const Stand& stand = stands_[nodes_[node].stand];
    if (stand.clean_cost <= nodes_[node].cost || nodes_[node].cost + stand.at_least >= goal_cost_) continue;
    least = std::min(least, nodes_[node].cost + stand.at_least);
    open_.push_back({nodes_[node].cost + estimate(stand), nodes_[node].cost, node});
  }
  std::ranges::make_heap(open_, is_later);
  return least;
}

FootstepSearch::Result FootstepSearch::run(const Budget& budget) {
  for (std::uint32_t side = 0; side < 2; ++side) {
    stands_[side].at_least = stands_[side].about =
        0.0;  // whatever its own place is like: from there the search begins
    if (!first_ || static_cast<Side>(side) != *first_) push(side);  // on it the robot stands
  }
  Result result;
  double least = 0.0;
  for (const double weight : kWeights) {
    least = std::max(least, next_round(weight));
    if (goal_cost_ <= budget.good_enough * least && std::isfinite(goal_cost_)) break;
    const bool in_time = improve(budget);
    if (!in_time || (!std::isfinite(goal_cost_) && open_.empty() && waiting_.empty())) break;
  }
  least = std::max(least, next_round(1.0));
  result.expansions = expansions_;
  result.found = std::isfinite(goal_cost_);
  result.exhausted = !result.found && open_.empty();
  if (!result.found) return result;
  result.steps = steps();
  // Less than goal_cost_ where something on the way has become cheaper since.
  result.cost = cost_of(limits_, stands_[0].standing.pose, stands_[1].standing.pose, result.steps);
  result.bound = std::max(result.cost / std::min(least, result.cost), 1.0);
  return result;
}

std::vector<Footstep> FootstepSearch::steps() const {
  std::vector<Footstep> steps;
  const Stand& last = stands_[nodes_[goal_parent_].stand];
  const auto add = [&steps](Side side, const Standing& standing) {
    steps.push_back({side, standing.pose, standing.height_m});
  };
  if (!is_same(last.standing.pose, goal_[static_cast<std::size_t>(last.side)].pose)) {
    add(last.side, goal_[static_cast<std::size_t>(last.side)]);
  }
  add(other(last.side), goal_[static_cast<std::size_t>(other(last.side))]);
  for (std::uint32_t node = goal_parent_; nodes_[node].parent != node; node = nodes_[node].parent) {
    add(stands_[nodes_[node].stand].side, stands_[nodes_[node].stand].standing);
  }
  std::ranges::reverse(steps);
  return steps;
}

}  // namespace gaitway::planning
