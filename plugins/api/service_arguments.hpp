// The arguments of a service call as the service's request.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "gaitway/api/json_reader.hpp"

namespace gaitway::api {

// Arguments by name: an object as it is, a list by the order of `fields`, null as nothing. Throws Refused for
// anything else, and for a list that is too long.
[[nodiscard]] nlohmann::json named_arguments(const nlohmann::json& arguments,
                                             const std::vector<std::string_view>& fields);

// Throws Refused or MessageError.
template <Message Request>
[[nodiscard]] Request request_of(const nlohmann::json& arguments) {
  Request request;
  std::vector<std::string_view> fields;
  request.fields([&fields](std::string_view name, const auto&) { fields.push_back(name); });
  api::from_json(named_arguments(arguments, fields), request);
  return request;
}

}  // namespace gaitway::api
