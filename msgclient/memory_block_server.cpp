// The server's side of set-up: requests in, descriptors out.
// "model: NAME.N" names a step of the models in tests/models.
#include "gaitway/msgclient/memory_block_server.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "block_protocol.hpp"
#include "topic_registry.hpp"

namespace gaitway::msgclient {
namespace {

constexpr int kClientsAStep = 16;
constexpr int kRequestsAStep = 32;  // of one client: bounds the time that one step takes

TopicDescriptor descriptor_of(const protocol::Request& request) {
  return {std::string(name_of(request.topic)),
          std::string(name_of(request.type_name)),
          request.type_hash,
          request.size,
          request.kind,
          request.capacity};
}

// An answer and the descriptors that go with it; keeps those open that were made for it.
struct Reply {
  protocol::Answer answer;
  std::array<int, protocol::kMaxFds> fds{};
  std::array<process::FileDescriptor, protocol::kMaxFds> made;

  void give(const Segment& segment, Access access) {
    const std::size_t index = answer.fd_count++;
    answer.segment_bytes.at(index) = segment.size();
    answer.access.at(index) = access;
    if (access == Access::read_only) {
      made.at(index) = segment.reopen_read_only();
    }
    fds.at(index) = access == Access::read_only ? made.at(index).get() : segment.fd();
  }
};

struct Asker {
  ClientId id = 0;
  bool sealed = false;
};

// Throws TopicError when the request is refused.
Reply reply_to(TopicRegistry& registry, Asker& asker, const protocol::Request& request) {
  if (request.magic != protocol::kMagic) {
    throw TopicError(
        "the client speaks another version of the memory block's protocol: build both from the same release");
  }
  if (asker.sealed) {
    throw TopicError(sealed_text(name_of(request.client), name_of(request.topic)));
  }
  Reply reply;
  if (request.verb == protocol::Verb::seal) {
    asker.sealed = true;
    return reply;
  }
  if (request.verb == protocol::Verb::hello) {
    // model: serve.1
    reply.give(registry.directory_segment(), Access::read_only);
    return reply;
  }
  if (request.verb != protocol::Verb::open || request.role > Role::writer) {
    throw TopicError("the client asks for something unknown: build both from the same release");
  }
  // model: serve.2
  const TopicGrant grant =
      registry.open(asker.id, std::string(name_of(request.client)), descriptor_of(request), request.role);
  const bool writer = request.role == Role::writer;
  reply.answer.capacity = grant.descriptor.capacity;
  reply.answer.slots = grant.geometry.slots;
  reply.answer.generation = grant.generation;
  try {
    reply.give(*grant.storage, writer ? Access::read_write : Access::read_only);
    if (grant.cursor) {
      reply.give(*grant.cursor, writer ? Access::read_only : Access::read_write);
    }
  } catch (...) {
    registry.release(asker.id, grant.descriptor.name, request.role);  // who gets nothing holds nothing
    throw;
  }
  return reply;
}

}  // namespace

struct MemoryBlockServer::Connection {
  process::FileDescriptor socket;
  Asker asker;
  pid_t process = 0;
  std::int64_t silent_until_ns = 0;  // 0: it has asked for something

