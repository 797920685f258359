// What two processes of one program say to each other: JSON in packets, and descriptors along with it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::timeline {

// The other end is gone: its process has ended.
class ChannelEnded : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class CopyChannel {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{128} << 10U;  // of a packet
  static constexpr int kForEver = -1;

  struct Packet {
    nlohmann::json message;
    process::FileDescriptor passed;  // none: nothing came along
  };

  // Both ends. Throws std::system_error.
  static std::pair<CopyChannel, CopyChannel> pair();
  explicit CopyChannel(process::FileDescriptor socket) : socket_(std::move(socket)) {}

  // Waits until there is room. Throws ChannelEnded; std::length_error for what is larger than a packet.
  void send(const nlohmann::json& message, int passed = -1) const;
  // The same, without waiting. False: there is no room now.
  [[nodiscard]] bool try_send(const nlohmann::json& message) const;
  // Nothing: nothing has come within the time. Throws ChannelEnded.
  [[nodiscard]] std::optional<Packet> receive(int patience_ms) const;
  [[nodiscard]] int descriptor() const noexcept { return socket_.get(); }
  // The process's own descriptor of it, to be passed on.
  [[nodiscard]] process::FileDescriptor take() { return std::move(socket_); }

 private:
  [[nodiscard]] bool send_packet(const nlohmann::json& message, int passed, int flags) const;

  process::FileDescriptor socket_;
};

}  // namespace gaitway::timeline
