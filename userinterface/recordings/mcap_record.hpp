// The pieces that MCAP's records are made of (mcap.dev/spec): little-endian numbers, texts and records with
// their length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gaitway::api::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  summary_offset = 0x0E,
  data_end = 0x0F
};

inline constexpr std::size_t kRecordHeaderBytes = 9;  // opcode and length

template <class Unsigned>
void append_number(std::string& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    out.push_back(static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i))));
  }
}

// Texts and blocks: 4 bytes of length, then the bytes.
inline void append_text(std::string& out, std::string_view text) {
  append_number(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

inline void append_record_header(std::string& out, Opcode opcode, std::uint64_t length) {
  out.push_back(static_cast<char>(opcode));
  append_number(out, length);
}

inline void append_record(std::string& out, Opcode opcode, std::string_view content) {
  append_record_header(out, opcode, content.size());
  out.append(content);
}

}  // namespace gaitway::api::mcap
