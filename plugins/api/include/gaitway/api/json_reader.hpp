// Messages out of JSON that a client sent.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

// What is wrong with a message, for the client: "linear.x is \"fast\", but must be a number".
class MessageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Fields that `json` does not name keep their values. Throws MessageError: an unknown field, a wrong type, a
// number out of range or not finite, an array of wrong length.
template <Message M>
void from_json(const nlohmann::json& json, M& message);

}  // namespace gaitway::api
