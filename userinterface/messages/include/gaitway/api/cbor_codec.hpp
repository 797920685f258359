// CBOR (RFC 8949) of the ROS messages, as rosbridge clients expect it: maps of fields, arrays of numbers as
// typed arrays (RFC 8746, little endian), uint8[] as byte strings.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

enum class CborKind : std::uint8_t { unsigned_integer, negative_integer, bytes, text, array, map, tag };

// Appends the head of an item: its kind, and its value, size or number of entries, in as few bytes as
// possible.
void append_cbor_head(std::string& out, CborKind kind, std::uint64_t value);
// Bytes that are not UTF-8 become U+FFFD.
void append_cbor_text(std::string& out, std::string_view text);
void append_cbor_bool(std::string& out, bool value);
void append_cbor_number(std::string& out, double value);
void append_cbor_number(std::string& out, float value);

// The tag of RFC 8746 of an array of such numbers in little endian.
template <Number T>
[[nodiscard]] constexpr std::uint64_t typed_array_tag() noexcept {
  // 0b010'f's'e'll: float, signed, little endian; ll: log2 of the size, for floats from two bytes on.
  constexpr unsigned kBase = 0b0100'0000, kLittleEndian = 0b0100, kSigned = 0b1000, kFloat = 0b1'0000;
  constexpr unsigned kSizeLog = static_cast<unsigned>(std::countr_zero(sizeof(T)));
  if constexpr (std::floating_point<T>) {
    return kBase | kFloat | kLittleEndian | (kSizeLog - 1);
  } else {
    // Of one byte there is no endianness: there, that bit has another meaning.
    constexpr unsigned kEndian = sizeof(T) > 1 ? kLittleEndian : 0;
    return kBase | (std::signed_integral<T> ? kSigned : 0U) | kEndian | kSizeLog;
  }
}

template <Integer T>
void append_cbor_integer(std::string& out, T value) {
  if (value < 0) {
    append_cbor_head(out, CborKind::negative_integer, static_cast<std::uint64_t>(-(value + 1)));
  } else {
    append_cbor_head(out, CborKind::unsigned_integer, static_cast<std::uint64_t>(value));
  }
}

template <Message M>
void append_cbor(std::string& out, const M& message);

// An array of numbers that lie side by side.
template <Number T>
void append_cbor_numbers(std::string& out, std::span<const T> numbers) {
  static_assert(std::endian::native == std::endian::little, "the tags say so");
  if constexpr (!std::same_as<T, std::uint8_t>) {
    append_cbor_head(out, CborKind::tag, typed_array_tag<T>());
  }
  append_cbor_head(out, CborKind::bytes, numbers.size_bytes());
  out.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
}

template <class T>
void append_cbor_value(std::string& out, const T& value) {
  if constexpr (Message<T>) {
    append_cbor(out, value);
  } else if constexpr (Array<T>) {
    using Element = typename FieldShape<T>::Element;
    if constexpr (Number<Element>) {
      append_cbor_numbers(out, std::span<const Element>(value));
    } else {
      append_cbor_head(out, CborKind::array, value.size());
      for (std::size_t i = 0; i < value.size(); ++i) {
        append_cbor_value<Element>(out, value[i]);
      }
    }
  } else if constexpr (std::same_as<T, bool>) {
    append_cbor_bool(out, value);
  } else if constexpr (std::floating_point<T>) {
    append_cbor_number(out, value);
  } else if constexpr (Integer<T>) {
    append_cbor_integer(out, value);
  } else {
    append_cbor_text(out, value);
  }
}

template <Message M>
void append_cbor(std::string& out, const M& message) {
  std::uint64_t count = 0;
  message.fields([&count](std::string_view, const auto&) { ++count; });
  append_cbor_head(out, CborKind::map, count);
  message.fields([&out](std::string_view name, const auto& value) {
    append_cbor_text(out, name);
    append_cbor_value(out, value);
  });
}

// Appends the start of {op: "publish", topic: topic, msg: ...}: the message is to follow.
void append_cbor_publish_head(std::string& out, std::string_view topic);

// Appends {op: "publish", topic: topic, msg: message}.
template <Message M>
void append_publish_cbor(std::string& out, std::string_view topic, const M& message) {
  append_cbor_publish_head(out, topic);
  append_cbor(out, message);
}

// Appends {op: "publish", topic: topic, msg: {secs, nsecs, bytes}}: what a subscriber with the compression
// "cbor-raw" gets. `cdr`: the message in ROS 2's own encoding, with its four bytes of encapsulation; the
// time: when it was published.
void append_publish_cbor_raw(std::string& out, std::string_view topic, std::int64_t time_ns,
                             std::string_view cdr);

}  // namespace gaitway::api
