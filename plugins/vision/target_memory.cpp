// One filter a target; the oldest makes room.
#include "gaitway/vision/target_memory.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace gaitway::vision {
namespace {

constexpr double kMoves_m_per_s = 0.05;  // standard deviation of a target's, and of odometry's, own way
constexpr double kContradicts = 16.0;  // squared Mahalanobis distance in three dimensions: one in a thousand
constexpr double kTurnShare = 0.3;     // by which a new orientation turns the old one
constexpr double kTurnedAnew_rad = 0.5;
constexpr std::uint32_t kToldFrom = 2;  // sightings
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr double kNs = 1e-9;

Eigen::Matrix3d matrix_of(const std::array<double, 6>& c) {
  Eigen::Matrix3d full;
  full << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return full;
}

// One number that is none would stay in the filter for ever.
bool is_sound(const TagSighting& sighting) noexcept {
  return sighting.position_m.allFinite() && sighting.covariance_m2.allFinite() &&
         sighting.covariance_m2.diagonal().minCoeff() > 0.0 && sighting.orientation.coeffs().allFinite() &&
         sighting.orientation.norm() > 0.5 && std::isfinite(sighting.size_m);
}

std::array<double, 6> list_of(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

}  // namespace

TargetMemory::Target* TargetMemory::find(int id) noexcept {
  const auto known = std::span(known_).first(count_);
  const auto found = std::ranges::find(known, id, &Target::id);
  return found == known.end() ? nullptr : &*found;
}

TargetMemory::Target& TargetMemory::place_for(int id) noexcept {
  if (count_ < kMaxTargets) {
    known_[count_] = Target{.id = id};
    return known_[count_++];
  }
  Target& oldest = *std::ranges::min_element(known_, {}, &Target::seen_ns);
  oldest = Target{.id = id};
  return oldest;
}

void TargetMemory::see(const TagSighting& sighting, std::int64_t stamp_ns) noexcept {
  if (!is_sound(sighting)) return;
  Target* known = find(sighting.id);
  if (known == nullptr) known = &place_for(sighting.id);
  Target& target = *known;
  const double elapsed_s = kNs * static_cast<double>(std::max<std::int64_t>(stamp_ns - target.seen_ns, 0));
  Eigen::Map<Eigen::Vector3d> position(target.position_m.data());
  const double way_m = kMoves_m_per_s * elapsed_s;
  const Eigen::Matrix3d before =
      matrix_of(target.covariance_m2) + way_m * way_m * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d off = sighting.position_m - position;
  const Eigen::Matrix3d doubt = before + sighting.covariance_m2;
  Eigen::Quaterniond turn(target.orientation[0], target.orientation[1], target.orientation[2],
                          target.orientation[3]);
  const bool begins = target.sightings == 0 || off.dot(doubt.ldlt().solve(off)) > kContradicts;
  if (begins) {
    // A place that is new must be confirmed; a known target that was carried off is still that target.
    position = sighting.position_m;
    target.covariance_m2 = list_of(sighting.covariance_m2);
    turn = sighting.orientation;
  } else {
    const Eigen::Matrix3d gain = before * doubt.inverse();
    position += gain * off;
    const Eigen::Matrix3d after = (Eigen::Matrix3d::Identity() - gain) * before;
    target.covariance_m2 = list_of(0.5 * (after + after.transpose()));
    if (sighting.knows_orientation) {
      turn = turn.angularDistance(sighting.orientation) > kTurnedAnew_rad
                 ? sighting.orientation
                 : turn.slerp(kTurnShare, sighting.orientation);
    }
  }
  const bool is_confirmed = target.sightings >= kToldFrom || elapsed_s < 1.0;
  target.sightings =
      target.sightings == 0 || !is_confirmed ? 1 : std::min(target.sightings + 1, std::uint32_t{1000});
  turn.normalize();
  target.orientation = {turn.w(), turn.x(), turn.y(), turn.z()};
  target.size_m = sighting.size_m;
  target.seen_ns = stamp_ns;
}

void TargetMemory::forget(std::int64_t now_ns) noexcept {
  const auto known = std::span(known_).first(count_);
  const auto left = std::remove_if(known.begin(), known.end(), [&](const Target& target) {
    const std::int64_t age_ns = now_ns - target.seen_ns;
    return age_ns > forget_after_ns_ || (target.sightings < kToldFrom && age_ns > kSecond_ns);
  });
  count_ = static_cast<std::uint32_t>(left - known.begin());
}

void TargetMemory::write(SeenTargets& targets, std::int64_t stamp_ns) const noexcept {
  targets = {};
  targets.stamp_ns = stamp_ns;
  for (const Target& target : std::span(known_).first(std::min<std::size_t>(count_, kMaxTargets))) {
    if (target.sightings < kToldFrom) continue;
    const std::uint32_t i = targets.count++;
    targets.kind[i] = seen_targets::kind::tag;
    targets.id[i] = static_cast<std::uint32_t>(target.id);
    targets.seen_ns[i] = target.seen_ns;
    std::ranges::copy(target.position_m, targets.position[i]);
    std::ranges::copy(target.covariance_m2, targets.covariance[i]);
    std::ranges::copy(target.orientation, targets.orientation[i]);
    targets.size[i] = target.size_m;
  }
}

}  // namespace gaitway::vision
