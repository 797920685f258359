// Opens the simulated bus to clients of the socketcand protocol (python-can, Kayak, …): each is one station.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::can {

inline constexpr std::uint16_t kSocketcandPort = 29536;
inline constexpr std::uint16_t kSocketcandBeaconPort = 42000;

// Where to listen. The protocol knows no passwords, so only addresses of this machine's loopback are served.
struct SocketcandAddress {
  std::string host = "127.0.0.1";        // numeric; 127.0.0.0/8 or ::1
  std::uint16_t port = kSocketcandPort;  // 0: any that is free

  // "[ADDRESS:]PORT", an IPv6 address in brackets; "localhost" is 127.0.0.1. Throws BusError naming value,
  // rule and remedy.
  static SocketcandAddress parse(std::string_view text);
};

struct SocketcandStatistics {
  std::uint64_t clients = 0;               // that ever connected
  std::uint64_t turned_away = 0;           // there were too many
  std::uint64_t not_reading = 0;           // dropped, since they read nothing for long
  std::uint64_t rejected_commands = 0;     // answered with an error
  std::uint64_t frames = 0;                // that clients sent
  std::uint64_t untold_remote_frames = 0;  // the protocol has no words for them
};

// Passive: owns no thread and reads no clock; never blocks. A round is step(), offer(), the bus's advance()
// with on_delivery() for each delivery, flush().
class SocketcandServer {
 public:
  static constexpr std::size_t kMostClients = 32;

  struct Options {
    std::string bus_name = "can0";                      // under which clients open the bus
    std::uint16_t beacon_port = kSocketcandBeaconPort;  // UDP on the loopback; 0: no beacon
  };
  // `bus` outlives it. Throws BusError when the address cannot be served.
  SocketcandServer(const SocketcandAddress& address, SimulatedBus& bus, Options options);
  SocketcandServer(const SocketcandAddress& address, SimulatedBus& bus)
      : SocketcandServer(address, bus, Options()) {}
  ~SocketcandServer();
  SocketcandServer(const SocketcandServer&) = delete;
  SocketcandServer& operator=(const SocketcandServer&) = delete;

  // Takes in clients and what they said, detaches those that went. `now_ns`: the time of the bus.
  void step(std::int64_t now_ns);
  // Before the bus runs on from `now_ns` to `until_ns`: hands it what clients want to send by then.
  void offer(std::int64_t now_ns, std::int64_t until_ns);
  // Of anyone on the bus.
  void on_delivery(const SimulatedBus::Delivery& delivery);
  // Hands out what clients are to get.
  void flush(std::int64_t now_ns);

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  [[nodiscard]] std::size_t client_count() const noexcept { return clients_.size(); }
  [[nodiscard]] const SocketcandStatistics& statistics() const noexcept { return statistics_; }
  // Readable when step() has something to do.
  [[nodiscard]] int wake_fd() const noexcept { return epoll_.get(); }

 private:
  struct Client;
  void listen(const SocketcandAddress& address);
  void accept_clients();
  void read(Client& client, std::int64_t now_ns);
  void watch(int fd, bool readable, bool is_new) const;
  void offer(Client& client, std::int64_t now_ns);
  void drop_gone();
  void send_beacon(std::int64_t now_ns);

  SimulatedBus& bus_;
  Options options_;
  process::FileDescriptor listener_, epoll_, beacon_;
  std::uint16_t port_ = 0;
  std::string beacon_text_;
  std::optional<std::int64_t> beacon_sent_ns_;
  std::list<Client> clients_;
  std::vector<int> leaving_stations_;  // of clients that went
  std::int64_t horizon_ns_ = 0;        // how far the bus is about to run
  SocketcandStatistics statistics_;
};

}  // namespace gaitway::can
