// The reference for people who write clients, made from the tables that the code works with.
#pragma once

#include <string>

namespace gaitway::api {

// docs/api.md: operations, topics, services, types, limits, schemas.
[[nodiscard]] std::string api_reference();

// docs/api_examples.json: every message of the reference that a client may send, in an order in which they
// can be sent on one connection. [{"name", "send": message, "answer": what the answer holds among others, or
// null}]
[[nodiscard]] std::string api_examples();

// docs/api_schemas.json: a JSON Schema (2020-12) for every message that crosses the network, by "message
// /joint_states", "publish /cmd_vel", "call /stand" and "answer /stand".
[[nodiscard]] std::string api_schemas();

}  // namespace gaitway::api
