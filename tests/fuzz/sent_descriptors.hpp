// Descriptors that a peer sends along with a packet, as many as it likes.
#pragma once

#include <sys/socket.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <span>

#include "fuzz_input.hpp"

namespace gaitway::fuzz {

inline constexpr std::size_t kMostDescriptors = 3;

// `descriptors` go along; sends whatever `bytes` are.
inline void send_with_descriptors(int socket, std::span<const std::byte> bytes,
                                  std::span<const int> descriptors) {
  iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
  alignas(cmsghdr) char room[CMSG_SPACE(kMostDescriptors * sizeof(int))]{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (!descriptors.empty()) {
    message.msg_control = room;
    message.msg_controllen = CMSG_SPACE(descriptors.size_bytes());
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(descriptors.size_bytes());
    std::memcpy(CMSG_DATA(header), descriptors.data(), descriptors.size_bytes());
  }
  require(sendmsg(socket, &message, MSG_NOSIGNAL) >= 0, "the packet can be sent");
}

// How many descriptors this process has open.
inline std::ptrdiff_t open_descriptors() {
  using Entries = std::filesystem::directory_iterator;
  return std::distance(Entries("/proc/self/fd"), Entries());
}

}  // namespace gaitway::fuzz
