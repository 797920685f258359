// CBOR of the ROS messages, as rosbridge clients expect it: maps of fields, arrays of numbers as typed arrays
// (RFC 8746, little endian), uint8[] as byte strings.
#pragma once

#include <string>
#include <string_view>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

template <Message M>
void append_cbor(std::string& out, const M& message);

// Appends {op: "publish", topic: topic, msg: message}.
template <Message M>
void append_publish_cbor(std::string& out, std::string_view topic, const M& message);

}  // namespace gaitway::api
