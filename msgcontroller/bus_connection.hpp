// The bus that the message controller's process was told to use: the simulated one behind a socket, or a CAN
// interface.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/can/socketcan_port.hpp"

namespace gaitway::msgcontroller {

struct BusChoice {
  std::filesystem::path socket;    // of the simulated bus; or
  std::string interface;           // a CAN interface
  std::filesystem::path sent_log;  // with an interface: file for what was sent, in candump's format; or empty
};

class BusConnection {
 public:
  // Throws can::BusError when the bus is not there, std::runtime_error when the log cannot be written.
  explicit BusConnection(const BusChoice& choice);

  [[nodiscard]] can::BusPort& port() noexcept;
  // Where to wait for the bus with poll(): nowhere (-1) while an interface has nothing to confirm. What
  // others send is taken every millisecond, which saves a wake-up for each of some 2400 frames a second.
  [[nodiscard]] int wake_fd() const noexcept {
    return client_ ? client_->wake_fd() : interface_->transmit_pending() ? interface_->wake_fd() : -1;
  }
  // The server of the simulated bus has ended. An interface that is down may come back.
  [[nodiscard]] bool gone() const noexcept { return client_ && client_->closed(); }
  // Prints what has changed with the interface, if anything has.
  void report();
  // Waits a moment for what is on its way, and closes the log; throws std::runtime_error when it was not
  // written whole.
  void close();
  [[nodiscard]] const can::SocketCanPort* interface() const noexcept {
    return interface_ ? &*interface_ : nullptr;
  }

 private:
  std::optional<can::CandumpWriter> sent_log_;
  std::optional<can::BusClient> client_;
  std::optional<can::SocketCanPort> interface_;
  can::SocketCanReporter reporter_;
};

}  // namespace gaitway::msgcontroller
