// Deterministic random numbers of whatever is simulated: the same on every machine and standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace gaitway::facts {

// SplitMix64 (Steele, Lea, Flood 2014). Streams with different names are independent of each other.
class RandomStream {
 public:
  // Seed and name are mixed before they become a place in the sequence: neighbouring seeds start far apart.
  RandomStream(std::uint64_t seed, std::uint64_t name) noexcept : state_(mix(mix(seed + kStep) ^ name)) {}

  std::uint64_t next() noexcept { return mix(state_ += kStep); }
  // Uniform in [0, 1).
  double uniform() noexcept { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  // Standard normal (Box and Muller 1958).
  double normal() noexcept {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  // Nearly standard normal and fast, for sensor noise: the sum of four 16-bit uniforms (Irwin-Hall), mean 0,
  // variance 1, never beyond 3.5 sigma.
  double quick_normal() noexcept {
    const std::uint64_t bits = next();
    const std::uint64_t sum =
        (bits & 0xFFFFU) + ((bits >> 16U) & 0xFFFFU) + ((bits >> 32U) & 0xFFFFU) + (bits >> 48U);
    constexpr double kMean = 2.0 * 65535.0;
    constexpr double kInverseDeviation = 1.7320508075688772 / 65536.0;  // sqrt(12 / 4) / 2^16
    return (static_cast<double>(sum) - kMean) * kInverseDeviation;
  }

 private:
  static constexpr std::uint64_t kStep = 0x9E37'79B9'7F4A'7C15ULL;

  static constexpr std::uint64_t mix(std::uint64_t z) noexcept {
    z = (z ^ (z >> 30U)) * 0xBF58'476D'1CE4'E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D0'49BB'1331'11EBULL;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace gaitway::facts
