// What the server's connections share. All of it belongs to the server's one thread.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "gaitway/api/server.hpp"
#include "gaitway/api/server_setup.hpp"
#include "gaitway/api/server_statistics.hpp"
#include "gaitway/api/session.hpp"

namespace gaitway::api {

class ClientLink;

// Monotonic.
[[nodiscard]] std::int64_t wall_now_ns() noexcept;

class ServerCore {
 public:
  ServerCore(SessionHub& sessions, const ServerSetup& server_setup, const ServerPage& server_page);

  // Whether a connection of this address is within the limits. When all places are taken, or all of this
  // address, the oldest link there gives way that may.
  [[nodiscard]] bool make_room_for(const boost::asio::ip::address& address);
  void add(std::shared_ptr<ClientLink> link);
  void remove(ClientLink& link);
  // The link's pump() is called soon, but not from here.
  void want_pump(std::shared_ptr<ClientLink> link) noexcept;
  [[nodiscard]] const std::vector<std::shared_ptr<ClientLink>>& links() const noexcept { return links_; }
  [[nodiscard]] std::size_t surplus_links() const noexcept { return links_.size() - places_taken_; }

  boost::asio::io_context io{1};
  SessionHub& hub;
  const ServerSetup& setup;
  const ServerOptions& options;
  const ServerPage page;
  ServerStatistics statistics;

 private:
  void pump_all();

  std::vector<std::shared_ptr<ClientLink>> links_;
  // Without those that are surplus.
  std::map<boost::asio::ip::address, std::size_t> of_address_;
  std::size_t places_taken_ = 0;
  std::vector<std::shared_ptr<ClientLink>> woken_, pumped_;
  bool pump_posted_ = false;
};

}  // namespace gaitway::api
