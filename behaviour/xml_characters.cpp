// UTF-8 and XML's characters, by XML 1.0 (fifth edition), productions 2, 4, 66 and 68.
#include "xml_characters.hpp"

#include <tinyxml2.h>

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

bool begins_name(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<signed char>(c) < 0;
}

std::string encode(std::uint32_t code) {
  constexpr std::size_t kLongest = 4;
  std::array<char, kLongest> bytes{};
  int length = 0;
  tinyxml2::XMLUtil::ConvertUTF32ToUTF8(code, bytes.data(), &length);
  return {bytes.data(), static_cast<std::size_t>(length)};
}

// What "lt" or "#x20" stands for; nothing: it is no entity that needs no document type.
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

std::optional<std::string> replace_entities(std::string& text) {
  std::string replaced;
  replaced.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '&') {
      replaced += text[i] == '\n' || text[i] == '\t' || text[i] == '\r' ? ' ' : text[i];
      ++i;
      continue;
    }
    const std::size_t end = text.find(';', i);
    const std::string entity = text.substr(i + 1, end == std::string::npos ? 0 : end - i - 1);
    const std::optional<std::string> meant = entity_text(entity);
    if (!meant) return entity;
    replaced += *meant;
    i = end + 1;
  }
  text = std::move(replaced);
  return std::nullopt;
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
