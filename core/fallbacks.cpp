// The built-in fallbacks, and which one writes the topics of which kind.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "estimate_fallback.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/manager/fallback.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgclient/trim_law.hpp"

namespace gaitway::core {
namespace {

// In place of the behaviour: whatever it has ordered ends, and the robot stands.
class StopFallback final : public Fallback {
 public:
  void follow(const Tick&) noexcept override { acts_ = 0; }
  bool act(const Tick& tick, ManagedPlugin& through) noexcept override {
    // An order is new by its number; so are the behaviour's own, which have this bit, too.
    const std::uint32_t number =
        0x8000'0000U | static_cast<std::uint32_t>(tick.now_ns / facts::kMillisecond_ns);
    WalkCommand stand{};
    stand.stamp_ns = tick.now_ns;
    WalkToRequest leave_way{};
    leave_way.stamp_ns = tick.now_ns;
    leave_way.number = number;
    leave_way.cancel = 1;
    MotionRequest leave_motion{};
    leave_motion.stamp_ns = tick.now_ns;
    leave_motion.number = number;
    const bool stands = through.publish_in_place("behaviour_walk", stand, tick.now_ns);
    const bool leaves = through.publish_in_place("behaviour_walk_to", leave_way, tick.now_ns);
    const bool motionless = through.publish_in_place("behaviour_motion", leave_motion, tick.now_ns);
    // Once: looking ahead is an order of its own, which would take the command again and again. Not after a
    // single fault: what looks around then goes on, and orders the head no second time.
    if (++acts_ == kActsUntilHeadGoesHome) {
      HeadCommand ahead{};
      ahead.stamp_ns = tick.now_ns;
      static_cast<void>(through.publish_in_place("behaviour_head", ahead, tick.now_ns));
    }
    return motionless || leaves || stands;
  }

 private:
  static constexpr int kActsUntilHeadGoesHome = 10;
  int acts_ = 0;  // in a row
};

constexpr std::int64_t kRamp_ns = 300'000'000;
constexpr double kTrimLimit_rad = 0.11;  // the message controller limits further, to the robot's own
constexpr std::int64_t kTrimmedEstimateLifetime_ns = 50'000'000;
constexpr double kFallen_rad = 0.8;
constexpr double kPerTick = 0.1;  // of the way to a law of zero when the estimate is of no use

// In place of the balance feedback: its last corrections fade to zero, its last trims to what its last gains
// make of the estimate (the law by which the message controller balances in a safe tail), or to zero, too:
// trim = s * last trim + (1 - s) * law, with s from 1 to 0. The gains stay: the message controller goes on
// with them.
class TrimFallback final : public Fallback {
 public:
  TrimFallback(msgclient::Client& client, bool with_gains)
      : with_gains_(with_gains),
        trim_reader_(client.read<TrimCommand>("trim")),
        estimate_reader_(client.read<Estimate>("estimate")),
        correction_reader_(client.read<Correction>("correction")) {}

  void follow(const Tick&) noexcept override { acting_ = false; }
  bool act(const Tick& tick, ManagedPlugin& through) noexcept override;

 private:
  void begin(const Tick& tick) noexcept;
  void update_law(const Tick& tick) noexcept;

  bool with_gains_;
  msgclient::Reader<TrimCommand> trim_reader_;
  msgclient::Reader<Estimate> estimate_reader_;
  msgclient::Reader<Correction> correction_reader_;
  bool acting_ = false;
  std::int64_t begin_ns_ = 0;  // of the last tick in which the plug-in worked
  TrimCommand last_trim_{};
  msgclient::TrimGains gains_;
  std::array<double, kTrimChannels> law_rad_{};
  Estimate estimate_{};
  Correction last_correction_{};
};

template <std::size_t size>
void scale(double (&values)[size], double share) noexcept {
  for (double& value : values) {
    value *= share;
  }
}

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
                      (estimate_.contact[0] == estimate::contact::bears_load ||
                       estimate_.contact[1] == estimate::contact::bears_load);
  if (!usable) {
    for (double& angle : law_rad_) {
      angle *= with_gains_ ? 1.0 - kPerTick : 0.0;
    }
    return;
  }
  const Support support = estimate_.contact[1] == estimate::contact::lifted   ? Support::left
                          : estimate_.contact[0] == estimate::contact::lifted ? Support::right
                                                                              : Support::both;
  law_rad_ = msgclient::trim_angles(gains_, static_cast<int>(support),
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

}  // namespace

std::unique_ptr<Fallback> make_fallback(FallbackKind kind, const FallbackSource& source) {
  switch (kind) {
    case FallbackKind::estimate:
      return std::make_unique<EstimateFallback>(source);
    case FallbackKind::trims_from_gains:
    case FallbackKind::trims_to_zero:
      return std::make_unique<TrimFallback>(source.client, kind == FallbackKind::trims_from_gains);
    case FallbackKind::stop:
      return std::make_unique<StopFallback>();
    default:
      return nullptr;
  }
}

}  // namespace gaitway::core
