// Texts in arrays of fixed size, as topics have them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace gaitway::behaviour_leaves {

// A text of a topic, whose writer may have left out the 0 at its end.
template <std::size_t size>
[[nodiscard]] std::string_view text_of(const std::uint8_t (&bytes)[size]) noexcept {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  return text.substr(0, text.find('\0'));
}

// What there is no room for is cut off.
template <class Byte, std::size_t size>
void copy_text(Byte (&to)[size], std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), size - 1);
  std::memcpy(to, text.data(), length);
  std::memset(to + length, 0, size - length);
}

template <std::size_t size>
void copy_text(std::array<char, size>& to, std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), size - 1);
  to.fill('\0');
  std::memcpy(to.data(), text.data(), length);
}

}  // namespace gaitway::behaviour_leaves
