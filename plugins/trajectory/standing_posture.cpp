// The standing posture by forward kinematics.
#include "gaitway/trajectory/standing_posture.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::trajectory {

namespace {

// Each link of the leg moves with the foot by its share of the way from hip to sole; what does not belong to
// the leg moves the other way, so that the CoM does not follow.
double swing_moment_s2(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home,
                       double sole_height_m) {
  const double com_height_m = home.com_m().z();
  const double hip_height_m = sole_height_m + robot.hip_height_m;
  double moved_kg = 0.0, leg_kg = 0.0, leg_height_kg_m = 0.0, moment_kg_m = 0.0;
  for (const int index : robot.legs[0].joints) {
    const int child = robot.joints[static_cast<std::size_t>(index)].child_link;
    const urdf::Link& link = robot.links[static_cast<std::size_t>(child)];
    const double height_m = (home.link_pose(child) * link.com_m).z();
    const double share = std::clamp((hip_height_m - height_m) / robot.hip_height_m, 0.0, 1.0);
    moved_kg += link.mass_kg * share;
    leg_kg += link.mass_kg;
    leg_height_kg_m += link.mass_kg * height_m;
    moment_kg_m += link.mass_kg * share * (com_height_m - height_m);
  }
  const double mass_kg = robot.total_mass_kg();
  const double rest_height_m = (mass_kg * com_height_m - leg_height_kg_m) / (mass_kg - leg_kg);
  moment_kg_m += moved_kg * (rest_height_m - com_height_m);
  return moment_kg_m / (mass_kg * facts::kGravity_m_per_s2);
}

}  // namespace

GaitParameters with_standing_posture(GaitParameters parameters, const urdf::RobotModel& robot) {
  const urdf::ForwardKinematics home(robot);
  const Eigen::Vector3d& com = home.com_m();
  const Eigen::Vector3d left = home.sole_pose(urdf::Side::left).translation();
  const Eigen::Vector3d right = home.sole_pose(urdf::Side::right).translation();
  parameters.com_height_m = com.z() - 0.5 * (left.z() + right.z());
  parameters.stand_com_forward_m = com.x() - 0.5 * (left.x() + right.x());
  parameters.foot_spacing_m = left.y() - right.y();
  parameters.hip_height_m = robot.hip_height_m;
  parameters.fast_hip_height_m = std::min(parameters.fast_hip_height_m, robot.hip_height_m);
  parameters.swing_moment_s2 = swing_moment_s2(robot, home, 0.5 * (left.z() + right.z()));
  const urdf::Foot& foot = robot.feet[0];
  parameters.sole = {foot.size_m.x(), foot.size_m.y(), foot.centre_m.x()};
  parameters.zmp_forward_m = foot.centre_m.x();
  return parameters;
}

bool stands_as_described(const GaitParameters& parameters, const GaitParameters& described) noexcept {
  constexpr double kSame_m = 1e-4;
  const auto same = [](double a, double b) { return std::abs(a - b) < kSame_m; };
  return same(parameters.stand_com_forward_m, described.stand_com_forward_m) &&
         same(parameters.hip_height_m, described.hip_height_m) &&
         same(parameters.foot_spacing_m, described.foot_spacing_m);
}

}  // namespace gaitway::trajectory
