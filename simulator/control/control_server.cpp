// Requests in, answers out, some of them a millisecond.
#include "gaitway/simulation/control_server.hpp"

#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <span>
#include <utility>

namespace gaitway::simulation {
namespace {

bool send_packet(const process::FileDescriptor& client, const Packet& packet) noexcept {
  return send(client.get(), packet.data(), packet.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(packet.size());
}

bool has_no_room() noexcept {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR || errno == ENOBUFS;
}

Packet answer_packet(const Answer& answer) {
  try {
    return encode(answer);
  } catch (const std::exception& error) {  // it is too long
    return encode(Answer{.number = answer.number, .text = error.what()});
  }
}

}  // namespace

ControlServer::ControlServer(std::filesystem::path socket, OnPush on_push, OnOrder on_order)
    : on_push_(std::move(on_push)),
      on_order_(std::move(on_order)),
      listener_(std::move(socket), "simulator"),
      wake_(epoll_create1(EPOLL_CLOEXEC)) {
  epoll_event event{};
  event.events = EPOLLIN;
  if (!wake_ || epoll_ctl(wake_.get(), EPOLL_CTL_ADD, listener_.wake_fd(), &event) != 0) {
    throw process::SocketError("socket '" + listener_.path().native() +
                               "': cannot wait for clients: " + std::strerror(errno));
  }
}

void ControlServer::step() {
  pollfd wake{wake_.get(), POLLIN, 0};
  if (poll(&wake, 1, 0) > 0) {
    std::ranges::for_each(clients_, [this](Client& client) { send_unsent(client); });
    int left = kRequestsAStep;
    std::size_t silent = 0;
    while (left > 0 && silent < clients_.size()) {
      turn_ %= clients_.size();
      switch (serve(clients_[turn_])) {
        case Heard::request:
          --left;
          silent = 0;
          ++turn_;
          break;
        case Heard::nothing:
          ++silent;
          ++turn_;
          break;
        case Heard::end:
          --left;
          clients_.erase(clients_.begin() + static_cast<std::ptrdiff_t>(turn_));
          break;
      }
    }
    accept_clients();
  }
  std::erase_if(clients_, [](const Client& client) { return !client.socket; });
}

void ControlServer::accept_clients() {
  for (int i = 0; i < kClientsAStep; ++i) {
    process::FileDescriptor socket = listener_.accept();
    if (!socket) {
      return;
    }
    if (clients_.size() >= kMostClients) {
      static_cast<void>(send_packet(
          socket, answer_packet({.text = "the simulator serves " + std::to_string(kMostClients) +
                                         " clients at once and has as many: close one of their connections "
                                         "first"})));
      continue;
    }
    listener_.watch(socket);
    clients_.push_back({.id = ++last_client_, .socket = std::move(socket)});
  }
}

ControlServer::Heard ControlServer::serve(Client& client) {
  if (!client.socket) {
    return Heard::end;
  }
  std::array<std::byte, kMostRequestBytes> packet;
  // No room for descriptors is given, so the kernel drops any that a client might send.
  const ssize_t size = recv(client.socket.get(), packet.data(), packet.size(), MSG_DONTWAIT | MSG_TRUNC);
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
    return Heard::nothing;
  }
  const bool whole = size > 0 && static_cast<std::size_t>(size) <= packet.size();
  const auto request =
      whole ? decode_request(std::span(packet).first(static_cast<std::size_t>(size))) : std::nullopt;
  if (!request) {
    return Heard::end;
  }
  take(client, *request);
  return client.socket ? Heard::request : Heard::end;
}

void ControlServer::take(Client& client, const Request& request) {
  if (request.version != kControlVersion) {
    return finish(client, {.number = request.number,
                           .text = "the request is of version " + std::to_string(request.version) +
                                   " of the protocol, but the simulator speaks " +
                                   std::to_string(kControlVersion) + ": run both from the same release"});
  }
  switch (static_cast<RequestKind>(request.kind)) {
    case RequestKind::push:
      return take_push(client, request);
    case RequestKind::order:
      return take_order(client, request);
  }
  finish(client, {.number = request.number,
                  .text = "kind is " + std::to_string(request.kind) + ", but must be push (1) or order (2)"});
}

void ControlServer::take_push(Client& client, const Request& request) {
  const auto ticket = open(client, request.number);
  if (!ticket) return;
  try {
    if (on_push_(*ticket, push_of(request))) answer(*ticket, true, {});
  } catch (const std::exception& error) {
    answer(*ticket, false, error.what());
  }
}

void ControlServer::take_order(Client& client, const Request& request) {
  if (!on_order_) {
    return finish(client,
                  {.number = request.number,
                   .text = "this simulator takes pushes alone: `gaitway simulator` takes orders, too"});
  }
  const auto ticket = open(client, request.number);
  if (!ticket) return;
  try {
    if (const auto json = on_order_(*ticket, order_of(request))) answer(*ticket, true, *json);
  } catch (const std::exception& error) {
    answer(*ticket, false, error.what());
  }
}

std::optional<Ticket> ControlServer::open(Client& client, std::uint32_t number) {
  const auto refuse = [&](std::string why) { finish(client, {.number = number, .text = std::move(why)}); };
  if (client.open.size() >= kMostOpen) {
    refuse(std::to_string(client.open.size()) +
           " requests of this client wait for their answers, and no more may: wait for one of them first");
    return std::nullopt;
  }
  if (std::ranges::find(client.open, number) != client.open.end()) {
    refuse("number is " + std::to_string(number) +
           ", but must not be one of a request that waits for its answer");
    return std::nullopt;
  }
  client.open.push_back(number);
  return Ticket{client.id, number};
}

void ControlServer::answer(const Ticket& ticket, bool accepted, const std::string& text) {
  const auto client = std::ranges::find(clients_, ticket.client, &Client::id);
  if (client != clients_.end() && std::erase(client->open, ticket.number) > 0) {
    finish(*client, {ticket.number, accepted, text});
  }
}

void ControlServer::finish(Client& client, const Answer& answer) {
  if (!client.socket) {
    return;
  }
  Packet packet = answer_packet(answer);
  if (client.unsent.empty()) {
    if (send_packet(client.socket, packet)) {
      return;
    }
    if (!has_no_room()) {
      client.socket = process::FileDescriptor();
      return;
    }
    await_room(client, true);
  }
  client.unsent_bytes += packet.size();
  client.unsent.push_back(std::move(packet));
  if (client.unsent.size() > kMostUnsent || client.unsent_bytes > kMostUnsentBytes) {
    client.socket = process::FileDescriptor();  // it does not read
  }
}

void ControlServer::send_unsent(Client& client) {
  if (!client.socket || client.unsent.empty()) {
    return;
  }
  while (!client.unsent.empty()) {
    if (!send_packet(client.socket, client.unsent.front())) {
      if (!has_no_room()) {
        client.socket = process::FileDescriptor();
      }
      return;
    }
    client.unsent_bytes -= client.unsent.front().size();
    client.unsent.pop_front();
  }
  await_room(client, false);
}

void ControlServer::await_room(const Client& client, bool wanted) const {
  epoll_event event{};
  event.events = EPOLLOUT;
  static_cast<void>(
      epoll_ctl(wake_.get(), wanted ? EPOLL_CTL_ADD : EPOLL_CTL_DEL, client.socket.get(), &event));
}

}  // namespace gaitway::simulation
