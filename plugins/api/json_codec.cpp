// The one part of JSON that takes thought: strings.
#include "gaitway/api/json_codec.hpp"

#include "utf8.hpp"

namespace gaitway::api {
namespace {

bool is_plain(char character) noexcept {
  const auto byte = static_cast<unsigned char>(character);
  return byte >= 0x20 && byte < 0x80 && byte != '"' && byte != '\\';
}

void append_escaped(std::string& out, char character) {
  constexpr std::string_view kEscaped = "\"\\\b\f\n\r\t", kLetters = "\"\\bfnrt";
  out += '\\';
  if (const std::size_t index = kEscaped.find(character); index != std::string_view::npos) {
    out += kLetters[index];
    return;
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(character);
  out += "u00";
  out += kDigits[byte >> 4U];
  out += kDigits[byte & 0xFU];
}

}  // namespace

void append_json_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    std::size_t plain = 0;
    while (plain < text.size() && is_plain(text[plain])) {
      ++plain;
    }
    out += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) {
      break;
    }
    const Utf8Character character = first_character(text);
    if (character.bytes == 1) {
      append_escaped(out, text[0]);
    } else if (character.bytes > 1) {
      out += text.substr(0, character.bytes);
    } else {
      out += kReplacementCharacter;
    }
    text.remove_prefix(character.bytes + character.broken);
  }
  out += '"';
}

}  // namespace gaitway::api
