// What the feet bear, of a robot whose feet do not tell: from the accelerometer and the legs' posture.
#pragma once

#include <Eigen/Core>
#include <array>

#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/cell_calibration.hpp"
#include "gaitway/zmp/support_kinematics.hpp"

namespace gaitway::zmp {

// The trunk's specific force stands for the whole body's: it says how much the ground bears, and, drawn
// through the CoM, meets the ground in the ZMP. A foot that is clearly above the other one bears nothing; two
// feet on the ground share the load as the ZMP lies between their middles. It knows neither limbs that are
// accelerated otherwise than the trunk, nor a foot that hangs in the air by less than the threshold.
class FootLoadModel {
 public:
  explicit FootLoadModel(const urdf::RobotModel& model) noexcept;

  // specific_force: level, in the trunk's heading; the mean over the last dt_s.
  void update(const SupportKinematics& kinematics, const Eigen::Vector3d& specific_force_m_per_s2,
              double dt_s) noexcept;

  // As four cells under each sole would tell it.
  [[nodiscard]] const CellForces& force_N() const noexcept { return force_N_; }
  // Standard deviation of the ZMP that these forces have, for what the model does not know.
  [[nodiscard]] double zmp_deviation_m() const noexcept { return zmp_deviation_m_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.specific_force_, self.raised_, self.force_N_);
  }

 private:
  void find_raised_feet(const SupportKinematics& kinematics) noexcept;

  std::array<urdf::Foot, 2> feet_;
  double mass_kg_;
  double on_ground_m_, raised_m_;
  double zmp_deviation_m_;
  Eigen::Vector3d specific_force_;
  std::array<bool, 2> raised_{};
  CellForces force_N_{};
};

}  // namespace gaitway::zmp
