// The standing posture by forward kinematics.
#include "gaitway/trajectory/standing_posture.hpp"

#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::trajectory {

GaitParameters with_standing_posture(GaitParameters parameters, const urdf::RobotModel& robot) {
  const urdf::ForwardKinematics home(robot);
  const Eigen::Vector3d& com = home.com_m();
  const Eigen::Vector3d left = home.sole_pose(urdf::Side::left).translation();
  const Eigen::Vector3d right = home.sole_pose(urdf::Side::right).translation();
  parameters.com_height_m = com.z() - 0.5 * (left.z() + right.z());
  parameters.stand_com_forward_m = com.x() - 0.5 * (left.x() + right.x());
  parameters.foot_spacing_m = left.y() - right.y();
  parameters.hip_height_m = robot.hip_height_m;
  const urdf::Foot& foot = robot.feet[0];
  parameters.sole = {foot.size_m.x(), foot.size_m.y(), foot.centre_m.x()};
  parameters.zmp_forward_m = foot.centre_m.x();
  return parameters;
}

}  // namespace gaitway::trajectory
