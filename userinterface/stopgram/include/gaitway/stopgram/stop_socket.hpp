// The UDP socket of stop datagrams, at the robot and at a client.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/stopgram/datagrams.hpp"
#include "gaitway/stopgram/refusal_tally.hpp"

namespace gaitway::stopgram {

// The text names address, port and remedy.
class StopSocketError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Asks the system for the host's address, the IPv4 one first; may take seconds for a name, not for a numeric
// address. Throws StopSocketError.
Peer find_peer(const std::string& host, std::uint16_t port);

// Does not block. Takes datagrams from everybody, so an answer may come from another of the robot's
// addresses.
class StopSocket {
 public:
  // The desk's. `address`: numeric, or localhost for 127.0.0.1; port 0: any that is free. Throws
  // StopSocketError.
  StopSocket(const std::string& address, std::uint16_t port);
  // A client's, that can send to `peer`. Throws StopSocketError.
  explicit StopSocket(const Peer& peer);

  struct Received {
    Bytes datagram;  // valid until the next one; a longer one than any of ours is cut off
    Peer from;
  };
  // The next datagram that waits.
  std::optional<Received> receive() noexcept;
  // False: the system does not take it now, as if it were lost.
  bool send(Bytes datagram, const Peer& to) noexcept;

  // Readable when a datagram waits.
  [[nodiscard]] int wake_fd() const noexcept { return socket_.get(); }
  [[nodiscard]] std::uint16_t port() const;

 private:
  process::FileDescriptor socket_;
  bool ipv6_ = false;
  std::array<std::uint8_t, kMostDatagramBytes + 1> room_{};
};

}  // namespace gaitway::stopgram
