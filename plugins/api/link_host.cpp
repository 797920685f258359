// Accepts, turns away, and says so.
#include "gaitway/api/link_host.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <utility>

#include "gaitway/link/frame_codec.hpp"
#include "gaitway/link/messages.hpp"
#include "gaitway/link/serial_carrier.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::api {
namespace {

// For texts: " (process 4711)"; empty: it is not known.
std::string process_of(const process::FileDescriptor& connection) {
  ucred peer{};
  socklen_t size = sizeof peer;
  const bool known =
      getsockopt(connection.get(), SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.pid != 0;
  return known ? fmt::format(" (process {})", peer.pid) : std::string();
}

}  // namespace

LinkHost::LinkHost(const link::LinkAddress& address) : address_(address) {
  if (address.kind == link::LinkAddress::Kind::serial) {
    open_line();
  } else {
    listener_.emplace(address.path, "api");
  }
}

void LinkHost::open_line() {
  auto line = std::make_unique<link::SerialCarrier>(address_.path, address_.baud);
  wake_fd_ = line->wake_fd();
  carrier_ = std::move(line);
}

// Adapters are pulled out, and plugged in again.
void LinkHost::open_line_again(std::int64_t now_ns) {
  constexpr std::int64_t kBetweenTries_ns = 50 * facts::kMillisecond_ns;
  if (now_ns - tried_ns_ < kBetweenTries_ns) {
    return;
  }
  tried_ns_ = now_ns;
  try {
    open_line();
    line_error_.clear();
  } catch (const link::SerialError& error) {
    if (line_error_ != error.what()) {
      line_error_ = report_ = error.what();
    }
  }
}

void LinkHost::wait(int most_ms) {
  constexpr int kWakes = 4;
  const std::int64_t now_ns = process::monotonic_ns();
  if (now_ns - wakes_since_ns_ >= facts::kMillisecond_ns) {
    wakes_since_ns_ = now_ns;
    wakes_ = 0;
  }
  if (++wakes_ > kWakes) {
    const timespec left{0, wakes_since_ns_ + facts::kMillisecond_ns - now_ns};
    ppoll(nullptr, 0, &left, nullptr);
    return;
  }
  std::array<pollfd, 2> wakes{pollfd{wake_fd_, POLLIN, 0},  // -1 is left out
                              pollfd{listener_ ? listener_->wake_fd() : -1, POLLIN, 0}};
  poll(wakes.data(), wakes.size(), most_ms);
}

void LinkHost::pump(link::ControllerEnd& end, std::int64_t now_ns) {
  if (listener_) {
    accept(end, now_ns);
  } else if (carrier_ == nullptr) {
    open_line_again(now_ns);
  }
  if (carrier_ != nullptr) {
    link::pump(end, *carrier_, now_ns);
    if (!carrier_->connected()) {
      carrier_.reset();
      wake_fd_ = -1;
    }
  } else {
    end.step(now_ns);
  }
  follow_session(end, now_ns);
}

void LinkHost::accept(link::ControllerEnd& end, std::int64_t now_ns) {
  constexpr int kMostAtOnce = 4;
  for (int i = 0; i < kMostAtOnce; ++i) {
    process::FileDescriptor connection = listener_->accept();
    if (!connection) {
      return;
    }
    if (carrier_ != nullptr && end.session().open()) {
      link::pump(end, *carrier_, now_ns);  // perhaps it has just gone
      if (carrier_->connected()) {
        turn_away(std::move(connection), end, now_ns);
        continue;
      }
    }
    end.cut(now_ns);
    auto carrier = std::make_unique<link::UnixCarrier>(std::move(connection));
    wake_fd_ = carrier->wake_fd();
    carrier_ = std::move(carrier);
  }
}

void LinkHost::turn_away(process::FileDescriptor connection, const link::ControllerEnd& end,
                         std::int64_t now_ns) {
  const std::string who = process_of(connection);
  std::array<std::uint8_t, link::kMostContentBytes> content{};
  std::array<std::uint8_t, link::kMostFrameBytes> frame{};
  const std::size_t size = link::encode(end.session().refusal_of_another(), content);
  const std::size_t bytes = link::encode_frame(link::Bytes(content).first(size), frame);
  link::UnixCarrier(std::move(connection)).write(link::Bytes(frame).first(bytes));
  tell_refusal(
      fmt::format("another user interface module{} wants the link that '{}' has, and was turned away: "
                  "a robot has one; end one of the two",
                  who, end.session().peer_name()),
      now_ns);
}

void LinkHost::follow_session(const link::ControllerEnd& end, std::int64_t now_ns) {
  const std::uint32_t session = end.session().open() ? end.session().count() : 0;
  const bool refused_anew = std::exchange(refusals_, end.session().refusals()) != end.session().refusals();
  if (std::exchange(session_, session) == session) {
    if (refused_anew && link::is_refusal(end.session().why())) {
      tell_refusal(fmt::format("no link to the user interface module: {}", end.session().description()),
                   now_ns);
    }
    return;
  }
  refusal_.clear();
  report_ = session != 0 ? fmt::format("linked to '{}'", end.session().peer_name())
                         : fmt::format("the link to the user interface module is lost: {}",
                                       end.session().description());
}

void LinkHost::tell_refusal(std::string text, std::int64_t now_ns) {
  constexpr std::int64_t kBetween_ns = facts::kSecond_ns, kBetweenTheSame_ns = 60 * facts::kSecond_ns;
  const std::int64_t since_ns = now_ns - refusal_told_ns_;
  if (refusal_.empty() || since_ns >= (text == refusal_ ? kBetweenTheSame_ns : kBetween_ns)) {
    refusal_told_ns_ = now_ns;
    report_ = refusal_ = std::move(text);
  }
}

std::string LinkHost::take_report() {
  return std::exchange(report_, {});
}

}  // namespace gaitway::api
