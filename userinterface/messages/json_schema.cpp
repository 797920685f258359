// JSON schemas of the messages.
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/api/message_definition.hpp"
#include "type_registry.hpp"

namespace gaitway::api {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json range() {
  return {{"type", "integer"},
          {"minimum", std::numeric_limits<T>::min()},
          {"maximum", std::numeric_limits<T>::max()}};
}

// Names of types hold slashes, which a JSON pointer writes as ~1.
std::string pointer(std::string_view type) {
  std::string text = "#/$defs/";
  for (const char character : type) {
    character == '/' ? text += "~1" : text += character;
  }
  return text;
}

Json integer_schema(std::string_view type) {
  const bool is_signed = type.starts_with("int");
  if (type.ends_with("64")) {
    return is_signed ? range<std::int64_t>() : range<std::uint64_t>();
  }
  if (type.ends_with("32")) {
    return is_signed ? range<std::int32_t>() : range<std::uint32_t>();
  }
  if (type.ends_with("16")) {
    return is_signed ? range<std::int16_t>() : range<std::uint16_t>();
  }
  return is_signed ? range<std::int8_t>() : range<std::uint8_t>();  // or "byte"
}

Json element_schema(const FieldDescription& field, Sender sender) {
  if (field.is_message) {
    return {{"$ref", pointer(field.type)}};
  }
  if (field.type == "bool") {
    return {{"type", "boolean"}};
  }
  if (field.type == "string") {
    return {{"type", "string"}};
  }
  if (field.type == "float64" || field.type == "float32") {
    return {{"type", sender == Sender::robot ? Json{"number", "null"} : Json("number")}};
  }
  return integer_schema(field.type);
}

Json field_schema(const FieldDescription& field, Sender sender) {
  if (field.length == kNoArray) {
    return element_schema(field, sender);
  }
  if (field.type == "uint8" && sender == Sender::robot) {
    return {{"type", "string"}, {"contentEncoding", "base64"}};
  }
  Json schema{{"type", "array"}, {"items", element_schema(field, sender)}};
  if (field.length != kAnyLength) {
    schema["minItems"] = schema["maxItems"] = field.length;
  }
  return schema;
}

// Clients may leave fields out, the robot never does.
Json object_schema(const TypeDescription& type, Sender sender) {
  Json properties = Json::object(), names = Json::array();
  for (const FieldDescription& field : type.fields) {
    properties[std::string(field.name)] = field_schema(field, sender);
    names.push_back(field.name);
  }
  Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (sender == Sender::robot) {
    schema["required"] = names;
  }
  return schema;
}

}  // namespace

std::string json_schema(std::string_view type, Sender sender) {
  const std::vector<const TypeDescription*> all = with_inner_types(type_description(type));
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", all.front()->name}};
  schema.update(object_schema(*all.front(), sender));
  for (std::size_t i = 1; i < all.size(); ++i) {
    schema["$defs"][std::string(all[i]->name)] = object_schema(*all[i], sender);
  }
  return schema.dump();
}

}  // namespace gaitway::api
