// What the robot was planned to do at an instant. The newest motion plan is usually for a batch that has not
// started, so the ones before it are kept.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::api {

struct PlannedFoot {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // of the sole frame's origin, frame `plan`
  double yaw_rad = 0.0;
  bool on_ground = true;
};

struct PlannedMoment {
  std::array<PlannedFoot, 2> feet;  // [Side]
  Eigen::Vector2d zmp_m = Eigen::Vector2d::Zero();
  const MotionPlan* plan = nullptr;  // in force; until the next take() or clear()
};

// Holds four plans of 28 KiB: for the heap. take() and at() do not allocate.
class PlannedMotion {
 public:
  // A plan, in the place of one of the same batch. One without sequence is not taken.
  void take(const MotionPlan& plan) noexcept;
  void clear() noexcept { kept_ = {}; }

  // accepted_sequence: newest batch that the message controller accepted, if that is known: a plan that it
  // has not accepted is not played. Between two points the values are interpolated; after its last point a
  // plan stays at it. Nothing before the first plan starts.
  [[nodiscard]] std::optional<PlannedMoment> at(
      std::int64_t instant_ns, std::optional<std::uint32_t> accepted_sequence) const noexcept;

 private:
  static constexpr std::size_t kKept = 4;  // a batch is planned less than three cycles ahead

  // The plan before `plan`, of those that are kept.
  [[nodiscard]] const MotionPlan* before(const MotionPlan& plan) const noexcept;

  std::array<MotionPlan, kKept> kept_{};  // sequence 0: none
};

}  // namespace gaitway::api
