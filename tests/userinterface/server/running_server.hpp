// A server in a thread of its own, with a hub whose sessions answer each message with itself. Tests look into
// both from within the server's ticks, so that nothing is waited for by guessing.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/api/server.hpp"

namespace gaitway::api {

// Messages are echoed, but for some: `close` asks the connection to close (1008, "as you wish") after two
// further frames, `many N` is answered with N frames of 16 KiB, `hold` keeps the server's thread until the
// test releases it, `work` takes a millisecond of it, and what begins with `urgent` is urgent, with
// `emergency` an emergency.
class EchoHub final : public SessionHub {
 public:
  struct Opened {
    std::string peer;
    bool authorised;
  };

  std::unique_ptr<Session> open(Connection& connection, std::string peer, bool authorised,
                                std::int64_t wall_ns) override;
  void step(std::int64_t wall_ns) override;

  std::vector<Opened> opened;
  std::size_t sessions = 0;  // now
  std::size_t most_sessions = 1'000'000;
  std::uint64_t steps = 0;
  std::vector<std::string> taken;  // `work`, `urgent...`, and these after "overtaken ", in their order
  std::binary_semaphore held{0}, released{0};
};

class RawClient;
class WebSocketClient;

class RunningServer {
 public:
  using Condition = std::function<bool(const ServerStatistics&, EchoHub&)>;

  // `before_running`: called in the server's thread.
  explicit RunningServer(ServerOptions options, std::function<void()> before_running = {});
  ~RunningServer();

  [[nodiscard]] std::uint16_t port() const noexcept { return server_.port(); }
  // Returns when it holds at a tick; looked at in the server's thread.
  void await(Condition condition);
  // Nothing is read or done by the server while `meanwhile` runs, which a client's `hold` begins.
  void while_held(RawClient& client, const std::function<void()>& meanwhile);
  void while_held(WebSocketClient& client, const std::function<void()>& meanwhile);
  // The statistics at the next tick.
  [[nodiscard]] ServerStatistics statistics();
  // Lines about refusals so far.
  [[nodiscard]] std::vector<std::string> refusals();
  void stop();  // and waits until run() has ended

 private:
  void hold(const std::function<void()>& meanwhile);
  void look();

  EchoHub hub_;
  Server server_;
  std::mutex mutex_;
  std::condition_variable met_;
  Condition condition_;
  std::vector<std::string> refusals_;  // of the server's thread
  std::thread thread_;
};

// Loopback, any port.
[[nodiscard]] ServerOptions local();

}  // namespace gaitway::api
