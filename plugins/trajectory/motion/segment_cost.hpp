// What one segment of a motion costs: its time, its jerk, and every limit that it breaks.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/motion_limits.hpp"
#include "gaitway/motion/motion_path.hpp"
#include "gaitway/motion/stance_map.hpp"

namespace gaitway::motion {

// Postures and loads along a segment.
class SegmentSampler {
 public:
  explicit SegmentSampler(const urdf::RobotModel& robot)
      : map_(robot), loads_(robot), joint_count_(robot.joints.size()) {}

  // By how much a leg is out of reach, m.
  double posture(const Segment& segment, const std::vector<trajectory::Quintic>& spline, double time_s,
                 BodyPosture& posture);
  [[nodiscard]] BodyLoadCalculator& loads() noexcept { return loads_; }
  [[nodiscard]] const Eigen::VectorXd& coordinates() const noexcept {
    return coordinates_;
  }  // of the last posture

 private:
  StanceMap map_;
  BodyLoadCalculator loads_;
  std::size_t joint_count_;
  Eigen::VectorXd coordinates_;
};

struct CostWeights {
  double smoothness = 0.0;
  double penalty = 0.0;  // of a limit broken by its own size
};

// A residual vector for Ceres. Its parameter blocks: the duration; the velocities, then the accelerations of
// what moves at the knot before, if anything does; the same of the knot after.
class SegmentCost {
 public:
  SegmentCost(const urdf::RobotModel& robot, const MotionLimits& limits, const Segment& segment,
              const Knot& start, const Knot& end, const CostWeights& weights);

  [[nodiscard]] int residual_count() const noexcept;
  bool operator()(const double* const* parameters, double* residuals) const;

 private:
  struct Workspace {
    Segment segment;
    Knot start, end;
    SegmentSampler sampler;
    std::array<BodyPosture, 3> posture;
  };
  double* limits_of_joints(const BodyPosture& posture, const BodyLoad& load, double* residual) const;
  double* limits_of_stance(const BodyLoad& load, const Eigen::VectorXd& coordinates, double* residual) const;

  double friction_;
  MotionLimits limits_;
  JointLimits joint_limits_;
  CostWeights weights_;
  SupportArea area_;
  std::vector<Eigen::Index> lifted_;  // coordinates of the heights of the feet in the air
  int samples_;
  mutable Workspace work_;  // Ceres calls from one thread
};

}  // namespace gaitway::motion