  [[nodiscard]] bool has_left() const noexcept;
};

MemoryBlockServer::MemoryBlockServer(const MemoryBlock& block, std::filesystem::path socket)
    // model: start.1, start.2, start.3, start.4 in process::ListeningSocket: lock, unlink, bind, listen
    : registry_(block.registry()), listener_(std::move(socket), "message controller") {}

MemoryBlockServer::~MemoryBlockServer() {
  for (const Connection& connection : connections_) {
    registry_->release_all(connection.asker.id);
  }
}

std::size_t MemoryBlockServer::client_count() const noexcept {
  return connections_.size();
}

void MemoryBlockServer::step(std::int64_t now_ns) {
  // Old connections first: who died has given its claims back before a successor asks for them.
  for (auto connection = connections_.begin(); connection != connections_.end();) {
    const auto current = connection++;
    const bool lives = serve(*current);
    if (!lives || (current->silent_until_ns != 0 && now_ns >= current->silent_until_ns)) {
      drop(current);
    }
  }
  accept_clients(now_ns);
}

std::int64_t MemoryBlockServer::due_ns() const noexcept {
  std::int64_t due_ns = std::numeric_limits<std::int64_t>::max();
  for (const Connection& connection : connections_) {
    due_ns = connection.silent_until_ns == 0 ? due_ns : std::min(due_ns, connection.silent_until_ns);
  }
  return due_ns;
}

bool MemoryBlockServer::has_room_for(pid_t process) const noexcept {
  const auto of_process = std::ranges::count(connections_, process, &Connection::process);
  return connections_.size() < kMostClients && static_cast<std::size_t>(of_process) < kMostOfOneProcess;
}

void MemoryBlockServer::accept_clients(std::int64_t now_ns) {
  for (int i = 0; i < kClientsAStep; ++i) {
    // model: accept.1
    process::FileDescriptor socket = listener_.accept();
    if (!socket) {
      return;
    }
    ucred peer{};
    socklen_t size = sizeof peer;
    if (getsockopt(socket.get(), SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0 || !has_room_for(peer.pid)) {
      protocol::Answer refusal;
      refusal.refused = 1;
      const std::string who = peer.pid != 0 ? fmt::format("process {}", peer.pid)
                                            : "processes of other PID namespaces, which count as one";
      const std::string text = fmt::format(
          "{}: the memory block serves at most {} connections of a process and {} in all: close some first",
          who, kMostOfOneProcess, kMostClients);
      std::strncpy(refusal.error, text.c_str(), sizeof refusal.error - 1);
      static_cast<void>(protocol::send_answer(socket.get(), refusal, {}));
      continue;
    }
    listener_.watch(socket);
    connections_.push_back({.socket = std::move(socket),
                            .asker = {.id = registry_->new_client()},
                            .process = peer.pid,
                            .silent_until_ns = now_ns + kSilence_ns});
    if (!serve(connections_.back())) {
      drop(std::prev(connections_.end()));
    }
  }
}

void MemoryBlockServer::drop(std::list<Connection>::iterator connection) {
  // model: serve.4
  registry_->release_all(connection->asker.id);
  connections_.erase(connection);  // closing the socket also takes it out of the epoll set
}

bool MemoryBlockServer::Connection::has_left() const noexcept {
  pollfd end{socket.get(), POLLRDHUP, 0};
  return poll(&end, 1, 0) > 0;
}

void MemoryBlockServer::hear_departed() noexcept {
  for (const Connection& connection : connections_) {
    if (connection.has_left()) {
      // model: serve.7
      registry_->release_all(connection.asker.id);
    }
  }
}

void MemoryBlockServer::hear_holder(std::string_view topic, Role role) {
  const ClientId holder = registry_->holder(topic, role);
  const auto connection = std::ranges::find(connections_, holder, [](const auto& c) { return c.asker.id; });
  if (holder == 0 || connection == connections_.end()) {
    return;  // nobody, or a client in this process
  }
  if (connection->has_left()) {
    // model: serve.5
    registry_->release_all(holder);  // it is dropped in its turn
    return;
  }
  protocol::Request request;
  while (protocol::receive_release(connection->socket.get(), request)) {
    // model: serve.6
    registry_->release(holder, std::string(name_of(request.topic)), request.role);
  }
}

bool MemoryBlockServer::serve(Connection& connection) {
  for (int i = 0; i < kRequestsAStep; ++i) {
    protocol::Request request;
    switch (protocol::receive_request(connection.socket.get(), request)) {
      case protocol::Received::nothing:
        return true;
      case protocol::Received::packet:
        connection.silent_until_ns = 0;
        break;
      case protocol::Received::closed:
      case protocol::Received::malformed:
        return false;
    }
    if (request.magic == protocol::kMagic && request.verb == protocol::Verb::release) {
      // model: serve.3
      registry_->release(connection.asker.id, std::string(name_of(request.topic)), request.role);
      continue;
    }
    Reply reply;
    try {
      if (request.verb == protocol::Verb::hello) {
        hear_departed();
      } else if (request.verb == protocol::Verb::open) {
        hear_holder(name_of(request.topic), request.role);
      }
      reply = reply_to(*registry_, connection.asker, request);
    } catch (const std::exception& error) {
      reply = {};
      reply.answer.refused = 1;
      std::strncpy(reply.answer.error, error.what(), sizeof reply.answer.error - 1);
    }
    if (!protocol::send_answer(connection.socket.get(), reply.answer, reply.fds)) {
      return false;
    }
  }
  return true;
}

}  // namespace gaitway::msgclient
