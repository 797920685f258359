// The link's carrier at the main controller: a socket at which the module connects, or a serial line.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gaitway/link/carrier.hpp"
#include "gaitway/link/controller_end.hpp"
#include "gaitway/link/link_address.hpp"
#include "gaitway/link/unix_carrier.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::api {

// One module at a time: another one that connects meanwhile is told who has the link, and turned away.
// Whoever is refused is told of once a minute.
class LinkHost {
 public:
  // Opens all that it needs: throws process::SocketError, link::SerialError. A serial line that is lost later
  // is opened again when it is there.
  explicit LinkHost(const link::LinkAddress& address);

  // Waits until something has come, for at most `most_ms`; but who floods the link wakes it four times a
  // millisecond and no more, since this process goes before others. Then brings the end and its carrier
  // together.
  void wait(int most_ms);
  void pump(link::ControllerEnd& end, std::int64_t now_ns);
  // News for people: who was turned away, what link there is; empty: none.
  [[nodiscard]] std::string take_report();

 private:
  void open_line();  // throws link::SerialError
  void open_line_again(std::int64_t now_ns);
  void accept(link::ControllerEnd& end, std::int64_t now_ns);
  void turn_away(process::FileDescriptor connection, const link::ControllerEnd& end, std::int64_t now_ns);
  void follow_session(const link::ControllerEnd& end, std::int64_t now_ns);
  void tell_refusal(std::string text, std::int64_t now_ns);

  link::LinkAddress address_;
  std::optional<process::ListeningSocket> listener_;  // nothing: a serial line
  std::unique_ptr<link::Carrier> carrier_;
  int wake_fd_ = -1;
  std::int64_t tried_ns_ = 0;
  std::string line_error_;  // why there is no line, as told last
  std::uint32_t session_ = 0, refusals_ = 0;
  std::string refusal_;  // as told last
  std::int64_t refusal_told_ns_ = 0;
  std::int64_t wakes_since_ns_ = 0;
  int wakes_ = 0;  // since then
  std::string report_;
};

}  // namespace gaitway::api
