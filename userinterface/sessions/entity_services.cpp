// What a call wants is checked first, then the world is looked at, then the simulator is asked.
#include "entity_services.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "client_message.hpp"
#include "entity_filter.hpp"

namespace gaitway::api {

using namespace ros::simulation;
using nlohmann::json;

namespace {

constexpr std::size_t kMostEntityNameBytes = 47;

bool is_entity_name(std::string_view name) {
  return !name.empty() && name.size() <= kMostEntityNameBytes &&
         std::ranges::all_of(name, [](char c) { return c >= ' ' && c < '\x7f'; });
}

// Why nothing can be put there; empty: it can.
std::string objection_to_place(const ros::Header& header, const ros::Pose& pose) {
  constexpr double kFarthest_m = 50.0;      // as in world files
  constexpr double kMostTilt_rad = 0.0175;  // 1 deg
  if (!header.frame_id.empty() && header.frame_id != kWorldFrame) {
    return "header.frame_id is " + shown(header.frame_id) + ", but must be \"world\" or empty";
  }
  const auto& [x, y, z] = pose.position;
  if (std::max({std::abs(x), std::abs(y), std::abs(z)}) > kFarthest_m) {
    return "pose.position is " + shown_json(json{x, y, z}) + ", but must be within " +
           shown_json(json(kFarthest_m)) + " m of the world's origin along each axis";
  }
  const auto& [qx, qy, qz, qw] = pose.orientation;
  const double size = std::hypot(std::hypot(qx, qy), std::hypot(qz, qw));
  if (!(size > 0.5 && size < 2.0)) {
    return "pose.orientation is " + shown_json(json{qx, qy, qz, qw}) + ", but must be a quaternion of size 1";
  }
  if (2.0 * std::asin(std::min(1.0, std::hypot(qx, qy) / size)) > kMostTilt_rad) {
    return "pose.orientation is " + shown_json(json{qx, qy, qz, qw}) +
           ", but must be upright: turned about the vertical alone";
  }
  return {};
}

double yaw_deg_of(const ros::Quaternion& upright) {
  return 2.0 * std::atan2(upright.z, upright.w) * 180.0 / std::numbers::pi;
}

// The event of a scenario that puts `name` there.
json placed(const std::string& name, const ros::Pose& pose) {
  return {{"name", name},
          {"position_m", {pose.position.x, pose.position.y, pose.position.z}},
          {"yaw_deg", std::remainder(yaw_deg_of(pose.orientation), 360.0)}};
}

bool is_still(const ros::Vector3& linear, const ros::Vector3& angular) {
  return linear.x == 0.0 && linear.y == 0.0 && linear.z == 0.0 && angular.x == 0.0 && angular.y == 0.0 &&
         angular.z == 0.0;
}

// `name`, or the first of name_2, name_3, ... that is free.
std::string free_name(const std::vector<Entity>& entities, std::string name) {
  name.resize(std::min(name.size(), kMostEntityNameBytes - 6));
  std::string free = name;
  for (int number = 2; find_entity(entities, free) != nullptr; ++number) {
    free = name + "_" + std::to_string(number);
  }
  return free;
}

}  // namespace

template <class S>
void EntityServices::conclude(const SimulationCall& call, std::uint8_t code, std::string text) const {
  typename S::Response response;
  response.result = {code, std::move(text)};
  orders_.reply(call, response);
}

template <class S>
void EntityServices::with_entities(const SimulationCall& call, ThenEntities then) {
  orders_.ask_state(
      call,
      [this, call, then = std::move(then)](const StateAnswer& state) {
        geometry_.want(call, state, [this, then](const std::vector<SolidAnswer>& solids) {
          then(entities_of(orders_.states(), solids));
        });
      },
      [this, call](const OrderResult& refused) {
        conclude<S>(call, Result::RESULT_OPERATION_FAILED, refused.text);
      });
}

template <class S>
void EntityServices::with_entity(const SimulationCall& call, const std::string& name, ThenEntity then) {
  with_entities<S>(call, [this, call, name, then = std::move(then)](const Entities& entities) {
    const Entity* const entity = find_entity(entities, name);
    if (entity == nullptr) {
      return conclude<S>(
          call, Result::RESULT_NOT_FOUND,
          "entity is " + shown(name) + ", but must be one that /simulation/get_entities lists");
    }
    then(*entity);
  });
}

template <class S>
void EntityServices::apply(const SimulationCall& call, const json& event,
                           std::function<void(typename S::Response& response)> done) {
  orders_.ask(call, {{"order", "apply"}, {"event", event.dump()}}, SimulationOrders::kPatience_ns,
              [this, call, done = std::move(done)](const OrderResult& result) {
                typename S::Response response;
                if (result.done) {
                  orders_.states().forget_motion();
                  response.result.result = Result::RESULT_OK;
                  if (done) {
                    done(response);
                  }
                } else {
                  response.result = {Result::RESULT_OPERATION_FAILED, result.text};
                }
                orders_.reply(call, response);
              });
}

void EntityServices::spawn(const SimulationCall& call, const SpawnEntity::Request& asked) {
  using Codes = SpawnedEntity;
  const auto refuse = [&](std::uint8_t code, std::string text) {
    conclude<SpawnEntity>(call, code, std::move(text));
  };
  const std::string& uri = asked.entity_resource.uri;
  if (!asked.entity_namespace.empty()) {
    return refuse(Result::RESULT_FEATURE_UNSUPPORTED,
                  "entity_namespace is " + shown(asked.entity_namespace) +
                      ", but must be empty: what is spawned has no interfaces of its own");
  }
  if (uri.empty() && asked.entity_resource.resource_string.empty()) {
    return refuse(Codes::NO_RESOURCE, "entity_resource has neither a uri nor a resource_string");
  }
  if (uri.empty()) {
    return refuse(Result::RESULT_FEATURE_UNSUPPORTED,
                  "entity_resource.uri is empty, but must be one as /simulation/get_spawnables lists them: "
                  "texts are not read");
  }
  if (!is_spawnable_uri(uri)) {
    return refuse(Codes::UNSUPPORTED_FORMAT,
                  "entity_resource.uri is " + shown(uri) +
                      ", but must begin with gaitway: as those that /simulation/get_spawnables lists");
  }
  if (asked.name.empty() ? !asked.allow_renaming : !is_entity_name(asked.name)) {
    return refuse(Codes::NAME_INVALID, "name is " + shown(asked.name) + ", but must have 1 to " +
                                           std::to_string(kMostEntityNameBytes) + " printable characters");
  }
  if (std::string why = objection_to_place(asked.initial_pose.header, asked.initial_pose.pose);
      !why.empty()) {
    return refuse(Codes::INVALID_POSE, "initial_pose: " + why);
  }
  SpawnableBody body;
  try {
    body = spawnable_of(uri);
  } catch (const SpawnableError& error) {
    return refuse(Codes::RESOURCE_PARSE_ERROR, std::string("entity_resource.uri: ") + error.what());
  }
  with_entities<SpawnEntity>(call, [this, call, asked, body](const Entities& entities) {
    std::string name = asked.name.empty() ? body.shape : asked.name;
    if (asked.allow_renaming) {
      name = free_name(entities, std::move(name));
    } else if (find_entity(entities, name) != nullptr) {
      return conclude<SpawnEntity>(
          call, Codes::NAME_NOT_UNIQUE,
          "name is " + shown(name) +
              ", but must be one that nothing in the world has, or allow_renaming true");
    }
    spawn_as(call, asked, body, name);
  });
}

void EntityServices::spawn_as(const SimulationCall& call, const SpawnEntity::Request& asked,
                              const SpawnableBody& body, const std::string& name) {
  json event = placed(name, asked.initial_pose.pose);
  event["shape"] = body.shape;
  event["size_m"] = body.size_m;
  event["colour"] = body.colour_rgb;
  if (body.mass_kg) {
    event["mass_kg"] = *body.mass_kg;
  }
  apply<SpawnEntity>(call, {{"spawn", event}},
                     [name](SpawnEntity::Response& response) { response.entity_name = name; });
}

void EntityServices::remove(const SimulationCall& call, const DeleteEntity::Request& asked) {
  with_entity<DeleteEntity>(call, asked.entity, [this, call](const Entity& entity) {
    if (!entity.spawned) {
      return conclude<DeleteEntity>(
          call, Result::RESULT_OPERATION_FAILED,
          "entity is " + shown(entity.name) + ", but must be one that was spawned: all else stays");
    }
    apply<DeleteEntity>(call, {{"remove", {{"name", entity.name}}}});
  });
}

void EntityServices::list(const SimulationCall& call, const GetEntities::Request& asked) {
  try {
    const auto filter = std::make_shared<EntityFilter>(asked.filters);
    with_entities<GetEntities>(call, [this, call, filter](const Entities& entities) {
      GetEntities::Response response;
      response.result.result = Result::RESULT_OK;
      for (const Entity& entity : entities) {
        if (filter->passes(entity)) {
          response.entities.push_back(entity.name);
        }
      }
      orders_.reply(call, response);
    });
  } catch (const EntityFilter::Unsupported& why) {
    conclude<GetEntities>(call, Result::RESULT_FEATURE_UNSUPPORTED, why.what());
  }
}

void EntityServices::list_states(const SimulationCall& call, const GetEntitiesStates::Request& asked) {
  constexpr std::size_t kMostStates = 500;  // that fit well into what may wait for one client
  try {
    const auto filter = std::make_shared<EntityFilter>(asked.filters);
    with_entities<GetEntitiesStates>(call, [this, call, filter](const Entities& entities) {
      GetEntitiesStates::Response response;
      response.result.result = Result::RESULT_OK;
      for (const Entity& entity : entities) {
        if (!filter->passes(entity)) {
          continue;
        }
        if (response.states.size() == kMostStates) {
          return conclude<GetEntitiesStates>(
              call, Result::RESULT_OPERATION_FAILED,
              "more than " + std::to_string(kMostStates) +
                  " entities pass the filters, and no answer holds their states: "
                  "ask for fewer");
        }
        response.entities.push_back(entity.name);
        response.states.push_back(entity.state);
      }
      orders_.reply(call, response);
    });
  } catch (const EntityFilter::Unsupported& why) {
    conclude<GetEntitiesStates>(call, Result::RESULT_FEATURE_UNSUPPORTED, why.what());
  }
}

void EntityServices::tell_state(const SimulationCall& call, const GetEntityState::Request& asked) {
  with_entity<GetEntityState>(call, asked.entity, [this, call](const Entity& entity) {
    GetEntityState::Response response;
    response.result.result = Result::RESULT_OK;
    response.state = entity.state;
    orders_.reply(call, response);
  });
}

void EntityServices::tell_info(const SimulationCall& call, const GetEntityInfo::Request& asked) {
  with_entity<GetEntityInfo>(call, asked.entity, [this, call](const Entity& entity) {
    GetEntityInfo::Response response;
    response.result.result = Result::RESULT_OK;
    response.info = entity.info;
    orders_.reply(call, response);
  });
}

void EntityServices::set_state(const SimulationCall& call, const SetEntityState::Request& asked) {
  const std::string why = asked.set_pose ? objection_to_place(asked.state.header, asked.state.pose) : "";
  if (!why.empty()) {
    return conclude<SetEntityState>(call, EntityStateOutcome::INVALID_POSE, "state." + why);
  }
  with_entity<SetEntityState>(call, asked.entity, [this, call, asked](const Entity& entity) {
    const auto& [header, pose, twist, acceleration] = asked.state;
    const bool can_be_moved = entity.movable || entity.spawned;
    const bool moves = asked.set_twist && !is_still(twist.linear, twist.angular);
    const bool speeds_up = asked.set_acceleration && !is_still(acceleration.linear, acceleration.angular);
    if ((moves || speeds_up) && !entity.movable && entity.name != kRobotEntity) {
      return conclude<SetEntityState>(
          call, Result::RESULT_OPERATION_FAILED,
          "entity " + shown(entity.name) + " stands fast: its twist and its acceleration must be 0");
    }
    if (asked.set_twist && (entity.movable || entity.name == kRobotEntity)) {
      return conclude<SetEntityState>(call, Result::RESULT_FEATURE_UNSUPPORTED,
                                      "set_twist is true, but must be false: velocities cannot be set");
    }
    if (!asked.set_pose) {
      return conclude<SetEntityState>(call, Result::RESULT_OK, "");
    }
    if (!can_be_moved) {
      return conclude<SetEntityState>(call, Result::RESULT_OPERATION_FAILED,
                                      "entity is " + shown(entity.name) +
                                          ", but must be one that was spawned or can be pushed, to be moved");
    }
    apply<SetEntityState>(call, {{"move", placed(entity.name, pose)}});
  });
}

}  // namespace gaitway::api
