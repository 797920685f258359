// How often a bus may be disturbed, for the response-time analysis: what the analysis allows for is a promise
// about the surroundings, and nothing beyond it is covered.
#pragma once

#include <cstdint>
#include <vector>

namespace gaitway::can {

// Bits that an error costs beside the frame that it destroys: two superposed error flags (12), delimiter (8),
// interframe space (3), and the eight bits that an error-passive sender waits (Tindell, Burns 1994).
inline constexpr int kErrorBits = 31;

// One source of disturbance: `burst` hits at once at the worst instant, then one more every `interval_ns`.
struct ErrorSource {
  int burst = 1;                 // >= 0; 0: the source is absent
  std::int64_t interval_ns = 0;  // of the hits after the burst; 0: there are none
  std::int64_t duration_ns = 0;  // how long the bus is unusable at each hit: a jam; 0: a corrupted bit

  // The most hits that fall into a window of `window_ns` (> 0), its end not included.
  [[nodiscard]] constexpr std::int64_t hits(std::int64_t window_ns) const noexcept {
    if (burst == 0) {
      return 0;
    }
    return burst + (interval_ns > 0 ? (window_ns - 1) / interval_ns : 0);
  }
};

// Independent sources that add up (Punnekkat, Hansson, Norström 2000). Empty: a bus without errors.
//
// Every hit costs kErrorBits, its duration, and the repetition of the longest frame that it can have
// destroyed. Counted on is that every sender stays error-active: an error-passive one leaves the bus to less
// urgent frames after each of its own, and a bus-off one sends nothing at all.
using ErrorModel = std::vector<ErrorSource>;

// Tindell, Burns 1994: `burst` errors at once, then one every `interval_ns`.
[[nodiscard]] inline ErrorModel burst_errors(int burst, std::int64_t interval_ns) {
  return {{.burst = burst, .interval_ns = interval_ns}};
}
// The bus is jammed for `duration_ns`; again after each `interval_ns`, if that is not 0.
[[nodiscard]] inline ErrorModel jam(std::int64_t duration_ns, std::int64_t interval_ns = 0) {
  return {{.burst = 1, .interval_ns = interval_ns, .duration_ns = duration_ns}};
}

}  // namespace gaitway::can
