// The newest plan that plays, looked up at each slot's edge.
#include "gaitway/api/plan_digest.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

// Whether a foot is lifted in the batch that plays, a step is still to come, or the body still comes to rest
// after the last one.
bool walks(const MotionPlan& plan, std::int64_t instant_ns) noexcept {
  constexpr std::uint8_t kBothFeet = 2;
  constexpr double kRest_m_per_s = 1e-3;
  const auto support = std::span(plan.support).first(kBatchPoints);
  const auto velocities = std::span(plan.com_velocity).first(kBatchPoints);
  const auto landings =
      std::span(plan.footstep_landing_ns).first(std::min<std::size_t>(plan.footstep_count, kMaxFootsteps));
  return std::ranges::any_of(support, [](std::uint8_t feet) { return feet != kBothFeet; }) ||
         std::ranges::any_of(landings,
                             [instant_ns](std::int64_t landing_ns) { return landing_ns > instant_ns; }) ||
         std::ranges::any_of(velocities, [](const auto& velocity_m_per_s) {
           return std::hypot(velocity_m_per_s[0], velocity_m_per_s[1]) > kRest_m_per_s;
         });
}

// What is left to step, from the plan in force.
void add_footsteps(const MotionPlan& plan, PlannedState& state) noexcept {
  const std::size_t count = std::min<std::size_t>(plan.footstep_count, kMaxFootsteps);
  for (std::size_t i = 0; i < count; ++i) {
    if (plan.footstep_landing_ns[i] > state.stamp_ns) {
      std::ranges::copy(plan.footstep[i], state.footstep[state.footstep_count++]);
    }
  }
}

}  // namespace

PlannedState planned_state_of(const std::optional<PlannedMoment>& moment, std::int64_t instant_ns) noexcept {
  PlannedState state{};
  state.stamp_ns = instant_ns;
  if (!moment) {
    return state;
  }
  state.sequence = moment->plan->sequence;
  state.walks = walks(*moment->plan, instant_ns) ? 1 : 0;
  for (std::size_t side = 0; side < moment->feet.size(); ++side) {
    const PlannedFoot& foot = moment->feet[side];
    state.on_ground[side] = foot.on_ground ? 1 : 0;
    std::ranges::copy(foot.position_m, state.foot_position[side]);
    state.foot_yaw[side] = foot.yaw_rad;
  }
  std::ranges::copy(moment->zmp_m, state.zmp);
  add_footsteps(*moment->plan, state);
  return state;
}

PlanDigest::PlanDigest(msgclient::Client& client)
    : plans_(client.read<MotionPlan>("motion_plan")),
      network_(client.read<NetworkState>("network_state")),
      digests_(client.write<PlannedState>("planned_state")),
      plan_(std::make_unique<MotionPlan>()),
      motion_(std::make_unique<PlannedMotion>()) {}

void PlanDigest::step(std::int64_t robot_ns) noexcept {
  if (robot_ns < edge_ns_) {  // the robot was started anew
    motion_->clear();
  }
  if (plans_.newest_sequence() != plan_seen_) {
    if (const auto read = plans_.read(*plan_)) {
      plan_seen_ = read.sequence;
      motion_->take(*plan_);
    }
  }
  const std::int64_t edge_ns = robot_ns - robot_ns % facts::kSlot_ns;
  if (edge_ns == edge_ns_ || robot_ns == 0) {
    return;
  }
  edge_ns_ = edge_ns;
  NetworkState network;
  const auto accepted = network_.read(network) ? std::optional(network.accepted_sequence) : std::nullopt;
  digests_.publish(planned_state_of(motion_->at(edge_ns, accepted), edge_ns), robot_ns);
}

}  // namespace gaitway::api
