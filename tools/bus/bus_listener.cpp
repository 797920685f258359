// Opens the port and drains it.
#include "tools/bus/bus_listener.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

// How often a port is looked after without a frame: an interface may have gone or come back.
constexpr std::int64_t kLookAfter_ns = 100'000'000;

}  // namespace

BusListener::BusListener(const ListenerPlace& place) {
  if (place.socket) {
    auto client = std::make_unique<can::BusClient>(*place.socket, "listener", can::Pace::free);
    client_ = client.get();
    port_ = std::move(client);
    name_ = place.socket->string();
  } else {
    can::SocketCanOptions options;
    options.restart_delay_ns = 0;  // a listener leaves the interface as it is
    auto port = std::make_unique<can::SocketCanPort>(*place.interface, options);
    interface_ = port.get();
    port_ = std::move(port);
    name_ = *place.interface;
  }
}

void BusListener::listen_until(std::int64_t until_ns,
                               const std::function<void(const can::TimedFrame&)>& take) {
  std::array<pollfd, 1> wakes{pollfd{port_->wake_fd(), POLLIN, 0}};
  for (std::int64_t now_ns = process::monotonic_ns(); open() && !process::stop_requested();) {
    if (interface_ != nullptr) {
      port_->flush(now_ns);  // looks after the interface; a client that never sends has nothing to flush
    }
    while (const auto frame = port_->receive()) {
      take(*frame);
    }
    if (now_ns >= until_ns) {
      return;
    }
    process::wait_until(std::min(until_ns, now_ns + kLookAfter_ns), wakes);
    now_ns = process::monotonic_ns();
  }
}

std::uint64_t BusListener::take_error_reports() noexcept {
  const std::uint64_t before = reports_;
  reports_ = interface_ == nullptr ? 0 : interface_->statistics().error_frames;
  return reports_ - before;
}

}  // namespace gaitway::tools
