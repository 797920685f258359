// A TCP client that sends any bytes, for what no WebSocket library would send.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::api {

class RawClient {
 public:
  struct Message {
    unsigned opcode = 0;
    std::string payload;
  };

  explicit RawClient(std::uint16_t port);
  // A socket of the caller's.
  RawClient(process::FileDescriptor socket, std::uint16_t port);

  // False when the server has closed.
  bool send(std::string_view bytes);
  // Whether the server has sent something that nobody has taken.
  [[nodiscard]] bool has_answer() const;
  // All until the server closes.
  std::string receive_all();
  // The answer to the handshake, up to its empty line.
  std::string receive_header();
  // The next frame that is no ping, nothing at the end of the stream.
  std::optional<Message> receive_frame();
  // Of the newest ping that came meanwhile: it is answered by nobody.
  [[nodiscard]] const std::string& newest_ping() const noexcept { return newest_ping_; }
  // Sends a valid request for a WebSocket, and takes the answer.
  std::string open_websocket();
  void reset();  // ends the connection as a crashed machine's kernel would
  void finish_sending();

 private:
  bool receive_some();
  std::string take(std::size_t bytes);

  process::FileDescriptor socket_;
  std::string received_, newest_ping_;
};

// A request for a WebSocket; `more`: further header lines, each with its line end.
[[nodiscard]] std::string upgrade_request(std::string_view more = "", std::string_view target = "/");
// A frame as a client sends it: `first`: FIN, reserved bits and opcode.
[[nodiscard]] std::string masked_frame(unsigned first, std::string_view payload);
// Code and reason of a close frame.
[[nodiscard]] unsigned close_code(const RawClient::Message& message);
[[nodiscard]] std::string close_reason(const RawClient::Message& message);

inline constexpr unsigned kText = 0x81, kBinary = 0x82, kClose = 0x88, kPing = 0x89, kPong = 0x8A;

}  // namespace gaitway::api
