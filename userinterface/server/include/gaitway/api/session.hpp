// One client's conversation, without a network: messages in, frames out. A server calls it; tests and fuzzers
// do the same.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace gaitway::api {

// One WebSocket message on its way out. Shared by all subscribers that get the same.
struct Frame {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
};

// What a session asks of its connection. Called from within the session's and the hub's own calls, so neither
// call may destroy a session.
class Connection {
 public:
  virtual ~Connection() = default;
  // Frames wait: ask next_frame() until it gives none, one after the other as each has been written.
  virtual void wake() noexcept = 0;
  // Close after what waits has been written, at the latest after a short while. `reason`: for people, at most
  // 123 bytes; `code`: of the WebSocket protocol (1008 policy violation, 1009 too big, 1013 try again later).
  virtual void close(std::uint16_t code, std::string_view reason) noexcept = 0;
  // So long ago, at most, the client sent the message that is being taken: it sent it after it had answered a
  // ping of then. 0: as good as now.
  [[nodiscard]] virtual std::int64_t message_age_ns(std::int64_t /*wall_ns*/) const noexcept { return 0; }
  // The client has shown a token that is not the right one: what it is told from now on may come later.
  virtual void shown_wrong_token() noexcept = 0;
};

// Whether a message must not wait for those before it. An emergency waits for nothing that is urgent, either.
enum class Urgency : std::uint8_t { none, urgent, emergency };

class Session {
 public:
  virtual ~Session() = default;
  // A whole message that arrived. Never throws for what a client sends.
  virtual void take(std::string_view message, bool binary, std::int64_t wall_ns) = 0;
  // The same, when an urgent message that came after it has been taken already.
  virtual void take_overtaken(std::string_view message, bool binary, std::int64_t wall_ns) = 0;
  // Of a stop, say. Cheap, whatever the message is.
  [[nodiscard]] virtual Urgency urgency(std::string_view message, bool binary) const noexcept = 0;
  // The next frame to write.
  virtual std::optional<Frame> next_frame(std::int64_t wall_ns) = 0;
  // Whether it gives orders, so that it must be known how old its messages are.
  [[nodiscard]] virtual bool gives_orders() const noexcept { return false; }
  // Whether it ever will. Who never does is not pinged while it sends something else.
  [[nodiscard]] virtual bool may_give_orders() const noexcept { return true; }
  // Whether the client has shown that it may be here.
  [[nodiscard]] virtual bool authorised() const noexcept = 0;
};

// All sessions together. The server opens one for each connection whose handshake succeeded, and drops it
// when the connection ends, for whatever reason.
class SessionHub {
 public:
  virtual ~SessionHub() = default;
  // `peer`: for events and diagnostics. `authorised`: the handshake carried the token, or none is wanted.
  // Nothing when there are too many.
  virtual std::unique_ptr<Session> open(Connection& connection, std::string peer, bool authorised,
                                        std::int64_t wall_ns) = 0;
  // Time passes: time-outs, throttled messages. To be called every 10 ms or so.
  virtual void step(std::int64_t wall_ns) = 0;
};

}  // namespace gaitway::api
