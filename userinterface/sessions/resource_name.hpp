// Names that clients give to topics and services of their own, and to types: in one spelling each.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace gaitway::api {

// A topic's or service's name as the client wrote it: letters, digits and _, in parts between single slashes.
// Throws Refused.
[[nodiscard]] std::string resource_name_in(const nlohmann::json& message, const char* field);

// "chat" and "/chat" are one.
[[nodiscard]] std::string absolute_name(std::string_view name);

// "std_msgs/String" -> "std_msgs/msg/String", with `kind` "msg" or "srv"; the robot need not know the type.
// Empty when the message has none. Throws Refused.
[[nodiscard]] std::string type_in(const nlohmann::json& message, std::string_view kind);

}  // namespace gaitway::api
