// What messages and their fields mean, in words: for people who read the .dbc file or docs/network.md. Where
// the fields lie is said in can/message_layout.hpp alone, whose names these texts go by.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "gaitway/can/message_layout.hpp"

namespace gaitway::tools {

// A value of a field that has a name.
struct NamedValue {
  std::int64_t value = 0;
  std::string_view name;     // a word
  std::string_view meaning;  // a sentence's part
};

// What the message is for, in one or two sentences.
[[nodiscard]] std::string_view meaning_of(can::MessageKind kind);
// What the field says. Throws std::logic_error that names it when nobody has described it.
[[nodiscard]] std::string_view meaning_of(can::MessageKind kind, std::string_view field);
// Empty for a field that is a number.
[[nodiscard]] std::span<const NamedValue> values_of(can::MessageKind kind, std::string_view field);
// The field is a mask of bits: then the named values are its bits.
[[nodiscard]] bool is_mask(can::MessageKind kind, std::string_view field);

}  // namespace gaitway::tools
