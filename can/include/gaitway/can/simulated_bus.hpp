// The bus in virtual time: arbitration by identifier at bit-time resolution, with exact frame lengths.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

// Lengths in microseconds, interframe space included.
struct LengthStatistics {
  std::uint64_t count = 0;
  double sum = 0.0;
  double min = std::numeric_limits<double>::infinity();
  double max = 0.0;
  [[nodiscard]] double mean() const noexcept { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
};

struct BusStatistics {
  std::uint64_t frames = 0;
  std::uint64_t lost = 0;
  std::int64_t busy_ns = 0;  // interframe spaces included
  LengthStatistics eight_byte_us;
  [[nodiscard]] double load(std::int64_t elapsed_ns) const noexcept {
    return elapsed_ns > 0 ? static_cast<double>(busy_ns) / static_cast<double>(elapsed_ns) : 0.0;
  }
};

class SimulatedBus {
 public:
  explicit SimulatedBus(std::int64_t bit_time_ns = 1000);  // 1 Mb/s

  // A station on the bus with one transmit buffer. Returns its number, counted from 0.
  int attach();

  // Offers a frame to the bus from `now_ns` on; it takes part in every arbitration until it has been sent.
  // False, and nothing changes, when the station's transmit buffer is occupied. Two stations never send the
  // same identifier on a real bus; here the lower station would win.
  bool transmit(int station, const Frame& frame, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool transmit_pending(int station) const noexcept;
  // Takes a waiting frame back; false when there is none or it is already on the wire.
  bool abort(int station) noexcept;

  struct Delivery {
    Frame frame;
    int sender = 0;
    std::int64_t start_ns = 0;  // start of frame
    std::int64_t end_ns = 0;    // last bit of end-of-frame: receivers have it; the bus is free 3 bits later
    int bits = 0;               // exact length with stuff bits, without the interframe space
    bool lost = false;          // a fault: no receiver has it, though its sender thinks that it was sent
  };
  // The next frame that completes at or before `until_ns`, in order of time; nothing when none does. The
  // caller handles the delivery (and may transmit() in answer, at end_ns or later) and calls again until
  // nothing comes.
  std::optional<Delivery> advance(std::int64_t until_ns) noexcept;

  // Decides for each frame, at its start, whether it gets lost. Empty: none does.
  void set_loss(std::function<bool(const Frame&, std::int64_t start_ns)> loss) { loss_ = std::move(loss); }
  [[nodiscard]] const BusStatistics& statistics() const noexcept { return statistics_; }

 private:
  struct Station {
    bool pending = false;
    std::int64_t since_ns = 0;
    Frame frame;
  };
  void start_next(std::int64_t until_ns) noexcept;
  void count(const Delivery& delivery) noexcept;

  std::int64_t bit_time_ns_;
  std::vector<Station> stations_;
  int waiting_ = 0;                // stations with a pending frame that is not on the wire
  std::int64_t free_from_ns_ = 0;  // end of the last interframe space
  std::optional<Delivery> on_wire_;
  std::function<bool(const Frame&, std::int64_t)> loss_;
  BusStatistics statistics_;
};

}  // namespace gaitway::can
