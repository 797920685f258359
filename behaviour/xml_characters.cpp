// UTF-8 and XML's characters, by XML 1.0 (fifth edition), productions 2, 4, 66 and 68.
#include "xml_characters.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

namespace gaitway::behaviour {
namespace {

struct Decoded {
  std::uint32_t code = 0;
  std::size_t length = 0;  // 0: it is no UTF-8
};

Decoded decode(std::string_view text) noexcept {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return {};
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  return code >= kLeast[length] ? Decoded{code, length} : Decoded{};
}

bool allowed(std::uint32_t code) noexcept {
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  return code < 0xD800 || (code > 0xDFFF && code < 0xFFFE) || (code > 0xFFFF && code <= 0x10FFFF);
}

std::string encode(std::uint32_t code) {
  std::string text;
  const auto add = [&text](std::uint32_t byte) {
    text += static_cast<char>(static_cast<unsigned char>(byte));
  };
  const auto tail = [&](int groups) {
    for (int i = groups - 1; i >= 0; --i) add(0x80U | (code >> (6U * static_cast<unsigned>(i)) & 0x3FU));
  };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | code >> 6U);
    tail(1);
  } else if (code < 0x10000) {
    add(0xE0U | code >> 12U);
    tail(2);
  } else {
    add(0xF0U | code >> 18U);
    tail(3);
  }
  return text;
}

bool begins_name(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<signed char>(c) < 0;
}

}  // namespace

std::optional<std::size_t> first_forbidden(std::string_view text) noexcept {
  for (std::size_t i = 0; i < text.size();) {
    const Decoded character = decode(text.substr(i));
    if (character.length == 0 || !allowed(character.code)) return i;
    i += character.length;
  }
  return std::nullopt;
}

std::size_t name_length(std::string_view text) noexcept {
  if (text.empty() || !begins_name(text[0])) return 0;
  std::size_t length = 1;
  while (length < text.size() && (begins_name(text[length]) || (text[length] >= '0' && text[length] <= '9') ||
                                  text[length] == '-' || text[length] == '.')) {
    ++length;
  }
  return length;
}

std::optional<std::string> entity_text(std::string_view entity) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kNamed{
      {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
  for (const auto& [known, character] : kNamed) {
    if (entity == known) return std::string(1, character);
  }
  if (!entity.starts_with('#')) return std::nullopt;
  entity.remove_prefix(1);
  const bool hexadecimal = entity.starts_with('x');
  entity.remove_prefix(hexadecimal ? 1 : 0);
  std::uint32_t code = 0;
  const auto [stop, error] = std::from_chars(entity.begin(), entity.end(), code, hexadecimal ? 16 : 10);
  if (entity.empty() || error != std::errc{} || stop != entity.end() || !allowed(code)) return std::nullopt;
  return encode(code);
}

std::string xml_text(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size();) {
    const Decoded character = decode(text.substr(i));
    const std::size_t length = character.length == 0 ? 1 : character.length;
    const std::string_view bytes = text.substr(i, length);
    if (character.length == 0 || !allowed(character.code)) {
      safe += "\xEF\xBF\xBD";
    } else if (bytes == "<") {
      safe += "&lt;";
    } else if (bytes == ">") {
      safe += "&gt;";
    } else if (bytes == "&") {
      safe += "&amp;";
    } else if (bytes == "\"") {
      safe += "&quot;";
    } else {
      safe += bytes;
    }
    i += length;
  }
  return safe;
}

}  // namespace gaitway::behaviour
