// Blocking sockets: what never comes makes the test time out.
#include "raw_client.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace gaitway::api {
namespace {

constexpr std::array<char, 4> kMask{'\x37', '\x12', '\x55', '\x0A'};

unsigned byte(char c) {
  return static_cast<unsigned char>(c);
}

}  // namespace

RawClient::RawClient(std::uint16_t port)
    : RawClient(process::FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)), port) {}

RawClient::RawClient(process::FileDescriptor socket, std::uint16_t port) : socket_(std::move(socket)) {
  sockaddr_in server{};
  server.sin_family = AF_INET;
  server.sin_port = htons(port);
  server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_.get(), reinterpret_cast<const sockaddr*>(&server), sizeof server) != 0) {
    throw std::system_error(errno, std::generic_category(), "connect");
  }
}

bool RawClient::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool RawClient::has_answer() const {
  pollfd readable{socket_.get(), POLLIN, 0};
  return poll(&readable, 1, 0) == 1;
}

bool RawClient::receive_some() {
  std::array<char, 65536> buffer;
  const ssize_t got = recv(socket_.get(), buffer.data(), buffer.size(), 0);
  if (got > 0) {
    received_.append(buffer.data(), static_cast<std::size_t>(got));
  }
  return got > 0;
}

std::string RawClient::take(std::size_t bytes) {
  std::string taken = received_.substr(0, bytes);
  received_.erase(0, bytes);
  return taken;
}

std::string RawClient::receive_all() {
  while (receive_some()) {
  }
  return take(received_.size());
}

std::string RawClient::receive_header() {
  std::size_t end = 0;
  while ((end = received_.find("\r\n\r\n")) == std::string::npos) {
    if (!receive_some()) {
      return take(received_.size());
    }
  }
  return take(end + 4);
}

std::optional<RawClient::Message> RawClient::receive_frame() {
  const auto have = [this](std::size_t bytes) {
    while (received_.size() < bytes) {
      if (!receive_some()) {
        return false;
      }
    }
    return true;
  };
  while (have(2)) {
    const unsigned opcode = byte(received_[0]);
    std::size_t size = byte(received_[1]), header = 2;
    const std::size_t further = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (!have(header + further)) {
      return std::nullopt;
    }
    if (further > 0) {
      size = 0;
      for (std::size_t at = 0; at < further; ++at) {
        size = size << 8U | byte(received_[header + at]);
      }
      header += further;
    }
    if (!have(header + size)) {
      return std::nullopt;
    }
    static_cast<void>(take(header));
    Message message{opcode, take(size)};
    if (opcode != kPing) {
      return message;
    }
    newest_ping_ = std::move(message.payload);
  }
  return std::nullopt;
}

std::string RawClient::open_websocket() {
  send(upgrade_request());
  return receive_header();
}

void RawClient::reset() {
  const linger at_once{1, 0};
  setsockopt(socket_.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  socket_ = process::FileDescriptor();
}

void RawClient::finish_sending() {
  shutdown(socket_.get(), SHUT_WR);
}

std::string upgrade_request(std::string_view more, std::string_view target) {
  return "GET " + std::string(target) +
         " HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
         "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
         std::string(more) + "\r\n";
}

std::string masked_frame(unsigned first, std::string_view payload) {
  std::string frame(1, static_cast<char>(first));
  const std::size_t size = payload.size();
  const int further = size < 126 ? 0 : size < 65536 ? 2 : 8;
  frame += static_cast<char>(0x80U | (further == 0 ? size : further == 2 ? 126U : 127U));
  for (int at = further; at-- > 0;) {
    frame += static_cast<char>((size >> (8U * static_cast<unsigned>(at))) & 0xFFU);
  }
  frame.append(kMask.data(), kMask.size());
  for (std::size_t at = 0; at < size; ++at) {
    frame += static_cast<char>(byte(payload[at]) ^ byte(kMask[at % kMask.size()]));
  }
  return frame;
}

unsigned close_code(const RawClient::Message& message) {
  return message.opcode == kClose && message.payload.size() >= 2
             ? byte(message.payload[0]) << 8U | byte(message.payload[1])
             : 0;
}

std::string close_reason(const RawClient::Message& message) {
  return message.payload.size() >= 2 ? message.payload.substr(2) : "";
}

}  // namespace gaitway::api
