// Where the frame `odometry` lies in the world: dead reckoning drifts, and whatever sees the room corrects
// it.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/planning/limits.hpp"

namespace gaitway::navigation {

struct PoseFilterParameters {
  // Of dead reckoning: standard deviations after one metre of way, and after one radian of turn.
  double way_drift_m = 0.02, way_drift_rad = 0.02, turn_drift_rad = 0.03;
  double start_deviation_m = 0.005, start_deviation_rad = 0.01;
};

// A Kalman filter with place and heading of the base as its independent states. What is measured is held
// against where the base was when it was seen.
class PoseFilter {
 public:
  // `start`: of the frame `odometry` in the world.
  PoseFilter(const planning::Pose& start, const PoseFilterParameters& parameters) noexcept;

  // At each estimate, in the order of time: the base in the frame `odometry`.
  void predict(std::int64_t stamp_ns, const planning::Pose& base) noexcept;
  // False: it is of no use, since it is older than what is remembered, not finite, or far from all that is
  // likely. Ten such in a row that agree are believed: somebody has carried the robot.
  bool correct(std::int64_t stamp_ns, const planning::Pose& base_in_world, double deviation_m,
               double deviation_rad) noexcept;

  [[nodiscard]] const planning::Pose& odometry() const noexcept { return odometry_; }
  [[nodiscard]] double deviation_m() const noexcept;
  [[nodiscard]] double deviation_rad() const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.odometry_, self.variance_m2_, self.variance_rad2_, self.moments_, self.count_,
            self.strange_);
  }

 private:
  struct Moment {
    std::int64_t stamp_ns = 0;
    planning::Pose base;
  };
  static constexpr std::size_t kRemembered = 128;  // estimates of 10 ms
  static constexpr int kInsistent = 10;

  [[nodiscard]] const Moment* at(std::int64_t stamp_ns) const noexcept;

  PoseFilterParameters parameters_;
  planning::Pose odometry_;
  double variance_m2_, variance_rad2_;
  std::array<Moment, kRemembered> moments_{};
  std::size_t count_ = 0;  // of moments since the start
  int strange_ = 0;        // measurements in a row
};

}  // namespace gaitway::navigation
