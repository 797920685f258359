// The WebSocket server: connections on one side, sessions on the other. It knows nothing of what they say.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "gaitway/api/server_setup.hpp"
#include "gaitway/api/server_statistics.hpp"
#include "gaitway/api/session.hpp"
#include "gaitway/page/asset_table.hpp"

namespace gaitway::api {

// Called in the server's thread. Times are of the monotonic clock.
struct ServerCallbacks {
  std::function<void(std::int64_t wall_ns)> on_tick;  // every tick_ns, after the hub's step
  std::function<void(std::int64_t wall_ns)> on_poll;  // every poll_ns
  // Who was refused, for people: a line for all that have the same cause, at most every ten seconds.
  std::function<void(const std::string& line)> on_refusals = {};
};

// What there is for browsers; each outlives the server. Null: none.
struct ServerPage {
  const page::AssetTable* assets = nullptr;
  SessionHub* view = nullptr;  // of the WebSockets at /view, which are written before all others
  // Of the page: one of another version gets no view.
  std::string_view version = {};
};

// All work is done by the thread in run(). After the constructor it makes no socket but by accept4, opens no
// file and starts no thread. But glibc's allocator does, in a thread beside the first, when it gives memory
// back
// (/proc/sys/vm/overcommit_memory): a filter that kills for it wants mallopt(M_TRIM_THRESHOLD, INT_MAX)
// before.
class Server {
 public:
  // `hub` must outlive the server, too. Throws std::system_error when the kernel gives no descriptor.
  Server(SessionHub& hub, ServerSetup setup, ServerCallbacks callbacks = {}, ServerPage page = {});
  // Ends what is still connected. Not while run() runs.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // Serves until stop(), then closes every connection (1001), within closing_ns. Once only.
  void run();
  // From any thread, before or during run().
  void stop();

  [[nodiscard]] std::uint16_t port() const noexcept;
  // From the callbacks and the hub, or while run() does not run.
  [[nodiscard]] const ServerStatistics& statistics() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitway::api
