// All types that the API speaks, described by visiting their structs once.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

struct TypeDescription;

struct FieldDescription {
  std::string_view name;
  std::string_view type;  // of an element: "float64", or a message's name
  int length = kNoArray;  // or kAnyLength, or how many elements
  bool is_message = false;
  std::string default_value;  // of a plain field, as Python prints it
};

struct TypeDescription {
  std::string_view name;
  std::vector<Constant> constants;
  std::vector<FieldDescription> fields;
};

struct TypeRegistry {
  // Requests and responses ("..._Request") as well as messages.
  std::map<std::string_view, TypeDescription> types;
  std::vector<std::string_view> messages, services;  // sorted
};

[[nodiscard]] const TypeRegistry& type_registry();

// Throws std::invalid_argument when there is none of that name, in whichever spelling.
[[nodiscard]] const TypeDescription& type_description(std::string_view type);

// A message's own type and those within it, each once, it first.
[[nodiscard]] std::vector<const TypeDescription*> with_inner_types(const TypeDescription& type);

// "sensor_msgs/msg/JointState" -> "sensor_msgs/JointState".
[[nodiscard]] std::string short_name(std::string_view type);

}  // namespace gaitway::api
