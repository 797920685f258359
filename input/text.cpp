// Reads files up to a size; replaces what a terminal would obey.
#include "gaitway/input/text.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>

#include "gaitway/input/complaint.hpp"

namespace gaitway::input {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool is_utf8 = false;
};

Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) {
    return {lead, 1, true};
  }
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  constexpr std::uint32_t kLowest[]{0x80, 0x800, 0x10000};  // no longer form than needed
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) {
    return {lead};
  }
  std::uint32_t code = lead & (0x7FU >> bytes);
  for (const char next : text.substr(1, bytes - 1)) {
    if ((static_cast<unsigned char>(next) & 0xC0U) != 0x80) {
      return {lead};
    }
    code = code << 6U | (static_cast<unsigned char>(next) & 0x3FU);
  }
  return code < kLowest[bytes - 2] || code > 0x10FFFF ? Character{lead} : Character{code, bytes, true};
}

bool is_obeyed(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return (code < 0x20 && code != '\n' && code != '\t') || within(0x7F, 0x9F) || within(0x200E, 0x200F) ||
         within(0x2028, 0x202E) || within(0x2066, 0x2069) || within(0xD800, 0xDFFF);
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file, const std::string& remedy,
                           std::size_t largest_bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code unknown;
  if (!stream || std::filesystem::is_directory(file, unknown)) {
    refuse({file, 0, "", "", "the file is missing or cannot be read", remedy});
  }
  std::string text;
  while (text.size() <= largest_bytes && stream) {
    constexpr std::size_t kPiece_bytes = 65536;
    const std::size_t end = text.size();
    text.resize(end + kPiece_bytes);
    stream.read(text.data() + end, kPiece_bytes);
    text.resize(end + static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > largest_bytes) {
    refuse({file, 0, "", "",
            fmt::format("the file is larger than {:g} MiB, the most that is read",
                        static_cast<double>(largest_bytes) / (1024.0 * 1024.0)),
            "Check that it is the right one, and leave out what is not needed"});
  }
  return text;
}

std::string terminal_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character first = first_character(text);
    if (first.is_utf8 && !is_obeyed(first.code)) {
      result += text.substr(0, first.bytes);
    } else {
      result +=
          first.code < 0x100 ? fmt::format("\\x{:02X}", first.code) : fmt::format("\\u{:04X}", first.code);
    }
    text.remove_prefix(first.bytes);
  }
  return result;
}

}  // namespace gaitway::input
