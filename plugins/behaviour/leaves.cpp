// All leaves under their names.
#include "gaitway/behaviour_leaves/leaves.hpp"

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {

void Robot::begin() noexcept {
  orders.begin(situation.now_ns);
  if (!situation.is_upright() || situation.plays_motion()) return;
  // The ticks of one such time lie close together.
  const bool goes_on = on_feet.to_ns >= 0 && situation.now_ns - on_feet.to_ns <= 2 * facts::kCycle_ns;
  if (!goes_on) on_feet.from_ns = situation.now_ns;
  on_feet.to_ns = situation.now_ns;
}

void register_leaves(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  register_conditions(registry, robot);
  register_walking(registry, robot);
  register_ways(registry, robot);
  register_head(registry, robot);
  register_search(registry, robot);
  register_motions(registry, robot);
  register_getting_up(registry, robot);
}

}  // namespace gaitway::behaviour_leaves
