#include "secrets.hpp"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace gaitway::api {
namespace {

using Digest = std::array<unsigned char, EVP_MAX_MD_SIZE>;

bool digest(std::string_view text, Digest& to) noexcept {
  unsigned int length = 0;
  return EVP_Digest(text.data(), text.size(), to.data(), &length, EVP_sha256(), nullptr) == 1;
}

}  // namespace

std::string random_id() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::system_error(errno, std::generic_category(), "no random bytes for a lease");
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string id;
  for (const unsigned char byte : bytes) {
    id += kDigits[byte >> 4U];
    id += kDigits[byte & 15U];
  }
  return id;
}

bool same_secret(std::string_view a, std::string_view b) noexcept {
  Digest of_a{}, of_b{};
  const bool both = digest(a, of_a) && digest(b, of_b);
  return both && CRYPTO_memcmp(of_a.data(), of_b.data(), of_a.size()) == 0;
}

}  // namespace gaitway::api
