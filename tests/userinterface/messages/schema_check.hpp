// Whether a JSON value satisfies a schema, for the few words of JSON Schema that json_schema() uses.
#pragma once

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace gaitway::api::testing_messages {

class SchemaCheck {
 public:
  explicit SchemaCheck(nlohmann::json schema) : root_(std::move(schema)) {}

  [[nodiscard]] bool accepts(const nlohmann::json& value) const { return accepts(root_, value); }

 private:
  using Json = nlohmann::json;

  [[nodiscard]] bool accepts(const Json& schema, const Json& value) const {
    if (schema.contains("$ref")) {
      return accepts(root_.at(Json::json_pointer(schema.at("$ref").get<std::string>().substr(1))), value);
    }
    if (!has_type(schema.at("type"), value)) {
      return false;
    }
    if (value.is_object()) {
      return accepts_object(schema, value);
    }
    if (value.is_array()) {
      return accepts_array(schema, value);
    }
    return !value.is_number() || ((!schema.contains("minimum") || value >= schema.at("minimum")) &&
                                  (!schema.contains("maximum") || value <= schema.at("maximum")));
  }

  [[nodiscard]] bool accepts_object(const Json& schema, const Json& value) const {
    if (schema.at("additionalProperties") != false) {
      throw std::logic_error("this check knows closed objects only");
    }
    for (const auto& [name, element] : value.items()) {
      if (!schema.at("properties").contains(name) || !accepts(schema.at("properties").at(name), element)) {
        return false;
      }
    }
    for (const Json& name : schema.value("required", Json::array())) {
      if (!value.contains(name)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool accepts_array(const Json& schema, const Json& value) const {
    for (const Json& element : value) {
      if (!accepts(schema.at("items"), element)) {
        return false;
      }
    }
    return value.size() >= schema.value("minItems", 0U) &&
           (!schema.contains("maxItems") || value.size() <= schema.at("maxItems").get<std::size_t>());
  }

  // In JSON Schema 3.0 is an integer, too.
  [[nodiscard]] static bool has_type(const Json& type, const Json& value) {
    if (type.is_array()) {
      return has_type(type.at(0), value) || has_type(type.at(1), value);
    }
    if (type == "integer") {
      return value.is_number_integer() ||
             (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
    }
    return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
           (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
           (type == "number" && value.is_number()) || (type == "null" && value.is_null());
  }

  Json root_;
};

}  // namespace gaitway::api::testing_messages
