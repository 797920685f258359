// Plans cost at most 1.1 times the cheapest: an exhaustive search of the same lattice, which leaves out what
// can't be cheaper by its distance alone, finds none that costs less than plan / 1.1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

#include "plan_checker.hpp"
#include "step_check.hpp"
#include "step_lattice.hpp"
#include "terrain.hpp"

namespace gaitway::planning {
namespace {

// Dijkstra's algorithm. Over single feet it leaves out the swings, so what it finds is as cheap as the
// cheapest plan, or cheaper; over pairs of feet, which takes longer, it looks at them, too.
class Exhaustive {
 public:
  Exhaustive(const Scene& scene, bool pairs)
      : pairs_(pairs),
        limits_(small_humanoid()),
        lattice_(planner().lattice()),
        terrain_(scene.map(), limits_, {scene.start.x_m, scene.start.y_m}, lattice_.reach_m()),
        check_(limits_, lattice_, terrain_),
        goal_(scene.goal) {}

  // Cost of the cheapest plan, as far as it is below `below`; infinite: there is none.
  double cheapest(const Request& request, double below) {
    below_ = below;
    for (const Side side : {Side::left, Side::right}) {
      const Pose& stance = side == Side::left ? request.left : request.right;
      const Pose& swing = side == Side::left ? request.right : request.left;
      const Standing from{swing, check_.surface_below_m(swing)}, on{stance, check_.surface_below_m(stance)};
      finish(on, side, 0.0, from, true);
      for (const Place& place : lattice_.places_from(stance, side, terrain_.corner_m({0, 0}))) {
        const double effort = limits_.effort(stance.relative_of(pose_of(place)), other(side));
        add({cost_of(effort), place, other(side), on, static_cast<std::uint64_t>(side)}, from, true);
      }
    }
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.cost <= costs_.at(keys(entry)) && entry.cost < below_) expand(entry);
    }
    return best_;
  }
  [[nodiscard]] int expanded() const { return expanded_; }

 private:
  struct Entry {
    double cost;
    Place place;
    Side side;
    Standing partner;
    std::uint64_t partner_key;  // 0 and 1 are the feet at the start
    bool operator<(const Entry& later) const { return cost > later.cost; }
  };
  using Keys = std::pair<std::uint64_t, std::uint64_t>;
  struct Hash {
    std::size_t operator()(const Keys& keys) const {
      return keys.first * 0x9E37'79B9'7F4A'7C15ULL ^ (keys.second * 0xBF58'476D'1CE4'E5B9ULL >> 7U);
    }
  };
  static std::uint64_t key(const Place& place, Side side) {
    return 2U +
           ((static_cast<std::uint64_t>(place.cell.row) * 65536U +
             static_cast<std::uint64_t>(place.cell.column)) *
                64U +
            static_cast<std::uint64_t>(place.direction)) *
               2U +
           static_cast<std::uint64_t>(side);
  }
  [[nodiscard]] Pose pose_of(const Place& place) const {
    const Eigen::Vector2d at = terrain_.corner_m(place.cell);
    return {at.x(), at.y(), lattice_.yaw_rad(place.direction)};
  }
  [[nodiscard]] Keys keys(const Entry& entry) const {
    return {key(entry.place, entry.side), pairs_ ? entry.partner_key : 0};
  }
  [[nodiscard]] bool may_pay(const Entry& entry) const {
    const Pose middle = limits_.middle_beside(pose_of(entry.place), entry.side);
    const StepLattice::Fastest& fastest = lattice_.fastest();
    const double left = fastest.cost_per_norm * fastest.norm(way_m(middle, goal_), turn_rad(middle, goal_));
    if (entry.cost + std::max(left, 1.0) >= below_) return false;
    const auto known = costs_.find(keys(entry));
    return known == costs_.end() || known->second > entry.cost;
  }
  // The foot that lands has stood at `from`.
  void add(const Entry& entry, const Standing& from, bool from_start) {
    if (!terrain_.contains(entry.place.cell) || !may_pay(entry)) return;
    const auto height_m = check_.height_at(entry.place);
    if (!height_m) return;
    if (pairs_ && !check_.can_swing(from, {pose_of(entry.place), *height_m}, from_start)) return;
    costs_[keys(entry)] = entry.cost;
    queue_.push(entry);
  }
  void expand(const Entry& entry) {
    ++expanded_;
    const Standing stance{pose_of(entry.place), *check_.height_at(entry.place)};
    const bool from_start = entry.partner_key < 2;
    finish(stance, entry.side, entry.cost, entry.partner, from_start);
    const auto landings = lattice_.landings(entry.side, entry.place.direction);
    for (std::size_t i = 0; i < landings.size(); ++i) {
      const Landing& landing = landings[i];
      const Place next{{entry.place.cell.column + landing.columns, entry.place.cell.row + landing.rows},
                       (entry.place.direction + landing.turn + kDirections) % kDirections};
      const Entry landed{entry.cost + landing.cost, next, other(entry.side), stance,
                         key(entry.place, entry.side)};
      if (may_pay(landed) && check_.has_room(entry.place, entry.side, i))
        add(landed, entry.partner, from_start);
    }
  }
  void finish(const Standing& stance, Side side, double cost, const Standing& partner, bool from_start) {
    const Pose first = limits_.foot_of(goal_, other(side)), own = limits_.foot_of(goal_, side);
    const double effort = limits_.effort(stance.pose.relative_of(first), other(side));
    const auto height_m = check_.height_at(first), own_height_m = check_.height_at(own);
    if (!(effort <= kMostEffort) || !height_m || !own_height_m ||
        !check_.has_room(stance.pose, side, first, limits_.clearance_m)) {
      return;
    }
    if (pairs_ && (!check_.can_swing(partner, {first, *height_m}, from_start) ||
                   !check_.can_swing(stance, {own, *own_height_m}, false))) {
      return;
    }
    const bool there = way_m(stance.pose, own) < 1e-6 && turn_rad(stance.pose, own) < 1e-6;
    const double total = cost + cost_of(effort) + (there ? 0.0 : 1.0);
    if (total < below_) below_ = best_ = total;
  }

  bool pairs_;
  Limits limits_;
  const StepLattice& lattice_;
  Terrain terrain_;
  StepCheck check_;
  Pose goal_;
  double below_ = 0.0, best_ = std::numeric_limits<double>::infinity();
  int expanded_ = 0;
  std::unordered_map<Keys, double, Hash> costs_;
  std::priority_queue<Entry> queue_;
};

