// JSON of the ROS messages, as rosbridge clients expect it. Numbers in their shortest form that reads back as
// the same number; NaN and infinities as null, since JSON has neither.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

// Appends a JSON string, quoted and escaped. Bytes that are not UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);

// Appends a JSON string of the bytes in base64 (RFC 4648, 4), as rosbridge writes uint8[].
void append_json_bytes(std::string& out, std::span<const std::uint8_t> bytes);

// Appends a number; null when it is not finite.
template <Number T>
void append_json_number(std::string& out, T value) {
  if constexpr (std::floating_point<T>) {
    if (!std::isfinite(value)) {
      out += "null";
      return;
    }
    if (value == T{0} && std::signbit(value)) {
      out += "-0.0";  // "-0" is an integer to many parsers, and that has no sign
      return;
    }
  }
  constexpr std::size_t kLongest = 32;  // shortest forms of a double have at most 24 characters
  std::array<char, kLongest> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  out.append(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
}

// Appends `{"name":value,...}`.
template <Message M>
void append_json(std::string& out, const M& message);

template <class T>
void append_json_value(std::string& out, const T& value) {
  if constexpr (Message<T>) {
    append_json(out, value);
  } else if constexpr (Array<T>) {
    using Element = typename FieldShape<T>::Element;
    if constexpr (std::same_as<Element, std::uint8_t>) {
      return append_json_bytes(out, value);
    } else {
      out += '[';
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (i > 0) {
          out += ',';
        }
        append_json_value<Element>(out, value[i]);
      }
      out += ']';
    }
  } else if constexpr (std::same_as<T, bool>) {
    out += value ? "true" : "false";
  } else if constexpr (Number<T>) {
    append_json_number(out, value);
  } else {
    append_json_string(out, value);
  }
}

template <Message M>
void append_json(std::string& out, const M& message) {
  char separator = '{';
  message.fields([&](std::string_view name, const auto& value) {
    out += separator;
    separator = ',';
    out += '"';
    out += name;
    out += "\":";
    append_json_value(out, value);
  });
  out += separator == '{' ? "{}" : "}";
}

// Appends {"op":"publish","topic":topic,"msg":message}.
template <Message M>
void append_publish_json(std::string& out, std::string_view topic, const M& message) {
  out += R"({"op":"publish","topic":)";
  append_json_string(out, topic);
  out += R"(,"msg":)";
  append_json(out, message);
  out += '}';
}

}  // namespace gaitway::api
