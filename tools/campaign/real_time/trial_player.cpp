// Looks each two milliseconds.
#include "tools/campaign/real_time/trial_player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;
using facts::kSecond_ns;

constexpr std::int64_t kBetweenLooks_ns = 2 * kMillisecond_ns;
constexpr std::int64_t kBetweenFallLooks_ns = 100 * kMillisecond_ns;
constexpr std::int64_t kUntilItWalks_ns = 30 * kSecond_ns;
constexpr std::int64_t kPrepared_ns = 400 * kMillisecond_ns;  // before the instant
// It stands by itself for so long, then it is asked to walk again.
constexpr std::int64_t kStopped_ns = 2 * kSecond_ns;
constexpr std::int64_t kWatched_ns = 3 * kSecond_ns, kAfterEnd_ns = 1'500 * kMillisecond_ns;
constexpr std::int64_t kWell_ns = 500 * kMillisecond_ns;
constexpr std::int64_t kPatience_ns = 25 * kSecond_ns;  // after its end; then it does not come back

std::int64_t ns(double time_s) {
  return std::llround(time_s * 1e9);
}

}  // namespace

std::int64_t TrialPlayer::look() {
  process::wait_until(process::monotonic_ns() + kBetweenLooks_ns, {});
  const RobotSight sight = ground_.eye.look();
  watch_.look(sight);
  if (sight.at_ns - fall_looked_ns_ >= kBetweenFallLooks_ns) {
    fall_looked_ns_ = sight.at_ns;
    if (ground_.robot.told_fall()) watch_.on_fall(sight.at_ns);
  }
  well_ = watch_.walks() && sight.is_commandable && sight.all_parts_work;
  return sight.at_ns;
}

bool TrialPlayer::wait_for_walk() {
  ground_.person.walk(true);
  const std::int64_t until_ns = process::monotonic_ns() + kUntilItWalks_ns;
  while (!process::stop_requested()) {
    const std::int64_t now_ns = look();
    if (watch_.has_fallen()) throw std::runtime_error("the robot fell before any fault");
    if (well_) return true;
    if (now_ns > until_ns) {
      throw std::runtime_error(fmt::format("the robot does not walk within {} s, before any fault",
                                           kUntilItWalks_ns / kSecond_ns));
    }
  }
  return false;
}

bool TrialPlayer::wait_for_instant() {
  instant_ns_ = process::monotonic_ns() + ns(trial_.instant_s);
  bool prepared = !row_.prepare;
  FaultPlace place{ground_.robot, ground_.person};
  if (trial_.is_stopped) {
    stop_ = std::make_unique<StopAsker>(ground_.robot.url(), instant_ns_ + ns(kStopAsked_s));
  }
  while (!process::stop_requested()) {
    const std::int64_t now_ns = look();
    if (!prepared && now_ns >= instant_ns_ - kPrepared_ns) {
      prepared = true;
      row_.prepare(place, instant_ns_);
    }
    if (now_ns + kBetweenLooks_ns >= instant_ns_) {
      process::wait_until(instant_ns_, {});
      return true;
    }
  }
  return false;
}

void TrialPlayer::let_it_happen() {
  FaultPlace place{ground_.robot, ground_.person};
  instant_ns_ = std::max(instant_ns_, process::monotonic_ns());
  watch_.on_fault(instant_ns_);
  if (row_.begin) noise_ = row_.begin(place);
  end_ns_ = instant_ns_ + ns(row_.lasts_s);
}

// Who commands is silent while the stop holds, else the next order would end it.
void TrialPlayer::follow_stop(std::int64_t now_ns) {
  if (!stop_ || stop_->asked_ns() == 0) return;
  if (walk_again_ns_ == 0) {
    watch_.on_stop_asked(stop_->asked_ns());
    ground_.person.walk(false);
    walk_again_ns_ = now_ns + kStopped_ns;
  } else if (now_ns >= walk_again_ns_) {
    ground_.person.walk(true);
  }
}

bool TrialPlayer::is_over(std::int64_t now_ns) const {
  if (watch_.has_fallen()) return true;
  const bool is_told = now_ns >= std::max(instant_ns_ + kWatched_ns, end_ns_ + kAfterEnd_ns);
  return (is_told && watch_.well_ns(now_ns) >= kWell_ns) || now_ns >= end_ns_ + kPatience_ns;
}

std::optional<RealTimeOutcome> TrialPlayer::play() {
  if (!wait_for_walk() || !wait_for_instant()) return std::nullopt;
  let_it_happen();
  for (std::int64_t now_ns = instant_ns_; !is_over(now_ns);) {
    now_ns = look();
    if (process::stop_requested()) return std::nullopt;
    follow_stop(now_ns);
    if (noise_ && now_ns >= end_ns_) {
      note_ = noise_->told();
      noise_.reset();
    }
  }
  ground_.person.walk(true);
  RealTimeOutcome outcome = watch_.outcome();
  outcome.seed = ground_.robot.seed();
  outcome.note = note_;
  return outcome;
}

}  // namespace gaitway::tools
