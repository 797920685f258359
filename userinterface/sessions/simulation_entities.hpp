// What is in a simulated world as entities of simulation_interfaces: the robot, and every solid.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/simulation_interfaces_types.hpp"
#include "simulation_states.hpp"
#include "simulator_answers.hpp"

namespace gaitway::api {

inline constexpr std::string_view kRobotEntity = "robot", kWorldFrame = "world";

struct Entity {
  std::string name;  // unique
  ros::simulation::EntityInfo info;
  ros::simulation::EntityState state;
  std::string shape;  // of a solid; empty: the robot, which counts as the origin of its base
  std::array<double, 3> size_m{};
  bool movable = false;
  bool spawned = false;
};

// The robot first, then the solids in their order. Names that are not unique, or empty, get a number.
[[nodiscard]] std::vector<Entity> entities_of(const SimulationStates& states,
                                              const std::vector<SolidAnswer>& solids);
// Null: there is none of that name.
[[nodiscard]] const Entity* find_entity(const std::vector<Entity>& entities, std::string_view name);

// Of the entity's surface, or its inside, to a point [m]; 0 within.
[[nodiscard]] double distance_m(const Entity& entity, const std::array<double, 3>& point_m);

}  // namespace gaitway::api
