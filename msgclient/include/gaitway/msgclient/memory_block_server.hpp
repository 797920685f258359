// Gives the memory block to other processes, over a Unix socket. Passive: step() serves what has come and
// returns.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <string_view>

#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::msgclient {

// A client gets descriptors of shared memory: writable for what it writes, read-only for the rest. Its claims
// end with its connection, so that a process that was killed can be started again. Clients speak to the
// server during set-up only. One process may have kMostOfOneProcess connections, all together kMostClients,
// and who connects must ask for something within kSilence_ns: further ones are turned away. Processes that
// the kernel cannot name here, since they live in another PID namespace, count as one.
class MemoryBlockServer {
 public:
  // Listens on `socket`; a stale socket file is replaced. Only this user can connect. Throws
  // process::SocketError if another server answers there or the path is unusable.
  MemoryBlockServer(const MemoryBlock& block, std::filesystem::path socket);
  ~MemoryBlockServer();
  MemoryBlockServer(const MemoryBlockServer&) = delete;
  MemoryBlockServer& operator=(const MemoryBlockServer&) = delete;

  static constexpr std::size_t kMostOfOneProcess = 32;
  static constexpr std::size_t kMostClients = 256;
  static constexpr std::int64_t kSilence_ns = 2'000'000'000;

  // Takes new clients in, answers requests, releases the claims of clients that went. Never blocks; makes
  // system calls (one when nothing has come, and one a client) and allocates only when somebody asks for a
  // topic. `now_ns`: of any clock that doesn't go back.
  void step(std::int64_t now_ns);
  // When step() must be called even if nothing has come: a client that has asked for nothing is to be
  // dropped. Never, as the largest number.
  [[nodiscard]] std::int64_t due_ns() const noexcept;

  [[nodiscard]] std::size_t client_count() const noexcept;
  // For those that want to sleep until something comes: readable when step() has something to do (an epoll
  // descriptor).
  [[nodiscard]] int wake_fd() const noexcept { return listener_.wake_fd(); }

 private:
  struct Connection;

  void accept_clients(std::int64_t now_ns);
  [[nodiscard]] bool has_room_for(pid_t process) const noexcept;
  // False: the client is gone or broke the protocol.
  bool serve(Connection& connection);
  // The claims of all that have left are void, though their turn to be dropped comes later: whoever connects
  // after that sees none of them in the directory.
  void hear_departed() noexcept;
  // Nobody is refused for a claim whose holder has left or given it back meanwhile: it may be served later.
  void hear_holder(std::string_view topic, Role role);
  void drop(std::list<Connection>::iterator connection);

  std::shared_ptr<TopicRegistry> registry_;
  process::ListeningSocket listener_;
  std::list<Connection> connections_;
};

}  // namespace gaitway::msgclient
