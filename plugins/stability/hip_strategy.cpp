// How far to bow, and the batches that bring the trunk there.
#include "gaitway/stability/hip_strategy.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::stability {
namespace {

constexpr double kNoBow_rad = 0.02;  // less is no bow
constexpr double kHipShare =
    0.45;  // the hips turn twice as fast as the trunk, since the CoM stays over the feet

}  // namespace

HipStrategy::HipStrategy(const urdf::RobotModel& model, const BalanceParameters& parameters)
    : parameters_(parameters),
      middle_m_(0.5 * (model.feet[0].centre_m.x() + model.feet[1].centre_m.x())),
      most_rad_per_s_(kHipShare * urdf::slowest_leg_joint_rad_per_s(model)) {}

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
void HipStrategy::begin_batch(std::uint32_t sequence, Batching what, std::uint32_t tail_count,
                              std::optional<std::uint32_t> accepted_sequence) noexcept {
  if (sequence == 0 || sequence == batches_[newest_].sequence) return;
  Batch next{.sequence = sequence, .tail_count = tail_count, .from = {}, .to = {}};
  newest_ = (newest_ + 1) % kKept;
  if (what == Batching::lies_down) {
    wanted_rad_ = 0.0;
    batches_[newest_] = next;
    return;
  }
  if (const Batch* const before = played_before(sequence, accepted_sequence)) {
    next.from = at(before->sequence, facts::kCycle_s * (sequence - before->sequence));
  }
  if (what == Batching::steps)
    wanted_rad_ = next.from.angle_rad + 0.5 * next.from.rate_rad_per_s * facts::kCycle_s;
  const double to_go_rad =
      wanted_rad_ - next.from.angle_rad - 0.5 * next.from.rate_rad_per_s * facts::kCycle_s;
  const double most_rad_per_s = std::min(parameters_.bow_speed_rad_per_s, most_rad_per_s_);
  next.to.rate_rad_per_s = std::clamp(to_go_rad / facts::kCycle_s, -most_rad_per_s, most_rad_per_s);
  // Going back quickly would throw the body to where it came from.
  const double outwards = next.from.angle_rad + wanted_rad_ >= 0.0 ? 1.0 : -1.0;
  next.to.rate_rad_per_s =
      outwards * std::max(outwards * next.to.rate_rad_per_s, -parameters_.bow_return_rad_per_s);
  next.to.angle_rad =
      next.from.angle_rad + 0.5 * (next.from.rate_rad_per_s + next.to.rate_rad_per_s) * facts::kCycle_s;
  batches_[newest_] = next;
}

const HipStrategy::Batch* HipStrategy::played_before(
    std::uint32_t sequence, std::optional<std::uint32_t> accepted_sequence) const noexcept {
  const Batch* newest = nullptr;
  for (const Batch& kept : batches_) {
    const bool played = kept.sequence != 0 && kept.sequence < sequence &&
                        kept.sequence <= accepted_sequence.value_or(kept.sequence);
    if (played && (newest == nullptr || kept.sequence > newest->sequence)) newest = &kept;
  }
  return newest;
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
