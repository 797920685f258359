// One connection at a time, never blocking.
#include "tools/robot/keeper/page_probe.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <memory>
#include <utility>

#include "tools/robot/keeper/port_owner.hpp"

namespace gaitway::tools {
namespace {

bool is_ready(int descriptor, short events) {
  pollfd one{descriptor, events, 0};
  return poll(&one, 1, 0) > 0;
}

}  // namespace

bool port_is_taken(const std::string& address, int port) {
  addrinfo wanted{};
  wanted.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) return false;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> place(found, freeaddrinfo);
  const process::FileDescriptor listener(socket(place->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const int reuse = 1;  // a connection that has just ended takes no port
  setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &reuse, sizeof reuse);
  return listener &&
         (bind(listener.get(), place->ai_addr, place->ai_addrlen) != 0 || listen(listener.get(), 1) != 0) &&
         errno == EADDRINUSE;
}

PageProbe::PageProbe(std::string address, int port) : address_(std::move(address)), port_(port) {
  if (address_ == "0.0.0.0") address_ = "127.0.0.1";
  if (address_ == "::") address_ = "::1";
}

std::uint64_t PageProbe::step(std::int64_t now_ns, pid_t process) {
  if (connection_) {
    look(now_ns, process);
  } else if (now_ns >= due_ns_) {
    ask(now_ns);
  }
  return answers_;
}

void PageProbe::ask(std::int64_t now_ns) {
  begin_ns_ = now_ns;
  due_ns_ = now_ns + kBetween_ns;
  asked_ = false;
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
  wanted.ai_socktype = SOCK_STREAM;
  if (getaddrinfo(address_.c_str(), std::to_string(port_).c_str(), &wanted, &found) != 0) return;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> address(found, &freeaddrinfo);
  connection_ =
      process::FileDescriptor(socket(found->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  static_cast<void>(connect(connection_.get(), found->ai_addr, found->ai_addrlen));
}

std::string PageProbe::take_stranger() {
  return std::exchange(stranger_is_news_, false) ? stranger_ : std::string();
}

void PageProbe::look(std::int64_t now_ns, pid_t process) {
  if (!asked_ && is_ready(connection_.get(), POLLOUT)) {
    const std::string host = address_.find(':') == std::string::npos ? address_ : "[" + address_ + "]";
    const std::string request =
        fmt::format("HEAD / HTTP/1.1\r\nHost: {}:{}\r\nConnection: close\r\n\r\n", host, port_);
    asked_ = send(connection_.get(), request.data(), request.size(), MSG_NOSIGNAL) ==
             static_cast<ssize_t>(request.size());
    if (!asked_) connection_ = process::FileDescriptor();  // nobody listens there
    return;
  }
  if (asked_ && is_ready(connection_.get(), POLLIN)) {
    std::array<char, 16> answer{};
    if (recv(connection_.get(), answer.data(), answer.size(), 0) > 0) on_answer(process);
    connection_ = process::FileDescriptor();
  } else if (now_ns - begin_ns_ >= kPatience_ns) {
    connection_ = process::FileDescriptor();
  }
}

// Whoever is not allowed to know whose page it was, believes it.
void PageProbe::on_answer(pid_t process) {
  const bool is_own = listens(process, port_).value_or(true);
  if (is_own) ++answers_;
  const std::string stranger = is_own ? std::string() : describe_listener(port_);
  stranger_is_news_ = !stranger.empty() && (stranger_is_news_ || stranger != stranger_);
  stranger_ = stranger;
}

}  // namespace gaitway::tools
