// What people get to read of a port on a CAN interface: its counters by name, and a line when its state
// changes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/can/socketcan_port.hpp"

namespace gaitway::can {

[[nodiscard]] std::string_view name_of(BusState state) noexcept;

// Every counter under the name that it has in SocketCanStatistics, in that order.
[[nodiscard]] std::vector<std::pair<std::string_view, std::uint64_t>> counters(
    const SocketCanStatistics& statistics);

class SocketCanReporter {
 public:
  // A line to print when the port's state is another than at the last call, or when a restart was refused for
  // the first time since; empty otherwise.
  [[nodiscard]] std::string news(const SocketCanPort& port);

 private:
  BusState state_ = BusState::error_active;
  std::uint64_t refused_before_ = 0;
  bool told_problem_ = false;
};

}  // namespace gaitway::can
