// Bit timing of a CAN controller from its clock: prescaler and segments for 1 Mb/s. Freestanding.
#pragma once

#include <cstdint>
#include <optional>

namespace gaitway::firmware {

// In time quanta. A bit is the synchronisation quantum, segment 1 (propagation and phase 1) and segment 2; it
// is sampled between the two segments.
struct BitTiming {
  int prescaler = 0;  // clocks in a time quantum
  int segment_1 = 0;
  int segment_2 = 0;
  int jump_width = 0;  // by how much a resynchronisation may move the sample point

  [[nodiscard]] constexpr int quanta() const noexcept { return 1 + segment_1 + segment_2; }
  [[nodiscard]] constexpr double sample_point() const noexcept {
    return static_cast<double>(1 + segment_1) / quanta();
  }
  // What is left for the way there and back: twice cable, transceiver and isolator. Phase 1 is as long as
  // segment 2.
  [[nodiscard]] constexpr double propagation_ns(double clock_Hz) const noexcept {
    return (segment_1 - segment_2) * prescaler * 1e9 / clock_Hz;
  }
  // By how much each node's clock may be wrong, as a share (Bosch, CAN Specification 2.0, part B, chapter 9):
  // between two edges of ten bits the jump width suffices, and after an error flag phase 2 does.
  [[nodiscard]] constexpr double clock_tolerance() const noexcept {
    const double between_edges = jump_width / (20.0 * quanta());
    const double after_error = segment_2 / (2.0 * (13.0 * quanta() - segment_2));
    return between_edges < after_error ? between_edges : after_error;
  }
  friend constexpr bool operator==(const BitTiming&, const BitTiming&) = default;
};

// Nodes of one bus sample alike; SocketCAN takes the same share above 800 kb/s.
inline constexpr double kSamplePoint = 0.75;

// The exact division of the bit whose sample point lies nearest; of equals the one with the finest quanta.
// Within the registers of the STM32's bxCAN, which later controllers exceed. Nothing where the clock is no
// multiple of the bit rate, or no division has at least eight quanta.
[[nodiscard]] constexpr std::optional<BitTiming> bit_timing(std::uint32_t clock_Hz,
                                                            std::uint32_t bit_rate = 1'000'000) noexcept {
  constexpr int kFewestQuanta = 8, kLongestSegment1 = 16, kLongestSegment2 = 8, kLargestJump = 4;
  constexpr int kLargestPrescaler = 1024;
  std::optional<BitTiming> best;
  double best_distance = 1.0;
  if (bit_rate == 0 || clock_Hz % bit_rate != 0) {
    return best;
  }
  const auto clocks = static_cast<int>(clock_Hz / bit_rate);
  for (int quanta = 1 + kLongestSegment1 + kLongestSegment2; quanta >= kFewestQuanta; --quanta) {
    if (clocks % quanta != 0 || clocks / quanta > kLargestPrescaler) {
      continue;
    }
    for (int segment_2 = 2; segment_2 <= kLongestSegment2; ++segment_2) {
      const int segment_1 = quanta - 1 - segment_2;
      if (segment_1 < segment_2 || segment_1 > kLongestSegment1) {
        continue;
      }
      const BitTiming timing{clocks / quanta, segment_1, segment_2,
                             segment_2 < kLargestJump ? segment_2 : kLargestJump};
      const double distance = timing.sample_point() > kSamplePoint ? timing.sample_point() - kSamplePoint
                                                                   : kSamplePoint - timing.sample_point();
      if (distance < best_distance - 1e-9) {
        best = timing;
        best_distance = distance;
      }
    }
  }
  return best;
}

}  // namespace gaitway::firmware
