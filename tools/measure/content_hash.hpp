// A 64-bit hash of texts and files: FNV-1a.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace gaitway::tools {

class ContentHash {
 public:
  void add(std::string_view bytes) noexcept {
    for (const char byte : bytes) {
      state_ = (state_ ^ static_cast<unsigned char>(byte)) * 0x0000'0100'0000'01B3ULL;
    }
  }
  // Its bytes. Throws std::runtime_error that names the file when it cannot be read.
  void add_file(const std::filesystem::path& file);
  [[nodiscard]] std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0xCBF2'9CE4'8422'2325ULL;
};

}  // namespace gaitway::tools
