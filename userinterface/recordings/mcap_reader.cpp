// Records of a file, and those of its chunks, by the same function.
#include "gaitway/api/mcap_reader.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <span>

#include "gaitway/input/complaint.hpp"
#include "gaitway/process/crc32.hpp"
#include "mcap_record.hpp"

namespace gaitway::api {
namespace {

using mcap::Opcode;

class McapFile {
 public:
  McapFile(const std::filesystem::path& file, const std::function<void(const McapMessage&)>& take)
      : file_(file), take_(take) {}

  // True: the data's end was reached.
  bool read(std::string_view bytes, bool in_chunk) {
    while (bytes.size() >= mcap::kRecordHeaderBytes) {
      Content head{*this, bytes};
      const auto opcode = static_cast<Opcode>(head.number<std::uint8_t>());
      const auto length = head.number<std::uint64_t>();
      bytes.remove_prefix(mcap::kRecordHeaderBytes);
      if (length > bytes.size()) {
        if (in_chunk) refuse("a record is longer than its chunk");
        return false;
      }
      if (opcode == Opcode::data_end) return true;
      record(opcode, bytes.substr(0, length), in_chunk);
      bytes.remove_prefix(length);
    }
    return in_chunk;
  }
  [[noreturn]] void refuse(const std::string& rule) const {
    input::refuse({.file = file_,
                   .line = 0,
                   .field = "",
                   .value = "",
                   .rule = rule,
                   .remedy = "Give a recording as the robot API writes them"});
  }

 private:
  struct Content {
    const McapFile& file;
    std::string_view rest;

    std::string_view bytes(std::uint64_t size) {
      if (size > rest.size()) file.refuse("a record ends too soon");
      const std::string_view taken = rest.substr(0, size);
      rest.remove_prefix(size);
      return taken;
    }
    template <class Unsigned>
    Unsigned number() {
      Unsigned value = 0;
      std::size_t shift = 0;
      for (const char byte : bytes(sizeof value)) {
        value = static_cast<Unsigned>(
            value | static_cast<Unsigned>(Unsigned{static_cast<std::uint8_t>(byte)} << shift));
        shift += 8;
      }
      return value;
    }
    std::string_view text() { return bytes(number<std::uint32_t>()); }
  };
  struct Channel {
    std::string topic, encoding;
    std::uint16_t schema = 0;
  };

  void record(Opcode opcode, std::string_view bytes, bool in_chunk) {
    Content content{*this, bytes};
    if (opcode == Opcode::schema) {
      const auto id = content.number<std::uint16_t>();
      types_[id] = content.text();
    } else if (opcode == Opcode::channel) {
      const auto id = content.number<std::uint16_t>();
      const auto schema = content.number<std::uint16_t>();
      const std::string topic(content.text());
      channels_[id] = {topic, std::string(content.text()), schema};
    } else if (opcode == Opcode::message) {
      message(content);
    } else if (opcode == Opcode::chunk && !in_chunk) {
      chunk(content);
    }
  }
  void message(Content content) {
    const auto channel = channels_.find(content.number<std::uint16_t>());
    if (channel == channels_.end()) refuse("a message is on a channel that is not described before");
    (void)content.number<std::uint32_t>();  // of the channel, its number
    const auto log_ns = content.number<std::uint64_t>();
    (void)content.number<std::uint64_t>();  // when it was published
    take_({channel->second.topic, types_[channel->second.schema], channel->second.encoding, content.rest,
           log_ns});
  }
  void chunk(Content content) {
    (void)content.bytes(2 * sizeof(std::uint64_t));  // its times
    (void)content.number<std::uint64_t>();           // its size when it is not compressed
    const auto crc = content.number<std::uint32_t>();
    if (const std::string_view compression = content.text(); !compression.empty()) {
      refuse(fmt::format("is compressed ({}): only files without compression are read",
                         compression.substr(0, 16)));
    }
    const std::string_view records = content.bytes(content.number<std::uint64_t>());
    if (crc != 0 && crc != process::crc32(std::as_bytes(std::span(records)), 0))
      refuse("a chunk is damaged: its CRC differs");
    read(records, true);
  }

  const std::filesystem::path& file_;
  const std::function<void(const McapMessage&)>& take_;
  std::map<std::uint16_t, std::string> types_;
  std::map<std::uint16_t, Channel> channels_;
};

}  // namespace

bool read_mcap(const std::filesystem::path& file, const std::function<void(const McapMessage&)>& take) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  McapFile reader(file, take);
  if (!in.is_open()) reader.refuse("cannot be read");
  if (!bytes.starts_with(mcap::kMagic)) reader.refuse("is no MCAP file");
  return reader.read(std::string_view(bytes).substr(mcap::kMagic.size()), false);
}

}  // namespace gaitway::api
