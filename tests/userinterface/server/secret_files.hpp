// A folder with what a server needs to be reached from outside: a token, a key and a certificate for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace gaitway::api {

// Made new, and removed at the end.
class SecretFiles {
 public:
  static constexpr std::string_view kToken = "a-token-of-some-length-4711";

  // An elliptic key costs its server a tenth of a millisecond for each handshake, a costly one some.
  enum class KeyKind : std::uint8_t { elliptic, costly };

  // Of the certificate, from now.
  struct Validity {
    long begins_s, ends_s;
  };
  static constexpr long kDay = 24L * 3600;  // s

  // `name`: of the certificate's subject; empty: it has none, as one whose hosts stand in an extension alone.
  explicit SecretFiles(KeyKind kind = KeyKind::elliptic, Validity validity = {-kDay, kDay},
                       const std::string& name = "localhost");
  ~SecretFiles();
  SecretFiles(const SecretFiles&) = delete;
  SecretFiles& operator=(const SecretFiles&) = delete;

  // A file for its owner only.
  [[nodiscard]] std::filesystem::path write(const std::string& name, std::string_view text) const;
  [[nodiscard]] std::filesystem::path token() const { return folder_ / "token"; }
  [[nodiscard]] std::filesystem::path key() const { return folder_ / "key.pem"; }
  [[nodiscard]] std::filesystem::path certificate() const { return folder_ / "certificate.pem"; }
  // A key that no certificate belongs to.
  [[nodiscard]] std::filesystem::path other_key() const { return folder_ / "other_key.pem"; }

 private:
  std::filesystem::path folder_;
};

}  // namespace gaitway::api
