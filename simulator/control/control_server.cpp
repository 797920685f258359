// Requests in, answers out, some of them a millisecond.
#include "gaitway/simulation/control_server.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <exception>
#include <string>
#include <utility>

namespace gaitway::simulation {
namespace {

bool send_answer(const process::FileDescriptor& client, const Answer& answer) noexcept {
  const AnswerPacket packet = encode(answer);
  return send(client.get(), packet.data(), packet.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(packet.size());
}

}  // namespace

ControlServer::ControlServer(std::filesystem::path socket, OnPush on_push)
    : on_push_(std::move(on_push)), listener_(std::move(socket), "simulator") {}

void ControlServer::step() {
  pollfd wake{listener_.wake_fd(), POLLIN, 0};
  if (poll(&wake, 1, 0) <= 0) {
    return;
  }
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

void ControlServer::accept_clients() {
  for (int i = 0; i < kClientsAStep; ++i) {
    process::FileDescriptor client = listener_.accept();
    if (!client) {
      return;
    }
    if (clients_.size() >= kMostClients) {
      static_cast<void>(send_answer(
          client, {.reason = "the simulator serves " + std::to_string(kMostClients) +
                             " clients at once and has as many: close one of their connections first"}));
      continue;
    }
    listener_.watch(client);
    clients_.push_back(std::move(client));
  }
}

ControlServer::Heard ControlServer::serve(const process::FileDescriptor& client) {
  RequestPacket packet;
  // No room for descriptors is given, so the kernel drops any that a client might send.
  const ssize_t size = recv(client.get(), packet.data(), packet.size(), MSG_DONTWAIT | MSG_TRUNC);
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
    return Heard::nothing;
  }
  const auto request = size == static_cast<ssize_t>(packet.size()) ? decode_request(packet) : std::nullopt;
  return request && send_answer(client, answer_to(*request)) ? Heard::request : Heard::end;
}

Answer ControlServer::answer_to(const Request& request) const {
  Answer answer{.number = request.number};
  if (request.version != kControlVersion) {
    answer.reason = "the request is of version " + std::to_string(request.version) +
                    " of the protocol, but the simulator speaks " + std::to_string(kControlVersion) +
                    ": run both from the same release";
    return answer;
  }
  if (request.kind != static_cast<std::uint16_t>(RequestKind::push)) {
    answer.reason = "kind is " + std::to_string(request.kind) + ", but must be push (1)";
    return answer;
  }
  try {
    on_push_(push_of(request));
    answer.accepted = true;
  } catch (const std::exception& error) {
    answer.reason = error.what();
  }
  return answer;
}

}  // namespace gaitway::simulation
