// The parts of JSON that take thought: strings, and bytes as one.
#include "gaitway/api/json_codec.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gaitway::api {
namespace {

bool is_plain(char character) noexcept {
  const auto byte = static_cast<unsigned char>(character);
  return byte >= 0x20 && byte < 0x80 && byte != '"' && byte != '\\';
}

}  // namespace

void append_json_string(std::string& out, std::string_view text) {
  if (std::ranges::all_of(text, is_plain)) {
    out += '"';
    out += text;
    out += '"';
    return;
  }
  out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_json_bytes(std::string& out, std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kGroup = 3, kDigitsOfGroup = 4;
  out += '"';
  for (std::size_t i = 0; i < bytes.size(); i += kGroup) {
    const auto group = bytes.subspan(i, std::min(kGroup, bytes.size() - i));
    std::uint32_t bits = 0;
    for (std::size_t byte = 0; byte < kGroup; ++byte) {
      bits = bits << 8U | (byte < group.size() ? group[byte] : 0U);
    }
    for (std::size_t digit = 0; digit < kDigitsOfGroup; ++digit) {
      const std::size_t shift = 6 * (kDigitsOfGroup - 1 - digit);
      out += digit <= group.size() ? kDigits[bits >> shift & 0x3FU] : '=';
    }
  }
  out += '"';
}

}  // namespace gaitway::api
