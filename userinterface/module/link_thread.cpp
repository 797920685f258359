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
// So long without a session, and people are told why.
constexpr std::int64_t kPatience_ns = facts::kSecond_ns;

}  // namespace

LinkThread::LinkThread(ModuleLink& link, link::LinkAddress address,
                       std::function<void(const std::string&)> tell)
    : link_(link),
      address_(std::move(address)),
      tell_(std::move(tell)),
      wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
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
  closed_ns_ = process::monotonic_ns();
  while (!stop.stop_requested()) {
    wait();
    const std::int64_t now_ns = process::monotonic_ns();
    if (carrier_ == nullptr && now_ns - tried_ns_ >= kBetweenTries_ns) {
      connect(now_ns);
    }
    link_.pump(carrier_.get(), now_ns);
    follow_session(now_ns);
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
  } catch (const std::exception& error) {
    if (told_ != error.what() && now_ns - closed_ns_ > kPatience_ns) {
      told_ = error.what();
      tell_(told_);
    }
  }
}

void LinkThread::follow_session(std::int64_t now_ns) {
  const bool open = link_.open();
  if (open != std::exchange(open_, open)) {
    closed_ns_ = now_ns;
    complained_ = false;
    told_.clear();
    tell_(open ? "linked to the main controller"
               : "the link to the main controller is lost: " + link_.description());
  }
  const bool says_why = carrier_ != nullptr || link_.why() == link::SessionEnd::occupied;
  if (!open && !complained_ && says_why && now_ns - closed_ns_ > kPatience_ns) {
    complained_ = true;
    tell_("no link to the main controller: " + link_.description());
  }
}

}  // namespace gaitway::api
