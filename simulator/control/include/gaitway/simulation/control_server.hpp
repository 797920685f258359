// The simulator's side of the control channel: takes what local processes ask, and answers. Passive: step()
// serves what has come and returns.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "gaitway/simulation/control_messages.hpp"

namespace gaitway::simulation {

// Nothing that a client does costs the simulator more than kRequestsAStep requests a step. Who sends what is
// no packet of the protocol, or does not read its answers, is dropped; clients beyond kMostClients are turned
// away with the reason. Clients take turns, so that none keeps the others from being heard.
class ControlServer {
 public:
  static constexpr std::size_t kMostClients = 8;
  static constexpr int kRequestsAStep = 4, kClientsAStep = 2;

  // What becomes of a push; throws std::exception to refuse it, with the reason.
  using OnPush = std::function<void(const Push& push)>;

  // Listens at `socket`, for this user alone. Throws process::SocketError.
  ControlServer(std::filesystem::path socket, OnPush on_push);

  // Never blocks; one system call while nobody has anything to say.
  void step();
  [[nodiscard]] std::size_t client_count() const noexcept { return clients_.size(); }

 private:
  enum class Heard { nothing, request, end };

  void accept_clients();
  [[nodiscard]] Heard serve(const process::FileDescriptor& client);
  [[nodiscard]] Answer answer_to(const Request& request) const;

  OnPush on_push_;
  process::ListeningSocket listener_;
  std::vector<process::FileDescriptor> clients_;
  std::size_t turn_ = 0;  // of clients_: who is heard first
};

}  // namespace gaitway::simulation
