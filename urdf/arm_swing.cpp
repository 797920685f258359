// The shoulders that pitch, and by how much the masses go ahead when they do.
#include "gaitway/urdf/arm_swing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "gaitway/urdf/body_joints.hpp"

namespace gaitway::urdf {
namespace {

constexpr double kProbe_rad = 1e-3;
// Of what the limits leave: the rest is for the servo's lag.
constexpr double kUsableRange = 0.9;

// Sum of mass x place ahead x distance to the left at home.
double way_moment_kg_m2(const RobotModel& model, const ForwardKinematics& home,
                        const ForwardKinematics& moved) {
  double moment = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    const int index = static_cast<int>(i);
    moment +=
        link.mass_kg * (moved.link_pose(index) * link.com_m).x() * (home.link_pose(index) * link.com_m).y();
  }
  return moment;
}

}  // namespace

std::optional<ArmSwing> arm_swing(const RobotModel& model, const ForwardKinematics& home) {
  const BodyJoints body(model, home);
  ArmSwing swing;
  std::vector<double> ahead, back;
  for (const Joint& joint : model.joints) ahead.push_back(joint.home_rad);
  back = ahead;
  for (const Side side : kSides) {
    const std::size_t i = index_of(side);
    const BodyPart part = side == Side::left ? BodyPart::left_arm : BodyPart::right_arm;
    const std::optional<int> shoulder = body.find({part, JointPlace::shoulder, Turn::pitch, 0});
    if (!shoulder) return std::nullopt;
    const auto index = static_cast<std::size_t>(*shoulder);
    const Joint& joint = model.joints[index];
    swing.joint[i] = *shoulder;
    swing.sign[i] = home.joint_axis(model, *shoulder).y() < 0.0 ? -1.0 : 1.0;
    const double range_rad = std::min(joint.upper_rad - joint.home_rad, joint.home_rad - joint.lower_rad);
    swing.most_rad = i == 0 ? range_rad : std::min(swing.most_rad, range_rad);
    swing.most_rad_per_s = i == 0 ? joint.velocity_limit_rad_per_s
                                  : std::min(swing.most_rad_per_s, joint.velocity_limit_rad_per_s);
    const double left_ahead_rad = (side == Side::left ? -1.0 : 1.0) * swing.sign[i] * kProbe_rad;
    ahead[index] += left_ahead_rad;
    back[index] -= left_ahead_rad;
  }
  ForwardKinematics moved_ahead(model), moved_back(model);
  moved_ahead.compute(ahead);
  moved_back.compute(back);
  swing.most_rad *= kUsableRange;
  swing.moment_kg_m2 =
      (way_moment_kg_m2(model, home, moved_ahead) - way_moment_kg_m2(model, home, moved_back)) /
      (2.0 * kProbe_rad);
  return swing.moment_kg_m2 > 0.0 && swing.most_rad > 0.0 ? std::optional(swing) : std::nullopt;
}

}  // namespace gaitway::urdf
