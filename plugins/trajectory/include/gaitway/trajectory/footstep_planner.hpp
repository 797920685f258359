// Where the feet go: footsteps from a walking velocity, kept within what the legs can reach and clear of each
// other; and the words for what had to be limited.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

enum class Side : std::uint8_t { left = 0, right = 1 };

[[nodiscard]] constexpr Side other(Side side) noexcept {
  return side == Side::left ? Side::right : Side::left;
}
// +1 for left, −1 for right: the sign of y on that side.
[[nodiscard]] constexpr double sign_of(Side side) noexcept {
  return side == Side::left ? 1.0 : -1.0;
}

// A place on the ground; yaw is not wrapped.
struct Pose2 {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;

  [[nodiscard]] Eigen::Vector2d position() const noexcept { return {x_m, y_m}; }
  [[nodiscard]] Eigen::Vector2d transform(double forward_m, double left_m) const noexcept;
  [[nodiscard]] Pose2 compose(const Pose2& local) const noexcept;           // this · local
  [[nodiscard]] Pose2 relative_of(const Pose2& other_pose) const noexcept;  // this⁻¹ · other_pose
};

struct Velocity2 {
  double forward_m_per_s = 0.0, left_m_per_s = 0.0, turn_rad_per_s = 0.0;
};

// Which named rule changed a request; a set of bits.
enum class StepLimit : std::uint32_t {
  none = 0,
  speed = 1,         // velocity outside the ellipsoid of largest speeds: scaled onto it, direction kept
  acceleration = 2,  // velocity changed by more than the accelerations allow in one step
  length = 4,        // footstep further ahead or behind than max_step_forward / max_step_backward
  sole_gap = 8,      // footstep so near that the soles would come closer than min_sole_gap
  spacing = 16,      // footstep further to the side than max_foot_spacing
  turn = 32,         // footstep turned by more than max_step_turn
};
[[nodiscard]] constexpr StepLimit operator|(StepLimit a, StepLimit b) noexcept {
  return static_cast<StepLimit>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr bool has(StepLimit set, StepLimit rule) noexcept {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(rule)) != 0;
}

class FootstepPlanner {
 public:
  explicit FootstepPlanner(const GaitParameters& parameters);

  // The velocity of the next step: `wanted` limited to the ellipsoid of largest speeds, then approached from
  // `present` within one step's acceleration. Adds what it applied to `applied`.
  [[nodiscard]] Velocity2 next_velocity(const Velocity2& present, const Velocity2& wanted,
                                        StepLimit& applied) const noexcept;

  // Landing place of the swing foot, given the stance foot, which stepped with the velocity `before`.
  // `offset_m` (stance frame) is added before the limits.
  [[nodiscard]] Pose2 landing(const Pose2& stance, Side swing, const Velocity2& before,
                              const Velocity2& velocity, const Eigen::Vector2d& offset_m,
                              StepLimit& applied) const noexcept;

  // The same of a step that is moved after the body: nobody has commanded that, so no limit is told of, and
  // the feet come no further apart than adjust_spacing, or than they would anyway.
  [[nodiscard]] Pose2 adjusted_landing(const Pose2& stance, Side swing, const Velocity2& before,
                                       const Velocity2& velocity,
                                       const Eigen::Vector2d& offset_m) const noexcept;

  // Landing place of a step whose place is given, in the stance foot's frame: within the limits of one step,
  // `offset_m` added before.
  [[nodiscard]] Pose2 placed_landing(const Pose2& stance, Side swing, const Pose2& place,
                                     const Eigen::Vector2d& offset_m) const noexcept;

  // Landing place beside the stance foot.
  [[nodiscard]] Pose2 beside(const Pose2& stance, Side swing) const noexcept;
  [[nodiscard]] bool is_beside(const Pose2& stance, Side swing, const Pose2& foot) const noexcept;

  // Least lateral distance of the sole origins that keeps the soles min_sole_gap apart when the swing foot is
  // turned by turn_rad against the stance foot (positive: counter-clockwise).
  [[nodiscard]] double least_spacing_m(Side swing, double turn_rad) const noexcept;

  // Largest speeds, the half axes of the ellipsoid; forward and backward differ.
  [[nodiscard]] double max_forward_m_per_s(bool backward) const noexcept;
  [[nodiscard]] double max_left_m_per_s() const noexcept;
  [[nodiscard]] double max_turn_rad_per_s() const noexcept;

 private:
  [[nodiscard]] Pose2 limited(Pose2 foot, Side swing, const Eigen::Vector2d& offset_m,
                              StepLimit& applied) const noexcept;
  [[nodiscard]] double walking_spacing_m(const Velocity2& velocity) const noexcept;
  [[nodiscard]] Velocity2 limit_speed(const Velocity2& wanted, StepLimit& applied) const noexcept;

  GaitParameters parameters_;
};

// Says which named rule limits a walk command, once a command and rule.
// What the last plan had to change of what was asked for; no allocation.
class LimitReport {
 public:
  explicit LimitReport(const GaitParameters& parameters) noexcept
      : parameters_(parameters), planner_(parameters) {}

  // The live numbers of the parameters.
  void tune(const GaitParameters& changed) noexcept { parameters_.tune(changed); }

  // The rules in `applied` that have not been told since the command last changed.
  [[nodiscard]] StepLimit news(const WalkCommand& command, StepLimit applied) noexcept;

  // One line for one rule: what was asked for, the rule's name and its value. Valid until the next call.
  [[nodiscard]] const char* text(StepLimit rule) noexcept;

 private:
  GaitParameters parameters_;
  FootstepPlanner planner_;
  WalkCommand command_{};
  StepLimit told_ = StepLimit::none;
  std::array<char, 192> text_{};
};

// Every rule, one bit each.
inline constexpr std::array kStepLimits{StepLimit::speed,    StepLimit::acceleration, StepLimit::length,
                                        StepLimit::sole_gap, StepLimit::spacing,      StepLimit::turn};

}  // namespace gaitway::trajectory
