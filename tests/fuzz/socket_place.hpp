// A folder of this process's own for the sockets of servers under test, and bare clients of such sockets.
#pragma once

#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>

#include "gaitway/process/listening_socket.hpp"

namespace gaitway::fuzz {

class SocketPlace {
 public:
  SocketPlace() : folder_(make()) {}
  ~SocketPlace() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  SocketPlace(const SocketPlace&) = delete;
  SocketPlace& operator=(const SocketPlace&) = delete;
  [[nodiscard]] std::filesystem::path path() const { return folder_ / "socket"; }

 private:
  static std::filesystem::path make() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error(name + ": the folder cannot be made");
    }
    return name;
  }
  std::filesystem::path folder_;
};

// A peer that sends what it likes. Nothing it does waits.
class BareClient {
 public:
  explicit BareClient(const std::filesystem::path& path)
      : socket_(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    const sockaddr_un address = process::socket_address(path);
    if (!socket_ ||
        connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error(path.string() + ": nobody listens there");
    }
  }
  void send(std::span<const std::byte> packet) const {
    // A full socket or a server that has hung up: the packet is lost, as it would be.
    (void)::send(socket_.get(), packet.data(), packet.size(), MSG_NOSIGNAL);
  }
  // Reads everything that has come.
  void drain() const {
    std::array<std::byte, 4096> packet;
    while (recv(socket_.get(), packet.data(), packet.size(), 0) > 0) {
    }
  }
  [[nodiscard]] int fd() const { return socket_.get(); }

 private:
  process::FileDescriptor socket_;
};

}  // namespace gaitway::fuzz
