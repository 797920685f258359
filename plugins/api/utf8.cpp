// Which bytes are a character: Unicode 15, table 3-7.
#include "utf8.hpp"

namespace gaitway::api {
namespace {

unsigned char byte_at(std::string_view text, std::size_t index) noexcept {
  return static_cast<unsigned char>(text[index]);
}

// What may follow a first byte: how many bytes, and the range of the first of these.
struct Continuation {
  std::size_t bytes = 0;
  unsigned char lowest = 0x80, highest = 0xBF;
};

Continuation continuation(unsigned char first) noexcept {
  if (first >= 0xC2 && first <= 0xDF) {
    return {1};
  }
  if (first >= 0xE0 && first <= 0xEF) {
    // No longer form than needed, no surrogates.
    return {2, static_cast<unsigned char>(first == 0xE0 ? 0xA0 : 0x80),
            static_cast<unsigned char>(first == 0xED ? 0x9F : 0xBF)};
  }
  if (first >= 0xF0 && first <= 0xF4) {
    // No longer form than needed, nothing above U+10FFFF.
    return {3, static_cast<unsigned char>(first == 0xF0 ? 0x90 : 0x80),
            static_cast<unsigned char>(first == 0xF4 ? 0x8F : 0xBF)};
  }
  return {};
}

}  // namespace

Utf8Character first_character(std::string_view text) noexcept {
  const unsigned char first = byte_at(text, 0);
  if (first < 0x80) {
    return {.bytes = 1};
  }
  const Continuation rest = continuation(first);
  for (std::size_t i = 1; i <= rest.bytes; ++i) {
    const unsigned char lowest = i == 1 ? rest.lowest : 0x80, highest = i == 1 ? rest.highest : 0xBF;
    if (i >= text.size() || byte_at(text, i) < lowest || byte_at(text, i) > highest) {
      return {.broken = i};
    }
  }
  return rest.bytes == 0 ? Utf8Character{.broken = 1} : Utf8Character{.bytes = rest.bytes + 1};
}

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t bytes = first_character(text).bytes;
    if (bytes == 0) {
      return false;
    }
    text.remove_prefix(bytes);
  }
  return true;
}

std::string to_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    if (character.bytes > 0) {
      result += text.substr(0, character.bytes);
    } else {
      result += kReplacementCharacter;
    }
    text.remove_prefix(character.bytes + character.broken);
  }
  return result;
}

}  // namespace gaitway::api
