// Requests for topics as the memory block's server reads them, through a real socket (msgclient/
// block_protocol.hpp, topic_registry.hpp). Whatever clients ask for: each request of the right size is
// answered once (a release not at all), with the memory or with a text; never more memory is given than the
// block has; and when all clients have gone, every topic can be written and read by others.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <list>
#include <span>
#include <string>

#include "fuzz_input.hpp"
#include "gaitway/msgclient/memory_block_server.hpp"
#include "msgclient/block_protocol.hpp"
#include "socket_place.hpp"

namespace gaitway::fuzz {
namespace {

using namespace msgclient;
using protocol::Received;
using protocol::Request;

constexpr std::size_t kMostClients = 4;

void name(Input& input, char (&text)[kMaxNameLength + 1]) {
  constexpr std::array<std::string_view, 4> kKnown{"walk", "zmp", "a.very.long/name_", "emi.host_to_message"};
  const std::size_t which = input.choose(kKnown.size() + 2);
  if (which < kKnown.size()) {
    copy_name(kKnown[which], text);
    return;
  }
  const auto bytes = input.take_bytes(which == kKnown.size() ? 4 : sizeof text);  // without its zero, too
  std::copy(bytes.begin(), bytes.end(), text);
}

Request take_request(Input& input) {
  Request request;
  const auto oddity = input.choose(8);
  request.magic = oddity == 0 ? input.take<std::uint32_t>() : protocol::kMagic;
  request.verb = static_cast<protocol::Verb>(oddity == 1 ? input.take<std::uint32_t>() : 1 + input.choose(3));
  name(input, request.client);
  name(input, request.topic);
  copy_name("Type", request.type_name);
  if (oddity == 2) {
    name(input, request.type_name);
  }
  request.type_hash = input.choose(2);
  request.size = oddity == 3 ? input.take<std::uint32_t>() : 1U << input.choose(20);
  request.kind = static_cast<TopicKind>(oddity == 4 ? input.take<std::uint32_t>() : input.choose(4));
  request.capacity = oddity == 5 ? input.take<std::uint32_t>() : static_cast<std::uint32_t>(input.choose(20));
  request.role = static_cast<Role>(oddity == 6 ? input.take<std::uint32_t>() : input.choose(2));
  return request;
}

bool ends_in_time(const protocol::Answer& answer) {
  return std::find(std::begin(answer.error), std::end(answer.error), '\0') != std::end(answer.error);
}

class Server {
 public:
  explicit Server(const std::filesystem::path& path) : path_(path), server_(block_, path) {}

  void connect() {
    if (clients_.size() < kMostClients) {
      clients_.emplace_back(path_);
      server_.step(0);  // else those that wait for it fill its backlog
    }
  }
  void disconnect(std::size_t client) {
    if (!clients_.empty()) {
      clients_.erase(std::next(clients_.begin(), static_cast<std::ptrdiff_t>(client % clients_.size())));
    }
  }
  void send_and_forget(std::size_t client, std::span<const std::byte> packet) {
    if (!clients_.empty()) {
      send(client, packet);
      at(client).drain();  // an answer, if the bytes were a request
    }
  }
  void ask(std::size_t client, const Request& request) {
    if (clients_.empty()) {
      return;
    }
    send(client, std::as_bytes(std::span(&request, 1)));
    const bool answered = request.magic != protocol::kMagic || request.verb != protocol::Verb::release;
    protocol::ReceivedAnswer received;
    const Received status = protocol::receive_answer(at(client).fd(), received);
    require(status == Received::closed || (status == Received::packet) == answered,
            "a request is answered once, a release not at all");
    if (status == Received::packet) {
      check(request, received);
    }
    require(block_.used_bytes() <= block_.size_bytes(), "no more memory is given than there is");
  }

  void check_that_claims_end() {
    clients_.clear();
    server_.step(0);
    require(server_.client_count() == 0, "who has gone is no client any more");
    Client successor = block_.local_client("successor");
    for (const TopicInfo& topic : successor.directory()) {
      require(topic.writer.empty() && topic.reader.empty(), "claims end with their client");
      require(!topic.descriptor.name.empty() && topic.descriptor.name.size() <= kMaxNameLength,
              "topics have names");
    }
  }

 private:
  void send(std::size_t client, std::span<const std::byte> packet) {
    at(client).send(packet);
    server_.step(0);
  }
  BareClient& at(std::size_t client) {
    return *std::next(clients_.begin(), static_cast<std::ptrdiff_t>(client % clients_.size()));
  }
  void check(const Request& request, protocol::ReceivedAnswer& received) const {
    const protocol::Answer& answer = received.answer;
    require(ends_in_time(answer), "the text of a refusal ends");
    if (answer.refused != 0) {
      require(answer.error[0] != '\0' && answer.fd_count == 0, "who is refused gets a text, and no memory");
      return;
    }
    if (request.verb == protocol::Verb::seal) {
      require(answer.fd_count == 0, "who gives up the right to open topics gets no memory for it");
      return;
    }
    require(answer.fd_count >= 1, "who is not refused gets memory");
    for (std::size_t i = 0; i < answer.fd_count; ++i) {
      const auto segment =
          Segment::map(std::move(received.fds[i]), answer.segment_bytes[i], answer.access[i]);
      require(segment.size() <= block_.size_bytes(), "memory is part of the block");
    }
    if (request.verb == protocol::Verb::open) {
      const std::size_t value = request.size;
      require(answer.segment_bytes[0] >= value, "the memory has room for a value");
      require((answer.access[0] == Access::read_write) == (request.role == Role::writer),
              "only a writer may write");
    }
  }

  std::filesystem::path path_;
  MemoryBlock block_;
  MemoryBlockServer server_;
  std::list<BareClient> clients_;
};

}  // namespace

void block_requests(std::span<const std::uint8_t> bytes) {
  static const SocketPlace place;
  Input input(bytes);
  Server server(place.path());
  server.connect();
  constexpr int kMostActions = 100;
  for (int action = 0; action < kMostActions && !input.empty(); ++action) {
    switch (input.choose(8)) {
      case 0:
        server.connect();
        break;
      case 1:
        server.disconnect(input.choose(kMostClients));
        break;
      case 2:
        server.send_and_forget(input.choose(kMostClients),
                               std::as_bytes(input.take_bytes(input.take<std::uint16_t>())));
        break;
      default: {
        const std::size_t client = input.choose(kMostClients);
        server.ask(client, take_request(input));
      }
    }
  }
  server.check_that_claims_end();
}

}  // namespace gaitway::fuzz
