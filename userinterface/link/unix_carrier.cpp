// The link over a Unix socket, with the smallest buffer that the kernel gives.
#include "gaitway/link/unix_carrier.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "gaitway/process/listening_socket.hpp"

namespace gaitway::link {

UnixCarrier::UnixCarrier(const std::filesystem::path& path)
    : socket_(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const sockaddr_un address = process::socket_address(path);
  if (!socket_ || connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw process::SocketError("link '" + path.native() + "': cannot connect: " + std::strerror(errno) +
                               ". Is main_controller running, with a link at this path?");
  }
  keep_short();
}

UnixCarrier::UnixCarrier(process::FileDescriptor connection) : socket_(std::move(connection)) {
  keep_short();
}

void UnixCarrier::keep_short() const noexcept {
  // The kernel raises it to its own least, room for a few frames. Where it refuses, the window of the state
  // bounds what is under way.
  const int bytes = 1;
  static_cast<void>(setsockopt(socket_.get(), SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes));
}

std::size_t UnixCarrier::write(Bytes bytes) noexcept {
  const ssize_t sent = send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR && errno != ENOBUFS) {
    connected_ = false;
  }
  return sent > 0 ? static_cast<std::size_t>(sent) : 0;
}

std::size_t UnixCarrier::read(std::span<std::uint8_t> room) noexcept {
  const ssize_t count = recv(socket_.get(), room.data(), room.size(), MSG_DONTWAIT);
  if (count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) {
    connected_ = false;
  }
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace gaitway::link
