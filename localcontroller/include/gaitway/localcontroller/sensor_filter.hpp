// A sensor channel: sampled every millisecond, sent as the mean of its last ten samples.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/facts/facts.hpp"

namespace gaitway::localcontroller {

class SensorFilter {
 public:
  static constexpr int kSamples = static_cast<int>(facts::kSlot_ns / facts::kMillisecond_ns);

  void add(float sample) noexcept {
    sum_ += sample - samples_[next_];
    samples_[next_] = sample;
    next_ = (next_ + 1) % kSamples;
    if (next_ == 0) {  // rounding of the running sum does not pile up
      sum_ = 0.0F;
      for (const float value : samples_) {
        sum_ += value;
      }
    }
    count_ = count_ < kSamples ? count_ + 1 : kSamples;
  }
  // Mean in counts of `scale` sensor units, rounded, saturating at the 16 bits of its channel.
  [[nodiscard]] std::int16_t counts(float scale) const noexcept {
    const float mean = count_ == 0 ? 0.0F : sum_ / static_cast<float>(count_) / scale;
    if (!(mean > -32767.0F)) {  // also what is not a number
      return -32767;
    }
    return mean < 32767.0F ? static_cast<std::int16_t>(mean < 0.0F ? mean - 0.5F : mean + 0.5F)
                           : std::int16_t{32767};
  }

 private:
  std::array<float, kSamples> samples_{};
  std::size_t next_ = 0;
  int count_ = 0;
  float sum_ = 0.0F;
};

}  // namespace gaitway::localcontroller
