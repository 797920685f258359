// A Unix packet socket at a path, where one process of a robot waits for the others.
#pragma once

#include <sys/un.h>

#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::process {

// The text names the path, what was tried, why it failed and what to do.
class SocketError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws SocketError when the path is empty or too long for a Unix socket.
sockaddr_un socket_address(const std::filesystem::path& path);

// Listens until it is destroyed. At most one process listens at a path: a lock file beside the socket tells a
// living one from what a dead one left, without a race, since the kernel drops the lock with the process.
class ListeningSocket {
 public:
  // `owner` names the server in messages ("bus"). Throws SocketError.
  ListeningSocket(std::filesystem::path path, std::string_view owner);
  ~ListeningSocket();
  ListeningSocket(const ListeningSocket&) = delete;
  ListeningSocket& operator=(const ListeningSocket&) = delete;

  // The next client that waits, or an empty descriptor; does not block, nor will the connection. When the
  // process has no descriptor left, clients are turned away: one that went on waiting would keep wake_fd()
  // readable for ever.
  [[nodiscard]] FileDescriptor accept() noexcept;
  // Has wake_fd() tell of this connection, too, until it is closed. Throws SocketError.
  void watch(const FileDescriptor& connection) const;
  // Readable when a client waits, or a watched connection has data or has ended.
  [[nodiscard]] int wake_fd() const noexcept { return epoll_.get(); }
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  [[nodiscard]] FileDescriptor take_spare() const noexcept;
  void lock(std::string_view owner);
  void listen();
  [[noreturn]] void fail(std::string_view what) const;

  std::filesystem::path path_;
  FileDescriptor lock_, listener_, epoll_;
  FileDescriptor spare_;  // given up for a client that is to be turned away
};

}  // namespace gaitway::process
