// Stiffness * lead + damping * its rate = torque: a first-order lag, so that steps of the torque make none
// here.
#include "gaitway/motion/servo_lead.hpp"

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/plan_loads.hpp"

namespace gaitway::motion {

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
