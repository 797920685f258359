// A station on a CAN interface of the Linux kernel (SocketCAN): a raw socket that never blocks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/can/bounded_queue.hpp"
#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/frame_heap.hpp"

namespace gaitway::can {

// What a SocketCAN error frame tells: the kernel reports the state of the CAN controller and what went wrong
// on the bus in frames of their own (linux/can/error.h).
struct ErrorReport {
  std::optional<BusState> state;  // the controller's new state, if the frame tells of a change
  std::optional<ErrorCounters> counters;
  bool restarted = false;
  bool no_acknowledge = false;      // nobody else was there to acknowledge a frame
  bool lost_arbitration = false;    // to a more urgent frame: it is sent again
  bool protocol_violation = false;  // a bit, stuff, form or check sum error, of whatever sender
  bool transceiver_fault = false;   // as of a cut wire
  bool transmit_timeout = false;    // the driver gave up a frame
  bool receive_overflow = false;    // the controller had no room for a frame, which is lost
  bool transmit_overflow = false;   // the controller's transmit buffer was full
};

// `error_class`: the frame's identifier without its flags; `data`: its eight bytes.
[[nodiscard]] ErrorReport read_error_frame(std::uint32_t error_class,
                                           const std::array<std::uint8_t, 8>& data) noexcept;

// Lets those frames of one format through whose identifier equals `id` in all bits of `mask`.
struct IdFilter {
  std::uint32_t id = 0;
  std::uint32_t mask = kLargestExtendedId;
  bool extended = false;
};

struct SocketCanOptions {
  // Frames that pass one of them are received; all frames when there are none. The kernel applies them to the
  // echoes of own frames, too: an own frame that passes none counts as sent as soon as the kernel has it, and
  // the port cannot keep its successor back until then.
  std::vector<IdFilter> filters{};
  // How many frames may wait or be on their way to the bus, at most FrameHeap::kCapacity. With 1, whoever has
  // a queue of its own keeps the choice of the next frame until the last moment.
  std::size_t transmit_buffers = 32;
  // A frame whose echo has not come by then counts as lost. Longer than any response on a sound bus.
  std::int64_t echo_deadline_ns = 20'000'000;
  // How long after bus-off to ask the kernel for a restart, where it does not restart by itself (restart-ms
  // 0); and again after each refusal. 0: never.
  std::int64_t restart_delay_ns = 100'000'000;
  // How often to look whether an interface that is down or gone is back.
  std::int64_t interface_poll_ns = 50'000'000;
  // Takes every own frame when its echo comes: what was on the bus, in the bus's order. Outlives the port.
  CandumpWriter* sent_log = nullptr;
};

// One counter a cause.
struct SocketCanStatistics {
  // Own frames. Accepted = sent + unconfirmed + lost + flushed + failed + those that still wait.
  std::uint64_t accepted = 0;
  std::uint64_t sent = 0;                // their echo came in time
  std::uint64_t unconfirmed = 0;         // the kernel took them, the filters keep their echo away
  std::uint64_t lost = 0;                // no echo before the deadline, bus-off or the interface's end
  std::uint64_t flushed = 0;             // waited when the bus became unusable: stale afterwards
  std::uint64_t failed = 0;              // the kernel refused them for good
  std::uint64_t late_echoes = 0;         // of frames that had counted as lost
  std::uint64_t refused_full = 0;        // transmit() while all buffers were occupied
  std::uint64_t refused_unusable = 0;    // transmit() while bus-off or down
  std::uint64_t refused_invalid = 0;     // transmit() of what is no CAN frame
  std::uint64_t kernel_buffer_full = 0;  // ENOBUFS and EAGAIN: tried again later
  // Others' frames.
  std::uint64_t received = 0;
  std::uint64_t fd_ignored = 0;         // CAN FD frames
  std::uint64_t dropped_by_kernel = 0;  // the socket's receive buffer was full
  std::uint64_t receive_failed = 0;     // other errors of the socket
  std::uint64_t without_stamp = 0;      // frames to which the kernel gave no time
  std::uint64_t hardware_stamps = 0;
  // Error frames and the interface.
  std::uint64_t error_frames = 0;
  std::uint64_t error_passive = 0;
  std::uint64_t bus_off = 0;
  std::uint64_t recovered = 0;  // from bus-off
  std::uint64_t restarts_requested = 0;
  std::uint64_t restarts_refused = 0;
  std::uint64_t interface_down = 0;
  std::uint64_t interface_up = 0;  // again
  std::uint64_t rebound = 0;       // of these, to an interface that had been removed and added
  std::uint64_t no_acknowledge = 0;
  std::uint64_t arbitration_lost = 0;
  std::uint64_t protocol_violations = 0;
  std::uint64_t transceiver_faults = 0;
  std::uint64_t transmit_timeouts = 0;
  std::uint64_t controller_overflows = 0;
};

// Frames wait in the port, by priority, and the kernel has one of them at a time: the next is written when
// the echo of the one before has come. A kernel's transmit queue is first in, first out, and would give every
// frame the response of the least urgent one.
//
// Times are CLOCK_MONOTONIC. Passive: a round is transmit(), flush(); receive() until nothing comes; echoes
// are seen in flush() and receive(). No call blocks, allocates or throws after the construction, with one
// reserve: while the bus cannot be used, flush() may bind the socket again or ask for a restart, and waits
// then for the kernel's lock of the network configuration.
class SocketCanPort final : public BusPort {
 public:
  // Throws BusError, naming the interface and what to do, when the kernel has no CAN, the interface does not
  // exist, is no CAN interface, or is down.
  explicit SocketCanPort(const std::string& interface, const SocketCanOptions& options = {});
  ~SocketCanPort() override;
  SocketCanPort(const SocketCanPort&) = delete;
  SocketCanPort& operator=(const SocketCanPort&) = delete;

