// Opening of topics, and the client in another process than the memory block: asks the server, maps what it
// gives.
// "model: NAME.N" names a step of the models in tests/models.
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <mutex>

#include "block_protocol.hpp"
#include "directory.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::msgclient {
namespace {

constexpr std::string_view kSimulated = "bus.simulated";

// The connection; handles keep it alive, since the server takes its end for the end of all claims.
// model: watch.3
class Connection {
 public:
  Connection(const std::filesystem::path& path, std::string client_name, std::chrono::milliseconds timeout)
      : path_(path),
        client_name_(std::move(client_name)),
        timeout_(timeout),
        socket_(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)) {
    if (client_name_.empty() || client_name_.size() > kMaxNameLength) {
      throw TopicError(
          fmt::format("client '{}': a name has 1 to {} characters", client_name_, kMaxNameLength));
    }
    // model: attach.1
    const sockaddr_un address = process::socket_address(path);
    const timeval limit{timeout.count() / 1000, timeout.count() % 1000 * 1000};
    if (!socket_ || setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit) != 0 ||
        setsockopt(socket_.get(), SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit) != 0 ||
        connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      throw TopicError(
          fmt::format("client '{}': cannot connect to '{}': {}; is the message controller running?",
                      client_name_, path.native(), std::strerror(errno)));
    }
  }

  protocol::ReceivedAnswer ask(protocol::Request request) {
    const std::scoped_lock lock(mutex_);
    copy_name(client_name_, request.client);
    protocol::ReceivedAnswer received;
    // A server that has turned this client away says why, and hangs up.
    const bool sent = !broken_ && protocol::send_request(socket_.get(), request);
    if (broken_) {
      fail("the message controller is gone");
    }
    switch (protocol::receive_answer(socket_.get(), received)) {
      case protocol::Received::packet:
        break;
      case protocol::Received::nothing:
        broken_ = true;  // the answer may still come and would be taken for that of the next request
        fail(fmt::format("no answer within {} ms; is the message controller hanging?", timeout_.count()));
      case protocol::Received::closed:
        fail(sent ? "the message controller closed the connection" : "the message controller is gone");
      case protocol::Received::malformed:
        fail("the answer is malformed; is it another program's socket, or another release?");
    }
    if (received.answer.refused != 0) {
      received.answer.error[sizeof received.answer.error - 1] = '\0';
      throw TopicError(received.answer.error);
    }
    return received;
  }

  [[nodiscard]] int fd() const noexcept { return socket_.get(); }

  // No answer and no waiting: if it cannot be sent, the end of the connection releases the claim.
  void release(const std::string& topic, Role role) noexcept {
    protocol::Request request;
    request.verb = protocol::Verb::release;
    request.role = role;
    copy_name(topic, request.topic);
    const std::scoped_lock lock(mutex_);
    (void)protocol::send_request(socket_.get(), request);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw TopicError(fmt::format("client '{}' at '{}': {}", client_name_, path_.native(), what));
  }

  std::mutex mutex_;  // set-up calls only
  std::filesystem::path path_;
  std::string client_name_;
  std::chrono::milliseconds timeout_;
  process::FileDescriptor socket_;
  bool broken_ = false;
};

Segment take_segment(protocol::ReceivedAnswer& received, std::size_t index) {
  return Segment::map(std::move(received.fds.at(index)), received.answer.segment_bytes.at(index),
                      received.answer.access.at(index));
}

class RemoteSource final : public TopicSource {
 public:
  explicit RemoteSource(std::shared_ptr<Connection> connection)
      : connection_(std::move(connection)), directory_segment_(say_hello()), directory_(directory_segment_) {
    directory_.check();
  }

