// humanoid22's drives, dimensionless, on another body.
#include "gaitway/importer/drive_figures.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::importer {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kStiffness = 12.4, kServoDamping = 0.86, kArmature = 0.011, kMotorDamping = 0.032,
                 kFriction = 0.004, kTorque = 0.33;  // in units of the body
constexpr double kSpeed = 1.53;                      // of omega: humanoid22's motors
constexpr double kPlenty = 1.5;                      // of that speed: more is of no use to a walk
constexpr double kFinestCount_deg = 0.05, kCountStep_deg = 0.005;
constexpr double kWeakest = 0.02;     // share of a leg's drive
constexpr double kCarriesMuch = 0.1;  // of the mass: a drive like a leg's
constexpr double kFastest_rad_per_s = 100.0, kStrongest_Nm = 1000.0,
                 kMostArmature_kg_m2 = 1.0;  // that a network file may name

// Of what each joint carries.
std::vector<double> carried_kg(const MakerRobot& robot) {
  std::vector<double> link_kg(robot.links.size()), joint_kg(robot.joints.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) link_kg[i] = robot.links[i].mass_kg;
  for (std::size_t i = robot.joints.size(); i-- > 0;) {  // children come after parents
    const MakerJoint& joint = robot.joints[i];
    joint_kg[i] = link_kg[static_cast<std::size_t>(joint.child_link)];
    link_kg[static_cast<std::size_t>(joint.parent_link)] += joint_kg[i];
  }
  return joint_kg;
}

}  // namespace

double total_mass_kg(const MakerRobot& robot) noexcept {
  double mass = 0.0;
  for (const MakerLink& link : robot.links) mass += link.mass_kg;
  return mass;
}

std::vector<DriveFigures> drive_figures(const MakerRobot& robot, const BodyPlan& plan, double hip_height_m) {
  const double mass_kg = total_mass_kg(robot);
  const double omega = std::sqrt(kGravity_m_per_s2 / hip_height_m);
  const double moment_Nm = mass_kg * kGravity_m_per_s2 * hip_height_m;
  const std::vector<double> carried = carried_kg(robot);
  std::vector<DriveFigures> drives;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const MakerJoint& joint = robot.joints[i];
    const bool of_leg = std::any_of(plan.legs.begin(), plan.legs.end(), [&](const LegChain& leg) {
      return std::find(leg.joints.begin(), leg.joints.end(), joint.name) != leg.joints.end();
    });
    DriveFigures drive;
    const bool strong = of_leg || carried[i] > kCarriesMuch * mass_kg;
    drive.torque_Nm =
        std::min(joint.effort_Nm.value_or(kTorque * moment_Nm *
                                          (strong ? 1.0 : std::max(kWeakest, carried[i] / mass_kg))),
                 kStrongest_Nm);
    if (!joint.effort_Nm) drive.guessed.emplace_back("torque");
    if (!joint.velocity_rad_per_s) drive.guessed.emplace_back("speed");
    drive.motor_speed_rad_per_s =
        std::min(joint.velocity_rad_per_s.value_or(kSpeed * omega), kFastest_rad_per_s);
    drive.reference_speed_rad_per_s = std::min(drive.motor_speed_rad_per_s, kPlenty * kSpeed * omega);
    const double needed_deg =
        drive.reference_speed_rad_per_s * facts::kSlot_s / facts::kLargestByte_counts / facts::kRadPerDegree;
    drive.count_deg =
        std::max(kFinestCount_deg, std::ceil(needed_deg * (1.0 + 1e-6) / kCountStep_deg) * kCountStep_deg);
    const double share = strong ? 1.0 : std::clamp(drive.torque_Nm / (kTorque * moment_Nm), kWeakest, 1.0);
    drive.stiffness_Nm_per_rad = kStiffness * moment_Nm * share;
    drive.damping_Nms_per_rad = kServoDamping * moment_Nm / omega * share;
    drive.armature_kg_m2 =
        std::min(kArmature * mass_kg * hip_height_m * hip_height_m * share, kMostArmature_kg_m2);
    drive.motor_damping_Nms_per_rad = kMotorDamping * moment_Nm / omega * share;
    drive.friction_Nm = kFriction * moment_Nm * share;
    drives.push_back(drive);
  }
  return drives;
}

}  // namespace gaitway::importer
