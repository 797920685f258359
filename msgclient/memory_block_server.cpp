// The server's side of set-up: requests in, descriptors out.
#include "gaitway/msgclient/memory_block_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "block_protocol.hpp"
#include "topic_registry.hpp"

namespace gaitway::msgclient {
namespace {

constexpr int kBacklog = 16;
constexpr int kRequestsAStep = 32;  // of one client: bounds the time that one step takes

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw TopicError(fmt::format("socket '{}': {}: {}", path.native(), what, std::strerror(errno)));
}

// The lock file tells a living server from a stale socket without a race: the kernel drops the lock with the
// process.
FileDescriptor lock_beside(const std::filesystem::path& path) {
  const std::string lock_path = path.native() + ".lock";
  FileDescriptor lock(open(lock_path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600));
  if (!lock) {
    fail(path, fmt::format("cannot make '{}'", lock_path));
  }
  if (flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    throw TopicError(fmt::format(
        "socket '{}': another message controller serves it; end that one first, or choose another path",
        path.native()));
  }
  return lock;
}

FileDescriptor listen_on(const std::filesystem::path& path) {
  const sockaddr_un address = protocol::address_of(path);
  FileDescriptor listener(socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!listener) {
    fail(path, "cannot make a socket");
  }
  if (struct stat status{}; lstat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode)) {
    unlink(path.c_str());  // we hold the lock: nobody serves it
  }
  if (bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    fail(path, "cannot bind");
  }
  if (chmod(path.c_str(), 0600) != 0 || listen(listener.get(), kBacklog) != 0) {
    fail(path, "cannot listen");
  }
  return listener;
}

void watch(int epoll, int fd) {
  epoll_event event{};
  event.events = EPOLLIN | EPOLLRDHUP;
  event.data.fd = fd;
  if (epoll_ctl(epoll, EPOLL_CTL_ADD, fd, &event) != 0) {
    throw TopicError(fmt::format("memory block server: epoll_ctl: {}", std::strerror(errno)));
  }
}

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
  std::array<FileDescriptor, protocol::kMaxFds> made;

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

// Throws TopicError when the request is refused.
Reply reply_to(TopicRegistry& registry, ClientId client, const protocol::Request& request) {
  if (request.magic != protocol::kMagic) {
    throw TopicError(
        "the client speaks another version of the memory block's protocol: build both from the same release");
  }
  Reply reply;
  if (request.verb == protocol::Verb::hello) {
    reply.give(registry.directory_segment(), Access::read_only);
    return reply;
  }
  if (request.verb != protocol::Verb::open || request.role > Role::writer) {
    throw TopicError("the client asks for something unknown: build both from the same release");
  }
  const TopicGrant grant =
      registry.open(client, std::string(name_of(request.client)), descriptor_of(request), request.role);
  const bool writer = request.role == Role::writer;
  reply.answer.capacity = grant.descriptor.capacity;
  reply.answer.slots = grant.geometry.slots;
  reply.answer.generation = grant.generation;
  reply.give(*grant.storage, writer ? Access::read_write : Access::read_only);
  if (grant.cursor) {
    reply.give(*grant.cursor, writer ? Access::read_only : Access::read_write);
  }
  return reply;
}

}  // namespace

struct MemoryBlockServer::Connection {
  FileDescriptor socket;
  ClientId id = 0;
};

MemoryBlockServer::MemoryBlockServer(const MemoryBlock& block, std::filesystem::path socket)
    : registry_(block.registry()),
      path_(std::move(socket)),
      lock_(lock_beside(path_)),
      listener_(listen_on(path_)),
      epoll_(epoll_create1(EPOLL_CLOEXEC)) {
  if (!epoll_) {
    fail(path_, "cannot make an epoll descriptor");
  }
  watch(epoll_.get(), listener_.get());
}

MemoryBlockServer::~MemoryBlockServer() {
  for (const Connection& connection : connections_) {
    registry_->release_all(connection.id);
  }
  unlink(path_.c_str());
}

std::size_t MemoryBlockServer::client_count() const noexcept {
  return connections_.size();
}

void MemoryBlockServer::step() {
  // Old connections first: who died has given its claims back before a successor asks for them.
  for (auto connection = connections_.begin(); connection != connections_.end();) {
    const auto current = connection++;
    if (!serve(*current)) {
      drop(current);
    }
  }
  accept_clients();
}

void MemoryBlockServer::accept_clients() {
  for (int i = 0; i < kBacklog; ++i) {
    FileDescriptor socket(accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!socket) {
      return;
    }
    watch(epoll_.get(), socket.get());
    connections_.push_back({std::move(socket), registry_->new_client()});
    if (!serve(connections_.back())) {
      drop(std::prev(connections_.end()));
    }
  }
}

void MemoryBlockServer::drop(std::list<Connection>::iterator connection) {
  registry_->release_all(connection->id);
  connections_.erase(connection);  // closing the socket also takes it out of the epoll set
}

bool MemoryBlockServer::serve(Connection& connection) {
  for (int i = 0; i < kRequestsAStep; ++i) {
    protocol::Request request;
    switch (protocol::receive_request(connection.socket.get(), request)) {
      case protocol::Received::nothing:
        return true;
      case protocol::Received::packet:
        break;
      case protocol::Received::closed:
      case protocol::Received::malformed:
        return false;
    }
    if (request.magic == protocol::kMagic && request.verb == protocol::Verb::release) {
      registry_->release(connection.id, std::string(name_of(request.topic)), request.role);
      continue;
    }
    Reply reply;
    try {
      reply = reply_to(*registry_, connection.id, request);
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
