// Why there is no way, in a word and a sentence.
#pragma once

#include <array>
#include <string>

#include "gaitway/planning/planner.hpp"
#include "step_check.hpp"
#include "step_lattice.hpp"
#include "terrain.hpp"

namespace gaitway::planning {

struct Diagnosis {
  Reason reason = Reason::found;
  std::string explanation;
};

// What is asked for, with what the planner has made of it. `left, right` of each pair of feet.
struct Question {
  const GroundMap& map;
  const Limits& limits;
  const StepLattice& lattice;
  std::array<Pose, 2> feet, goal;
  Pose start_middle, goal_middle;
};

// Whether start and goal can be what they are; Reason::found: nothing is wrong with them by themselves.
[[nodiscard]] Diagnosis judge_start(const Question& question, const Terrain& terrain, const StepCheck& check);
[[nodiscard]] Diagnosis judge_goal(const Question& question, const Terrain& terrain, const StepCheck& check);

// Of a search that found nothing: each rule is lifted in turn, and the first without which there might be a
// way is the reason. `expansions`: after which the search was cut short; 0: it looked at everything.
[[nodiscard]] Diagnosis judge_way(const Question& question, const Terrain& terrain, int expansions);

}  // namespace gaitway::planning
