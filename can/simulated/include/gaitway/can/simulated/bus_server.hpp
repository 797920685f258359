// Opens the simulated bus to other processes: each client of a Unix socket is one station, beside those of
// this process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <optional>
#include <vector>

#include "gaitway/can/simulated/simulated_bus.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::can {

struct BusServerStatistics {
  std::uint64_t clients = 0;      // that ever connected
  std::uint64_t refused = 0;      // beyond 64 at a time
  std::uint64_t broken = 0;       // clients that were dropped, since they broke the protocol
  std::uint64_t not_reading = 0;  // clients that were dropped, since they read nothing for long
  std::uint64_t late_frames =
      0;  // frames whose time had passed on the bus by more than a millisecond when they came
};

// Passive: owns no thread and reads no clock. A round is step(), advance() until nothing comes, flush().
class BusServer {
 public:
  // Listens on `socket`; a stale socket file is replaced. Only this user can connect. Throws
  // process::SocketError if another server answers there or the path is unusable. `start_ns`: the time of the
  // bus.
  BusServer(std::filesystem::path socket, std::int64_t start_ns);
  ~BusServer();
  BusServer(const BusServer&) = delete;
  BusServer& operator=(const BusServer&) = delete;

  // Local stations attach and transmit here; deliveries come from advance() below alone.
  [[nodiscard]] SimulatedBus& bus() noexcept { return bus_; }
  [[nodiscard]] const SimulatedBus& bus() const noexcept { return bus_; }

  // Takes in clients and what they sent; detaches those that went. Never blocks.
  void step();
  // The next frame that completes at or before `until_ns`, as of SimulatedBus::advance(); clients get it with
  // flush().
  std::optional<SimulatedBus::Delivery> advance(std::int64_t until_ns);
  // Hands out what the clients are to get.
  void flush();

  // Whether every client whose pace the bus keeps has flushed up to `time_ns`.
  [[nodiscard]] bool reached(std::int64_t time_ns) const noexcept;
  [[nodiscard]] std::size_t client_count() const noexcept { return clients_.size(); }
  [[nodiscard]] const BusServerStatistics& statistics() const noexcept { return statistics_; }
  // Readable when step() has something to do.
  [[nodiscard]] int wake_fd() const noexcept { return listener_.wake_fd(); }

 private:
  struct Client;
  bool serve(Client& client);  // false: it has gone, or has to go
  void offer();
  void hand_to_clients(const SimulatedBus::Delivery& delivery);
  void hand_to_clients(const ErrorFrame& error);

  SimulatedBus bus_;
  process::ListeningSocket listener_;
  std::list<Client> clients_;
  std::vector<int> leaving_stations_;  // of clients that went
  std::int64_t time_ns_;               // how far the bus has run
  BusServerStatistics statistics_;
};

}  // namespace gaitway::can
