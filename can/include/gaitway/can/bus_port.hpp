// One station's access to a bus, whatever the bus is: a simulated one behind a socket, or a real interface.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

// A frame from the bus and when it was on it.
struct TimedFrame {
  Frame frame;
  std::int64_t start_ns = 0;  // start of frame
  std::int64_t end_ns = 0;    // receivers have it
};

// Nothing here blocks. All times are of the clock that the processes of one robot share.
class BusPort {
 public:
  virtual ~BusPort() = default;

  // Offers a frame to the bus, from `now_ns` on. False, and nothing changes, when every transmit buffer is
  // occupied. The buffers are sent by priority, frames of one identifier in their order.
  virtual bool transmit(const Frame& frame, std::int64_t now_ns) = 0;
  // Whether a frame of this station still waits or is on the wire.
  [[nodiscard]] virtual bool transmit_pending() const = 0;
  // The next frame of another station, in the order of the bus.
  virtual std::optional<TimedFrame> receive() = 0;
  // Ends a round of work: everything that this station wanted to send up to `now_ns` has been offered.
  virtual void flush(std::int64_t now_ns) = 0;
  // Whether everything that was on the bus up to `time_ns` has come, as far as the bus can tell: a simulated
  // one may lag behind the clock, a real one never does.
  [[nodiscard]] virtual bool caught_up(std::int64_t time_ns) const noexcept {
    static_cast<void>(time_ns);
    return true;
  }
  // Where frames come from, to wait on with poll().
  [[nodiscard]] virtual int wake_fd() const noexcept = 0;
};

}  // namespace gaitway::can
