// Brings time stamps of a CAN controller's own clock into the clock of the robot. Nothing is known of that
// clock but that it runs almost as fast; each frame has the controller's stamp and a later one of the kernel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace gaitway::can {

// The smallest lag of the kernel's stamp behind the controller's, over the last quarter to half a second, is
// taken for the distance of the two clocks. So a result is too late by the shortest interrupt latency of that
// time, and too early by what the clocks drift meanwhile (25 us at 50 ppm), and no later than the kernel's.
class HardwareClock {
 public:
  // Both stamps of one frame; `kernel_ns` in the clock that the result is wanted in.
  std::int64_t convert(std::int64_t hardware_ns, std::int64_t kernel_ns) noexcept {
    const std::int64_t lag_ns = kernel_ns - hardware_ns;
    if (known() && std::abs(lag_ns - distance_ns()) > kJump_ns) {
      *this = HardwareClock();  // the controller's clock was set, as by a restart of the interface
    }
    if (!known() || kernel_ns - window_begin_ns_ > kWindow_ns) {
      window_begin_ns_ = kernel_ns;
      previous_ns_ = current_ns_;
      current_ns_ = lag_ns;
    }
    current_ns_ = std::min(current_ns_, lag_ns);
    return hardware_ns + distance_ns();
  }

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::max();
  static constexpr std::int64_t kWindow_ns = 250'000'000;
  static constexpr std::int64_t kJump_ns = 1'000'000'000;
  [[nodiscard]] bool known() const noexcept { return current_ns_ != kUnknown; }
  [[nodiscard]] std::int64_t distance_ns() const noexcept { return std::min(current_ns_, previous_ns_); }

  std::int64_t window_begin_ns_ = 0;
  std::int64_t current_ns_ = kUnknown, previous_ns_ = kUnknown;  // smallest lags of two windows
};

}  // namespace gaitway::can
