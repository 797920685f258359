// Connects, pumps, waits.
#include "gaitway/api/link_thread.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "gaitway/link/serial_carrier.hpp"
#include "gaitway/link/unix_carrier.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::api {
namespace {

constexpr int kPeriod_ms = 2;
constexpr std::int64_t kBetweenTries_ns = 50 * facts::kMillisecond_ns;

}  // namespace

LinkThread::LinkThread(ModuleLink& link, link::LinkAddress address,
                       std::function<void(const std::string&)> tell)
    : link_(link),
      address_(std::move(address)),
      tell_(std::move(tell)),
      wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      watch_(address_, process::monotonic_ns()) {
  if (!wake_) {
    throw std::system_error(errno, std::generic_category(), "no descriptor to wake the link's thread");
  }
  link_.on_urgent([fd = wake_.get()] {
    const std::uint64_t one = 1;
    static_cast<void>(!write(fd, &one, sizeof one));  // full: it is awake
  });
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LinkThread::~LinkThread() {
  thread_.request_stop();
  thread_.join();
  link_.on_urgent({});
}

void LinkThread::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    wait();
    const std::int64_t now_ns = process::monotonic_ns();
    if (carrier_ == nullptr && now_ns - tried_ns_ >= kBetweenTries_ns) {
      connect(now_ns);
    }
    link_.pump(carrier_.get(), now_ns);
    watch(now_ns);
    if (carrier_ != nullptr && !carrier_->connected()) {
      carrier_.reset();
      carrier_fd_ = -1;
    }
  }
}

void LinkThread::wait() const {
  std::array<pollfd, 2> wakes{pollfd{wake_.get(), POLLIN, 0},
                              pollfd{carrier_fd_, POLLIN, 0}};  // -1 is left out
  poll(wakes.data(), wakes.size(), kPeriod_ms);
  std::uint64_t ignored = 0;
  static_cast<void>(!read(wake_.get(), &ignored, sizeof ignored));
}

void LinkThread::connect(std::int64_t now_ns) {
  tried_ns_ = now_ns;
  try {
    if (address_.kind == link::LinkAddress::Kind::serial) {
      auto serial = std::make_unique<link::SerialCarrier>(address_.path, address_.baud);
      carrier_fd_ = serial->wake_fd();
      carrier_ = std::move(serial);
    } else {
      auto connection = std::make_unique<link::UnixCarrier>(address_.path);
      carrier_fd_ = connection->wake_fd();
      carrier_ = std::move(connection);
    }
    error_.clear();
  } catch (const std::exception& error) {
    error_ = error.what();
  }
}

void LinkThread::watch(std::int64_t now_ns) {
  const bool open = link_.open();
  const LinkSight sight{.open = open,
                        .same_calibration = link_.same_calibration(),
                        .why = link_.why(),
                        .description = open ? std::string() : link_.description(),
                        .error = error_};
  std::optional<std::string> line;
  {
    const std::scoped_lock lock(mutex_);
    line = watch_.look(sight, now_ns);
  }
  if (line) {
    tell_(*line);
  }
}

LinkReport LinkThread::report() const {
  const std::scoped_lock lock(mutex_);
  return watch_.report();
}

}  // namespace gaitway::api
