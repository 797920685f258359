// The leaves over the public topics: what behaviour trees say of a walking robot, and have it do.
#pragma once

#include <memory>

#include "gaitway/behaviour/registry.hpp"
#include "gaitway/behaviour_leaves/orders.hpp"
#include "gaitway/behaviour_leaves/situation.hpp"

namespace gaitway::behaviour_leaves {

// The last time that it stood or walked, over or not.
struct TimeOnFeet {
  std::int64_t from_ns = -1, to_ns = -1;  // -1: none yet
};

// What all leaves of a tree share. Whoever ticks it fills in the situation and calls begin() before each
// tick, and passes the orders on after it.
struct Robot {
  Situation situation;
  Orders orders;
  TimeOnFeet on_feet;

  void begin() noexcept;
};

// All leaves, at work on that robot. Without one they can be checked and drawn, and see nothing.
void register_leaves(behaviour::Registry& registry,
                     const std::shared_ptr<Robot>& robot = std::make_shared<Robot>());

}  // namespace gaitway::behaviour_leaves
