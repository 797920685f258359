// What is in an MCAP file, as far as these tests want to know: messages of each topic in whole chunks, and
// whether the file has its end. Reads the file from front to back, as one does with what a killed writer has
// left.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::api::test {

class McapOutline {
 public:
  explicit McapOutline(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::string_view magic("\x89MCAP0\r\n", 8);
    if (!bytes.starts_with(magic)) throw std::runtime_error("no MCAP file: " + file.string());
    complete_ = bytes.size() > 2 * magic.size() && bytes.ends_with(magic);
    read(std::string_view(bytes).substr(magic.size()));
  }
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] std::size_t chunks() const { return chunks_; }
  [[nodiscard]] std::size_t messages(const std::string& topic) const {
    const auto found = messages_.find(topic);
    return found == messages_.end() ? 0 : found->second;
  }

 private:
  template <class Number>
  static Number number(std::string_view bytes, std::size_t at) {
    Number value{};
    std::memcpy(&value, bytes.substr(at, sizeof value).data(), sizeof value);
    return value;
  }
  void read(std::string_view bytes) {
    while (bytes.size() >= 9) {
      const auto opcode = static_cast<std::uint8_t>(bytes[0]);
      const auto length = number<std::uint64_t>(bytes, 1);
      if (length > bytes.size() - 9) return;
      take(opcode, bytes.substr(9, length));
      if (opcode == 0x0F) return;  // the rest is the summary
      bytes.remove_prefix(9 + length);
    }
  }
  void take(std::uint8_t opcode, std::string_view content) {
    if (opcode == 0x04) {  // channel: id, schema, topic
      topics_[number<std::uint16_t>(content, 0)] = content.substr(8, number<std::uint32_t>(content, 4));
    } else if (opcode == 0x05) {
      ++messages_[topics_.at(number<std::uint16_t>(content, 0))];
    } else if (opcode == 0x06) {  // chunk: times, size, CRC, compression, records
      ++chunks_;
      const auto compression = number<std::uint32_t>(content, 28);
      read(content.substr(32 + compression + 8, number<std::uint64_t>(content, 32 + compression)));
    }
  }

  bool complete_ = false;
  std::size_t chunks_ = 0;
  std::map<std::uint16_t, std::string> topics_;
  std::map<std::string, std::size_t> messages_;
};

}  // namespace gaitway::api::test
