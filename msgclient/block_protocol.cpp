// Packets and descriptors on a SOCK_SEQPACKET socket.
#include "block_protocol.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <type_traits>
#include <utility>

namespace gaitway::msgclient::protocol {
namespace {

static_assert(std::is_trivially_copyable_v<Request> && std::is_trivially_copyable_v<Answer>);

// Room for the control message that carries the descriptors, aligned as the kernel wants it.
union ControlRoom {
  cmsghdr header;
  char bytes[CMSG_SPACE(kMaxFds * sizeof(int))];
};

Received outcome(ssize_t received, std::size_t expected) noexcept {
  if (received == static_cast<ssize_t>(expected)) {
    return Received::packet;
  }
  if (received < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
    return Received::nothing;
  }
  return received <= 0 ? Received::closed : Received::malformed;
}

}  // namespace

bool send_request(int socket, const Request& request) noexcept {
  return send(socket, &request, sizeof request, MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(sizeof request);
}

bool send_answer(int socket, const Answer& answer, const std::array<int, kMaxFds>& fds) noexcept {
  Answer copy = answer;
  iovec part{&copy, sizeof copy};
  ControlRoom control{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (answer.fd_count > 0) {
    message.msg_control = control.bytes;
    message.msg_controllen = CMSG_SPACE(answer.fd_count * sizeof(int));
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(answer.fd_count * sizeof(int));
    std::memcpy(CMSG_DATA(header), fds.data(), answer.fd_count * sizeof(int));
  }
  return sendmsg(socket, &message, MSG_NOSIGNAL | MSG_DONTWAIT) == static_cast<ssize_t>(sizeof copy);
}

Received receive_request(int socket, Request& request) noexcept {
  // No room for descriptors is given, so the kernel drops any that a client might send.
  return outcome(recv(socket, &request, sizeof request, MSG_DONTWAIT | MSG_TRUNC), sizeof request);
}

bool receive_release(int socket, Request& request) noexcept {
  const ssize_t lies_there = recv(socket, &request, sizeof request, MSG_PEEK | MSG_DONTWAIT | MSG_TRUNC);
  return outcome(lies_there, sizeof request) == Received::packet && request.magic == kMagic &&
         request.verb == Verb::release && receive_request(socket, request) == Received::packet;
}

Received receive_answer(int socket, ReceivedAnswer& received) noexcept {
  iovec part{&received.answer, sizeof received.answer};
  ControlRoom control{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.bytes;
  message.msg_controllen = sizeof control.bytes;
  ssize_t bytes = 0;
  bool reset = false;
  do {
    bytes = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
    // A server that hangs up without having read all resets the connection, and what it has said before is
    // there once that has been told.
  } while (bytes < 0 && (errno == EINTR || (errno == ECONNRESET && !std::exchange(reset, true))));
  std::size_t count = 0;
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS) {
      const std::size_t here = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
      for (std::size_t i = 0; i < here && count < kMaxFds; ++i) {
        int fd = -1;
        std::memcpy(&fd, CMSG_DATA(header) + i * sizeof(int), sizeof(int));
        received.fds[count++] = process::FileDescriptor(fd);
      }
    }
  }
  const Received result = outcome(bytes, sizeof received.answer);
  if (result != Received::packet) {
    return result;
  }
  // Cut off: the packet was longer than an answer, or more descriptors came than one has.
  const bool cut = (message.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0;
  return !cut && received.answer.magic == kMagic && received.answer.fd_count == count ? Received::packet
                                                                                      : Received::malformed;
}

}  // namespace gaitway::msgclient::protocol
