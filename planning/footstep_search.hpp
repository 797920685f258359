// The search itself: ARA* over pairs of feet.
//
// What follows a stance foot hardly depends on where the other foot comes from: only the way through the air
// does. So a pair is looked at no further when its stance foot has been expanded at no higher cost and
// nothing was in the way of any swing: then it leads nowhere that is not reached as cheaply.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "body_field.hpp"
#include "distance_field.hpp"
#include "gaitway/planning/planner.hpp"
#include "id_table.hpp"
#include "step_check.hpp"
#include "step_lattice.hpp"

namespace gaitway::planning {

class FootstepSearch {
 public:
  // `feet` and `goal`: left and right. `start_clearance_m`: of the body's first steps, where it stands closer
  // to something than its clearance. `first`: the foot that steps first, if it is not free. `along`: if there
  // are steps, those that are found stay near them.
  FootstepSearch(const Limits& limits, const StepLattice& lattice, const Terrain& terrain,
                 const StepCheck& check, const DistanceField& field, const BodyField& guide,
                 const std::array<Standing, 2>& feet, const std::array<Standing, 2>& goal,
                 double start_clearance_m, std::optional<Side> first, std::span<const Footstep> along);

  struct Result {
    bool found = false;
    bool exhausted = false;  // not found, and there is nothing more to look at
    std::vector<Footstep> steps;
    double cost = 0.0, bound = 1.0;
    int expansions = 0;
  };
  [[nodiscard]] Result run(const Budget& budget);

 private:
  // A foot on the ground that the other may swing around.
  struct Stand {
    Place place;
    Side side = Side::left;
    bool is_start = false;
    bool is_footing = false, tried = false;  // tried: `possible` and `to_goal` are known
    Standing standing;
    double at_least = 0.0;       // what the rest costs, never more than the truth
    double about = 0.0;          // and by the guide
    std::uint64_t possible = 0;  // a bit for each landing that the body has room for
    double cost_to_goal = 0.0;   // by the goal's feet; infinite: they are not in reach
    double clean_cost = 0.0;     // the least at which it was expanded with all swings free; infinite: never
  };
  struct Node {
    std::uint32_t stand = 0, partner = 0, parent = 0;
    double cost = 0.0;
    int closed = -1;  // in which round
    bool waits = false;
  };
  struct Entry {
    double estimate, cost;
    std::uint32_t node;
  };

  std::uint32_t stand_at(const Place& place, Side side);
  void relax(std::uint32_t stand, std::uint32_t partner, std::uint32_t parent, double cost);
  void expand(std::uint32_t node);
  void expand_start(std::uint32_t node);
  bool reach_goal(std::uint32_t node);
  [[nodiscard]] bool has_room(const Stand& stance, const Pose& landing) const;
  [[nodiscard]] double cost_to_goal(const Stand& stand) const;
  [[nodiscard]] double estimate(const Stand& stand) const noexcept;
  void push(std::uint32_t node);
  bool improve(const Budget& budget);  // false: the budget has ended
  double next_round(double weight);
  [[nodiscard]] std::vector<Footstep> steps() const;
  [[nodiscard]] double at_least(const Pose& foot, Side side) const;
  [[nodiscard]] double about(const Pose& foot, Side side) const;
  [[nodiscard]] bool is_along(const Pose& foot) const noexcept;
  [[nodiscard]] static bool is_later(const Entry& a, const Entry& b) noexcept;

  const Limits& limits_;
  const StepLattice& lattice_;
  const Terrain& terrain_;
  const StepCheck& check_;
  const DistanceField& field_;
  const BodyField& guide_;
  std::array<Standing, 2> goal_;
  Pose goal_middle_;
  double start_clearance_m_;
  Eigen::Vector2d start_m_;
  std::optional<Side> first_;
  std::span<const Footstep> along_;
  bool tight_ = false;  // the start is closer to something than the clearance

  std::vector<Stand> stands_;
  std::vector<Node> nodes_;
  IdTable stand_ids_, node_ids_;
  std::vector<Entry> open_;
  std::vector<std::uint32_t> waiting_;
  double weight_ = 1.0;
  int round_ = 0, expansions_ = 0, found_after_ = 0;
  double goal_cost_;
  std::uint32_t goal_parent_ = 0;
};

}  // namespace gaitway::planning
