// The secret that lets a client in, read from a file that only its owner can read.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace gaitway::api {

// The text names the option, its value, the rule and the remedy.
class ServerSetupError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Keeps the token's SHA-256 digest only.
class AccessToken {
 public:
  static constexpr std::size_t kShortest = 16;
  static constexpr std::size_t kLongest = 4096;

  // Visible ASCII characters only, since it travels in an HTTP header. Throws ServerSetupError.
  explicit AccessToken(std::string_view text);
  // The file must be regular, belong to the user of this process and give nothing to group and others. One
  // line end after the token is no part of it. Throws ServerSetupError.
  static AccessToken read(const std::filesystem::path& file);

  // Takes the same time wherever the two differ.
  [[nodiscard]] bool matches(std::string_view offered) const noexcept;

 private:
  std::array<std::uint8_t, 32> digest_{};
};

}  // namespace gaitway::api
