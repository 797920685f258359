// How fast a foot that bears load slides over the ground.
#pragma once

#include <Eigen/Core>

#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// Joints do not tell the slip of the only foot on the ground; the accelerometer in its sole does. Its
// horizontal acceleration is integrated from touchdown on and leaks away with a time constant, as most feet
// stand most of the time; what stays while the foot stands is gravity on a sole whose tilt is not quite
// known, and is taken out. A slip shows at once, and one that lasts longer than the time constant shows
// smaller than it is.
class SlipObserver {
 public:
  explicit SlipObserver(const EstimatorParameters& parameters) noexcept;

  // acceleration: of the sole, horizontal, without gravity, mean over the last dt_s.
  void update(bool in_contact, const Eigen::Vector2d& acceleration_m_per_s2, double dt_s) noexcept;

  [[nodiscard]] double speed_m_per_s() const noexcept { return velocity_.norm(); }  // 0 without contact

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.velocity_, self.offset_, self.contact_s_);
  }

 private:
  double leak_s_, offset_time_s_;
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero();
  double contact_s_ = 0.0;
};

}  // namespace gaitway::zmp
