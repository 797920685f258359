// trim = s * last trim + (1 - s) * law, with s from 1 to 0.
#include "trim_fallback.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "gaitway/facts/facts.hpp"

namespace gaitway::core {
namespace {

constexpr double kTrimLimit_rad = 0.11;  // the message controller limits further, to the robot's own
constexpr std::int64_t kTrimmedEstimateLifetime_ns = 50'000'000;
constexpr double kFallen_rad = 0.8;
constexpr double kPerTick = 0.1;  // of the way to a law of zero when the estimate is of no use

enum : int { kLeft = 0, kRight = 1, kBoth = 2 };

template <std::size_t size>
void scale(double (&values)[size], double share) noexcept {
  for (double& value : values) {
    value *= share;
  }
}

}  // namespace

// The topics still hold the plug-in's last good values.
void TrimFallback::begin(const Tick& tick) noexcept {
  acting_ = true;
  begin_ns_ = tick.now_ns - facts::kSlot_ns;
  last_trim_ = TrimCommand{};
  last_correction_ = Correction{};
  trim_reader_.read(last_trim_);
  correction_reader_.read(last_correction_);
  gains_ = msgclient::trim_gains(last_trim_);
  std::copy(std::begin(last_trim_.angle), std::end(last_trim_.angle), law_rad_.begin());
}

void TrimFallback::update_law(const Tick& tick) noexcept {
  const bool usable = with_gains_ && estimate_reader_.read(estimate_) &&
                      tick.now_ns - estimate_.stamp_ns <= kTrimmedEstimateLifetime_ns &&
                      std::abs(estimate_.attitude[0]) < kFallen_rad &&
                      std::abs(estimate_.attitude[1]) < kFallen_rad &&
                      (estimate_.contact[0] != 0 || estimate_.contact[1] != 0);
  if (!usable) {
    for (double& angle : law_rad_) {
      angle *= with_gains_ ? 1.0 - kPerTick : 0.0;
    }
    return;
  }
  const int support = estimate_.contact[1] == 0 ? kLeft : estimate_.contact[0] == 0 ? kRight : kBoth;
  law_rad_ = msgclient::trim_angles(gains_, support,
                                    {estimate_.attitude[0], estimate_.attitude[1],
                                     estimate_.angular_velocity[0], estimate_.angular_velocity[1]},
                                    kTrimLimit_rad);
}

bool TrimFallback::act(const Tick& tick, ManagedPlugin& through) noexcept {
  if (!acting_) {
    begin(tick);
  }
  const double share = std::clamp(
      1.0 - static_cast<double>(tick.now_ns - begin_ns_) / static_cast<double>(kRamp_ns), 0.0, 1.0);
  TrimCommand trim = last_trim_;
  trim.stamp_ns = tick.now_ns;
  update_law(tick);
  for (std::size_t channel = 0; channel < law_rad_.size(); ++channel) {
    trim.angle[channel] = share * last_trim_.angle[channel] + (1.0 - share) * law_rad_[channel];
  }
  Correction correction = last_correction_;
  correction.stamp_ns = tick.now_ns;
  scale(correction.com_offset, share);
  scale(correction.base_attitude_offset, share);
  scale(correction.bow, share);
  scale(correction.bow_rate, 0.0);
  scale(correction.step_offset, share);
  correction.turn_rate_offset *= share;
  const bool trimmed = through.publish_in_place("trim", trim, tick.now_ns);
  const bool corrected = through.publish_in_place("correction", correction, tick.now_ns);
  return trimmed || corrected;
}

}  // namespace gaitway::core
