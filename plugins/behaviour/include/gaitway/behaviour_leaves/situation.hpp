// What the leaves of a tick see of the robot: topics as they are at that tick, and what follows from them.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::behaviour_leaves {

// Of something on the ground, in a frame that the name of the variable or function says.
struct Pose {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};
// A pose that is told in `frame`, in the frame in which `frame` is told.
[[nodiscard]] Pose outside(const Pose& frame, const Pose& pose) noexcept;
// The other way round.
[[nodiscard]] Pose inside(const Pose& frame, const Pose& pose) noexcept;
// The same angle from -pi to pi.
[[nodiscard]] double wrapped_rad(double angle_rad) noexcept;

// A target as the cameras have found it.
struct Target {
  std::int64_t seen_ns = 0;
  double position_m[3] = {};  // odometry
  std::optional<double>
      facing_rad;  // of a tag: where its face looks, in odometry; none: unknown, or up or down
};

// Topics that have no value yet or no writer, and those whose writer has gone silent, are null. They live for
// one tick.
struct Situation {
  std::int64_t now_ns = 0;
  const Estimate* estimate = nullptr;
  const FootstepState* footsteps = nullptr;
  const NavigationState* navigation = nullptr;
  const MotionState* motion = nullptr;
  const CommandState* command = nullptr;
  const SeenTargets* targets = nullptr;
  const VisionState* vision = nullptr;
  const NetworkState* network = nullptr;

  // Whether the behaviour's orders are obeyed. Without an arbiter: yes.
  [[nodiscard]] bool commands() const noexcept;
  // The same of motions: also where the robot has fallen under a person's command, and may get up.
  [[nodiscard]] bool commands_motions() const noexcept;
  [[nodiscard]] bool person_commands() const noexcept;
  // Without an estimate nothing of this is known, and none of it holds.
  [[nodiscard]] bool is_upright() const noexcept;
  [[nodiscard]] bool has_fallen() const noexcept;  // or is falling
  [[nodiscard]] bool lies() const noexcept;
  // Upright at rest: neither walks nor plays a motion.
  [[nodiscard]] bool stands() const noexcept;
  [[nodiscard]] bool plays_motion() const noexcept;
  [[nodiscard]] bool sees() const noexcept;  // the cameras, be it impaired

  [[nodiscard]] Pose base() const noexcept;                     // in odometry
  [[nodiscard]] std::optional<Pose> odometry() const noexcept;  // in world; none without navigation
  [[nodiscard]] std::optional<Pose> place() const noexcept;     // the middle between the feet in world
  // Nothing: never seen, or longer ago than `oldest_ns`.
  [[nodiscard]] std::optional<Target> tag(std::int64_t id, std::int64_t oldest_ns) const noexcept;
  [[nodiscard]] double distance_m(const Target& target) const noexcept;  // level, from the base
};

}  // namespace gaitway::behaviour_leaves
