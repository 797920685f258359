// Whether both feet stand on the ground so that the heading can be held by them, and how far they may creep.
#pragma once

#include <array>

#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// Feet that both bear load, and do not turn against each other, do not turn over the ground by much. They
// creep: while they settle, as long as play makes the load rattle between them, and when the legs are moved.
class PlantedFeet {
 public:
  PlantedFeet(const EstimatorParameters& parameters, double weight_N) noexcept;

  // force_N: on each foot. angle_rad: between the soles' headings. leg_rate: of the fastest leg joint, as
  // asked for.
  void update(const std::array<double, 2>& force_N, double angle_rad, double leg_rate_rad_per_s,
              double dt_s) noexcept;

  [[nodiscard]] bool planted() const noexcept { return planted_s_ >= least_s_; }
  // Random walk of their heading, per square root of a second.
  [[nodiscard]] double creep_rad_rts() const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.last_force_N_, self.rattle_, self.leg_rate_rad_per_s_, self.planted_s_, self.angle_rad_);
  }

 private:
  double weight_N_, least_force_N_, least_s_, creep_, settling_creep_, rattle_creep_, moved_creep_;
  std::array<double, 2> last_force_N_{};
  double rattle_ = 0.0;  // mean square of the load's change from sample to sample, as a share of the weight
  double leg_rate_rad_per_s_ = 0.0;
  double planted_s_ = 0.0;  // since both bear load; counted no further than it matters
  double angle_rad_ = 0.0;  // between the soles when they began
};

}  // namespace gaitway::zmp
