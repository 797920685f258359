// What clients and server say to each other: one packet a request, one packet an answer, memory as
// SCM_RIGHTS.
#pragma once

#include <array>

#include "directory.hpp"
#include "gaitway/msgclient/segment.hpp"

namespace gaitway::msgclient::protocol {

inline constexpr std::uint32_t kMagic = 0x4d425731;  // "1WBM": changes with the packets' layout
inline constexpr std::size_t kMaxFds = 2;

enum class Verb : std::uint32_t {
  hello = 1,    // answered with the directory
  open = 2,     // answered with the topic's storage, and a queue's cursor
  release = 3,  // a claim is given back; not answered
  seal = 4,     // from now on this connection asks for nothing more
};

struct Request {
  std::uint32_t magic = kMagic;
  Verb verb = Verb::hello;
  char client[kMaxNameLength + 1] = {};
  char topic[kMaxNameLength + 1] = {};
  char type_name[kMaxNameLength + 1] = {};
  std::uint64_t type_hash = 0;
  std::uint32_t size = 0;
  TopicKind kind = TopicKind::latest;
  std::uint32_t capacity = 0;
  Role role = Role::reader;
};

struct Answer {
  std::uint32_t magic = kMagic;
  std::uint32_t refused = 0;  // 1: error says why
  std::uint32_t capacity = 0;
  std::uint32_t slots = 0;
  std::uint32_t generation = 0;
  std::uint32_t fd_count = 0;
  std::array<std::uint64_t, kMaxFds> segment_bytes{};
  std::array<Access, kMaxFds> access{};
  char error[768] = {};
};

struct ReceivedAnswer {
  Answer answer;
  std::array<process::FileDescriptor, kMaxFds> fds;
};

// One packet, never waiting and without SIGPIPE. False: not sent.
bool send_request(int socket, const Request& request) noexcept;
bool send_answer(int socket, const Answer& answer, const std::array<int, kMaxFds>& fds) noexcept;

enum class Received : std::uint8_t { packet, nothing, closed, malformed };
Received receive_request(int socket, Request& request) noexcept;
// Takes the next packet if it gives a claim back, and leaves any other where it lies.
bool receive_release(int socket, Request& request) noexcept;
// Waits as long as the socket's receive time-out.
Received receive_answer(int socket, ReceivedAnswer& received) noexcept;

}  // namespace gaitway::msgclient::protocol
