// A WebSocket client as others have it: Beast's, blocking, plain or over TLS.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitway::api {

// What a client over TLS says first, all of it: its server has the dear part of the handshake to do then.
[[nodiscard]] std::string client_hello();

class WebSocketClient {
 public:
  using Headers = std::vector<std::pair<std::string, std::string>>;
  struct Options {
    Headers headers;
    bool tls = false;
    int highest_tls = 0;  // OpenSSL's number; 0: any
    std::string target = "/";
  };

  // Throws std::runtime_error (boost::system::system_error) when the handshake fails.
  explicit WebSocketClient(std::uint16_t port);
  WebSocketClient(std::uint16_t port, const Options& options);
  ~WebSocketClient();

  void send(std::string_view message, bool binary = false);
  // In fragments of so many bytes.
  void send_in_fragments(std::string_view message, std::size_t bytes);
  struct Message {
    std::string text;
    bool binary = false;
  };
  Message receive();
  // Takes and forgets messages until the server closes; gives the close frame's code, 0 without one.
  unsigned receive_close();
  void close();

 private:
  class Impl;
  template <class Stream>
  class Over;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitway::api
