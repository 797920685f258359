// The neck's first joint of each turn.
#include "gaitway/urdf/neck.hpp"

#include <algorithm>

#include "gaitway/urdf/body_joints.hpp"

namespace gaitway::urdf {
namespace {

NeckJoint neck_joint(const RobotModel& model, int index, double along_axis) {
  const Joint& joint = model.joints[static_cast<std::size_t>(index)];
  const double sign = along_axis < 0.0 ? -1.0 : 1.0;
  const double one = sign * (joint.lower_rad - joint.home_rad),
               other = sign * (joint.upper_rad - joint.home_rad);
  return {index,
          sign,
          std::min(one, other),
          std::max(one, other),
          joint.home_rad,
          joint.velocity_limit_rad_per_s};
}

}  // namespace

Neck neck_of(const RobotModel& model, const ForwardKinematics& home) {
  Neck neck;
  const BodyJoints body(model, home);
  const auto place = [&](int joint) {
    return home.link_position_m(model.joints[static_cast<std::size_t>(joint)].child_link);
  };
  if (const auto yaw = body.find({BodyPart::neck, JointPlace::neck, Turn::yaw, 0})) {
    neck.yaw = neck_joint(model, *yaw, home.joint_axis(model, *yaw).z());
    neck.position_m = place(*yaw);
  }
  if (const auto pitch = body.find({BodyPart::neck, JointPlace::neck, Turn::pitch, 0})) {
    neck.pitch = neck_joint(model, *pitch, home.joint_axis(model, *pitch).y());
    neck.position_m = place(*pitch);
  }
  return neck;
}

}  // namespace gaitway::urdf
