// How far to bow, and the batches that bring the trunk there.
#include "gaitway/stability/hip_strategy.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::stability {
namespace {

constexpr double kNoBow_rad = 0.02;  // less is no bow

}  // namespace

HipStrategy::HipStrategy(const urdf::RobotModel& model, const BalanceParameters& parameters)
    : parameters_(parameters), middle_m_(0.5 * (model.feet[0].centre_m.x() + model.feet[1].centre_m.x())) {}

// The body swings back over its middle before it rests: only a bow that is nearly over gives way to one to
// the other side.
void HipStrategy::follow(const std::optional<Standing>& standing) noexcept {
  const double ahead_m = standing ? standing->dcm_ahead_m - middle_m_ : 0.0;
  const double falling_m = standing ? standing->dcm_ahead_m - standing->com_ahead_m : 0.0;
  const bool is_pushed =
      std::copysign(1.0, ahead_m) * falling_m > parameters_.bow_sway_m || wanted_rad_ * ahead_m > 0.0;
  const double beyond_m =
      is_pushed && std::isfinite(ahead_m) ? std::max(std::abs(ahead_m) - parameters_.bow_beyond_m, 0.0) : 0.0;
  const double asked_rad =
      std::copysign(std::min(parameters_.bow_gain_rad_per_m * beyond_m, parameters_.bow_limit_rad), ahead_m);
  wanted_rad_ = std::copysign(
      std::max(std::abs(wanted_rad_) - parameters_.bow_return_rad_per_s * facts::kSlot_s, 0.0), wanted_rad_);
  const bool same_side = asked_rad * wanted_rad_ > 0.0;
  if (same_side ? std::abs(asked_rad) > std::abs(wanted_rad_) : std::abs(wanted_rad_) < kNoBow_rad) {
    wanted_rad_ = asked_rad;
  }
}

// With one acceleration for the batch and its opposite for the next, the bow rests where it is wanted.
void HipStrategy::begin_batch(std::uint32_t sequence, bool steps, std::uint32_t tail_count) noexcept {
  const Batch& last = batches_[newest_];
  if (sequence == 0 || sequence == last.sequence) return;
  Batch next{.sequence = sequence, .tail_count = tail_count, .from = {}, .to = {}};
  if (last.sequence != 0 && sequence > last.sequence) {
    next.from = at(last.sequence, facts::kCycle_s * (sequence - last.sequence));
  }
  if (steps) wanted_rad_ = next.from.angle_rad + 0.5 * next.from.rate_rad_per_s * facts::kCycle_s;
  const double to_go_rad =
      wanted_rad_ - next.from.angle_rad - 0.5 * next.from.rate_rad_per_s * facts::kCycle_s;
  next.to.rate_rad_per_s = std::clamp(to_go_rad / facts::kCycle_s, -parameters_.bow_speed_rad_per_s,
                                      parameters_.bow_speed_rad_per_s);
  // Going back quickly would throw the body to where it came from.
  const double outwards = next.from.angle_rad + wanted_rad_ >= 0.0 ? 1.0 : -1.0;
  next.to.rate_rad_per_s =
      outwards * std::max(outwards * next.to.rate_rad_per_s, -parameters_.bow_return_rad_per_s);
  next.to.angle_rad =
      next.from.angle_rad + 0.5 * (next.from.rate_rad_per_s + next.to.rate_rad_per_s) * facts::kCycle_s;
  newest_ = (newest_ + 1) % kKept;
  batches_[newest_] = next;
}

msgclient::Bow HipStrategy::at(std::uint32_t sequence, double since_start_s) const noexcept {
  const auto batch = std::find_if(batches_.begin(), batches_.end(), [&](const Batch& kept) {
    return kept.sequence != 0 && kept.sequence == sequence;
  });
  if (batch == batches_.end()) return {};
  msgclient::Bow bow = msgclient::bow_at(batch->from, batch->to, since_start_s, facts::kCycle_s);
  const double tail_points = std::max(since_start_s - facts::kCycle_s, 0.0) / facts::kSlot_s;
  bow.angle_rad *=
      msgclient::tail_share(static_cast<std::uint64_t>(std::lround(tail_points)), batch->tail_count);
  return bow;
}

bool HipStrategy::bows() const noexcept {
  const Batch& batch = batches_[newest_];
  return std::max(std::abs(batch.from.angle_rad), std::abs(batch.to.angle_rad)) > kNoBow_rad;
}

}  // namespace gaitway::stability
