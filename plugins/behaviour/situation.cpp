// What follows from the topics of one tick.
#include "gaitway/behaviour_leaves/situation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaitway::behaviour_leaves {
namespace {

// Where a tag's face looks on the ground: z of its frame. None where it looks up or down, or is not known.
std::optional<double> facing_rad(const double (&q)[4]) noexcept {
  const double x = 2.0 * (q[1] * q[3] + q[0] * q[2]);
  const double y = 2.0 * (q[2] * q[3] - q[0] * q[1]);
  constexpr double kLeastLevel = 0.3;
  if (!(std::hypot(x, y) >= kLeastLevel)) return std::nullopt;
  return std::atan2(y, x);
}

}  // namespace

Pose outside(const Pose& frame, const Pose& pose) noexcept {
  const double c = std::cos(frame.yaw_rad), s = std::sin(frame.yaw_rad);
  return {frame.x_m + c * pose.x_m - s * pose.y_m, frame.y_m + s * pose.x_m + c * pose.y_m,
          frame.yaw_rad + pose.yaw_rad};
}

Pose inside(const Pose& frame, const Pose& pose) noexcept {
  const double c = std::cos(frame.yaw_rad), s = std::sin(frame.yaw_rad);
  const double x = pose.x_m - frame.x_m, y = pose.y_m - frame.y_m;
  return {c * x + s * y, -s * x + c * y, pose.yaw_rad - frame.yaw_rad};
}

double wrapped_rad(double angle_rad) noexcept {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

bool Situation::commands() const noexcept {
  return command == nullptr || command->commander == command_state::commander::nobody ||
         command->commander == command_state::commander::behaviour;
}

bool Situation::commands_motions() const noexcept {
  return commands() || command->may_get_up != 0;
}

bool Situation::person_commands() const noexcept {
  return command != nullptr && (command->commander == command_state::commander::person ||
                                command->commander == command_state::commander::emergency_stop);
}

bool Situation::is_upright() const noexcept {
  return estimate != nullptr && estimate->fall == estimate::fall::upright;
}

bool Situation::has_fallen() const noexcept {
  return estimate != nullptr && estimate->fall != estimate::fall::upright;
}

bool Situation::lies() const noexcept {
  return estimate != nullptr && estimate->fall == estimate::fall::lies;
}

bool Situation::plays_motion() const noexcept {
  return motion != nullptr && motion->state != 0;
}

bool Situation::stands() const noexcept {
  return is_upright() && !plays_motion() && footsteps != nullptr &&
         footsteps->state == footstep_state::state::stands;
}

bool Situation::sees() const noexcept {
  return vision != nullptr &&
         (vision->state == vision_state::state::sees || vision->state == vision_state::state::impaired);
}

Pose Situation::base() const noexcept {
  if (estimate == nullptr) return {};
  return {estimate->odometry_base[0], estimate->odometry_base[1], estimate->odometry_base[2]};
}

std::optional<Pose> Situation::odometry() const noexcept {
  if (navigation == nullptr) return std::nullopt;
  return Pose{navigation->odometry[0], navigation->odometry[1], navigation->odometry[2]};
}

std::optional<Pose> Situation::place() const noexcept {
  if (navigation == nullptr) return std::nullopt;
  return Pose{navigation->pose[0], navigation->pose[1], navigation->pose[2]};
}

std::optional<Target> Situation::tag(std::int64_t id, std::int64_t oldest_ns) const noexcept {
  if (targets == nullptr) return std::nullopt;
  const std::uint32_t count = std::min<std::uint32_t>(targets->count, kMaxTargets);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (targets->kind[i] != seen_targets::kind::tag || targets->id[i] != id) continue;
    const std::int64_t age_ns = now_ns - targets->seen_ns[i];
    if (age_ns < 0 || age_ns > oldest_ns) continue;
    const double(&at)[3] = targets->position[i];
    if (!std::isfinite(at[0] + at[1] + at[2])) continue;
    return Target{targets->seen_ns[i], {at[0], at[1], at[2]}, facing_rad(targets->orientation[i])};
  }
  return std::nullopt;
}

double Situation::distance_m(const Target& target) const noexcept {
  const Pose from = base();
  return std::hypot(target.position_m[0] - from.x_m, target.position_m[1] - from.y_m);
}

}  // namespace gaitway::behaviour_leaves
