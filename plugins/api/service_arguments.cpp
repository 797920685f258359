#include "service_arguments.hpp"

#include <string>

#include "client_message.hpp"

namespace gaitway::api {

nlohmann::json named_arguments(const nlohmann::json& arguments, const std::vector<std::string_view>& fields) {
  if (arguments.is_object()) {
    return arguments;
  }
  auto named = nlohmann::json::object();
  if (arguments.is_null()) {
    return named;
  }
  if (!arguments.is_array()) {
    throw Refused("args is " + shown_json(arguments) + ", but must be an object or a list");
  }
  if (arguments.size() > fields.size()) {
    throw Refused("args has " + std::to_string(arguments.size()) + " elements, but the service takes " +
                  std::to_string(fields.size()));
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    named[std::string(fields[i])] = arguments[i];
  }
  return named;
}

}  // namespace gaitway::api
