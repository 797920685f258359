// The raw CAN socket itself: every system call of the port, and none of its decisions.
#pragma once

#include <linux/can.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/hardware_clock.hpp"
#include "gaitway/can/socketcan_port.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::can {

class SocketCanPort::Socket {
 public:
  static constexpr int kBatch = 16;

  // Opens, configures and binds; throws BusError.
  Socket(const std::string& interface, const std::vector<IdFilter>& filters);

  [[nodiscard]] int fd() const noexcept { return fd_.get(); }
  [[nodiscard]] int index() const noexcept { return index_; }

  // Takes up to kBatch messages. Returns how many came, or a negative errno.
  int read() noexcept;
  // Of message 0..read()-1.
  [[nodiscard]] const canfd_frame& frame(int message) const noexcept { return frame_[at(message)]; }
  [[nodiscard]] bool is_fd(int message) const noexcept { return header_[at(message)].msg_len == CANFD_MTU; }
  // This very socket sent it.
  [[nodiscard]] bool is_echo(int message) const noexcept {
    return (header_[at(message)].msg_hdr.msg_flags & MSG_CONFIRM) != 0;
  }
  // A program on this computer sent it.
  [[nodiscard]] bool is_local(int message) const noexcept {
    return (header_[at(message)].msg_hdr.msg_flags & MSG_DONTROUTE) != 0;
  }
  struct Arrival {
    std::int64_t end_ns = 0;  // CLOCK_MONOTONIC
    bool hardware = false;    // by the controller's clock
    bool stamped = false;     // otherwise it is the time of read()
  };
  Arrival arrival(int message) noexcept;
  // Frames that the kernel dropped since the socket was opened, as far as it has told.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

  // 0, or an errno.
  int write(const Frame& frame) noexcept;
  // Whether an own frame's echo gets through the filters.
  [[nodiscard]] bool passes(const Frame& frame) const noexcept;

  [[nodiscard]] bool interface_up() const noexcept;
  // Number of the interface of that name, now; 0: there is none.
  [[nodiscard]] int find_interface() const noexcept;
  // Binds to the interface of that number; false when it has gone meanwhile.
  bool bind_to(int index) noexcept;
  // The interface has been removed, and the kernel has ended the binding: even one of the same number is
  // another.
  void forget_interface() noexcept { index_ = 0; }

 private:
  static constexpr std::size_t at(int message) { return static_cast<std::size_t>(message); }
  // Room for the stamps and the drop counter, aligned as control messages are.
  struct alignas(cmsghdr) Control {
    std::array<std::uint8_t, 192> bytes;
  };
  void configure(const std::vector<IdFilter>& filters);
  void check_interface();
  [[noreturn]] void fail(const std::string& what, int error) const;
  void update_distance(std::int64_t stamp_ns) noexcept;

  std::string interface_;
  process::FileDescriptor fd_;
  int index_ = 0;
  std::vector<can_filter> filters_;
  std::array<mmsghdr, kBatch> header_{};
  std::array<iovec, kBatch> vector_{};
  std::array<canfd_frame, kBatch> frame_{};
  std::array<Control, kBatch> control_{};
  std::int64_t read_at_ns_ = 0;
  std::uint64_t dropped_ = 0;
  std::uint32_t last_drops_ = 0;

  // CLOCK_MONOTONIC minus CLOCK_REALTIME, and the stamp at which it was read.
  std::int64_t distance_ns_ = 0, distance_at_ns_ = 0;
  HardwareClock hardware_clock_;
};

// A CAN interface as the kernel's network configuration (rtnetlink) sees it.
struct CanLink {
  std::string kind;                 // "can" for hardware, "vcan" and so on for what has no controller
  std::optional<BusState> state;    // of hardware
  std::uint32_t restart_ms = 0;     // after bus-off, by itself; 0: never
  std::uint32_t bitrate_per_s = 0;  // 0: it has none
  ErrorCounters counters;
};

// Nothing when the kernel does not answer.
std::optional<CanLink> read_link(int index);

// Starts the controller again after bus-off. Returns 0, or the kernel's refusal as an errno: EPERM without
// the right (CAP_NET_ADMIN), EINVAL where the kernel restarts it by itself, EBUSY where it is not bus-off,
// EOPNOTSUPP where the driver cannot. Waits for the kernel's lock of the network configuration, which another
// program may hold for a moment.
int restart_link(int index) noexcept;

}  // namespace gaitway::can
