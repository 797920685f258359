// Plans footsteps from where the feet are to a place and a heading, through a map.
//
// The search is ARA* (Likhachev, Gordon and Thrun 2003) over footsteps on a lattice, as Hornung, Dornbush,
// Likhachev and Bennewitz (Humanoids 2012) plan them: a plan soon, a better one for as long as there is time,
// and at any instant a bound of how much better another could be.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/planning/ground_map.hpp"
#include "gaitway/planning/limits.hpp"

namespace gaitway::planning {

struct Footstep {
  Side side = Side::left;
  Pose pose;
  double height_m = 0.0;  // of the ground that it stands on
};

// Why there is no plan.
enum class Reason : std::uint8_t {
  found,
  start_outside_map,
  start_in_obstacle,
  goal_outside_map,
  goal_in_obstacle,
  goal_too_high,         // what the goal lies on is reached by no steps that are low enough
  goal_without_footing,  // edges or uneven ground under its soles
  goal_without_room,     // the body would touch something there
  too_high,              // every way has a step up or down that is too high
  too_low,               // every way goes below something that hangs too low
  too_narrow,            // every way is too narrow for the body
  no_footing,            // every way has a stretch without level ground, too wide to step over
  enclosed,              // obstacles are all around
  no_footsteps,          // there is room, but no footsteps within the limits
  out_of_budget          // none was found with as much search as was allowed
};
// One word with underscores, as in JSON.
[[nodiscard]] const char* name(Reason reason) noexcept;

// How long the search may go on. Expansions make it the same on every machine; `stop` is asked every 64 of
// them, and a plan that it cut short depends on whoever asked.
struct Budget {
  int expansions = 12'000;  // until there is a plan
  // In all, once there is a plan, but at least a quarter of them after it; for a plan of more than 10 steps
  // fewer in proportion.
  int improvements = 4'000;
  double good_enough = 1.0;      // it ends at a plan that is proven to cost at most this times the cheapest
  std::function<bool()> stop{};  // empty: never
};

struct Request {
  Pose left, right;             // where the feet are
  Pose goal;                    // of the middle between them
  std::optional<Side> first{};  // the foot that steps first; none: whichever is better
  // The plan that is being walked, if there is one: what is left of it is kept as long as it can be walked
  // and a new one would cost hardly less, so that the robot does not turn to and fro between two ways.
  std::span<const Footstep> previous{};
  Budget budget{};
};

struct Plan {
  Reason reason = Reason::found;
  std::string explanation;      // of the reason, with numbers and a remedy; empty: found
  std::vector<Footstep> steps;  // none: the feet are there already, or there is no plan
  double cost = 0.0;            // in steps: cost_of()
  double bound = 1.0;           // the cheapest plan of the same lattice costs at least cost / bound
  bool kept = false;            // it is what was left of the previous one
  int expansions = 0;

  [[nodiscard]] bool found() const noexcept { return reason == Reason::found; }
};

// What steps cost: one each, and up to 0.2 more for how much of what the gait can do it takes; infinite where
// the limits do not allow one.
[[nodiscard]] double cost_of(const Limits& limits, const Pose& left, const Pose& right,
                             std::span<const Footstep> steps) noexcept;

class BodyMoves;
class StepLattice;

// Knows a robot. Plans are independent of each other, the same for the same request, map and limits; one
// planner may be asked by several threads at once.
class Planner {
 public:
  // Of maps with cells of that size. Throws std::invalid_argument for limits that break their rules, and for
  // cells that are no finer than a quarter of the sole's width. Takes some 50 ms.
  Planner(const Limits& limits, double cell_m);
  ~Planner();

  // Throws std::invalid_argument for a map that is none, or has other cells, and for poses that are not
  // finite. That there is no way is a plan with a reason.
  [[nodiscard]] Plan plan(const GroundMap& map, const Request& request) const;

  [[nodiscard]] const Limits& limits() const noexcept { return limits_; }
  [[nodiscard]] double cell_m() const noexcept;  // of the maps that it takes
  [[nodiscard]] const StepLattice& lattice() const noexcept { return *lattice_; }
  [[nodiscard]] const BodyMoves& moves() const noexcept { return *moves_; }

 private:
  Limits limits_;
  std::unique_ptr<const StepLattice> lattice_;
  std::unique_ptr<const BodyMoves> moves_;
};

}  // namespace gaitway::planning
