// A context keeps the key's state, so that a code costs two hashes of a short text and no set-up.
#include "gaitway/stopgram/stop_key.hpp"

#include <openssl/core_names.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace gaitway::stopgram {
namespace {

using Code = std::array<std::uint8_t, 32>;

constexpr std::string_view kLabel = "gaitway stop datagrams 1";
constexpr std::size_t kLongestToken = 4096;
static_assert(kLabel.back() == '0' + kProtocolVersion);

evp_mac_ctx_st* new_context(Bytes key) {
  EVP_MAC* const hmac = EVP_MAC_fetch(nullptr, OSSL_MAC_NAME_HMAC, nullptr);
  EVP_MAC_CTX* const context = EVP_MAC_CTX_new(hmac);
  EVP_MAC_free(hmac);
  std::string digest = "SHA256";
  const std::array parameters{OSSL_PARAM_construct_utf8_string(OSSL_MAC_PARAM_DIGEST, digest.data(), 0),
                              OSSL_PARAM_construct_end()};
  static constexpr std::uint8_t kNothing = 0;  // an empty key is one, too
  if (context == nullptr ||
      EVP_MAC_init(context, key.empty() ? &kNothing : key.data(), key.size(), parameters.data()) != 1) {
    EVP_MAC_CTX_free(context);
    throw StopKeyError(
        "stop datagrams: OpenSSL gives no HMAC-SHA256: look at its configuration (openssl.cnf)");
  }
  return context;
}

Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

void StopKey::Free::operator()(evp_mac_ctx_st* context) const noexcept {
  EVP_MAC_CTX_free(context);
}

StopKey::StopKey(std::string_view token) : context_(new_context(bytes_of(token))) {
  Code key{};
  if (!code_of(bytes_of(kLabel), key)) {
    throw StopKeyError("stop datagrams: OpenSSL cannot derive the key");
  }
  context_.reset(new_context(key));
  OPENSSL_cleanse(key.data(), key.size());
}

StopKey StopKey::read(const std::filesystem::path& token_file) {
  const auto refuse = [&](const std::string& why) {
    throw StopKeyError("token file '" + token_file.native() + "': " + why);
  };
  errno = 0;
  std::ifstream in(token_file, std::ios::binary);
  std::string text(kLongestToken + 2, '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(text.size())) && !in.eof()) {
    refuse(std::string("cannot be read: ") + std::strerror(errno != 0 ? errno : EIO) +
           ". Name the file with the token of the robot's API");
  }
  text.resize(static_cast<std::size_t>(in.gcount()));
  for (const char end : {'\n', '\r'}) {
    if (text.ends_with(end)) {
      text.pop_back();
    }
  }
  if (text.empty() || text.size() > kLongestToken ||
      !std::ranges::all_of(text, [](char c) { return c > ' ' && c <= '~'; })) {
    refuse("must hold the token of the robot's API and nothing else: one line of visible ASCII characters");
  }
  StopKey key(text);
  OPENSSL_cleanse(text.data(), text.size());
  return key;
}

bool StopKey::sign(std::span<std::uint8_t> datagram) const noexcept {
  Code code{};
  if (datagram.size() < kMacBytes || !code_of(datagram.first(datagram.size() - kMacBytes), code)) {
    return false;
  }
  std::ranges::copy(Bytes(code).first(kMacBytes), datagram.last(kMacBytes).begin());
  return true;
}

bool StopKey::has_signed(Bytes datagram) const noexcept {
  Code code{};
  return datagram.size() >= kMacBytes && code_of(datagram.first(datagram.size() - kMacBytes), code) &&
         CRYPTO_memcmp(code.data(), datagram.last(kMacBytes).data(), kMacBytes) == 0;
}

bool StopKey::code_of(Bytes content, std::span<std::uint8_t, 32> code) const noexcept {
  std::size_t size = 0;
  return EVP_MAC_init(context_.get(), nullptr, 0, nullptr) == 1 &&
         EVP_MAC_update(context_.get(), content.data(), content.size()) == 1 &&
         EVP_MAC_final(context_.get(), code.data(), &size, code.size()) == 1 && size == code.size();
}

std::uint64_t random_identity() {
  std::uint64_t identity = 0;
  if (RAND_bytes(reinterpret_cast<unsigned char*>(&identity), sizeof identity) != 1) {
    throw StopKeyError("stop datagrams: the system gives no random numbers");
  }
  return identity;
}

}  // namespace gaitway::stopgram
