// Services of simulation_interfaces for what is in the world: who is there and where, spawned, moved,
// removed.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/api/simulation_interfaces_types.hpp"
#include "simulation_entities.hpp"
#include "simulation_geometry.hpp"
#include "simulation_orders.hpp"
#include "spawnables.hpp"

namespace gaitway::api {

class EntityServices {
 public:
  explicit EntityServices(SimulationOrders& orders) : orders_(orders), geometry_(orders) {}

  void step(std::int64_t now_ns) { geometry_.step(now_ns); }
  void forget(std::uint64_t client) { geometry_.forget(client); }

  // Each answers its call now or later; throws for wrong arguments, which the call is told.
  void spawn(const SimulationCall& call, const ros::simulation::SpawnEntity::Request& asked);
  void remove(const SimulationCall& call, const ros::simulation::DeleteEntity::Request& asked);
  void list(const SimulationCall& call, const ros::simulation::GetEntities::Request& asked);
  void list_states(const SimulationCall& call, const ros::simulation::GetEntitiesStates::Request& asked);
  void tell_state(const SimulationCall& call, const ros::simulation::GetEntityState::Request& asked);
  void set_state(const SimulationCall& call, const ros::simulation::SetEntityState::Request& asked);
  void tell_info(const SimulationCall& call, const ros::simulation::GetEntityInfo::Request& asked);

 private:
  using Entities = std::vector<Entity>;
  using ThenEntities = std::function<void(const Entities& entities)>;
  using ThenEntity = std::function<void(const Entity& entity)>;

  // `then` with what is in the world now; S's response bears the reason when that is not known.
  template <class S>
  void with_entities(const SimulationCall& call, ThenEntities then);
  // `then` with the entity of that name; S's response says when there is none.
  template <class S>
  void with_entity(const SimulationCall& call, const std::string& name, ThenEntity then);
  template <class S>
  void conclude(const SimulationCall& call, std::uint8_t code, std::string text) const;
  // An event of a scenario; S's response tells what became of it, with `done` having had its say.
  template <class S>
  void apply(const SimulationCall& call, const nlohmann::json& event,
             std::function<void(typename S::Response& response)> done = {});
  void spawn_as(const SimulationCall& call, const ros::simulation::SpawnEntity::Request& asked,
                const SpawnableBody& body, const std::string& name);

  SimulationOrders& orders_;
  SimulationGeometry geometry_;
};

}  // namespace gaitway::api
