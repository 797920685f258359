// Outwards motion, inwards forces, all in the motion's frame.
#include "gaitway/motion/whole_body_dynamics.hpp"

#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::motion {
namespace {

constexpr double kFrictionSpeed_rad_per_s = 0.05;  // below it dry friction comes in smoothly

}  // namespace

WholeBodyDynamics::WholeBodyDynamics(const urdf::RobotModel& robot)
    : links_(robot.links),
      joints_(robot.joints),
      foot_link_{robot.feet[0].link, robot.feet[1].link},
      weight_N_(robot.total_mass_kg() * facts::kGravity_m_per_s2),
      bodies_(robot.links.size()),
      axes_(robot.joints.size()),
      below_(robot.links.size()) {}

void WholeBodyDynamics::move_link(std::size_t link) {
  Body& body = bodies_[link];
  const Eigen::Vector3d com = body.rotation * links_[link].com_m;
  const Eigen::Vector3d& w = body.angular_velocity;
  Eigen::Vector3d acceleration =
      body.acceleration + body.angular_acceleration.cross(com) + w.cross(w.cross(com));
  acceleration.z() += facts::kGravity_m_per_s2;
  const Eigen::Matrix3d inertia = body.rotation * links_[link].inertia_kg_m2 * body.rotation.transpose();
  body.wrench.force_N = links_[link].mass_kg * acceleration;
  body.wrench.moment_Nm = inertia * body.angular_acceleration + w.cross(inertia * w) +
                          (body.position_m + com).cross(body.wrench.force_N);
}

Wrench WholeBodyDynamics::move(const BodyMotion& motion) {
  motion_ = motion;
  bodies_[0] = {motion.pelvis.linear(),
                motion.pelvis.translation(),
                motion.angular_velocity_rad_per_s,
                motion.angular_acceleration_rad_per_s2,
                motion.acceleration_m_per_s2,
                {}};
  move_link(0);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const urdf::Joint& joint = joints_[j];
    const Body& parent = bodies_[static_cast<std::size_t>(joint.parent_link)];
    Body& child = bodies_[static_cast<std::size_t>(joint.child_link)];
    const auto index = static_cast<Eigen::Index>(j);
    const Eigen::Vector3d offset = parent.rotation * joint.origin.translation();
    const Eigen::Matrix3d before = parent.rotation * joint.origin.linear();
    const Eigen::Vector3d axis = before * joint.axis;
    const Eigen::Vector3d turning = motion.speed_rad_per_s[index] * axis;
    axes_[j] = axis;
    child.rotation = before * Eigen::AngleAxisd(motion.joint_rad[index], joint.axis).toRotationMatrix();
    child.position_m = parent.position_m + offset;
    child.angular_velocity = parent.angular_velocity + turning;
    child.angular_acceleration = parent.angular_acceleration + motion.acceleration_rad_per_s2[index] * axis +
                                 parent.angular_velocity.cross(turning);
    child.acceleration = parent.acceleration + parent.angular_acceleration.cross(offset) +
                         parent.angular_velocity.cross(parent.angular_velocity.cross(offset));
    move_link(static_cast<std::size_t>(joint.child_link));
  }
  Wrench whole;
  for (const Body& body : bodies_) {
    whole.force_N += body.wrench.force_N;
    whole.moment_Nm += body.wrench.moment_Nm;
  }
  return whole;
}

void WholeBodyDynamics::torques(const std::array<Wrench, 2>& foot, Eigen::VectorXd& torque_Nm) {
  for (std::size_t link = 0; link < bodies_.size(); ++link) {
    below_[link] = bodies_[link].wrench;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    Wrench& through = below_[static_cast<std::size_t>(foot_link_[side])];
    through.force_N -= foot[side].force_N;
    through.moment_Nm -= foot[side].moment_Nm;
  }
  // Parents come before children, so that backwards each link has gathered all that hangs on it.
  for (std::size_t j = joints_.size(); j-- > 0;) {
    const urdf::Joint& joint = joints_[j];
    const Wrench& child = below_[static_cast<std::size_t>(joint.child_link)];
    Wrench& parent = below_[static_cast<std::size_t>(joint.parent_link)];
    const Eigen::Vector3d& place = bodies_[static_cast<std::size_t>(joint.child_link)].position_m;
    const auto index = static_cast<Eigen::Index>(j);
    const double speed = motion_.speed_rad_per_s[index];
    torque_Nm[index] = axes_[j].dot(child.moment_Nm - place.cross(child.force_N)) +
                       joint.motor.armature_kg_m2 * motion_.acceleration_rad_per_s2[index] +
                       joint.motor.damping_Nms_per_rad * speed +
                       joint.motor.friction_Nm * std::tanh(speed / kFrictionSpeed_rad_per_s);
    parent.force_N += child.force_N;
    parent.moment_Nm += child.moment_Nm;
  }
}

}  // namespace gaitway::motion
