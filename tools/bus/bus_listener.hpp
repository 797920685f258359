// A station that only listens, on a simulated bus behind a socket or on an interface of the machine. Reads
// the clock and waits: for commands, not for components.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/simulated/bus_client.hpp"
#include "gaitway/can/socketcan_port.hpp"
#include "tools/bus/bus_watch_text.hpp"

namespace gaitway::tools {

struct ListenerPlace {
  std::optional<std::filesystem::path> socket;
  std::optional<std::string> interface;  // one of the two
};

class BusListener {
 public:
  // Throws can::BusError when nobody serves the socket, or the interface cannot be used.
  explicit BusListener(const ListenerPlace& place);

  // Hands on what comes until `until_ns` (CLOCK_MONOTONIC), the bus ends or a signal asks to stop.
  void listen_until(std::int64_t until_ns, const std::function<void(const can::TimedFrame&)>& take);
  // What the interface reported about errors since the last call.
  [[nodiscard]] std::uint64_t take_error_reports() noexcept;

  [[nodiscard]] bool open() const noexcept { return client_ == nullptr || !client_->closed(); }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] ListenerState state() const noexcept { return {port_->state(), port_->error_counters()}; }

 private:
  std::string name_;
  std::unique_ptr<can::BusPort> port_;
  const can::BusClient* client_ = nullptr;         // the port, where it is one
  const can::SocketCanPort* interface_ = nullptr;  // the port, where it is one
  std::uint64_t reports_ = 0;                      // about errors, that were handed on
};

}  // namespace gaitway::tools
