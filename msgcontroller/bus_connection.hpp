// The bus that the message controller's process was told to use: the simulated one behind a socket, or a CAN
// interface. Whatever becomes of it, the message controller goes on; this one says what it was, in few lines.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::msgcontroller {

struct BusChoice {
  std::filesystem::path socket;    // of the simulated bus; or
  std::string interface;           // a CAN interface
  std::filesystem::path sent_log;  // with an interface: file for what was sent, in candump's format, after
                                   // what it holds; or empty
};

// What is printed while a bus comes and goes: a few lines in a second at most, and afterwards the newest of
// those that were kept back.
class BusNews {
 public:
  // Called every millisecond, mostly without a line. What is to be printed, or nothing.
  std::string tell(std::string line, std::int64_t now_ns);

 private:
  static constexpr int kLinesASecond = 3;
  std::int64_t second_ns_ = 0;  // that runs
  int told_ = 0, kept_back_ = 0;
  std::string newest_;  // of those that were kept back
};

class BusConnection {
 public:
  // Throws can::BusError when the bus is not there, std::runtime_error when another message controller is on
  // it, or the log cannot be written.
  explicit BusConnection(const BusChoice& choice);

  [[nodiscard]] can::BusPort& port() noexcept;
  // Where to wait for the bus with poll(): nowhere (-1) while an interface has nothing to confirm. What
  // others send is taken every millisecond, which saves a wake-up for each of some 2400 frames a second.
  [[nodiscard]] int wake_fd() const noexcept {
    return client_ ? client_->wake_fd() : interface_->transmit_pending() ? interface_->wake_fd() : -1;
  }
  // Prints what has changed with the bus, if anything has.
  void report(std::int64_t now_ns);
  // Waits a moment for what is on its way, and ends the log.
  void close();
  // Frames in the log of what was sent, and those that a full or slow disk had no room for; none: no log.
  [[nodiscard]] std::optional<process::LogCount> sent_log() const noexcept;
  [[nodiscard]] const can::SocketCanPort* interface() const noexcept {
    return interface_ ? &*interface_ : nullptr;
  }
  // No hardware is on it, and so no robot of metal.
  [[nodiscard]] bool is_simulated() const noexcept { return !interface_ || interface_->is_virtual(); }
  // Times that the bus went away, and how long it was away in all.
  [[nodiscard]] std::uint64_t outages() const noexcept { return outages_; }
  [[nodiscard]] std::int64_t away_ns() const noexcept { return away_ns_; }

 private:
  void claim(const BusChoice& choice);
  [[nodiscard]] std::string news(bool is_off, std::int64_t now_ns);

  process::FileDescriptor claim_;
  std::filesystem::path socket_;
  std::optional<can::CandumpWriter> sent_log_;
  std::optional<can::LastingBusClient> client_;
  std::optional<can::SocketCanPort> interface_;
  can::SocketCanReporter reporter_;
  BusNews news_;
  bool was_off_ = false;
  bool is_served_ = true;  // somebody has the socket, whether the bus runs or not
  std::int64_t off_since_ns_ = 0;
  std::uint64_t outages_ = 0;
  std::int64_t away_ns_ = 0;
};

}  // namespace gaitway::msgcontroller
