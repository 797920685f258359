// One client of the socketcand protocol: what mode it is in, what it wants to hear and what it wants to send.
// Knows neither sockets nor the bus: text goes in and comes out, frames go in and come out.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/simulated/socketcand_protocol.hpp"

namespace gaitway::can {

// Passive: every call says what time it is on the bus; time does not run backwards.
class SocketcandSession {
 public:
  // Bounds for one client.
  static constexpr std::size_t kQueuedFrames = 256;
  static constexpr std::size_t kJobs = 64;
  static constexpr std::size_t kSubscriptions = 512;
  // What may wait to be read by the client: more than two seconds of a full bus.
  static constexpr std::size_t kLongestBacklog_bytes = std::size_t{1} << 20U;
  // A client that switches to raw mode has so long to read the answer before the first frame comes: there are
  // clients (python-can) that take what comes with the answer for the answer.
  static constexpr std::int64_t kAnswerAlone_ns = 100'000'000;

  // `bus_name`: the one bus that can be opened.
  explicit SocketcandSession(std::string_view bus_name);

  // Takes what the client sent, or as much of it as there is room for what it asks to be sent: the rest is
  // left in `input`.
  void take(std::string_view& input, std::int64_t now_ns);
  // A frame has been on the bus. `own`: this client sent it.
  void on_frame(const TimedFrame& frame, bool own);
  // What is due by now: throttled updates, statistics.
  void step(std::int64_t now_ns);

  struct Release {
    Frame frame;
    std::int64_t since_ns = 0;  // from when on it takes part in arbitration
  };
  // The next frame that this client wants on the bus before `until_ns`; it counts as handed over. Cyclic
  // frames whose time had passed before `now_ns` are left out, but for the last.
  std::optional<Release> next_frame(std::int64_t now_ns, std::int64_t until_ns);

  // All single frames have been handed over; cyclic ones end with the session.
  [[nodiscard]] bool nothing_queued() const noexcept { return queue_.empty(); }

  // What the client is to get; the caller takes from its front what was sent.
  [[nodiscard]] std::string& output() noexcept { return output_; }
  // It broke the protocol where that ends a connection; it goes when its output is out.
  [[nodiscard]] bool ended() const noexcept { return ended_; }
  // It has not read for too long; its output is no longer whole.
  [[nodiscard]] bool overrun() const noexcept { return overrun_; }
  [[nodiscard]] std::uint64_t rejected() const noexcept { return rejected_; }
  [[nodiscard]] std::uint64_t untold_remote_frames() const noexcept { return untold_remote_frames_; }

 private:
  enum class Mode : std::uint8_t { no_bus, bcm, raw, control };
  struct Job {
    Frame frame;
    std::int64_t interval_ns = 0;
    std::optional<std::int64_t> due_ns;  // none: sent once, and done
  };
  struct Subscription {
    Frame mask;  // identifier, format, and for filters the bits that matter
    bool filters = false;
    std::int64_t interval_ns = 0;
    std::optional<TimedFrame> last;      // of the same content, as far as the mask goes
    std::optional<TimedFrame> withheld;  // by the throttle
    std::optional<std::int64_t> told_ns;
  };

  void handle(const socketcand::Command& command, std::int64_t now_ns);
  void handle_without_bus(const socketcand::Command& command);
  void handle_on_bus(const socketcand::Command& command, std::int64_t now_ns);
  bool switch_mode(socketcand::Verb verb, std::int64_t now_ns);
  void handle_job(const socketcand::Command& command, std::int64_t now_ns);
  void handle_subscription(const socketcand::Command& command);
  void notify(Subscription& subscription, const TimedFrame& frame);
  void tell(const TimedFrame& frame);
  void answer(std::string_view text);
  void reject(std::string_view reason);

  std::string bus_name_;
  Mode mode_ = Mode::no_bus;
  socketcand::ElementReader reader_;
  std::deque<Release> queue_;
  std::vector<Job> jobs_;
  std::vector<Subscription> subscriptions_;
  socketcand::Traffic traffic_;
  std::int64_t statistics_interval_ns_ = 0;  // 0: none
  std::int64_t statistics_due_ns_ = 0;
  std::int64_t silent_until_ns_ = 0;
  std::string output_;
  std::uint64_t rejected_ = 0;
  std::uint64_t untold_remote_frames_ = 0;
  bool ended_ = false;
  bool overrun_ = false;
};

}  // namespace gaitway::can
