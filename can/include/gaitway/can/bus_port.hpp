// One station's access to a bus, whatever the bus is: a simulated one behind a socket, or a real interface.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

// What can go wrong between a station and its bus: the text names the path, what was tried, why it failed and
// what to do.
class BusError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A frame from the bus and when it was on it.
struct TimedFrame {
  Frame frame;
  std::int64_t start_ns = 0;  // start of frame
  std::int64_t end_ns = 0;    // receivers have it
};

// What a station notices of the bus beside the frames of others.
struct BusNotice {
  enum class Kind : std::uint8_t {
    sent,  // a frame of its own was on the bus from start to end
    error  // an error was signalled at `end_ns`; of whose frame no station can know
  };
  Kind kind = Kind::sent;
  TimedFrame frame;
};

// What a station's CAN controller may do (ISO 11898-1, fault confinement), and whether there is a bus at all.
enum class BusState : std::uint8_t {
  error_active = 0,
  error_passive = 1,  // many errors: it may not destroy other stations' frames any more
  bus_off = 2,        // it neither sends nor receives, until it has seen 128 times 11 recessive bits
  down = 3            // the interface is down or gone
};

struct ErrorCounters {
  int transmit = 0;  // TEC
  int receive = 0;   // REC
  friend bool operator==(const ErrorCounters&, const ErrorCounters&) = default;
};

// A bus waits at most so long for a station whose pace it keeps; what such a station has to say about times
// further back is stale.
inline constexpr std::int64_t kLongestWait_ns = 50'000'000;

// Nothing here blocks. All times are of the clock that the processes of one robot share.
class BusPort {
 public:
  virtual ~BusPort() = default;

  // Offers a frame to the bus, from `now_ns` on. False, and nothing changes, when every transmit buffer is
  // occupied or the station is bus-off or down. The buffers are sent by priority, frames of one identifier in
  // their order.
  virtual bool transmit(const Frame& frame, std::int64_t now_ns) = 0;
  // Whether a frame of this station still waits or is on the wire.
  [[nodiscard]] virtual bool transmit_pending() const = 0;
  // The next frame of another station, in the order of the bus. A frame that bears one of this station's own
  // identifiers is among them, if another station sent it.
  virtual std::optional<TimedFrame> receive() = 0;
  // The next notice, in the order of the bus, of those that came with receive() or flush(). A few dozen are
  // kept: of who does not ask for them, the oldest give way. A port without eyes for them has none.
  virtual std::optional<BusNotice> next_notice() noexcept { return std::nullopt; }
  // Ends a round of work: everything that this station wanted to send up to `now_ns` has been offered.
  virtual void flush(std::int64_t now_ns) = 0;
  // Whether a frame that waits for the bus gives way to a more urgent one that is offered later. A port that
  // has handed it to an operating system cannot take it back.
  [[nodiscard]] virtual bool takes_back() const noexcept { return true; }
  // As of the last receive().
  [[nodiscard]] virtual BusState state() const noexcept { return BusState::error_active; }
  [[nodiscard]] virtual ErrorCounters error_counters() const noexcept { return {}; }
  // Whether everything that was on the bus up to `time_ns` has come, as far as the bus can tell: a simulated
  // one may lag behind the clock, a real one never does.
  [[nodiscard]] virtual bool caught_up(std::int64_t time_ns) const noexcept {
    static_cast<void>(time_ns);
    return true;
  }
  // How long the bus waits for what this station is late with; 0: not at all, a real one. A frame that is
  // later by more than that would be on it at another time than its own.
  [[nodiscard]] virtual std::int64_t longest_wait_ns() const noexcept { return 0; }
  // Where frames come from, to wait on with poll().
  [[nodiscard]] virtual int wake_fd() const noexcept = 0;
};

// For programs at their end: waits until the bus has what was transmitted, `longest_ns` at most. True: it
// has. What others send meanwhile is discarded.
bool finish_sending(BusPort& port, std::int64_t longest_ns = 100'000'000);

}  // namespace gaitway::can
