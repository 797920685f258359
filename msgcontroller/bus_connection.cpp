// The bus as the message controller's process meets it: one of two ports, claimed for one message controller,
// and what people are told when it goes and comes back.
#include "bus_connection.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr mode_t kOwnerOnly = 0600;

[[noreturn]] void refuse_second(const std::string& bus) {
  throw std::runtime_error(fmt::format(
      "another message controller is on the bus {}: two of them would talk across each other. End "
      "that one first, or choose another bus",
      bus));
}

// A lock that goes with its process, however that ends.
process::FileDescriptor lock_beside(const std::filesystem::path& socket) {
  const std::string path = socket.native() + ".message_controller.lock";
  process::FileDescriptor lock(open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, kOwnerOnly));
  if (!lock) {
    throw can::BusError(
        fmt::format("bus socket '{}': cannot make '{}': {}", socket.native(), path, std::strerror(errno)));
  }
  if (flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    refuse_second(socket.native());
  }
  return lock;
}

// An abstract name belongs to a network namespace, as an interface does.
process::FileDescriptor lock_interface(const std::string& interface) {
  const std::string name = "gaitway message_controller " + interface;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::size_t length = std::min(name.size(), sizeof address.sun_path - 1);
  std::copy_n(name.begin(), length, address.sun_path + 1);
  process::FileDescriptor lock(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
  if (lock && bind(lock.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0 &&
      errno == EADDRINUSE) {
    refuse_second(interface);
  }
  return lock;
}

}  // namespace

std::string BusNews::tell(std::string line, std::int64_t now_ns) {
  if (now_ns - second_ns_ >= facts::kSecond_ns) {
    second_ns_ = now_ns;
    told_ = 0;
  }
  if (told_ >= kLinesASecond) {
    if (!line.empty()) {
      newest_ = std::move(line);
      ++kept_back_;
    }
    return {};
  }
  if (kept_back_ > 0) {
    line = (line.empty() ? newest_ : line) + fmt::format(" ({} lines were kept back)", kept_back_);
    kept_back_ = 0;
  }
  told_ += line.empty() ? 0 : 1;
  return line;
}

BusConnection::BusConnection(const BusChoice& choice) {
  claim(choice);
  if (choice.interface.empty()) {
    socket_ = choice.socket;
    client_.emplace(choice.socket, "message", can::Pace::kept);
    return;
  }
  can::SocketCanOptions options;
  options.transmit_buffers = 1;  // the message controller's own queue knows priorities and deadlines
  if (!choice.sent_log.empty()) {
    constexpr std::uint64_t kSentLog_bytes = std::uint64_t{256} << 20;  // some 50 minutes
    options.sent_log = &sent_log_.emplace(
        choice.sent_log, can::CandumpOptions{.in_real_time = true,
                                             .start = process::LogOptions::Start::go_on,
                                             .most_bytes = kSentLog_bytes,
                                             .tell = process::tell_on_stderr("message_controller")});
  }
  interface_.emplace(choice.interface, options);
}

void BusConnection::claim(const BusChoice& choice) {
  if (!choice.interface.empty()) {
    claim_ = lock_interface(choice.interface);
  } else if (std::filesystem::exists(choice.socket.parent_path().empty() ? "."
                                                                         : choice.socket.parent_path())) {
    claim_ = lock_beside(choice.socket);
  }  // else nobody serves it: that is said when it is connected to
}

can::BusPort& BusConnection::port() noexcept {
  if (interface_) {
    return *interface_;
  }
  return *client_;
}

void BusConnection::report(std::int64_t now_ns) {
  const bool is_off = port().state() >= can::BusState::bus_off;
  std::string line = news(is_off, now_ns);
  if (is_off && !was_off_) {
    ++outages_;
    off_since_ns_ = now_ns;
  } else if (was_off_ && !is_off) {
    away_ns_ += now_ns - off_since_ns_;
  }
  was_off_ = is_off;
  if (line = news_.tell(std::move(line), now_ns); !line.empty()) {
    fmt::print(stderr, "message_controller: {}\n", line);
  }
}

std::string BusConnection::news(bool is_off, std::int64_t now_ns) {
  const double away_s = static_cast<double>(now_ns - off_since_ns_) * 1e-9;
  if (interface_) {
    std::string line = reporter_.news(*interface_);
    return !line.empty() && was_off_ && !is_off ? line + fmt::format(" It was away for {:.1f} s", away_s)
                                                : line;
  }
  const bool was_served = std::exchange(is_served_, client_->connected());
  const bool has_gone_meanwhile = is_off && was_served && !is_served_;  // it had only stood still
  if (is_off == was_off_ && !has_gone_meanwhile) {
    return {};
  }
  if (!is_off) {
    return fmt::format("the bus on {} is back after {:.1f} s", socket_.native(), away_s);
  }
  return is_served_ ? fmt::format("the bus on {} stands still: waiting for it. Is virtual_robot stopped?",
                                  socket_.native())
                    : fmt::format("the bus on {} has gone: waiting for it. Has virtual_robot ended?",
                                  socket_.native());
}

void BusConnection::close() {
  if (interface_) {
    can::finish_sending(*interface_);
  }
  if (sent_log_) {
    sent_log_->finish();
  }
}

std::optional<process::LogCount> BusConnection::sent_log() const noexcept {
  return sent_log_ ? std::optional(sent_log_->count()) : std::nullopt;
}

}  // namespace gaitway::msgcontroller
