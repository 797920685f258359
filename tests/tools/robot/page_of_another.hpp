// A page of this process's: it answers whoever asks at its port.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <string_view>
#include <thread>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::test {

class PageOfAnother {
 public:
  PageOfAnother() {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    EXPECT_EQ(bind(listener_.get(), reinterpret_cast<const sockaddr*>(&place), size), 0);
    EXPECT_EQ(listen(listener_.get(), 4), 0);
    EXPECT_EQ(getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&place), &size), 0);
    port_ = ntohs(place.sin_port);
    answers_ = std::jthread([this](const std::stop_token& stop) { answer(stop); });
  }
  [[nodiscard]] int port() const noexcept { return port_; }

 private:
  void answer(const std::stop_token& stop) const {
    while (!stop.stop_requested()) {
      pollfd come{listener_.get(), POLLIN, 0};
      constexpr int kBetweenLooks_ms = 20;
      if (poll(&come, 1, kBetweenLooks_ms) <= 0) continue;
      const process::FileDescriptor client(accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      std::array<char, 512> asked{};
      if (recv(client.get(), asked.data(), asked.size(), 0) <= 0) continue;
      constexpr std::string_view kAnswer = "HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n";
      static_cast<void>(send(client.get(), kAnswer.data(), kAnswer.size(), MSG_NOSIGNAL));
    }
  }

  process::FileDescriptor listener_{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  int port_ = 0;
  std::jthread answers_;
};

}  // namespace gaitway::test
