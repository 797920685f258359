// Differences of postures, inverse dynamics, and how two feet share what the ground gives.
#include "gaitway/motion/body_load.hpp"

#include <algorithm>

#include "gaitway/motion/support_area.hpp"

namespace gaitway::motion {
namespace {

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

// The share of the ground's wrench that acts at a point of the ground; `yaw_Nm`: the whole moment about the
// vertical through the ZMP.
Wrench share_of(const Wrench& ground, double share, const Eigen::Vector2d& at_m, double yaw_Nm) {
  Wrench part;
  part.force_N = share * ground.force_N;
  part.moment_Nm = Eigen::Vector3d(at_m.x(), at_m.y(), 0.0).cross(part.force_N) +
                   Eigen::Vector3d(0.0, 0.0, share * yaw_Nm);
  return part;
}

}  // namespace

BodyLoadCalculator::BodyLoadCalculator(const urdf::RobotModel& robot) : feet_(robot.feet), dynamics_(robot) {
  load_.torque_Nm.setZero(static_cast<Eigen::Index>(robot.joints.size()));
}

const BodyLoad& BodyLoadCalculator::compute(const std::array<BodyPosture, 3>& posture, double interval_s,
                                            Contact contact, const std::array<Eigen::Isometry3d, 2>& sole) {
  load_.speed_rad_per_s = (posture[2].joint_rad - posture[0].joint_rad) / (2.0 * interval_s);
  load_.acceleration_rad_per_s2 =
      (posture[2].joint_rad - 2.0 * posture[1].joint_rad + posture[0].joint_rad) / (interval_s * interval_s);
  if (contact != Contact::none) stand(posture, interval_s, contact, sole);
  return load_;
}

void BodyLoadCalculator::stand(const std::array<BodyPosture, 3>& posture, double interval_s, Contact contact,
                               const std::array<Eigen::Isometry3d, 2>& sole) {
  const Eigen::Vector3d before =
      rotation_vector(posture[1].pelvis.linear() * posture[0].pelvis.linear().transpose());
  const Eigen::Vector3d after =
      rotation_vector(posture[2].pelvis.linear() * posture[1].pelvis.linear().transpose());
  motion_.pelvis = posture[1].pelvis;
  motion_.angular_velocity_rad_per_s = (before + after) / (2.0 * interval_s);
  motion_.angular_acceleration_rad_per_s2 = (after - before) / (interval_s * interval_s);
  motion_.acceleration_m_per_s2 = (posture[2].pelvis.translation() - 2.0 * posture[1].pelvis.translation() +
                                   posture[0].pelvis.translation()) /
                                  (interval_s * interval_s);
  motion_.joint_rad = posture[1].joint_rad;
  motion_.speed_rad_per_s = load_.speed_rad_per_s;
  motion_.acceleration_rad_per_s2 = load_.acceleration_rad_per_s2;
  const Wrench ground = dynamics_.move(motion_);

  // In free fall there is no ZMP; a hundredth of the weight keeps the numbers finite, and is refused
  // elsewhere.
  const double normal_N = std::max(ground.force_N.z(), 0.01 * dynamics_.weight_N());
  const Eigen::Vector2d zmp(-ground.moment_Nm.y() / normal_N, ground.moment_Nm.x() / normal_N);
  load_.zmp_m = zmp;
  load_.normal_force_N = ground.force_N.z();
  load_.friction_ratio = ground.force_N.head<2>().norm() / normal_N;
  const double yaw_Nm = ground.moment_Nm.z() - zmp.x() * ground.force_N.y() + zmp.y() * ground.force_N.x();

  // Two feet share by where the ZMP lies between them, each pressing at the same place of its sole.
  const std::array<Eigen::Vector2d, 2> centre{sole_centre(feet_[0], sole[0]), sole_centre(feet_[1], sole[1])};
  const Eigen::Vector2d across = centre[0] - centre[1];
  const double left = contact == Contact::left ? 1.0
                      : contact == Contact::right
                          ? 0.0
                          : std::clamp((zmp - centre[1]).dot(across) / across.squaredNorm(), 0.0, 1.0);
  const Eigen::Vector2d beside = zmp - left * centre[0] - (1.0 - left) * centre[1];
  dynamics_.torques({share_of(ground, left, centre[0] + beside, yaw_Nm),
                     share_of(ground, 1.0 - left, centre[1] + beside, yaw_Nm)},
                    load_.torque_Nm);
}

}  // namespace gaitway::motion
