// The definitions of all types that the API speaks, made from the fields of their structs, and the registry
// by name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/rosapi_types.hpp"

namespace gaitway::api {

// "sensor_msgs/JointState", "sensor_msgs/msg/JointState" -> "sensor_msgs/msg/JointState";
// "std_srvs/Trigger" -> "std_srvs/srv/Trigger"; "rosapi/Topics" -> "rosapi_msgs/srv/Topics".
// Empty: no such type.
[[nodiscard]] std::string_view canonical_type(std::string_view type);

// Every message type and every service type, sorted.
[[nodiscard]] std::vector<std::string_view> message_types();
[[nodiscard]] std::vector<std::string_view> service_types();

// The rest take either spelling and throw std::invalid_argument that names an unknown type. A request or
// response is "std_srvs/srv/SetBool_Request" or "..._Response".

// The text of its .msg file.
[[nodiscard]] std::string message_definition(std::string_view type);
// The same, followed by those of all types within it: what MCAP's ros2msg schemas and
// rosapi/topics_and_raw_types hold.
[[nodiscard]] std::string full_message_definition(std::string_view type);
// What rosapi/message_details answers: the type and all types within it.
[[nodiscard]] std::vector<ros::TypeDef> type_definitions(std::string_view type);
// Whether a message comes from a client or from the robot. The robot writes null for a number that it does
// not know; clients may not.
enum class Sender : std::uint8_t { client, robot };

// JSON Schema (2020-12), as text, with those of the types within it in `$defs`.
[[nodiscard]] std::string json_schema(std::string_view type, Sender sender);

}  // namespace gaitway::api
