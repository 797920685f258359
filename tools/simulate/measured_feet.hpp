// What stands, by the force under each foot; and how sure one is of where.
#pragma once

#include <array>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/zmp/estimator_parameters.hpp"
#include "gaitway/zmp/foot_contact.hpp"
#include "gaitway/zmp/support_kinematics.hpp"

namespace gaitway::tools {

// As the estimator has it.
class MeasuredFeet {
 public:
  explicit MeasuredFeet(const urdf::RobotModel& robot) : feet_(thresholds(robot)) {}

  // To be told row by row.
  [[nodiscard]] motion::Contact contact(const std::array<double, 2>& force_N) noexcept {
    feet_.update(force_N);
    const bool left = feet_.in_contact(urdf::Side::left), right = feet_.in_contact(urdf::Side::right);
    using motion::Contact;
    return left ? (right ? Contact::both : Contact::left) : (right ? Contact::right : Contact::none);
  }

 private:
  static zmp::ContactThresholds thresholds(const urdf::RobotModel& robot) {
    const zmp::EstimatorParameters parameters;
    const double weight_N = robot.total_mass_kg() * facts::kGravity_m_per_s2;
    return {.on_N = parameters.contact_on_share * weight_N,
            .off_N = parameters.contact_off_share * weight_N,
            .support_margin = parameters.support_margin};
  }

  zmp::ContactDetector feet_;
};

// Three standard deviations of a sole's place, from the joints' zeros.
[[nodiscard]] inline double place_error_m(const urdf::RobotModel& robot) {
  return 3.0 * zmp::model_uncertainty(robot, zmp::EstimatorParameters{}).foot_m.norm();
}

}  // namespace gaitway::tools
