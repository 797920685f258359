// Definitions as ROS tools write them, and names in the spellings that clients use.
#include "gaitway/api/message_definition.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "type_registry.hpp"

namespace gaitway::api {
namespace {

std::string array_suffix(int length) {
  return length == kNoArray ? "" : length == kAnyLength ? "[]" : fmt::format("[{}]", length);
}

std::string fields_text(const TypeDescription& type) {
  std::string text;
  for (const Constant& constant : type.constants) {
    text += fmt::format("{} {}={}\n", constant.type, constant.name, constant.value);
  }
  for (const FieldDescription& field : type.fields) {
    text += fmt::format("{}{} {}\n", field.is_message ? short_name(field.type) : std::string(field.type),
                        array_suffix(field.length), field.name);
  }
  return text;
}

ros::TypeDef type_definition(const TypeDescription& type) {
  ros::TypeDef definition;
  definition.type = short_name(type.name);
  for (const FieldDescription& field : type.fields) {
    definition.fieldnames.emplace_back(field.name);
    definition.fieldtypes.push_back(field.is_message ? short_name(field.type) : std::string(field.type));
    definition.fieldarraylen.push_back(field.length);
    definition.examples.push_back(field.default_value);
  }
  for (const Constant& constant : type.constants) {
    definition.constnames.emplace_back(constant.name);
    definition.constvalues.push_back(fmt::format("{}", constant.value));
  }
  return definition;
}

// The known type of that package and name, whichever of the two kinds; empty when there is none.
std::string_view find_type(std::string_view package, std::string_view kind, std::string_view name) {
  const std::string full = fmt::format("{}/{}/{}", package, kind, name);
  const TypeRegistry& registry = type_registry();
  if (const auto found = registry.types.find(full); found != registry.types.end()) {
    return found->first;
  }
  const auto service = std::ranges::lower_bound(registry.services, full);
  return service != registry.services.end() && *service == full ? *service : std::string_view();
}

}  // namespace

std::string_view canonical_type(std::string_view type) {
  const std::size_t first = type.find('/');
  if (first == std::string_view::npos) {
    return {};
  }
  const std::size_t last = type.rfind('/');
  // ROS 1 has these services in the package of their node.
  const std::string_view package = type.substr(0, first) == "rosapi" ? "rosapi_msgs" : type.substr(0, first);
  const std::string_view name = type.substr(last + 1);
  if (first != last) {
    return find_type(package, type.substr(first + 1, last - first - 1), name);
  }
  const std::string_view message = find_type(package, "msg", name);
  return message.empty() ? find_type(package, "srv", name) : message;
}

std::vector<std::string_view> message_types() {
  return type_registry().messages;
}
std::vector<std::string_view> service_types() {
  return type_registry().services;
}

std::string message_definition(std::string_view type) {
  return fields_text(type_description(type));
}

std::string full_message_definition(std::string_view type) {
  constexpr std::size_t kSeparatorWidth = 80;
  const std::vector<const TypeDescription*> all = with_inner_types(type_description(type));
  std::string text = fields_text(*all.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    text += fmt::format("{}\nMSG: {}\n{}", std::string(kSeparatorWidth, '='), short_name(all[i]->name),
                        fields_text(*all[i]));
  }
  return text;
}

std::vector<ros::TypeDef> type_definitions(std::string_view type) {
  std::vector<ros::TypeDef> definitions;
  for (const TypeDescription* const one : with_inner_types(type_description(type))) {
    definitions.push_back(type_definition(*one));
  }
  return definitions;
}

}  // namespace gaitway::api