TEST(Optimum, PlansCostAtMostATenthMore) {
  constexpr double kMost = 1.1,
                   kLongest = 10.0;  // steps: what an exhaustive search soon comes to an end with
  int worlds = 0, expanded = 0;
  double worst = 1.0;
  for (std::uint64_t seed = 1000; worlds < GAITWAY_SMALL_WORLDS; ++seed) {
    ASSERT_LT(seed, 3000U);
    Scene scene = random_scene(seed, 1.6, 4);
    if (way_m(scene.start, scene.goal) > 0.6) continue;
    const Plan plan = scene.plan();
    if (!plan.found() || plan.steps.empty() || plan.cost > kLongest) continue;
    ++worlds;
    Exhaustive search(scene, false);
    double cheaper = search.cheapest(scene.request(), plan.cost / kMost);
    if (std::isfinite(cheaper)) {
      cheaper = Exhaustive(scene, true).cheapest(scene.request(), plan.cost / kMost);
    }
    EXPECT_TRUE(std::isinf(cheaper)) << "seed " << seed << ": " << plan.cost << " instead of " << cheaper;
    if (std::isfinite(cheaper)) worst = std::max(worst, plan.cost / cheaper);
    expanded += search.expanded();
  }
  RecordProperty("expanded", expanded);
  EXPECT_GT(expanded, 1000);  // it does look
  EXPECT_EQ(worst, 1.0);
}

// The bound that a plan tells is one.
TEST(Optimum, NoPlanIsCheaperThanTheBoundSays) {
  int checked = 0;
  for (std::uint64_t seed = 2000; checked < 12; ++seed) {
    ASSERT_LT(seed, 2500U);
    Scene scene = random_scene(seed, 1.4, 2);
    if (way_m(scene.start, scene.goal) > 0.4) continue;
    Request request = scene.request();
    request.budget.improvements = 0;
    const Plan plan = planner().plan(scene.map(), request);
    if (!plan.found()) continue;
    ++checked;
    request.budget.improvements = 1'000'000;
    const Plan best = planner().plan(scene.map(), request);
    EXPECT_GE(best.cost, plan.cost / plan.bound - 1e-9) << seed;
    EXPECT_LE(best.cost, plan.cost);
  }
}

}  // namespace
}  // namespace gaitway::planning