  bool transmit(const Frame& frame, std::int64_t now_ns) override;
  [[nodiscard]] bool transmit_pending() const override { return in_flight_ || !waiting_.empty(); }
  std::optional<TimedFrame> receive() override;
  std::optional<BusNotice> next_notice() noexcept override { return notices_.pop(); }
  void flush(std::int64_t now_ns) override;
  [[nodiscard]] bool takes_back() const noexcept override { return false; }
  [[nodiscard]] BusState state() const noexcept override { return state_; }
  [[nodiscard]] ErrorCounters error_counters() const noexcept override { return counters_; }
  // Readable when a frame, an echo, an error frame or a change of the interface waits.
  [[nodiscard]] int wake_fd() const noexcept override;

  // How many frames transmit() would take now.
  [[nodiscard]] std::size_t free_buffers() const noexcept;
  [[nodiscard]] const SocketCanStatistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] const std::string& interface() const noexcept { return interface_; }
  // An interface without hardware, as far as the kernel says: all that is on it is on this computer.
  [[nodiscard]] bool is_virtual() const noexcept { return virtual_; }
  // Why the last request for a restart was refused, and what to do; empty when none was.
  [[nodiscard]] std::string restart_problem() const;

 private:
  class Socket;
  struct Stamp;
  static constexpr std::size_t kReceived = 512;

  [[nodiscard]] bool usable() const noexcept { return state_ < BusState::bus_off; }
  bool drain() noexcept;
  void take(int message) noexcept;
  void take_echo(const TimedFrame& frame) noexcept;
  void take_error(std::uint32_t error_class, const std::array<std::uint8_t, 8>& data,
                  std::int64_t at_ns) noexcept;
  void take_socket_error(int error) noexcept;
  [[nodiscard]] TimedFrame timed(const Frame& frame, int message) noexcept;
  void write_next() noexcept;
  void write_failed(int error) noexcept;
  void enter(BusState state) noexcept;
  void drop_waiting() noexcept;
  void supervise() noexcept;
  void look_for_interface() noexcept;
  void ask_for_restart() noexcept;

  std::string interface_;
  SocketCanOptions options_;
  std::unique_ptr<Socket> socket_;
  SocketCanStatistics statistics_;
  BusState state_ = BusState::error_active;
  ErrorCounters counters_;
  int restart_error_ = 0;

  FrameHeap waiting_;
  std::optional<Frame> in_flight_;  // the kernel has it, its echo has not come
  std::int64_t in_flight_until_ns_ = 0;
  bool virtual_ = false;
  bool kernel_full_ = false;  // until the next flush()

  std::array<TimedFrame, kReceived> received_;  // a ring
  std::size_t received_first_ = 0, received_count_ = 0;
  BoundedQueue<BusNotice, 64> notices_;
  bool emptied_ = false;  // the socket was, when the frames in the ring came: no need to ask it again

  std::int64_t now_ns_ = 0;        // as of the last transmit() or flush()
  std::int64_t next_look_ns_ = 0;  // at the interface, or for a restart
  std::int64_t last_end_ns_ = 0;
  std::int64_t bit_time_ns_ = 1000;
};

// What people get to read of a port: its counters by name, and a line when its state changes.
[[nodiscard]] std::string_view name_of(BusState state) noexcept;

// Every counter under the name that it has in SocketCanStatistics, in that order.
[[nodiscard]] std::vector<std::pair<std::string_view, std::uint64_t>> counters(
    const SocketCanStatistics& statistics);

class SocketCanReporter {
 public:
  // A line to print when the port's state is another than at the last call, or when a restart was refused for
  // the first time since; empty otherwise.
  [[nodiscard]] std::string news(const SocketCanPort& port);

 private:
  BusState state_ = BusState::error_active;
  std::uint64_t refused_before_ = 0;
  bool told_problem_ = false;
};

}  // namespace gaitway::can
