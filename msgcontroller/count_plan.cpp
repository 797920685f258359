// Turns hand-overs into counts and checks that a trajectory frame can carry them.
#include "gaitway/msgcontroller/count_plan.hpp"

#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {

CountPlanProblem to_counts(const msgclient::HandOver& hand_over, std::span<const double> count_rad,
                           std::span<const std::int32_t> start_count, CountPlan& plan) noexcept {
  using msgclient::Reason;
  const auto joints = static_cast<int>(hand_over.joint_count);
  const auto points = static_cast<int>(hand_over.point_count);
  if (static_cast<std::size_t>(joints) != count_rad.size() || points < kBatchPoints || points > kMaxPoints) {
    return {.reason = Reason::wrong_size};
  }
  const auto first = static_cast<int>(hand_over.first_slot);
  for (int point = first; point < points; ++point) {
    auto& row = plan.count[static_cast<std::size_t>(point)];
    for (int joint = 0; joint < joints; ++joint) {
      const auto j = static_cast<std::size_t>(joint);
      const double counts = static_cast<double>(hand_over.position_at(point, joint)) / count_rad[j];
      if (!(std::abs(counts) < 1e9)) {
        return {Reason::not_finite, joint, point, 0.0};
      }
      row[j] = static_cast<std::int32_t>(std::lround(counts));
      const std::int32_t before =
          point == first ? start_count[j] : plan.count[static_cast<std::size_t>(point - 1)][j];
      const std::int32_t delta = row[j] - before;
      if (delta > facts::kLargestByte_counts || delta < -facts::kLargestByte_counts) {
        return {point == first ? Reason::jump : Reason::too_fast, joint, point, static_cast<double>(delta)};
      }
    }
    plan.support[static_cast<std::size_t>(point)] = hand_over.support[static_cast<std::size_t>(point)];
  }
  plan.sequence = hand_over.sequence;
  plan.joint_count = joints;
  plan.point_count = points;
  plan.first_point = first;
  return {};
}

}  // namespace gaitway::msgcontroller
