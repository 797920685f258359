// The types of the ROS package simulation_interfaces that the API speaks, in the style of service_types.hpp:
// how any simulator is paused, stepped, reset and asked for what is in its world.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/api/service_types.hpp"

namespace gaitway::api::ros::simulation {

// What became of a call. Services have further codes, from 101 on, in their responses.
struct Result {
  enum : std::uint8_t {
    RESULT_FEATURE_UNSUPPORTED = 0,
    RESULT_OK = 1,
    RESULT_NOT_FOUND = 2,
    RESULT_INCORRECT_STATE = 3,
    RESULT_OPERATION_FAILED = 4
  };
  std::uint8_t result = RESULT_FEATURE_UNSUPPORTED;
  std::string error_message;
  GAITWAY_CONSTANTS(uint8, RESULT_FEATURE_UNSUPPORTED, RESULT_OK, RESULT_NOT_FOUND, RESULT_INCORRECT_STATE,
                    RESULT_OPERATION_FAILED);
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/Result", result, error_message);
};

struct SimulationState {
  enum : std::uint8_t {
    STATE_STOPPED = 0,
    STATE_PLAYING = 1,
    STATE_PAUSED = 2,
    STATE_QUITTING = 3,
    STATE_NO_WORLD = 4,
    STATE_LOADING_WORLD = 5
  };
  std::uint8_t state = STATE_STOPPED;
  GAITWAY_CONSTANTS(uint8, STATE_STOPPED, STATE_PLAYING, STATE_PAUSED, STATE_QUITTING, STATE_NO_WORLD,
                    STATE_LOADING_WORLD);
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/SimulationState", state);
};

struct SimulatorFeatures {
  enum : std::uint8_t {
    SPAWNING = 0,
    DELETING = 1,
    NAMED_POSES = 2,
    POSE_BOUNDS = 3,
    ENTITY_TAGS = 4,
    ENTITY_BOUNDS = 5,
    ENTITY_BOUNDS_BOX = 6,
    ENTITY_BOUNDS_CONVEX = 7,
    ENTITY_CATEGORIES = 8,
    SPAWNING_RESOURCE_STRING = 9,
    ENTITY_STATE_GETTING = 10,
    ENTITY_STATE_SETTING = 11,
    ENTITY_INFO_GETTING = 12,
    ENTITY_INFO_SETTING = 13,
    SPAWNABLES = 14,
    SIMULATION_RESET = 20,
    SIMULATION_RESET_TIME = 21,
    SIMULATION_RESET_STATE = 22,
    SIMULATION_RESET_SPAWNED = 23,
    SIMULATION_STATE_GETTING = 24,
    SIMULATION_STATE_SETTING = 25,
    SIMULATION_STATE_PAUSE = 26,
    STEP_SIMULATION_SINGLE = 31,
    STEP_SIMULATION_MULTIPLE = 32,
    STEP_SIMULATION_ACTION = 33,
    WORLD_LOADING = 40,
    WORLD_RESOURCE_STRING = 41,
    WORLD_TAGS = 42,
    WORLD_UNLOADING = 43,
    WORLD_INFO_GETTING = 44,
    AVAILABLE_WORLDS = 45,
    SPAWNING_ENTITIES = 50
  };
  std::vector<std::uint16_t> features;
  std::vector<std::string> spawn_formats;
  std::string custom_info;
  GAITWAY_CONSTANTS(uint8, SPAWNING, DELETING, NAMED_POSES, POSE_BOUNDS, ENTITY_TAGS, ENTITY_BOUNDS,
                    ENTITY_BOUNDS_BOX, ENTITY_BOUNDS_CONVEX, ENTITY_CATEGORIES, SPAWNING_RESOURCE_STRING,
                    ENTITY_STATE_GETTING, ENTITY_STATE_SETTING, ENTITY_INFO_GETTING, ENTITY_INFO_SETTING,
                    SPAWNABLES, SIMULATION_RESET, SIMULATION_RESET_TIME, SIMULATION_RESET_STATE,
                    SIMULATION_RESET_SPAWNED, SIMULATION_STATE_GETTING, SIMULATION_STATE_SETTING,
                    SIMULATION_STATE_PAUSE, STEP_SIMULATION_SINGLE, STEP_SIMULATION_MULTIPLE,
                    STEP_SIMULATION_ACTION, WORLD_LOADING, WORLD_RESOURCE_STRING, WORLD_TAGS, WORLD_UNLOADING,
                    WORLD_INFO_GETTING, AVAILABLE_WORLDS, SPAWNING_ENTITIES);
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/SimulatorFeatures", features, spawn_formats, custom_info);
};

// By `uri`, or, where that is empty, by its own text.
struct Resource {
  std::string uri;
  std::string resource_string;
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/Resource", uri, resource_string);
};

// A volume; `points` mean what `type` says.
struct Bounds {
  enum : std::uint8_t { TYPE_EMPTY = 0, TYPE_BOX = 1, TYPE_CONVEX_HULL = 2, TYPE_SPHERE = 3 };
  std::uint8_t type = TYPE_EMPTY;
  std::vector<Vector3> points;
  GAITWAY_CONSTANTS(uint8, TYPE_EMPTY, TYPE_BOX, TYPE_CONVEX_HULL, TYPE_SPHERE);
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/Bounds", type, points);
};

struct EntityCategory {
  enum : std::uint8_t {
    CATEGORY_OBJECT = 0,
    CATEGORY_ROBOT = 1,
    CATEGORY_HUMAN = 2,
    CATEGORY_DYNAMIC_OBJECT = 4,
    CATEGORY_STATIC_OBJECT = 5
  };
  std::uint8_t category = CATEGORY_OBJECT;
  GAITWAY_CONSTANTS(uint8, CATEGORY_OBJECT, CATEGORY_ROBOT, CATEGORY_HUMAN, CATEGORY_DYNAMIC_OBJECT,
                    CATEGORY_STATIC_OBJECT);
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/EntityCategory", category);
};

struct TagsFilter {
  enum : std::uint8_t { FILTER_MODE_ANY = 0, FILTER_MODE_ALL = 1 };
  std::vector<std::string> tags;
  std::uint8_t filter_mode = FILTER_MODE_ANY;
  GAITWAY_CONSTANTS(uint8, FILTER_MODE_ANY, FILTER_MODE_ALL);
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/TagsFilter", tags, filter_mode);
};

// `filter`: a regular expression, POSIX extended.
struct EntityFilters {
  std::string filter;
  std::vector<EntityCategory> categories;
  TagsFilter tags;
  Bounds bounds;
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/EntityFilters", filter, categories, tags, bounds);
};

struct EntityInfo {
  EntityCategory category;
  std::string description;
  std::vector<std::string> tags;
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/EntityInfo", category, description, tags);
};

struct EntityState {
  Header header;
  Pose pose;
  Twist twist;
  Accel acceleration;
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/EntityState", header, pose, twist, acceleration);
};

struct Spawnable {
  Resource entity_resource;
  std::string description;
  Bounds spawn_bounds;
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/Spawnable", entity_resource, description, spawn_bounds);
};

struct WorldResource {
  std::string name;
  Resource world_resource;
  std::string description;
  std::vector<std::string> tags;
  GAITWAY_ROS_MESSAGE("simulation_interfaces/msg/WorldResource", name, world_resource, description, tags);
};

GAITWAY_ONE_FIELD(OnlyResult, Result, result);
GAITWAY_ONE_FIELD(OfEntity, std::string, entity);
GAITWAY_ONE_FIELD(OfFilters, EntityFilters, filters);

GAITWAY_ONE_FIELD(Features, SimulatorFeatures, features);
using GetSimulatorFeatures = RosService<"simulation_interfaces/srv/GetSimulatorFeatures", Nothing, Features>;

struct StateReading {
  SimulationState state;
  Result result;
  GAITWAY_FIELDS(state, result)
};
using GetSimulationState = RosService<"simulation_interfaces/srv/GetSimulationState", Nothing, StateReading>;

GAITWAY_ONE_FIELD(TargetState, SimulationState, state);
struct Transition {
  enum : std::uint8_t {
    ALREADY_IN_TARGET_STATE = 101,
    STATE_TRANSITION_ERROR = 102,
    INCORRECT_TRANSITION = 103
  };
  Result result;
  GAITWAY_CONSTANTS(uint8, ALREADY_IN_TARGET_STATE, STATE_TRANSITION_ERROR, INCORRECT_TRANSITION);
  GAITWAY_FIELDS(result)
};
using SetSimulationState =
    RosService<"simulation_interfaces/srv/SetSimulationState", TargetState, Transition>;

struct StepCount {
  std::uint64_t steps = 1;
  GAITWAY_FIELDS(steps)
};
using StepSimulation = RosService<"simulation_interfaces/srv/StepSimulation", StepCount, OnlyResult>;

struct ResetScope {
  enum : std::uint8_t {
    SCOPE_DEFAULT = 0,
    SCOPE_TIME = 1,
    SCOPE_STATE = 2,
    SCOPE_SPAWNED = 4,
    SCOPE_ALL = 255
  };
  std::uint8_t scope = SCOPE_DEFAULT;
  GAITWAY_CONSTANTS(uint8, SCOPE_DEFAULT, SCOPE_TIME, SCOPE_STATE, SCOPE_SPAWNED, SCOPE_ALL);
  GAITWAY_FIELDS(scope)
};
using ResetSimulation = RosService<"simulation_interfaces/srv/ResetSimulation", ResetScope, OnlyResult>;

struct EntityToSpawn {
  std::string name;
  bool allow_renaming = false;
  Resource entity_resource;
  std::string entity_namespace;
  PoseStamped initial_pose;
  GAITWAY_FIELDS(name, allow_renaming, entity_resource, entity_namespace, initial_pose)
};
struct SpawnedEntity {
  enum : std::uint8_t {
    NAME_NOT_UNIQUE = 101,
    NAME_INVALID = 102,
    UNSUPPORTED_FORMAT = 103,
    NO_RESOURCE = 104,
    NAMESPACE_INVALID = 105,
    RESOURCE_PARSE_ERROR = 106,
    MISSING_ASSETS = 107,
    UNSUPPORTED_ASSETS = 108,
    INVALID_POSE = 109
  };
  Result result;
  std::string entity_name;
  GAITWAY_CONSTANTS(uint8, NAME_NOT_UNIQUE, NAME_INVALID, UNSUPPORTED_FORMAT, NO_RESOURCE, NAMESPACE_INVALID,
                    RESOURCE_PARSE_ERROR, MISSING_ASSETS, UNSUPPORTED_ASSETS, INVALID_POSE);
  GAITWAY_FIELDS(result, entity_name)
};
using SpawnEntity = RosService<"simulation_interfaces/srv/SpawnEntity", EntityToSpawn, SpawnedEntity>;
using DeleteEntity = RosService<"simulation_interfaces/srv/DeleteEntity", OfEntity, OnlyResult>;

struct EntityNames {
  Result result;
  std::vector<std::string> entities;
  GAITWAY_FIELDS(result, entities)
};
using GetEntities = RosService<"simulation_interfaces/srv/GetEntities", OfFilters, EntityNames>;

struct EntityStates {
  Result result;
  std::vector<std::string> entities;
  std::vector<EntityState> states;
  GAITWAY_FIELDS(result, entities, states)
};
using GetEntitiesStates = RosService<"simulation_interfaces/srv/GetEntitiesStates", OfFilters, EntityStates>;

struct OneEntityState {
  Result result;
  EntityState state;
  GAITWAY_FIELDS(result, state)
};
using GetEntityState = RosService<"simulation_interfaces/srv/GetEntityState", OfEntity, OneEntityState>;

struct EntityStateSetting {
  std::string entity;
  EntityState state;
  bool set_pose = false;
  bool set_twist = false;
  bool set_acceleration = false;
  GAITWAY_FIELDS(entity, state, set_pose, set_twist, set_acceleration)
};
struct EntityStateOutcome {
  enum : std::uint8_t { INVALID_POSE = 101 };
  Result result;
  GAITWAY_CONSTANTS(uint8, INVALID_POSE);
  GAITWAY_FIELDS(result)
};
using SetEntityState =
    RosService<"simulation_interfaces/srv/SetEntityState", EntityStateSetting, EntityStateOutcome>;

struct OneEntityInfo {
  Result result;
  EntityInfo info;
  GAITWAY_FIELDS(result, info)
};
using GetEntityInfo = RosService<"simulation_interfaces/srv/GetEntityInfo", OfEntity, OneEntityInfo>;

GAITWAY_ONE_FIELD(Sources, std::vector<std::string>, sources);
struct SpawnableList {
  Result result;
  std::vector<Spawnable> spawnables;
  GAITWAY_FIELDS(result, spawnables)
};
using GetSpawnables = RosService<"simulation_interfaces/srv/GetSpawnables", Sources, SpawnableList>;

struct CurrentWorld {
  enum : std::uint8_t { NO_WORLD_LOADED = 101 };
  Result result;
  WorldResource world;
  GAITWAY_CONSTANTS(uint8, NO_WORLD_LOADED);
  GAITWAY_FIELDS(result, world)
};
using GetCurrentWorld = RosService<"simulation_interfaces/srv/GetCurrentWorld", Nothing, CurrentWorld>;

}  // namespace gaitway::api::ros::simulation
