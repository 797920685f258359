// What waits to be written to one client: whole WebSocket frames, the payloads shared with other clients.
#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>

#include "gaitway/api/session.hpp"

namespace gaitway::api {

class OutgoingQueue {
 public:
  // As many as one call of the kernel takes of them: header and payload of each frame.
  static constexpr std::size_t kBuffers = 64;
  using Gathered = std::span<const boost::asio::const_buffer>;

  // A message of a session, as one unmasked frame (RFC 6455, 5.2).
  void append(Frame frame);
  // Bytes that are complete already: HTTP answers and control frames, copied.
  void append_raw(std::string bytes);

  // The next bytes to write, valid until the next call of gather() or consume(), and as long as nothing is
  // dropped.
  [[nodiscard]] Gathered gather();
  struct Progress {
    bool finished_any = false;
    bool finished_raw = false;
  };
  // So many of them have been written.
  Progress consume(std::size_t bytes);
  // Keeps only what gather() has given out last, or has been written in part, and raw bytes.
  void drop_messages(bool keep_gathered);

  [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
  [[nodiscard]] std::size_t frames() const noexcept { return items_.size(); }
  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }

 private:
  struct Item {
    std::array<char, 10> header{};
    std::uint8_t header_bytes = 0;
    bool raw = false;
    std::shared_ptr<const std::string> payload;
  };

  std::deque<Item> items_;
  std::array<boost::asio::const_buffer, kBuffers> gathered_;
  std::size_t gathered_items_ = 0;
  std::size_t written_of_first_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace gaitway::api
