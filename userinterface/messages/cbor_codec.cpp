// Items of CBOR: heads, texts and numbers (RFC 8949, 3).
#include "gaitway/api/cbor_codec.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gaitway/api/json_codec.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

void append_big_endian(std::string& out, std::uint64_t value, unsigned bytes) {
  for (unsigned i = bytes; i > 0; --i) {
    out += static_cast<char>((value >> (8 * (i - 1))) & 0xFFU);
  }
}

}  // namespace

void append_cbor_head(std::string& out, CborKind kind, std::uint64_t value) {
  constexpr unsigned kKindShift = 5, kOneByte = 24;
  const unsigned first = static_cast<unsigned>(kind) << kKindShift;
  if (value < kOneByte) {
    out += static_cast<char>(first | static_cast<unsigned>(value));
    return;
  }
  // 24, 25, 26 and 27 stand for one, two, four and eight further bytes.
  unsigned size_log = 0;
  while (size_log < 3 && (value >> (8U << size_log)) != 0) {
    ++size_log;
  }
  out += static_cast<char>(first | (kOneByte + size_log));
  append_big_endian(out, value, 1U << size_log);
}

void append_cbor_text(std::string& out, std::string_view text) {
  if (std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; })) {
    append_cbor_head(out, CborKind::text, text.size());
    out += text;
    return;
  }
  std::string json;
  append_json_string(json, text);
  nlohmann::json::to_cbor(nlohmann::json::parse(json), out);
}

void append_cbor_bool(std::string& out, bool value) {
  constexpr char kFalse = '\xF4', kTrue = '\xF5';
  out += value ? kTrue : kFalse;
}

void append_cbor_number(std::string& out, double value) {
  constexpr char kDouble = '\xFB';
  out += kDouble;
  append_big_endian(out, std::bit_cast<std::uint64_t>(value), sizeof value);
}

void append_cbor_number(std::string& out, float value) {
  constexpr char kFloat = '\xFA';
  out += kFloat;
  append_big_endian(out, std::bit_cast<std::uint32_t>(value), sizeof value);
}

void append_cbor_publish_head(std::string& out, std::string_view topic) {
  append_cbor_head(out, CborKind::map, 3);
  append_cbor_text(out, "op");
  append_cbor_text(out, "publish");
  append_cbor_text(out, "topic");
  append_cbor_text(out, topic);
  append_cbor_text(out, "msg");
}

void append_publish_cbor_raw(std::string& out, std::string_view topic, std::int64_t time_ns,
                             std::string_view cdr) {
  append_cbor_publish_head(out, topic);
  append_cbor_head(out, CborKind::map, 3);
  append_cbor_text(out, "secs");
  append_cbor_integer(out, time_ns / facts::kSecond_ns);
  append_cbor_text(out, "nsecs");
  append_cbor_integer(out, time_ns % facts::kSecond_ns);
  append_cbor_text(out, "bytes");
  append_cbor_head(out, CborKind::bytes, cdr.size());
  out += cdr;
}

}  // namespace gaitway::api
