// Responses in the encoding that was asked for, and arguments by name.
#include "service_call.hpp"

#include "client_message.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

void append_cbor_value(std::string& out, const json& value) {
  json::to_cbor(value, out);
}

}  // namespace

// The values are the last field, so that they can be appended in their own encoding.
void begin_response(std::string& out, const ServiceCall& call, bool result) {
  if (call.encoding == Encoding::cbor) {
    constexpr unsigned kMap = 0xA0;
    out += static_cast<char>(kMap | (call.id.is_null() ? 4U : 5U));
    for (const json& text : {json("op"), json("service_response"), json("service"), json(call.service)}) {
      append_cbor_value(out, text);
    }
    if (!call.id.is_null()) {
      append_cbor_value(out, "id");
      append_cbor_value(out, call.id);
    }
    append_cbor_value(out, "result");
    append_cbor_value(out, result);
    append_cbor_value(out, "values");
    return;
  }
  out += R"({"op":"service_response","service":)";
  append_json_string(out, call.service);
  if (!call.id.is_null()) {
    out += ",\"id\":" + call.id.dump();
  }
  out += result ? R"(,"result":true,"values":)" : R"(,"result":false,"values":)";
}

void end_response(std::string& out, const ServiceCall& call) {
  if (call.encoding == Encoding::json) {
    out += '}';
  }
}

Frame service_failure(const ServiceCall& call, std::string_view why) {
  auto out = std::make_shared<std::string>();
  begin_response(*out, call, false);
  if (call.encoding == Encoding::cbor) {
    append_cbor_value(*out, why);
  } else {
    append_json_string(*out, why);
  }
  end_response(*out, call);
  return {std::move(out), call.encoding == Encoding::cbor};
}

Frame status_frame(std::string_view level, std::string_view text, const json& id) {
  auto out = std::make_shared<std::string>(R"({"op":"status","level":)");
  append_json_string(*out, level);
  if (!id.is_null()) {
    *out += ",\"id\":" + id.dump();
  }
  *out += ",\"msg\":";
  append_json_string(*out, text);
  *out += '}';
  return {std::move(out), false};
}

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
