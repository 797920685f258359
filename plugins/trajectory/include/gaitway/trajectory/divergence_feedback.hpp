// By how much the divergent component of the body's motion (DCM) will be off the plan's when the next batch
// begins.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

// Keeps the points of the last plans, since an estimate is of an instant that lies in the past.
class DivergenceFeedback {
 public:
  explicit DivergenceFeedback(const GaitParameters& parameters) noexcept;

  // Point i of the batch is reached at the end of its slot i. A batch that is planned anew takes its own
  // place.
  void take(const MotionPlan& plan) noexcept;
  // At its start, at `start_ns`, the plan has taken over so much of the deviation that was seen.
  void answered(const Eigen::Vector2d& by_m, std::int64_t start_ns) noexcept {
    answered_m_ = by_m;
    answered_ns_ = start_ns;
  }

  // Estimated less planned DCM at `start_ns`, in the plan's frame, m: the deviation at the estimate's
  // instant, both seen from the support foot, led on by ξ̇ = ω (ξ − p) as if the ZMP p stayed as far from the
  // planned one as it is. What the plan has answered since that instant is off no more. Zero without an
  // estimate that is upright, finite, at most 60 ms older than `start_ns`, and of an instant that was
  // planned.
  [[nodiscard]] Eigen::Vector2d deviation_m(const Estimate& estimate, std::int64_t start_ns) const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.points_, self.newest_, self.answered_m_, self.answered_ns_);
  }

 private:
  struct Point {
    std::int64_t time_ns = -1;
    double omega_per_s = 0.0;  // of the pendulum, as high as the hips have it
    Eigen::Vector2d dcm_m = Eigen::Vector2d::Zero(), zmp_m = Eigen::Vector2d::Zero();
    std::array<Eigen::Vector2d, 2> foot_m{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  // [Side]
    std::array<double, 2> foot_yaw_rad{};
    template <class Self, class Archive>
    static void visit_state(Self& self, Archive& archive) {
      archive(self.time_ns, self.omega_per_s, self.dcm_m, self.zmp_m, self.foot_m, self.foot_yaw_rad);
    }
  };
  static constexpr std::size_t kKept = 2UL * kBatchPoints;

  [[nodiscard]] const Point* planned_for(std::int64_t time_ns) const noexcept;
  [[nodiscard]] double omega_per_s(double hip_height_m) const noexcept;

  double com_above_hips_m_;
  std::int64_t lag_ns_;
  std::array<Point, kKept> points_{};
  std::size_t newest_ = 0;
  Eigen::Vector2d answered_m_ = Eigen::Vector2d::Zero();  // at answered_ns_, last
  std::int64_t answered_ns_ = -1;
};

}  // namespace gaitway::trajectory
