// The secret that desk and clients share, and the code that it puts behind each datagram.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

#include "gaitway/stopgram/datagrams.hpp"

struct evp_mac_ctx_st;

namespace gaitway::stopgram {

// The text names the file, the rule and the remedy.
class StopKeyError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Belongs to one thread. HMAC-SHA256, of which a datagram carries the first 16 bytes.
class StopKey {
 public:
  // Of the robot API's token; empty where the robot has none, which is no secret. Throws StopKeyError when
  // the cryptography library gives no HMAC-SHA256.
  explicit StopKey(std::string_view token = {});
  // The token's file: one line; its end is no part of it. Throws StopKeyError.
  static StopKey read(const std::filesystem::path& token_file);

  // Puts the code into the last kMacBytes of `datagram`. False: out of memory; it must not be sent.
  [[nodiscard]] bool sign(std::span<std::uint8_t> datagram) const noexcept;
  // Takes the same time wherever the code is wrong.
  [[nodiscard]] bool has_signed(Bytes datagram) const noexcept;

 private:
  struct Free {
    void operator()(evp_mac_ctx_st* context) const noexcept;
  };
  [[nodiscard]] bool code_of(Bytes content, std::span<std::uint8_t, 32> code) const noexcept;

  std::unique_ptr<evp_mac_ctx_st, Free> context_;  // holds the key
};

// Random: of a client, or of a run of the desk. Throws StopKeyError when the system gives no random numbers.
std::uint64_t random_identity();

// `message` with its code, into `room`; returns the datagram, empty when it cannot be made.
template <class Message>
Bytes signed_datagram(const StopKey& key, const Message& message, std::span<std::uint8_t> room) noexcept {
  const std::size_t size = encode(message, room);
  if (size == 0 || room.size() - size < kMacBytes) {
    return {};
  }
  const std::span<std::uint8_t> datagram = room.first(size + kMacBytes);
  return key.sign(datagram) ? Bytes(datagram) : Bytes{};
}

}  // namespace gaitway::stopgram
