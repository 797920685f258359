// A station in another process than the simulated bus, which it meets over the bus server's Unix socket.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/can/bounded_queue.hpp"
#include "gaitway/can/bus_port.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::can {

// How many frames of one client may wait for the bus, as in a controller with a priority-ordered transmit
// queue.
inline constexpr int kTransmitBuffers = 32;

enum class Pace : std::uint8_t {
  free,  // the bus runs on whether this client keeps up or not
  kept   // the bus runs at most to a millisecond after this client's last flush(), and waits a bounded time
         // for it
};

// Connects to a BusServer. Passive: what was transmitted goes out with flush(), what has come is taken with
// receive().
class BusClient final : public BusPort {
 public:
  // `name`: at most 8 characters are kept, for messages. Throws BusError when nobody serves the socket.
  BusClient(const std::filesystem::path& socket, std::string_view name, Pace pace);
  ~BusClient() override;
  BusClient(const BusClient&) = delete;
  BusClient& operator=(const BusClient&) = delete;

  // They throw BusError when the connection breaks for another reason than the server's end.
  bool transmit(const Frame& frame, std::int64_t now_ns) override;
  [[nodiscard]] bool transmit_pending() const override { return unsent_ > 0; }
  std::optional<TimedFrame> receive() override;
  std::optional<BusNotice> next_notice() noexcept override { return notices_.pop(); }
  void flush(std::int64_t now_ns) override;
  // For a client whose pace the bus keeps; true for the others, which are not told.
  [[nodiscard]] bool caught_up(std::int64_t time_ns) const noexcept override {
    return pace_ == Pace::free || bus_time_ns_ >= time_ns;
  }
  [[nodiscard]] std::int64_t longest_wait_ns() const noexcept override {
    return pace_ == Pace::kept ? kLongestWait_ns : 0;
  }
  [[nodiscard]] int wake_fd() const noexcept override { return socket_.get(); }

  // How far the bus has run, as far as it has told; 0: it has told nothing yet.
  [[nodiscard]] std::int64_t bus_time_ns() const noexcept { return bus_time_ns_; }
  // The server has gone; nothing comes or goes any more.
  [[nodiscard]] bool closed() const noexcept { return closed_; }

 private:
  struct Packets;
  void send_packet();
  bool receive_packet();
  [[noreturn]] void fail(std::string_view what) const;

  std::filesystem::path path_;
  process::FileDescriptor socket_;
  std::unique_ptr<Packets> packets_;
  Pace pace_;
  BoundedQueue<BusNotice, 64> notices_;
  std::int64_t bus_time_ns_ = 0;
  int unsent_ = 0;  // frames that were offered and not yet reported as sent
  bool closed_ = false;
};

// A client that outlives its bus. While nobody serves the socket, or a bus that keeps its pace stands still,
// its station is down: it takes no frame, and what had been offered is gone with the bus. It connects again
// by itself, at most every kBetweenTries_ns of what flush() is told, and is back on the bus when that runs.
// Passive like a BusClient; after the construction nothing throws.
class LastingBusClient final : public BusPort {
 public:
  static constexpr std::int64_t kBetweenTries_ns = 50'000'000;
  // A bus of which nothing has been heard for so long stands still.
  static constexpr std::int64_t kStandstill_ns = 200'000'000;

  // Throws BusError when nobody serves the socket now.
  LastingBusClient(std::filesystem::path socket, std::string name, Pace pace);

  bool transmit(const Frame& frame, std::int64_t now_ns) override;
  [[nodiscard]] bool transmit_pending() const override { return client_ && client_->transmit_pending(); }
  std::optional<TimedFrame> receive() override;
  std::optional<BusNotice> next_notice() noexcept override {
    return client_ ? client_->next_notice() : std::nullopt;
  }
  void flush(std::int64_t now_ns) override;
  [[nodiscard]] BusState state() const noexcept override { return state_; }
  [[nodiscard]] bool caught_up(std::int64_t time_ns) const noexcept override {
    return state_ == BusState::down || client_->caught_up(time_ns);
  }
  [[nodiscard]] std::int64_t longest_wait_ns() const noexcept override {
    return pace_ == Pace::kept ? kLongestWait_ns : 0;
  }
  // Changes with every connection; -1 while there is none.
  [[nodiscard]] int wake_fd() const noexcept override { return client_ ? client_->wake_fd() : -1; }

  // Somebody serves the bus, whether it runs or not.
  [[nodiscard]] bool connected() const noexcept { return client_.has_value(); }
  // Times that the station was taken off the bus.
  [[nodiscard]] std::uint64_t outages() const noexcept { return outages_; }

 private:
  void connect_again() noexcept;
  void judge(std::int64_t now_ns) noexcept;
  void go_down() noexcept;
  // A connection that breaks for whatever reason has ended.
  template <class Work>
  void attempt(const Work& work) noexcept;

  std::filesystem::path socket_;
  std::string name_;
  Pace pace_;
  std::optional<BusClient> client_;
  BusState state_ = BusState::error_active;
  std::int64_t now_ns_ = 0;                      // as of the last flush()
  std::int64_t next_try_ns_ = 0;                 // to connect
  std::int64_t judged_ns_ = 0;                   // as of the last flush() with a connection
  std::int64_t heard_ns_ = 0, heard_at_ns_ = 0;  // how far the bus has run, and when that was heard
  std::uint64_t outages_ = 0;
};

}  // namespace gaitway::can
