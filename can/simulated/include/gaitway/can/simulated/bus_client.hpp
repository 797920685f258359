// A station in another process than the simulated bus, which it meets over the bus server's Unix socket.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
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
  [[nodiscard]] int wake_fd() const noexcept override { return socket_.get(); }

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

}  // namespace gaitway::can
