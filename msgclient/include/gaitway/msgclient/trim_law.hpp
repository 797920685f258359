// The fast balance feedback: trims from the trunk's attitude. One function, so that the stability plug-in
// and, when the main controller is gone, the message controller turn the same gains into the same angles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgclient {

// What the law regulates with; travels with every hand-over. Single precision, as on the EMI, on both sides.
struct TrimGains {
  std::uint32_t channel_count = 0;  // valid channels, in the order of the network file's trim channels
  std::array<float, 2> attitude_reference{};  // trunk roll, pitch [rad]
  // [support: left, right, both][channel][roll, pitch: rad/rad; roll rate, pitch rate: s]
  std::array<std::array<std::array<float, 4>, kTrimChannels>, kSupports> gain{};

  friend bool operator==(const TrimGains&, const TrimGains&) = default;
};

// The gains of the topic `trim`.
inline TrimGains trim_gains(const TrimCommand& command) noexcept {
  TrimGains gains;
  gains.channel_count = std::min<std::uint32_t>(command.channel_count, kTrimChannels);
  for (std::size_t i = 0; i < gains.attitude_reference.size(); ++i) {
    gains.attitude_reference[i] = static_cast<float>(command.attitude_reference[i]);
  }
  for (std::size_t s = 0; s < kSupports; ++s) {
    for (std::size_t c = 0; c < kTrimChannels; ++c) {
      for (std::size_t k = 0; k < 4; ++k) {
        gains.gain[s][c][k] = static_cast<float>(command.gain[s][c][k]);
      }
    }
  }
  return gains;
}

// Motion of the trunk: roll, pitch against gravity [rad] and their rates [rad/s].
struct TrunkMotion {
  double roll = 0.0;
  double pitch = 0.0;
  double roll_rate = 0.0;
  double pitch_rate = 0.0;
};

// Angle of each channel's joint [rad]:
//   angle[c] = gain[support][c] . (roll - roll_reference, pitch - pitch_reference, roll_rate, pitch_rate)
// limited to +-limit_rad. Channels that are not in use, a support above 2 and a motion that is not finite
// give zero.
inline std::array<double, kTrimChannels> trim_angles(const TrimGains& gains, int support,
                                                     const TrunkMotion& motion, double limit_rad) noexcept {
  std::array<double, kTrimChannels> angle{};
  if (support < 0 || support >= kSupports) {
    return angle;
  }
  const std::array<double, 4> state = {motion.roll - static_cast<double>(gains.attitude_reference[0]),
                                       motion.pitch - static_cast<double>(gains.attitude_reference[1]),
                                       motion.roll_rate, motion.pitch_rate};
  const std::size_t channels = std::min<std::size_t>(gains.channel_count, kTrimChannels);
  for (std::size_t c = 0; c < channels; ++c) {
    const auto& row = gains.gain[static_cast<std::size_t>(support)][c];
    double sum = 0.0;
    for (std::size_t k = 0; k < state.size(); ++k) {
      sum += static_cast<double>(row[k]) * state[k];
    }
    // Written so that a NaN falls through to zero.
    angle[c] = sum > limit_rad ? limit_rad : sum < -limit_rad ? -limit_rad : sum == sum ? sum : 0.0;
  }
  return angle;
}

}  // namespace gaitway::msgclient
