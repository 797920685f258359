// The socketcand server: sockets on one side, stations of the simulated bus on the other, a session between.
#include "gaitway/can/simulated/socketcand_server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "gaitway/can/simulated/socketcand_session.hpp"

namespace gaitway::can {
namespace {

constexpr int kBacklog = 16;
constexpr std::size_t kPiece_bytes = 4096;
constexpr int kPiecesAStep = 16;  // of one client: bounds the time that one step takes
// The kernel's share of what a client has not read: small, since the session keeps more, and counts it.
constexpr int kSendBuffer_bytes = 128 * 1024;
constexpr std::int64_t kBeaconPeriod_ns = 3'000'000'000;

struct Endpoint {
  sockaddr_storage storage{};
  socklen_t size = 0;
  [[nodiscard]] const sockaddr* address() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

Endpoint endpoint_of(const std::string& host, std::uint16_t port) {
  Endpoint endpoint;
  sockaddr_in v4{};
  sockaddr_in6 v6{};
  if (inet_pton(AF_INET, host.c_str(), &v4.sin_addr) == 1) {
    v4.sin_family = AF_INET;
    v4.sin_port = htons(port);
    endpoint.size = sizeof v4;
    std::memcpy(&endpoint.storage, &v4, sizeof v4);
  } else {
    inet_pton(AF_INET6, host.c_str(), &v6.sin6_addr);
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(port);
    endpoint.size = sizeof v6;
    std::memcpy(&endpoint.storage, &v6, sizeof v6);
  }
  return endpoint;
}

std::uint16_t bound_port(int socket) {
  Endpoint bound;
  bound.size = sizeof bound.storage;
  getsockname(socket, reinterpret_cast<sockaddr*>(&bound.storage), &bound.size);
  in_port_t port = 0;  // at the same place in both families
  static_assert(offsetof(sockaddr_in, sin_port) == offsetof(sockaddr_in6, sin6_port));
  std::memcpy(&port, reinterpret_cast<const char*>(&bound.storage) + offsetof(sockaddr_in, sin_port),
              sizeof port);
  return ntohs(port);
}

std::string url_of(const SocketcandAddress& address, std::uint16_t port) {
  const bool v6 = address.host.find(':') != std::string::npos;
  return "can://" + (v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(port);
}

bool try_again() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

struct SocketcandServer::Client {
  Client(process::FileDescriptor connection, int station_number, std::string_view bus_name)
      : socket(std::move(connection)), station(station_number), session(bus_name) {}

  process::FileDescriptor socket;
  int station;
  SocketcandSession session;
  std::string unread;  // what there is no room for yet
  bool watched = true;
  bool has_said_all = false;  // it goes when what it sent has been on the bus
  bool gone = false;
  std::optional<SocketcandSession::Release> refused;  // by the bus: its station cannot send now

  void flush();
};

void SocketcandServer::Client::flush() {
  std::string& output = session.output();
  std::size_t sent = 0;
  while (!gone && sent < output.size()) {
    const ssize_t bytes =
        send(socket.get(), output.data() + sent, output.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (bytes < 0) {
      gone = !try_again();
      break;  // a full socket: it goes out with a later flush
    }
    sent += static_cast<std::size_t>(bytes);
  }
  output.erase(0, sent);
  gone = gone || (session.ended() && output.empty());
}

SocketcandServer::SocketcandServer(const SocketcandAddress& address, SimulatedBus& bus, Options options)
    : bus_(bus), options_(std::move(options)), epoll_(epoll_create1(EPOLL_CLOEXEC)) {
  listen(address);
  watch(listener_.get(), true, true);
  if (options_.beacon_port != 0) {
    beacon_ = process::FileDescriptor(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    beacon_text_ =
        "<CANBeacon name=\"gaitway\" type=\"adapter\" description=\"Simulated bus of a Gaitway "
        "robot\"><URL>" +
        url_of(address, port_) + "</URL><Bus name=\"" + options_.bus_name + "\"/></CANBeacon>";
  }
}

SocketcandServer::~SocketcandServer() = default;

void SocketcandServer::listen(const SocketcandAddress& address) {
  const auto fail = [&](const std::string& what) {
    throw BusError("socketcand at " + url_of(address, address.port) + ": " + what + ": " +
                   std::strerror(errno));
  };
  const Endpoint endpoint = endpoint_of(address.host, address.port);
  listener_ = process::FileDescriptor(
      socket(endpoint.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!listener_ || !epoll_) {
    fail("cannot make a socket");
  }
  const int on = 1;
  setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (bind(listener_.get(), endpoint.address(), endpoint.size) != 0 ||
      ::listen(listener_.get(), kBacklog) != 0) {
    if (errno == EADDRINUSE) {
      fail("port " + std::to_string(address.port) +
           " is taken by another program; end that one, choose another port, or 0 for any that is free");
    }
    fail("cannot listen");
  }
  port_ = bound_port(listener_.get());
}

void SocketcandServer::watch(int fd, bool readable, bool is_new) const {
  epoll_event event{};
  event.events = readable ? static_cast<std::uint32_t>(EPOLLIN) : 0U;
  event.data.fd = fd;
  if (epoll_ctl(epoll_.get(), is_new ? EPOLL_CTL_ADD : EPOLL_CTL_MOD, fd, &event) != 0) {
    throw BusError(std::string("socketcand: cannot wait for clients: ") + std::strerror(errno));
  }
}

void SocketcandServer::accept_clients() {
  while (true) {
    process::FileDescriptor connection(
        accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (!connection) {
      return;  // nobody waits, or the system has no descriptor left, and then they wait on
    }
    if (clients_.size() == kMostClients) {
      ++statistics_.turned_away;
      std::string text;
      socketcand::append_error(text, "there are " + std::to_string(kMostClients) + " clients already");
      send(connection.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      continue;
    }
    const int on = 1;
    setsockopt(connection.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    setsockopt(connection.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer_bytes, sizeof kSendBuffer_bytes);
    watch(connection.get(), true, true);
    clients_.emplace_back(std::move(connection), bus_.attach(), options_.bus_name).flush();
    ++statistics_.clients;
  }
}

void SocketcandServer::step(std::int64_t now_ns) {
  accept_clients();
  for (Client& client : clients_) {
    const std::uint64_t rejected = client.session.rejected();
    read(client, now_ns);
    client.session.step(now_ns);
    statistics_.rejected_commands += client.session.rejected() - rejected;
    client.flush();
  }
  drop_gone();
}

void SocketcandServer::read(Client& client, std::int64_t now_ns) {
  std::array<char, kPiece_bytes> piece;  // NOLINT: filled by recv
  for (int i = 0; i < kPiecesAStep && !client.gone && !client.has_said_all; ++i) {
    std::string_view waiting = client.unread;
    client.session.take(waiting, now_ns);
    client.unread.erase(0, client.unread.size() - waiting.size());
    if (!client.unread.empty()) {
      break;  // TCP holds the client back, until the bus has taken what it wants to send
    }
    const ssize_t bytes = recv(client.socket.get(), piece.data(), piece.size(), 0);
    if (bytes < 0 && try_again()) {
      break;
    }
    client.gone = bytes < 0;
    client.has_said_all = bytes == 0;
    if (bytes > 0) {
      client.unread.assign(piece.data(), static_cast<std::size_t>(bytes));
    }
  }
  const bool to_be_read = client.unread.empty() && !client.has_said_all;
  if (!client.gone && client.watched != to_be_read) {
    client.watched = to_be_read;
    watch(client.socket.get(), client.watched, false);
  }
}

void SocketcandServer::drop_gone() {
  for (auto client = clients_.begin(); client != clients_.end();) {
    const auto next = std::next(client);
    const bool done = client->has_said_all && client->session.nothing_queued() && !client->refused &&
                      !bus_.transmit_pending(client->station);
    if (client->gone || done || client->session.overrun()) {
      statistics_.not_reading += client->session.overrun() ? 1U : 0U;
      leaving_stations_.push_back(client->station);
      clients_.erase(client);
    }
    client = next;
  }
  bus_.detach_sent(leaving_stations_);
}

void SocketcandServer::offer(std::int64_t now_ns, std::int64_t until_ns) {
  horizon_ns_ = until_ns;
  for (Client& client : clients_) {
    client.session.step(now_ns);
    offer(client, now_ns);
  }
}

void SocketcandServer::offer(Client& client, std::int64_t now_ns) {
  if (bus_.transmit_pending(client.station)) {
    return;
  }
  if (!client.refused) {
    client.refused = client.session.next_frame(now_ns, horizon_ns_);
  }
  if (client.refused &&
      bus_.transmit(client.station, client.refused->frame, std::max(now_ns, client.refused->since_ns))) {
    client.refused.reset();
  }
}

void SocketcandServer::on_delivery(const SimulatedBus::Delivery& delivery) {
  for (Client& client : clients_) {
    const bool own = delivery.sent_by(client.station);
    if (own || delivery.received_by(client.station)) {
      const std::uint64_t untold = client.session.untold_remote_frames();
      client.session.on_frame({delivery.frame, delivery.start_ns, delivery.end_ns}, own);
      statistics_.untold_remote_frames += client.session.untold_remote_frames() - untold;
    }
    if (own) {
      ++statistics_.frames;
      offer(client, delivery.end_ns);
    }
  }
}

void SocketcandServer::flush(std::int64_t now_ns) {
  for (Client& client : clients_) {
    client.flush();
  }
  drop_gone();
  send_beacon(now_ns);
}

void SocketcandServer::send_beacon(std::int64_t now_ns) {
  if (!beacon_ || (beacon_sent_ns_ && now_ns < *beacon_sent_ns_ + kBeaconPeriod_ns)) {
    return;
  }
  beacon_sent_ns_ = now_ns;
  const Endpoint loopback = endpoint_of("127.0.0.1", options_.beacon_port);
  // Whether somebody listens is of no importance.
  sendto(beacon_.get(), beacon_text_.data(), beacon_text_.size(), MSG_DONTWAIT, loopback.address(),
         loopback.size);
}

}  // namespace gaitway::can
