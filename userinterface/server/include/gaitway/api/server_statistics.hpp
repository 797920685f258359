// What became of every connection, and what went through them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gaitway::api {

// Why a connection never became a WebSocket.
enum class Refusal : std::uint8_t {
  too_many,        // 503, or no answer when even those that wait for one are too many, or gave way to another
  bad_request,     // 400, 405, 431
  wrong_path,      // 404
  no_websocket,    // 426
  foreign_origin,  // 403
  wrong_token,     // 401
  other_page,      // 409: a page of another version
  tls,             // the TLS handshake failed
  handshake_time,  // too slow
  left             // the client went away first
};
inline constexpr std::size_t kRefusalCount = 10;

// Why a WebSocket ended.
enum class Closing : std::uint8_t {
  by_client,       // it closed properly
  by_session,      // the conversation asked for it
  protocol_error,  // 1002, 1007
  too_big,         // 1009
  flood,           // of pings or pongs
  slow,            // did not take what was written to it
  silent,          // no sign of life
  lost,            // reset, or ended without a close frame
  refused,         // the hub has no place for it, or it gave way to another before it was authorised
  shut_down        // the server stops
};
inline constexpr std::size_t kClosingCount = 10;

struct ServerStatistics {
  std::uint64_t accepted = 0;  // TCP connections
  std::uint64_t accept_errors = 0;
  std::size_t connected = 0;  // now, with those that are still in their handshake or closing
  std::uint64_t opened = 0;   // WebSockets
  std::uint64_t pages = 0;    // answers to browsers
  std::uint64_t messages_in = 0, bytes_in = 0;
  std::uint64_t control_frames = 0;  // pings and pongs of clients
  std::uint64_t messages_out = 0, bytes_out = 0;
  std::uint64_t writes = 0;  // system calls or TLS writes for them: several messages share one
  std::array<std::uint64_t, kRefusalCount> refused{};
  std::array<std::uint64_t, kClosingCount> closed{};

  [[nodiscard]] std::uint64_t of(Refusal cause) const noexcept {
    return refused[static_cast<std::size_t>(cause)];
  }
  [[nodiscard]] std::uint64_t of(Closing cause) const noexcept {
    return closed[static_cast<std::size_t>(cause)];
  }
  void count(Refusal cause) noexcept { ++refused[static_cast<std::size_t>(cause)]; }
  void count(Closing cause) noexcept { ++closed[static_cast<std::size_t>(cause)]; }
};

}  // namespace gaitway::api
