// Differences of postures, inverse dynamics, how two feet share what the ground gives; and the lag of servos.
#include "gaitway/motion/body_load.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/stance_map.hpp"

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
  if (contact == Contact::none) return load_;
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
  stand(contact, sole);
  return load_;
}

const BodyLoad& BodyLoadCalculator::compute(const BodyMotion& motion, Contact contact,
                                            const std::array<Eigen::Isometry3d, 2>& sole) {
  load_.speed_rad_per_s = motion.speed_rad_per_s;
  load_.acceleration_rad_per_s2 = motion.acceleration_rad_per_s2;
  if (contact == Contact::none) return load_;
  motion_ = motion;
  stand(contact, sole);
  return load_;
}

void BodyLoadCalculator::stand(Contact contact, const std::array<Eigen::Isometry3d, 2>& sole) {
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

// Where only one of two neighbours stands, the robot rests, so that its pelvis is that of the other.
BodyPosture PlanLoads::posture(std::size_t at, std::size_t point) const {
  const std::span<const double> angles = plan_.point(at);
  return {Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size())),
          plan_.pelvis[plan_.contact[at] == Contact::none ? point : at]};
}

const BodyLoad& PlanLoads::at(std::size_t point) {
  const std::size_t before = point == 0 ? 0 : point - 1;
  const std::size_t after = std::min(point + 1, plan_.point_count() - 1);
  if (plan_.contact[point] != Contact::none) {
    kinematics_.compute(plan_.point(point));
    for (const urdf::Side side : urdf::kSides) {
      soles_[static_cast<std::size_t>(side)] = plan_.pelvis[point] * kinematics_.sole_pose(side);
    }
  }
  return loads_.compute({posture(before, point), posture(point, point), posture(after, point)},
                        facts::kSlot_s, plan_.contact[point], soles_);
}

std::vector<double> leading_references(const urdf::RobotModel& robot, const MotionPlan& plan) {
  const auto joints = static_cast<Eigen::Index>(plan.joint_count);
  Eigen::VectorXd compliance(joints), share(joints);
  for (Eigen::Index j = 0; j < joints; ++j) {
    const urdf::Servo& servo = robot.joints[static_cast<std::size_t>(j)].servo;
    compliance[j] = 1.0 / servo.stiffness_Nm_per_rad;
    share[j] = 1.0 - std::exp(-facts::kSlot_s * servo.stiffness_Nm_per_rad / servo.damping_Nms_per_rad);
  }
  std::vector<double> reference = plan.joint_rad;
  PlanLoads loads(robot, plan);
  Eigen::VectorXd lead = Eigen::VectorXd::Zero(joints), standing_torque = lead;
  // A motion stands at home at its start, or else at its end.
  const std::size_t at_home = plan.contact.front() != Contact::none ? 0 : plan.point_count() - 1;
  if (plan.contact[at_home] != Contact::none) standing_torque = loads.at(at_home).torque_Nm;
  for (std::size_t i = 0; i < plan.point_count(); ++i) {
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(joints);
    if (plan.contact[i] != Contact::none) {
      wanted = compliance.cwiseProduct(loads.at(i).torque_Nm - standing_torque);
    }
    lead += share.cwiseProduct(wanted - lead);
    for (Eigen::Index j = 0; j < joints; ++j) {
      reference[i * plan.joint_count + static_cast<std::size_t>(j)] += lead[j];
    }
  }
  return reference;
}

}  // namespace gaitway::motion
