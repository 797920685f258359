// JSON of the ROS messages, as rosbridge clients expect it. Doubles in their shortest form that reads back as
// the same number; NaN and infinities as null, since JSON has neither.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

// Appends a JSON string, quoted and escaped. Bytes that are not UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);

// Appends a number: shortest form, null when it is not finite.
void append_json_number(std::string& out, double value);
void append_json_number(std::string& out, float value);

// Appends `{"name":value,...}`.
template <Message M>
void append_json(std::string& out, const M& message);

// Appends {"op":"publish","topic":topic,"msg":message}.
template <Message M>
void append_publish_json(std::string& out, std::string_view topic, const M& message);

}  // namespace gaitway::api
