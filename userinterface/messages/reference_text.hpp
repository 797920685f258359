// The paragraphs of docs/api.md between its tables.
#pragma once

#include <string_view>

namespace gaitway::api::reference_text {

inline constexpr std::string_view kBeginning =
    R"(<!-- Made by `./dev gaitway api document`; change the tables in userinterface/messages, not this file. -->
# The robot API

rosbridge v2 over WebSocket: what roslibjs, roslibpy and other rosbridge clients speak. Each WebSocket text message is one JSON
object with a field `op`. Messages that the robot publishes come as JSON, or as CBOR in binary messages for who asks for it.

- Types are those of ROS 2 (`sensor_msgs/msg/JointState`); the names of ROS 1 (`sensor_msgs/JointState`) are understood, too.
- Units are SI. A stamp is the robot's clock, `{"sec": 12, "nanosec": 340000000}`; `/clock` publishes it.
- The robot writes `null` for a number that it does not know. Clients may not.
- What is wrong is refused by a `status` message that names the field, its value and the rule; nothing else changes.

**Who commands.** One connection at a time; anybody may watch. Who sends a command while nobody has the command gets it, or asks
for it by `/command/acquire`. It lasts as long as commands or `/command/keep_alive` come, and ends with the connection. Stop and
emergency stop are open to everybody who is let in.

**People and the robot's behaviour.** Whichever client it is, to the robot it is a person, and a person stands above the plug-in that decides by
itself (`behaviour`): each order and each stop takes the command from it, and it comes back by `/command/let_go` alone. The end of a connection, of a
lease or of a walk gives nothing back. `/command/state` tells who commands and why, and whose order walk, way, motion and head follow.

**Clients among themselves.** Topics and services that are not the robot's belong to the clients: whoever is let in may advertise, publish,
subscribe, offer and call them, whoever commands. The robot passes on what they say as JSON, or as CBOR to who asked for it, whatever its type. Whole
numbers beyond 64 bits become doubles; the order of fields and spaces may change. Their names are letters, digits and `_`, in parts between single
slashes. A topic and its type last while somebody advertises it or subscribes to it; a service lasts as long as its provider's connection. `/rosapi/nodes`
lists who has any of them as `/client_` and a number. There are no actions: `advertise_action`, `send_action_goal` and the like are refused.

**Time-out.** A velocity command holds for a short while only: send it again, ten times a second, say. When none comes any more, the robot
stops smoothly and stands.

)";

inline constexpr std::string_view kOperations = R"(## Operations

The examples of clients' messages stand in [api_examples.json](api_examples.json), too, in an order in which they can be sent, and a test
sends them.

)";

inline constexpr std::string_view kTopics = R"(## Topics that the robot publishes

Latched: a new subscriber gets the last message at once. Rate 0: when something has changed.

)";

inline constexpr std::string_view kAccepted = R"(
## Topics that the robot takes

All other names are for the clients' own topics.

)";

inline constexpr std::string_view kServices = R"(
## Services of the robot

Every response has `success` and, when that is false, the reason in `message`; those of the package simulation_interfaces have a `result`, 1 when it
worked, and the reason in its `error_message`. A service that needs the command is refused to who does not have it. What stands under `/simulation/` is
offered by a simulated robot alone, to everybody who is let in.

)";

inline constexpr std::string_view kRosapi = R"(## Services of rosapi

With these clients find out what there is.

)";

inline constexpr std::string_view kTypes = R"(
## Types

)";

inline constexpr std::string_view kLimits = R"(
## Limits

Each can be set in a file: `user_interface --limits FILE`, `gaitway serve --limits FILE` (YAML: `name: value`).

)";

inline constexpr std::string_view kSchemas = R"(
## JSON schemas

[api_schemas.json](api_schemas.json) holds one schema (2020-12) for each message, request and response: `message /joint_states`,
`publish /cmd_vel`, `call /stand`, `answer /stand`. This is `publish /cmd_vel`:

)";

}  // namespace gaitway::api::reference_text
