// What the server's connections share. All of it belongs to the server's one thread.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "address_patience.hpp"
#include "fair_turns.hpp"
#include "gaitway/api/server.hpp"
#include "gaitway/api/server_setup.hpp"
#include "gaitway/api/server_statistics.hpp"
#include "gaitway/api/session.hpp"
#include "listening_time.hpp"
#include "refusal_log.hpp"

namespace gaitway::api {

class ClientLink;

// Monotonic.
[[nodiscard]] std::int64_t wall_now_ns() noexcept;

class ServerCore {
 public:
  ServerCore(SessionHub& sessions, const ServerSetup& server_setup, const ServerPage& server_page);

  // Whether a connection of this address is within the limits. When all places of this address are taken, or
  // those of its strangers, its oldest link gives way that may; when all places are taken, the oldest of the
  // address that has most such links. counted_address() says what one address is.
  [[nodiscard]] bool make_room_for(const boost::asio::ip::address& whose);
  void add(std::shared_ptr<ClientLink> link);
  void remove(ClientLink& link);
  // The link's pump() is called soon, but not from here.
  void want_pump(std::shared_ptr<ClientLink> link) noexcept;
  // The link has work that waits for its turn; not while it waits already.
  void want_work(std::shared_ptr<ClientLink> link);
  // The link shakes hands when the sockets have been looked at since the last one that did.
  void want_handshake(std::shared_ptr<ClientLink> link);
  [[nodiscard]] const std::vector<std::shared_ptr<ClientLink>>& links() const noexcept { return links_; }
  [[nodiscard]] std::size_t surplus_links() const noexcept { return links_.size() - places_taken_; }

  boost::asio::io_context io{1};
  SessionHub& hub;
  const ServerSetup& setup;
  const ServerOptions& options;
  const ServerPage page;
  ServerStatistics statistics;
  RefusalLog refusal_log;
  AddressPatience patience;
  unsigned urgent_beyond = 0;  // messages that overtook, beyond what each client may, since the last sweep
  ListeningTime listening;     // ticked by the server; what clients owe is counted in it

 private:
  // Of the time in which messages are carried out, before the sockets are looked at again: for a stop, say.
  static constexpr FairTurns::Budget kBudget{.each_ns = 200'000, .all_ns = 1'000'000};
  // In which the sockets are looked at meanwhile, at most.
  static constexpr std::int64_t kSockets_ns = 4'000'000;

  void pump_all();
  void post_work();
  void work();

  std::vector<std::shared_ptr<ClientLink>> links_;
  // Without those that are surplus.
  std::map<boost::asio::ip::address, std::size_t> of_address_;  // by counted_address()
  std::size_t places_taken_ = 0;
  std::vector<std::shared_ptr<ClientLink>> woken_, pumped_;
  bool pump_posted_ = false;
  FairTurns turns_{kBudget, wall_now_ns};
  std::deque<std::shared_ptr<ClientLink>> handshakes_;
  bool work_posted_ = false;
};

}  // namespace gaitway::api
