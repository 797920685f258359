// By how much the description misplaces the CoM over a foot, learned from the forces.
#pragma once

#include <Eigen/Core>

#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// Joint zeros and masses that are not as described put the kinematics' CoM some millimetres off, and by much
// the same while the robot is over one foot. A pendulum whose CoM is misplaced by e accelerates by -omega^2 e
// more than it should: on average over steps, or standing still, what the pendulum does not explain is that
// offset. One scalar Kalman filter for each horizontal axis; what pushes and swinging limbs do is noise to
// it.
class ComOffset {
 public:
  // deviation_m: before anything is learned, each axis.
  ComOffset(const EstimatorParameters& parameters, const Eigen::Vector2d& deviation_m) noexcept;

  // unexplained: horizontal acceleration that the pendulum about the corrected CoM does not explain.
  // zmp_variance: of the measured ZMP, m^2, common to all samples.
  void update(const Eigen::Vector2d& unexplained_m_per_s2, double omega_rad_per_s,
              const Eigen::Vector2d& zmp_variance_m2, double dt_s) noexcept;

  // To be taken from the kinematics' CoM.
  [[nodiscard]] const Eigen::Vector2d& offset_m() const noexcept { return offset_; }
  [[nodiscard]] Eigen::Vector2d variance_m2() const noexcept { return variance_ + floor_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_, self.variance_, self.floor_);
  }

 private:
  double noise_m_rts_, drift_m_per_rts_;
  Eigen::Vector2d prior_variance_;
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d variance_;
  Eigen::Vector2d floor_ = Eigen::Vector2d::Zero();  // what the forces themselves do not know
};

}  // namespace gaitway::zmp
