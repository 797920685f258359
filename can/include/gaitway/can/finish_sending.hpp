// For programs at their end.
#pragma once

#include <cstdint>

#include "gaitway/can/bus_port.hpp"

namespace gaitway::can {

// Waits until the bus has what was transmitted, `longest_ns` at most. True: it has. What others send
// meanwhile is discarded.
bool finish_sending(BusPort& port, std::int64_t longest_ns = 100'000'000);

}  // namespace gaitway::can
