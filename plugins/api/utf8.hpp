// Text that must be UTF-8, from text that may be anything.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gaitway::api {

// How many bytes at the start of `text`, which is not empty, are one character. 0: they are none, and the
// `broken` first ones stand for one U+FFFD (the longest start of a character, or one byte: Unicode, 3.9).
struct Utf8Character {
  std::size_t bytes = 0;
  std::size_t broken = 0;
};
[[nodiscard]] Utf8Character first_character(std::string_view text) noexcept;

[[nodiscard]] bool is_utf8(std::string_view text) noexcept;

// The text with U+FFFD for what is not UTF-8.
[[nodiscard]] std::string to_utf8(std::string_view text);

inline constexpr std::string_view kReplacementCharacter = "\xEF\xBF\xBD";

}  // namespace gaitway::api
