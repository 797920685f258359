// One of two ports.
#include "bus_connection.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "gaitway/can/bus_port.hpp"

namespace gaitway::msgcontroller {

BusConnection::BusConnection(const BusChoice& choice) {
  if (choice.interface.empty()) {
    client_.emplace(choice.socket, "message", can::Pace::kept);
    return;
  }
  can::SocketCanOptions options;
  options.transmit_buffers = 1;  // the message controller's own queue knows priorities and deadlines
  if (!choice.sent_log.empty()) {
    options.sent_log = &sent_log_.emplace(choice.sent_log);
  }
  interface_.emplace(choice.interface, options);
}

can::BusPort& BusConnection::port() noexcept {
  if (interface_) {
    return *interface_;
  }
  return *client_;
}

void BusConnection::report() {
  if (!interface_) {
    return;
  }
  if (const std::string news = reporter_.news(*interface_); !news.empty()) {
    fmt::print(stderr, "message_controller: {}\n", news);
  }
}

void BusConnection::close() {
  if (interface_) {
    can::finish_sending(*interface_);
  }
  if (sent_log_) {
    sent_log_->close();
  }
}

}  // namespace gaitway::msgcontroller
