// A client's call of a service: its arguments, and the frames that answer clients.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/cbor_codec.hpp"
#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/session.hpp"

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

struct ServiceCall {
  std::uint64_t client = 0;     // Claimant::number
  nlohmann::json id;            // null: none
  std::string service;          // as the client wrote it
  std::int64_t timeout_ns = 0;  // after which the client waits no more
  Encoding encoding = Encoding::json;
  std::size_t fragment_bytes = 0;
};

// Appends the beginning of a service_response, up to the values, and its end.
void begin_response(std::string& out, const ServiceCall& call, bool result);
void end_response(std::string& out, const ServiceCall& call);

// The service was carried out, `values` say with what success.
template <Message M>
[[nodiscard]] Frame service_response(const ServiceCall& call, const M& values) {
  auto out = std::make_shared<std::string>();
  begin_response(*out, call, true);
  if (call.encoding == Encoding::cbor) {
    append_cbor(*out, values);
  } else {
    append_json(*out, values);
  }
  end_response(*out, call);
  return {std::move(out), call.encoding == Encoding::cbor};
}

// The service could not be carried out: `why`, for people.
[[nodiscard]] Frame service_failure(const ServiceCall& call, std::string_view why);

// `level`: error, warning or info.
[[nodiscard]] Frame status_frame(std::string_view level, std::string_view text, const nlohmann::json& id);

}  // namespace gaitway::api
