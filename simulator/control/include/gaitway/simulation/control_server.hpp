// The simulator's side of the control channel: takes what local processes ask, and answers, at once or when
// it has been done. Passive: step() serves what has come and returns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "gaitway/simulation/control_messages.hpp"

namespace gaitway::simulation {

// A request whose answer may come later: whose, and which of his.
struct Ticket {
  std::uint64_t client = 0;  // of one connection, and of no other one ever after
  std::uint32_t number = 0;
  friend bool operator==(const Ticket&, const Ticket&) = default;
};

// Nothing that a client does costs the simulator more than kRequestsAStep requests a step. Who sends what is
// no packet of the protocol, or does not read its answers, is dropped; clients beyond kMostClients are turned
// away with the reason. Clients take turns, so that none keeps the others from being heard.
class ControlServer {
 public:
  static constexpr std::size_t kMostClients = 8;
  static constexpr int kRequestsAStep = 4, kClientsAStep = 2;
  // Of one client: requests that wait for their answers, and answers that it has not read.
  static constexpr std::size_t kMostOpen = 64, kMostUnsent = 256, kMostUnsentBytes = 4'000'000;

  // True: the push begins; false: what becomes of it comes later, by answer(). Throws std::exception to
  // refuse it, with the reason.
  using OnPush = std::function<bool(const Ticket& ticket, const Push& push)>;
  // The JSON of the answer; nothing: it comes later, by answer(). Throws std::exception to refuse.
  using OnOrder = std::function<std::optional<std::string>(const Ticket& ticket, std::string_view order)>;

  // Listens at `socket`, for this user alone. Without `on_order` orders are refused. Throws
  // process::SocketError.
  ControlServer(std::filesystem::path socket, OnPush on_push, OnOrder on_order = {});

  // Never blocks; one system call while nobody has anything to say.
  void step();
  // What became of a request that was left open; `text` is the JSON of the answer, or why not. Nothing
  // happens when that client has gone or has its answer. May be called by OnOrder, for any ticket.
  void answer(const Ticket& ticket, bool accepted, const std::string& text);
  // Readable when step() has something to do: for who waits for that alone, since its simulation is paused.
  [[nodiscard]] int wake_fd() const noexcept { return wake_.get(); }
  [[nodiscard]] std::size_t client_count() const noexcept { return clients_.size(); }

 private:
  enum class Heard { nothing, request, end };
  struct Client {
    std::uint64_t id = 0;
    process::FileDescriptor socket;     // none: it was dropped, and goes with the next step
    std::vector<std::uint32_t> open{};  // requests without an answer yet
    std::deque<Packet> unsent{};
    std::size_t unsent_bytes = 0;
  };

  void accept_clients();
  [[nodiscard]] Heard serve(Client& client);
  void take(Client& client, const Request& request);
  void take_push(Client& client, const Request& request);
  void take_order(Client& client, const Request& request);
  // Nothing: the request was refused.
  [[nodiscard]] std::optional<Ticket> open(Client& client, std::uint32_t number);
  void finish(Client& client, const Answer& answer);
  void send_unsent(Client& client);
  void await_room(const Client& client, bool wanted) const;

  OnPush on_push_;
  OnOrder on_order_;
  process::ListeningSocket listener_;
  process::FileDescriptor wake_;  // the listener's, and clients that have no room for an answer
  std::vector<Client> clients_;
  std::size_t turn_ = 0;  // of clients_: who is heard first
  std::uint64_t last_client_ = 0;
};

}  // namespace gaitway::simulation
