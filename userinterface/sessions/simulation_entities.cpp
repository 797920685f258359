// Names, categories, tags and states of entities; how far a point is from one.
#include "simulation_entities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace gaitway::api {
namespace {

using namespace ros::simulation;

ros::Accel unknown_acceleration() {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  return {{kUnknown, kUnknown, kUnknown}, {kUnknown, kUnknown, kUnknown}};
}

ros::Header header_at(double time_s) {
  return {ros_time(std::llround(time_s * static_cast<double>(facts::kSecond_ns))), std::string(kWorldFrame)};
}

Entity robot_of(const SimulationStates& states) {
  const StateAnswer& state = *states.newest();
  Entity robot;
  robot.name = kRobotEntity;
  robot.info = {{EntityCategory::CATEGORY_ROBOT},
                state.fallen ? "the robot, which has fallen; its pose is that of its base"
                             : "the robot; its pose is that of its base",
                {"robot"}};
  robot.state = {header_at(state.time_s), pose_of(state.base), states.twist_of_base(),
                 unknown_acceleration()};
  return robot;
}

Entity entity_of(const SimulationStates& states, const SolidAnswer& solid) {
  const StateAnswer& state = *states.newest();
  Entity entity;
  entity.name = solid.name;
  entity.shape = solid.shape;
  entity.size_m = solid.size;
  entity.movable = solid.movable;
  entity.spawned = std::ranges::find(state.spawned, solid.name) != state.spawned.end();
  const char* const how = solid.movable ? "can be moved" : "stands fast";
  entity.info = {{solid.movable ? EntityCategory::CATEGORY_OBJECT : EntityCategory::CATEGORY_STATIC_OBJECT},
                 solid.kind + ", a " + solid.shape + " that " + how,
                 {solid.kind, solid.shape}};
  if (entity.spawned) {
    entity.info.tags.emplace_back("spawned");
  }
  const auto thing = std::ranges::find(state.things, solid.name, &ThingAnswer::name);
  const bool moves = solid.movable && thing != state.things.end();
  entity.state = {header_at(state.time_s), pose_of(moves ? thing->pose : solid.pose),
                  moves ? states.twist_of_thing(solid.name) : ros::Twist{},
                  moves ? unknown_acceleration() : ros::Accel{}};
  return entity;
}

// The point in the frame of the pose.
std::array<double, 3> in_frame_of(const ros::Pose& pose, const std::array<double, 3>& point_m) {
  const auto& [x, y, z, w] = pose.orientation;
  const double v[3] = {point_m[0] - pose.position.x, point_m[1] - pose.position.y,
                       point_m[2] - pose.position.z};
  // v + 2 q x (q x v + w v), with the conjugate of q.
  const double q[3] = {-x, -y, -z};
  const double t[3] = {q[1] * v[2] - q[2] * v[1] + w * v[0], q[2] * v[0] - q[0] * v[2] + w * v[1],
                       q[0] * v[1] - q[1] * v[0] + w * v[2]};
  return {v[0] + 2.0 * (q[1] * t[2] - q[2] * t[1]), v[1] + 2.0 * (q[2] * t[0] - q[0] * t[2]),
          v[2] + 2.0 * (q[0] * t[1] - q[1] * t[0])};
}

}  // namespace

std::vector<Entity> entities_of(const SimulationStates& states, const std::vector<SolidAnswer>& solids) {
  std::vector<Entity> entities{robot_of(states)};
  std::map<std::string, int, std::less<>> taken{{std::string(kRobotEntity), 1}};  // up to which number
  for (const SolidAnswer& solid : solids) {
    Entity entity = entity_of(states, solid);
    const std::string name = entity.name.empty() ? solid.kind : entity.name;
    entity.name = name;
    while (!taken.try_emplace(entity.name, 1).second) {
      entity.name = name + "_" + std::to_string(++taken.find(name)->second);
    }
    entities.push_back(std::move(entity));
  }
  return entities;
}

const Entity* find_entity(const std::vector<Entity>& entities, std::string_view name) {
  const auto found = std::ranges::find(entities, name, &Entity::name);
  return found == entities.end() ? nullptr : &*found;
}

double distance_m(const Entity& entity, const std::array<double, 3>& point_m) {
  const auto [x, y, z] = in_frame_of(entity.state.pose, point_m);
  const auto [length, width, height] = entity.size_m;
  const auto beyond = [](double value, double whole) { return std::max(0.0, std::abs(value) - whole / 2.0); };
  if (entity.shape == "box") {
    return std::hypot(beyond(x, length), beyond(y, width), beyond(z, height));
  }
  if (entity.shape == "cylinder") {
    return std::hypot(beyond(std::hypot(x, y), length), beyond(z, height));
  }
  return beyond(std::hypot(x, y, z), length);  // a sphere; the robot is one of no size
}

}  // namespace gaitway::api
