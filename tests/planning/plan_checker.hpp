// Looks at a plan with other eyes than the planner's: on the solids themselves instead of a map of cells,
// with its own formulas. It shares nothing with the planner but the limits and the plan.
#pragma once

#include <string>
#include <vector>

#include "written_scene.hpp"

namespace gaitway::planning {

// What of the plan breaks which rule, step by step; empty: all is well. The scene's solids must be upright.
// What is clear of obstacles may be nearer to them by what cells of kCell_m cannot tell. `clearance_m`: of
// the body; from the start it may be less for as long as the start's is.
[[nodiscard]] std::vector<std::string> faults_of(const Plan& plan, const Scene& scene,
                                                 const Request& request);

}  // namespace gaitway::planning
