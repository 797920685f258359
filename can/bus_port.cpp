// The end of a station on whatever bus: waits until what it sent has been confirmed.
#include "gaitway/can/bus_port.hpp"

#include <array>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::can {

bool finish_sending(BusPort& port, std::int64_t longest_ns) {
  constexpr std::int64_t kBetweenLooks_ns = facts::kMillisecond_ns;
  const std::int64_t end_ns = process::monotonic_ns() + longest_ns;
  std::array<pollfd, 1> wakes{pollfd{port.wake_fd(), POLLIN, 0}};
  std::int64_t now_ns = process::monotonic_ns();
  port.flush(now_ns);
  while (port.transmit_pending() && now_ns < end_ns) {
    process::wait_until(now_ns + kBetweenLooks_ns, wakes);
    now_ns = process::monotonic_ns();
    port.flush(now_ns);
    while (port.receive()) {
    }
  }
  return !port.transmit_pending();
}

}  // namespace gaitway::can
