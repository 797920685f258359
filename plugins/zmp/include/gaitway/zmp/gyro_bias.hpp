// The gyro's bias, learned whenever the robot stands still: what keeps the heading from drifting.
#pragma once

#include <Eigen/Core>

#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

class GyroBias {
 public:
  explicit GyroBias(const EstimatorParameters& parameters) noexcept;

  // planted: both feet in contact. joint_rate: of the fastest leg joint. The bias is a running mean of what
  // the gyro says while the robot is still, at first over all samples, later with the time constant.
  void update(const Eigen::Vector3d& gyro_rad_per_s, bool planted, double joint_rate_rad_per_s,
              double dt_s) noexcept;

  [[nodiscard]] const Eigen::Vector3d& bias_rad_per_s() const noexcept { return bias_; }
  [[nodiscard]] bool is_still() const noexcept { return still_s_ >= still_time_s_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.bias_, self.still_s_, self.learned_s_);
  }

 private:
  double still_rate_, still_joint_rate_, still_time_s_, time_constant_s_, limit_;
  Eigen::Vector3d bias_ = Eigen::Vector3d::Zero();
  double still_s_ = 0.0;
  double learned_s_ = 0.0;
};

}  // namespace gaitway::zmp