  TopicGrant open(const TopicDescriptor& descriptor, Role role) override {
    if (descriptor.name.size() > kMaxNameLength || descriptor.type_name.size() > kMaxNameLength) {
      throw TopicError(fmt::format("topic '{}' of type '{}': a name has 1 to {} characters", descriptor.name,
                                   descriptor.type_name, kMaxNameLength));
    }
    protocol::Request request;
    request.verb = protocol::Verb::open;
    copy_name(descriptor.name, request.topic);
    copy_name(descriptor.type_name, request.type_name);
    request.type_hash = descriptor.type_hash;
    request.size = descriptor.size;
    request.kind = descriptor.kind;
    request.capacity = descriptor.capacity;
    request.role = role;
    // model: attach.4
    protocol::ReceivedAnswer received = connection_->ask(request);

    TopicGrant grant;
    if (role == Role::writer || descriptor.kind == TopicKind::queue) {
      grant.claim = Claim(
          [connection = connection_, topic = descriptor.name, role] { connection->release(topic, role); });
    }
    grant.descriptor = descriptor;
    grant.descriptor.capacity = received.answer.capacity;
    grant.geometry = {descriptor.size, received.answer.slots};
    grant.generation = received.answer.generation;
    // model: attach.5
    grant.storage = std::make_shared<const Segment>(take_segment(received, 0));
    const std::size_t needed =
        descriptor.kind == TopicKind::window ? descriptor.size : grant.geometry.bytes();
    if (grant.geometry.slots < 1 || grant.storage->size() < needed) {
      throw TopicError(fmt::format("topic '{}': the server gave {} bytes, {} are needed", descriptor.name,
                                   grant.storage->size(), needed));
    }
    if (descriptor.kind == TopicKind::queue) {
      grant.cursor = std::make_shared<const Segment>(take_segment(received, 1));
    }
    return grant;
  }
  void seal() override {
    protocol::Request request;
    request.verb = protocol::Verb::seal;
    connection_->ask(request);
  }
  std::vector<TopicInfo> directory() const override { return directory_.rows(); }
  std::uint64_t generation() const noexcept override { return directory_.generation(); }
  // model: watch.2
  std::int64_t heartbeat_ns() const noexcept override { return directory_.heartbeat_ns(); }
  int hang_up_fd() const noexcept override { return connection_->fd(); }

 private:
  Segment say_hello() {
    // model: attach.2
    protocol::ReceivedAnswer received = connection_->ask({});
    // model: attach.3
    Segment segment = take_segment(received, 0);
    if (segment.size() < Directory::bytes()) {
      throw TopicError("the directory that the server gave is too small: build both from the same release");
    }
    return segment;
  }

  std::shared_ptr<Connection> connection_;
  Segment directory_segment_;
  Directory directory_;
};

}  // namespace

Client Client::connect(const std::filesystem::path& socket, const std::string& client_name,
                       std::chrono::milliseconds timeout) {
  return Client(std::make_shared<RemoteSource>(std::make_shared<Connection>(socket, client_name, timeout)),
                client_name);
}

bool Client::server_has_ended() const noexcept {
  // model: watch.1
  pollfd ended{hang_up_fd(), POLLRDHUP, 0};
  return poll(&ended, 1, 0) > 0 && (ended.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

UntypedWriter Client::write_untyped(const TopicDescriptor& descriptor) {
  return UntypedWriter(source_->open(descriptor, Role::writer));
}
UntypedReader Client::read_untyped(const TopicDescriptor& descriptor) {
  return UntypedReader(source_->open(descriptor, Role::reader));
}
UntypedStreamReader Client::read_stream_untyped(const TopicDescriptor& descriptor, bool from_oldest) {
  return UntypedStreamReader(source_->open(descriptor, Role::reader), from_oldest);
}
UntypedQueueWriter Client::write_queue_untyped(const TopicDescriptor& descriptor) {
  return UntypedQueueWriter(source_->open(descriptor, Role::writer));
}
UntypedQueueReader Client::read_queue_untyped(const TopicDescriptor& descriptor) {
  return UntypedQueueReader(source_->open(descriptor, Role::reader));
}

TopicGrant Client::open_window(std::string_view name, std::uint32_t bytes, Role role) {
  return source_->open({std::string(name), "window", 0, bytes, TopicKind::window, 0}, role);
}

std::optional<TopicInfo> Client::find(std::string_view topic) const {
  auto rows = source_->directory();
  const auto found =
      std::ranges::find_if(rows, [&](const TopicInfo& row) { return row.descriptor.name == topic; });
  return found == rows.end() ? std::nullopt : std::optional(std::move(*found));
}

TopicGrant mark_simulated(Client& message_controller) {
  return message_controller.open_window(kSimulated, sizeof(std::uint64_t), Role::writer);
}

bool is_marked_simulated(const Client& client) {
  const std::optional<TopicInfo> mark = client.find(kSimulated);
  return mark && mark->writer == "message_controller";
}

}  // namespace gaitway::msgclient
