// Counts the points that have been played since the batch that was accepted last began.
#include "gaitway/trajectory/accepted_references.hpp"

#include <algorithm>

namespace gaitway::trajectory {

// After the tail's last point the references stay there.
std::optional<FallPosture::References> AcceptedReferences::before(std::uint32_t sequence) noexcept {
  if (accepted_.sequence == 0 || sequence <= accepted_.sequence) return std::nullopt;
  const std::size_t points = kBatchPoints + std::min<std::size_t>(accepted_.tail_count, kMaxTailPoints);
  const std::size_t played = kBatchPoints * std::size_t{sequence - accepted_.sequence};
  const std::size_t at = std::min(played, points) - 1;
  const std::size_t before = played > points ? at : at - 1;
  const std::size_t joints = std::min<std::size_t>(accepted_.joint_count, kMaxJoints);
  std::copy_n(accepted_.position[before], joints, before_rad_.begin());
  std::copy_n(accepted_.position[at], joints, at_rad_.begin());
  return FallPosture::References{before_rad_, at_rad_};
}

}  // namespace gaitway::trajectory
