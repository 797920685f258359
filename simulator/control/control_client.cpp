// One connection, and what waits for its answer on it.
#include "gaitway/simulation/control_client.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>
#include <sstream>
#include <utility>

#include "gaitway/process/listening_socket.hpp"

namespace gaitway::simulation {
namespace {

constexpr std::size_t kMostWaiting = 256;
constexpr int kAnswersAStep = 64;

// "2 s", "0.5 s".
std::string in_seconds(std::int64_t duration_ns) {
  std::ostringstream text;
  text << static_cast<double>(duration_ns) / static_cast<double>(facts::kSecond_ns) << " s";
  return text.str();
}

}  // namespace

ControlClient::ControlClient(std::filesystem::path socket) : path_(std::move(socket)) {
  static_cast<void>(process::socket_address(path_));  // refuses a bad path before anybody asks
}

std::uint32_t ControlClient::push(const Push& push, std::int64_t now_ns) {
  return ask(request_of(push, next_number()), now_ns, kPatience_ns);
}

std::uint32_t ControlClient::order(std::string_view json, std::int64_t now_ns, std::int64_t patience_ns) {
  return ask(request_of(json, next_number()), now_ns, patience_ns);
}

std::uint32_t ControlClient::ask(const Request& request, std::int64_t now_ns, std::int64_t patience_ns) {
  last_number_ = request.number;
  receive();  // and so notices a simulator that has ended
  if (!socket_) {
    connect(now_ns);
  }
  if (!socket_) {
    refuse(last_number_, "the simulator is not there: " + absent_);
    return last_number_;
  }
  const Packet packet = encode(request);
  const bool sent = waiting_.size() < kMostWaiting &&
                    send(socket_.get(), packet.data(), packet.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
                        static_cast<ssize_t>(packet.size());
  if (sent) {
    waiting_.push_back({last_number_, now_ns + patience_ns, patience_ns});
  } else {
    refuse(last_number_, "the simulator takes nothing now: too much waits for it; try again");
  }
  return last_number_;
}

void ControlClient::step(std::int64_t now_ns) {
  receive();
  std::erase_if(waiting_, [&](const Waiting& request) {
    const bool late = now_ns >= request.until_ns;
    if (late) {
      refuse(request.number, "the simulator has not answered within " + in_seconds(request.patience_ns) +
                                 "; whether it did it is not known");
    }
    return late;
  });
  if (!socket_ && (!tried_ns_ || now_ns - *tried_ns_ >= kBetweenTries_ns)) {
    connect(now_ns);
  }
}

std::optional<Answer> ControlClient::take_answer() {
  if (answers_.empty()) {
    return std::nullopt;
  }
  Answer answer = std::move(answers_.front());
  answers_.pop_front();
  return answer;
}

void ControlClient::connect(std::int64_t now_ns) {
  tried_ns_ = now_ns;
  process::FileDescriptor made(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const sockaddr_un address = process::socket_address(path_);
  if (!made || ::connect(made.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    absent_ = "socket '" + path_.native() + "': " + std::strerror(errno);
    return;
  }
  socket_ = std::move(made);
}

void ControlClient::receive() {
  bool reset = false;
  for (int i = 0; socket_ && i < kAnswersAStep; ++i) {
    const ssize_t size = recv(socket_.get(), packet_.data(), packet_.size(), MSG_DONTWAIT | MSG_TRUNC);
    // A server that hangs up without having read all resets the connection, and what it has said before is
    // there once that has been told.
    if (size < 0 && errno == ECONNRESET && !std::exchange(reset, true)) {
      continue;
    }
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
      return;
    }
    if (size <= 0) {
      return disconnect("the simulator has ended before it answered");
    }
    const auto bytes = static_cast<std::size_t>(size);
    auto answer = bytes <= packet_.size() ? decode_answer(std::span(packet_).first(bytes)) : std::nullopt;
    if (!answer) {
      return disconnect(
          "the simulator speaks another version of the protocol: run both from the same release");
    }
    take(std::move(*answer));
  }
}

void ControlClient::take(Answer answer) {
  if (answer.number == 0) {
    return disconnect(answer.text);
  }
  const auto request = std::ranges::find(waiting_, answer.number, &Waiting::number);
  if (request != waiting_.end()) {
    waiting_.erase(request);
    answers_.push_back(std::move(answer));
  }
}

void ControlClient::disconnect(const std::string& why) {
  socket_ = process::FileDescriptor();
  for (const Waiting& request : std::exchange(waiting_, {})) {
    refuse(request.number, why);
  }
}

}  // namespace gaitway::simulation
