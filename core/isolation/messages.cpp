// Plain bytes of one machine: both ends are built from one tree.
#include "messages.hpp"

#include <sys/socket.h>

#include <cerrno>

namespace gaitway::core {
namespace {

constexpr std::size_t kLargestPacket = std::size_t{128} * 1024;

}  // namespace

PacketWriter& PacketWriter::text(std::string_view text) {
  number(static_cast<std::uint32_t>(text.size()));
  const auto* const begin = reinterpret_cast<const std::byte*>(text.data());
  bytes_.insert(bytes_.end(), begin, begin + text.size());
  return *this;
}

PacketWriter& PacketWriter::text(const char* text) {
  return this->text(std::string_view(text == nullptr ? "" : text));
}

PacketWriter& PacketWriter::value(const gaitway_value& value) {
  return number(value.kind).number(value.number).number(value.integer).text(value.text);
}

const std::byte* PacketReader::take(std::size_t size) {
  if (size > bytes_.size()) {
    throw PluginError("its process sent a message that ends too early");
  }
  const std::byte* const begin = bytes_.data();
  bytes_ = bytes_.subspan(size);
  return begin;
}

std::string PacketReader::text() {
  const auto size = number<std::uint32_t>();
  return {reinterpret_cast<const char*>(take(size)), size};
}

gaitway_value PacketReader::value(std::string& keep) {
  gaitway_value value{};
  value.kind = number<gaitway_kind>();
  value.number = number<double>();
  value.integer = number<std::int64_t>();
  keep = text();
  value.text = value.kind == GAITWAY_TEXT ? keep.c_str() : nullptr;
  return value;
}

Sent send_packet(const process::FileDescriptor& socket, std::span<const std::byte> bytes, Wait wait,
                 int descriptor) noexcept {
  iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
  alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))]{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = room;
    message.msg_controllen = sizeof room;
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof descriptor);
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
  }
  ssize_t sent = 0;
  do {
    sent = sendmsg(socket.get(), &message, MSG_NOSIGNAL | (wait == Wait::yes ? 0 : MSG_DONTWAIT));
  } while (sent < 0 && errno == EINTR);
  if (sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
    return Sent::full;
  }
  return sent == static_cast<ssize_t>(bytes.size()) ? Sent::whole : Sent::failed;
}

Receipt receive_packet(const process::FileDescriptor& socket, std::vector<std::byte>& bytes, Wait wait,
                       process::FileDescriptor* descriptor) {
  bytes.resize(kLargestPacket);
  iovec part{bytes.data(), bytes.size()};
  alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))]{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room;
  message.msg_controllen = sizeof room;
  ssize_t got = 0;
  do {
    got = recvmsg(socket.get(), &message, MSG_CMSG_CLOEXEC | (wait == Wait::yes ? 0 : MSG_DONTWAIT));
  } while (got < 0 && errno == EINTR);
  if (got <= 0) {
    return got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) ? Receipt::nothing : Receipt::closed;
  }
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr; header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS) {
      // The control message's padding has room for a second one: whatever comes is taken, so that it is
      // closed.
      const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
      for (std::size_t i = 0; i < count; ++i) {
        int number = -1;
        std::memcpy(&number, CMSG_DATA(header) + i * sizeof number, sizeof number);
        process::FileDescriptor received(number);
        if (i == 0 && descriptor != nullptr) {
          *descriptor = std::move(received);
        }
      }
    }
  }
  if ((message.msg_flags & MSG_TRUNC) != 0) {
    throw PluginError("its process sent a message that is too long");
  }
  bytes.resize(static_cast<std::size_t>(got));
  return Receipt::packet;
}

}  // namespace gaitway::core
