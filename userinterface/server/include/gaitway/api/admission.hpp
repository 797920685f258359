// Whom the server lets in: who shows the token, out of a file that only its owner can read, and web pages of
// origins that may connect.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::api {

// The text names the option, its value, the rule and the remedy.
class ServerSetupError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The token in `file`, which must be regular, belong to the user of this process and give nothing to group
// and others. One line end after the token is no part of it. Throws ServerSetupError.
std::string read_token(const std::filesystem::path& file);

// The secret that lets a client in. Keeps the token's SHA-256 digest only.
class AccessToken {
 public:
  static constexpr std::size_t kShortest = 16;
  static constexpr std::size_t kLongest = 4096;

  // Visible ASCII characters only, since it travels in an HTTP header. Throws ServerSetupError.
  explicit AccessToken(std::string_view text);
  // The token of read_token(). Throws ServerSetupError.
  static AccessToken read(const std::filesystem::path& file);

  // Takes the same time wherever the two differ.
  [[nodiscard]] bool matches(std::string_view offered) const noexcept;

 private:
  std::array<std::uint8_t, 32> digest_{};
};

// Which web pages may connect.
class OriginRule {
 public:
  // Those listed, and always http and https pages of localhost, 127.0.0.1 and [::1], on any port. `null` and
  // `file://` stand for pages from files. Throws ServerSetupError for an entry that is neither, nor
  // `http(s)://host` or `http(s)://host:port`.
  explicit OriginRule(std::span<const std::string> allowed = {});

  // `origin`: the header's value.
  [[nodiscard]] bool allows(std::string_view origin) const;

 private:
  std::vector<std::string> allowed_;
};

}  // namespace gaitway::api
