// The services of the API: the table by which calls are looked up, answered and documented.
#pragma once

#include <array>
#include <string_view>

#include "gaitway/api/rosapi_types.hpp"
#include "gaitway/api/service_types.hpp"
#include "gaitway/api/simulation_interfaces_types.hpp"
#include "gaitway/api/simulation_types.hpp"

namespace gaitway::api {

struct ServiceRow {
  std::string_view name;
  std::string_view type;
  bool needs_command;  // refused to all but the one who has the command
  std::string_view doc;
  std::string_view example;    // arguments, as JSON
  bool of_simulation = false;  // a real robot does not offer it
};

inline constexpr std::array kServices{
    ServiceRow{
        "/stand", ros::Trigger::kName, true,
        "End the walk by the next steps, or the motion by its way out, and stand. Answered when the "
        "robot stands, or will not: who stopped it meanwhile, or that it fell, or that the link was lost "
        "(`success` false). On the way /robot_state tells what it does. `result` is false when it does "
        "not stand within `timeout`; it goes on to do so",
        "{}"},
    ServiceRow{"/stop", ros::Trigger::kName, false,
               "Play the safe tail now: finish the step and stand. For everybody who is let in", "{}"},
    ServiceRow{"/emergency_stop", ros::SetBool::kName, false,
               "Stop every joint at once. `data` true: they go soft, false: they hold. The robot may fall. "
               "For everybody who is let in",
               R"({"data": false})"},
    ServiceRow{"/release", ros::Trigger::kName, true,
               "End an emergency stop: every joint holds where it is, and the robot goes to its stand from "
               "there, so stay clear of it. Until then all that would move the robot is refused",
               "{}"},
    ServiceRow{"/move_joint", ros::MoveJoint::kName, true,
               "Move one joint to `position` [rad] within `duration` [s], while the robot stands; it walks "
               "again when the joint is back",
               R"({"joint": "neck_yaw", "position": 0.2, "duration": 1.0})"},
    ServiceRow{
        "/play_motion", ros::PlayMotion::kName, true,
        "Play a key-frame motion by its name, from the stand; the answer comes when it begins, /motion_state "
        "tells how it goes on",
        R"({"motion": "wave"})"},
    ServiceRow{
        "/walk_to", ros::WalkTo::kName, true,
        "Walk to a place of the world, `x`, `y` [m] and `yaw` [rad] of the middle between the feet: "
        "footsteps "
        "are planned through the robot's map and followed, and planned anew when it is pushed. Answered when "
        "there is a way, or with the reason why there is none; /walk_to/state tells how it goes on. Ended by "
        "its end, /walk_to/cancel, /stand, a velocity, a stop, a fall, or when who gave it has gone; nothing "
        "goes on with it by itself. Wants the plug-in `navigation`",
        R"({"x": 1.0, "y": 0.5, "yaw": 0.0})"},
    ServiceRow{"/walk_to/cancel", ros::Trigger::kName, true,
               "Leave the way that is being walked, if there is one: the robot stands after its next steps",
               "{}"},
    ServiceRow{
        "/walk/limits", ros::WalkLimits::kName, false,
        "How fast the gait walks now, ahead, back, aside [m/s] and turning [rad/s]; a velocity beyond is "
        "refused, and two at once are slowed down together. It is what the parameters of the plug-in "
        "`trajectory` make of it: changes by clients are seen at once, others within 30 s. `success` is "
        "false while it is not known: then the numbers are the API's own limits",
        "{}"},
    ServiceRow{"/plugins/list", ros::ListPlugins::kName, false,
               "The plug-ins, their state and what their steps cost [us]", "{}"},
    ServiceRow{"/plugins/get_parameters", ros::GetParameters::kName, false,
               "The parameters of a plug-in: one entry each in `names`, `values`, `units`, `docs` and `live` "
               "(may be changed while the plug-in works)",
               R"({"plugin": "stability"})"},
    ServiceRow{"/plugins/set_parameter", ros::SetParameter::kName, true,
               "Set a live parameter. `value` with its unit, as in the configuration",
               R"({"plugin": "stability", "parameter": "trim_limit", "value": "0.1 rad"})"},
    ServiceRow{"/plugins/reload", ros::ChangePlugin::kName, true,
               "Replace the plug-in `name` by what its library, or `library`, holds now",
               R"({"name": "stability", "library": ""})"},
    ServiceRow{"/plugins/unload", ros::ChangePlugin::kName, true, "Take the plug-in `name` out of service",
               R"({"name": "stability"})"},
    ServiceRow{"/plugins/load", ros::ChangePlugin::kName, true,
               "Load the plug-in `name`, from `library` when that is not empty",
               R"({"name": "stability", "library": ""})"},
    ServiceRow{"/recording/start", ros::StartRecording::kName, false,
               "Record every topic into an MCAP file `name`, or named by the time when that is empty. For "
               "everybody who is let in, one recording at a time; it goes on when who began it goes. "
               "`file`: its path. Refused where 1000 recordings are, or less than 256 MiB are free; one that "
               "grows too large or whose disk is too slow or too full ends, and an event says so",
               R"({"name": "walk"})"},
    ServiceRow{"/recording/stop", ros::Trigger::kName, false,
               "End the recording: for who began it, who commands, and everybody once the former has gone. "
               "`message`: the path of the finished file",
               "{}"},
    ServiceRow{
        "/recording/list", ros::ListRecordings::kName, false,
        "The recordings, newest first and 100 at most: each one's path, size and start. `message`: how many "
        "there are, where there are more",
        "{}"},
    ServiceRow{"/command/acquire", ros::AcquireCommand::kName, false,
               "Become the one who commands. Keep the `lease` alive at least every `keep_alive_period` [s]. "
               "Refused while somebody else has it",
               R"({"name": "dashboard"})"},
    ServiceRow{"/command/keep_alive", ros::Lease::kName, false, "Keep the lease of the command",
               R"({"lease": "0123456789abcdef"})"},
    ServiceRow{"/command/release", ros::Lease::kName, false, "Give the command back",
               R"({"lease": "0123456789abcdef"})"},
    ServiceRow{
        "/command/take", ros::Trigger::kName, true,
        "A person takes the command of the robot without an order: what the behaviour has ordered ends, "
        "and it orders no more until /command/let_go. /command/state tells who commands",
        "{}"},
    ServiceRow{
        "/command/let_go", ros::Trigger::kName, true,
        "A person lets the command of the robot go: what people have ordered ends, and the behaviour may "
        "command. Nothing else gives the command back after an order or a stop of a person's",
        "{}"},
    ServiceRow{
        "/head/look", ros::Look::kName, true,
        "Where the head is to look, while the robot stands or walks. `mode`: `ahead`; `direction`, by `yaw` "
        "to "
        "the left and `pitch` down [rad] of the neck; `point`, at `x`, `y`, `z` [m, odom]; `scan`, `extent` "
        "[rad] to either side of `yaw` and `pitch`, there and back in `period` [s]; `hold`, where it is. "
        "`speed` "
        "[rad/s] at most. 0: `period` and `speed` as the robot has them. It goes as far as the neck does",
        R"({"mode": "direction", "yaw": 0.5, "pitch": 0.1})"},
    ServiceRow{
        "/behaviour/start", ros::StartMission::kName, true,
        "Begin a mission anew: the name of a shipped one or the path of its file on the robot; empty: the "
        "one that is loaded. While a person commands it waits: /command/let_go. Wants the plug-in "
        "`behaviour`",
        R"({"mission": "stand_up_after_falls"})"},
    ServiceRow{"/behaviour/end", ros::Trigger::kName, true, "End the mission: its tree is halted", "{}"},
    ServiceRow{"/behaviour/change", ros::Trigger::kName, true,
               "Exchange the running tree for what its file says now; what nodes remember is kept by their "
               "path. `success` is false, and the old tree goes on, where that cannot be: `message` says why",
               "{}"},
    ServiceRow{
        "/simulation/push", ros::PushLink::kName, false,
        "Push the simulated robot: `force` [N, 0.1 to 200 in size] on the centre of mass of `link`, for "
        "`duration` [s, 0.01 to 2]. `frame`: `world`, the simulator's, also when it is empty; or `heading`, "
        "in "
        "which x is where the robot looks and z is up. Eight pushes at once at most. For everybody who is "
        "let "
        "in. A real robot does not list this service, and refuses it",
        R"({"link": "trunk", "force": {"x": 5.0, "y": 0.0, "z": 0.0}, "duration": 0.1, "frame": "heading"})",
        true},
    ServiceRow{"/simulation/set_speed", ros::SetSpeed::kName, false,
               "Let the simulation run at `speed` times real time, 0.1 to 40, as far as the computer can; "
               "`pace` of /simulation/state tells how fast it does",
               R"({"speed": 2.0})", true},
    ServiceRow{
        "/simulation/seek", ros::SeekTime::kName, false,
        "Go to the instant `time` [s], from 0 to `recorded` of /simulation/state, and pause there: all "
        "of the robot and the world is as it was. When it plays on from there, what came later is "
        "forgotten. `time`: the instant that was reached",
        R"({"time": 1.5})", true},
    ServiceRow{
        "/simulation/apply", ros::ApplyEvent::kName, false,
        "Do something to the robot or the world now: `event` is an event of a scenario without `at_s`, "
        "as YAML in one line or as JSON: `push`, `fault`, `spawn`, `move` or `remove` with its fields "
        "(docs/simulator.md)",
        R"({"event": "{fault: {kind: jam, duration_s: 0.01}}"})", true},
    ServiceRow{
        "/simulation/plan", ros::PlanFootsteps::kName, false,
        "Plan footsteps to a place of the world, as /walk_to does, and walk none of them. `sides`: of "
        "each step, 0 left or 1 right; `steps`: x, y [m] and yaw [rad] of each; `feet`: the same of the "
        "left and the right foot now; `duration`: of the walk [s], estimated. `success` is false with "
        "the planner's reason where there is no way",
        R"({"x": 1.0, "y": 0.5, "yaw": 0.0})", true},
    ServiceRow{
        "/simulation/geometry", ros::GetGeometry::kName, false,
        "The solids of the world, from the one of index `first` on, as many as one answer holds (200), "
        "of `total`. Ask again where `geometry` of /simulation/state is another one; what can be moved "
        "is where the state says",
        R"({"first": 0})", true},
    ServiceRow{"/simulation/twin/follow", ros::SetBool::kName, false,
               "`data` true: the simulated robot does what the real one is told whose twin it is; false: it "
               "is free for trials. Refused where there is no twin (/simulation/twin)",
               R"({"data": true})", true},
    ServiceRow{
        "/simulation/twin/send", ros::SendToRobot::kName, false,
        "Send the real robot what was tried: a `walk` [m/s, m/s, rad/s] for `duration` [s], a `motion` or a "
        "`goal` [m, m, rad], and `settings` of plug-ins (PLUGIN.PARAMETER=VALUE) before it. It is tried "
        "first "
        "on 20 simulated robots that begin where that one is, and sent when all of them stay up and do it; "
        "or "
        "with a `reason` of 10 characters or more, which is recorded. Answered when the trial begins: "
        "/simulation/twin tells the rest",
        R"({"walk": [0.1, 0.0, 0.0], "duration": 5.0})", true},
    ServiceRow{"/simulation/twin/stop", ros::Trigger::kName, false,
               "End what is tried or sent, and stop the real robot", "{}", true},
    ServiceRow{"/simulation/twin/reconnect", ros::Trigger::kName, false,
               "Connect to the real robot again after it was refused", "{}", true},
    ServiceRow{
        "/simulation/twin/picture", ros::GetPicture::kName, false,
        "The picture (PNG) of the worst robot of the newest trial, from the byte `first` on: `data` in "
        "base64, of `total` bytes",
        R"({"first": 0})", true},
    ServiceRow{
        "/simulation/get_simulator_features", ros::simulation::GetSimulatorFeatures::kName, false,
        "What this simulator can do of what the package simulation_interfaces has. `custom_info`: what "
        "there is to know about it, or why it can do nothing",
        "{}", true},
    ServiceRow{
        "/simulation/get_simulation_state", ros::simulation::GetSimulationState::kName, false,
        "Whether it plays (1) or is paused (2); it is stopped (0) when it is paused and nothing has been "
        "simulated",
        "{}", true},
    ServiceRow{"/simulation/set_simulation_state", ros::simulation::SetSimulationState::kName, false,
               "Play (1), pause (2), or stop (0), which pauses and resets", R"({"state": {"state": 2}})",
               true},
    ServiceRow{
        "/simulation/step_simulation", ros::simulation::StepSimulation::kName, false,
        "Simulate so many milliseconds, 1 to 10000, while it is paused; answered when it has. A step is "
        "one millisecond",
        R"({"steps": 10})", true},
    ServiceRow{"/simulation/reset_simulation", ros::simulation::ResetSimulation::kName, false,
               "Back to the start: the time, the robot and the world, without what was spawned. All of these "
               "together or none: `scope` is 0, 7 or 255",
               R"({"scope": 255})", true},
    ServiceRow{
        "/simulation/spawn_entity", ros::simulation::SpawnEntity::kName, false,
        "Put something into the world, centre at `initial_pose` (of the frame `world`, upright). `uri` of "
        "its "
        "resource: one that /simulation/get_spawnables lists, with other values: "
        "`gaitway:SHAPE?size=X,Y,Z&mass=KG&colour=R,G,B`, SHAPE box, cylinder or sphere, `size` whole [m], "
        "colours from 0 to 1. Without `mass` it stands fast. `entity_name`: what it is called now",
        R"({"name": "crate", "allow_renaming": true, "entity_resource": {"uri": "gaitway:box?size=0.1,0.1,0.1&mass=0.5"}, "initial_pose": {"pose": {"position": {"x": 1.0, "y": 0.5, "z": 0.05}}}})",
        true},
    ServiceRow{"/simulation/delete_entity", ros::simulation::DeleteEntity::kName, false,
               "Remove what was spawned", R"({"entity": "crate"})", true},
    ServiceRow{
        "/simulation/get_entities", ros::simulation::GetEntities::kName, false,
        "Names of what is in the world: `robot`, and every solid. Filters: a regular expression (POSIX "
        "extended, without intervals and back references) of the name, categories, tags, and a sphere "
        "that it overlaps with",
        R"({"filters": {"filter": "^crate"}})", true},
    ServiceRow{
        "/simulation/get_entity_state", ros::simulation::GetEntityState::kName, false,
        "True pose of an entity, in the frame `world`, and its velocity, as the mean of the last 0.25 s "
        "of simulated time or less; null where that is not known, as accelerations of what can move are",
        R"({"entity": "robot"})", true},
    ServiceRow{
        "/simulation/set_entity_state", ros::simulation::SetEntityState::kName, false,
        "Move what was spawned, or what can be pushed, to a pose (`set_pose`), upright; velocities cannot "
        "be set",
        R"({"entity": "crate", "state": {"pose": {"position": {"x": 1.0, "y": 0.2, "z": 0.05}}}, "set_pose": true})",
        true},
    ServiceRow{"/simulation/get_entities_states", ros::simulation::GetEntitiesStates::kName, false,
               "Names and states of what is in the world, with the filters of /simulation/get_entities",
               R"({"filters": {"filter": "robot"}})", true},
    ServiceRow{
        "/simulation/get_entity_info", ros::simulation::GetEntityInfo::kName, false,
        "What an entity is: its category (1 the robot, 0 what can be moved, 5 what stands fast), and as "
        "tags its kind, its shape and whether it was spawned",
        R"({"entity": "robot"})", true},
    ServiceRow{"/simulation/get_spawnables", ros::simulation::GetSpawnables::kName, false,
               "What /simulation/spawn_entity can spawn", "{}", true},
    ServiceRow{"/simulation/get_current_world", ros::simulation::GetCurrentWorld::kName, false,
               "The world that is simulated. `uri`: as the option --world has it", "{}", true},
    ServiceRow{"/rosapi/topics", ros::Topics::kName, false, "Every topic and its type", "{}"},
    ServiceRow{"/rosapi/topic_type", ros::TopicType::kName, false,
               "The type of a topic; empty when there is none of that name", R"({"topic": "/joint_states"})"},
    ServiceRow{"/rosapi/topics_for_type", ros::TopicsForType::kName, false, "The topics of a type",
               R"({"type": "geometry_msgs/msg/PointStamped"})"},
    ServiceRow{"/rosapi/topics_and_raw_types", ros::TopicsAndRawTypes::kName, false,
               "Every topic, its type and the whole text of its definition", "{}"},
    ServiceRow{"/rosapi/publishers", ros::Publishers::kName, false, "The nodes that publish a topic",
               R"({"topic": "/joint_states"})"},
    ServiceRow{"/rosapi/subscribers", ros::Subscribers::kName, false, "The nodes that subscribe to a topic",
               R"({"topic": "/cmd_vel"})"},
    ServiceRow{"/rosapi/interfaces", ros::Interfaces::kName, false, "Every message and service type", "{}"},
    ServiceRow{"/rosapi/services", ros::Services::kName, false, "Every service", "{}"},
    ServiceRow{"/rosapi/service_type", ros::ServiceType::kName, false,
               "The type of a service; empty when there is none of that name", R"({"service": "/stand"})"},
    ServiceRow{"/rosapi/services_for_type", ros::ServicesForType::kName, false, "The services of a type",
               R"({"type": "std_srvs/srv/Trigger"})"},
    ServiceRow{"/rosapi/service_node", ros::ServiceNode::kName, false, "The node that offers a service",
               R"({"service": "/stand"})"},
    ServiceRow{"/rosapi/service_providers", ros::ServiceProviders::kName, false,
               "The nodes that offer services of a type", R"({"service": "std_srvs/srv/Trigger"})"},
    ServiceRow{"/rosapi/service_request_details", ros::ServiceRequestDetails::kName, false,
               "The fields of a service type's request", R"({"type": "gaitway_msgs/srv/MoveJoint"})"},
    ServiceRow{"/rosapi/service_response_details", ros::ServiceResponseDetails::kName, false,
               "The fields of a service type's response", R"({"type": "gaitway_msgs/srv/ListPlugins"})"},
    ServiceRow{"/rosapi/message_details", ros::MessageDetails::kName, false,
               "The fields of a message type, and of those within it",
               R"({"type": "sensor_msgs/msg/JointState"})"},
    ServiceRow{"/rosapi/nodes", ros::Nodes::kName, false, "Every node: the robot is one", "{}"},
    ServiceRow{"/rosapi/node_details", ros::NodeDetails::kName, false,
               "What a node publishes, subscribes to and offers", R"({"node": "/gaitway"})"},
    ServiceRow{"/rosapi/action_servers", ros::GetActionServers::kName, false,
               "Action servers: the robot has none", "{}"},
    ServiceRow{"/rosapi/get_time", ros::GetTime::kName, false, "The robot's clock", "{}"},
    ServiceRow{"/rosapi/get_ros_version", ros::GetROSVersion::kName, false,
               "2, since types are those of ROS 2", "{}"},
    ServiceRow{"/rosapi/get_param_names", ros::GetParamNames::kName, false,
               "Every parameter, as plug-in:parameter", "{}"},
    ServiceRow{"/rosapi/get_param", ros::GetParam::kName, false, "A parameter, its value as JSON text",
               R"({"name": "stability:trim_limit"})"},
    ServiceRow{"/rosapi/set_param", ros::SetParam::kName, true, "Set a live parameter of a plug-in",
               R"({"name": "stability:trim_limit", "value": "\"0.1 rad\""})"},
    ServiceRow{"/rosapi/has_param", ros::HasParam::kName, false, "Whether there is such a parameter",
               R"({"name": "stability:trim_limit"})"},
    ServiceRow{"/rosapi/delete_param", ros::DeleteParam::kName, true, "Parameters cannot be deleted: says so",
               R"({"name": "stability:trim_limit"})"},
};

// The row of `name`; a client may leave the leading / out. Null: there is none.
[[nodiscard]] constexpr const ServiceRow* find_service(std::string_view name) noexcept {
  for (const ServiceRow& row : kServices) {
    if (row.name == name || row.name.substr(1) == name) {
      return &row;
    }
  }
  return nullptr;
}

}  // namespace gaitway::api
