// Packets over a pair of sockets.
#include "gaitway/timeline/copy_channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

namespace gaitway::timeline {
namespace {

constexpr int kBuffer_bytes = 1 << 20;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

std::pair<CopyChannel, CopyChannel> CopyChannel::pair() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    fail("no sockets for a copy of the simulation");
  }
  for (const int end : ends) {
    setsockopt(end, SOL_SOCKET, SO_SNDBUF, &kBuffer_bytes, sizeof kBuffer_bytes);
  }
  return {CopyChannel(process::FileDescriptor(ends[0])), CopyChannel(process::FileDescriptor(ends[1]))};
}

void CopyChannel::send(const nlohmann::json& message, int passed) const {
  static_cast<void>(send_packet(message, passed, 0));
}

bool CopyChannel::try_send(const nlohmann::json& message) const {
  return send_packet(message, -1, MSG_DONTWAIT);
}

bool CopyChannel::send_packet(const nlohmann::json& message, int passed, int flags) const {
  std::string text = message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > kMostBytes) {
    throw std::length_error("a message of " + std::to_string(text.size()) +
                            " bytes between copies of the simulation");
  }
  iovec piece{text.data(), text.size()};
  msghdr header{};
  header.msg_iov = &piece;
  header.msg_iovlen = 1;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  if (passed >= 0) {
    header.msg_control = control.data();
    header.msg_controllen = control.size();
    cmsghdr* const part = CMSG_FIRSTHDR(&header);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(part), &passed, sizeof passed);
  }
  while (sendmsg(socket_.get(), &header, MSG_NOSIGNAL | flags) < 0) {
    if (errno == EAGAIN || errno == EWOULDBLOCK) return false;
    if (errno == EPIPE || errno == ECONNRESET)
      throw ChannelEnded("the other process of the simulation has ended");
    if (errno != EINTR) fail("cannot speak to a copy of the simulation");
  }
  return true;
}

std::optional<CopyChannel::Packet> CopyChannel::receive(int patience_ms) const {
  pollfd wake{socket_.get(), POLLIN, 0};
  if (patience_ms != 0 && poll(&wake, 1, patience_ms) <= 0) return std::nullopt;
  thread_local std::vector<char> bytes(kMostBytes);
  iovec piece{bytes.data(), bytes.size()};
  msghdr header{};
  header.msg_iov = &piece;
  header.msg_iovlen = 1;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  header.msg_control = control.data();
  header.msg_controllen = control.size();
  const ssize_t size = recvmsg(socket_.get(), &header, MSG_CMSG_CLOEXEC | MSG_DONTWAIT);
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return std::nullopt;
  if (size <= 0) throw ChannelEnded("the other process of the simulation has ended");
  Packet packet;
  packet.message = nlohmann::json::parse(bytes.data(), bytes.data() + size);
  const cmsghdr* const part = CMSG_FIRSTHDR(&header);
  if (part != nullptr && part->cmsg_type == SCM_RIGHTS) {
    int passed = -1;
    std::memcpy(&passed, CMSG_DATA(part), sizeof passed);
    packet.passed = process::FileDescriptor(passed);
  }
  return packet;
}

}  // namespace gaitway::timeline
