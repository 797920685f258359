// Builds the KDL tree joint by joint.
#include "kdl_tree.hpp"

namespace gaitway::urdf {
namespace {

KDL::Vector vector_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

KDL::Frame frame_of(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d r = pose.linear();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          vector_of(pose.translation())};
}

KDL::RigidBodyInertia inertia_of(const Link& link) {
  const Eigen::Matrix3d& i = link.inertia_kg_m2;
  return KDL::RigidBodyInertia(link.mass_kg, vector_of(link.com_m),
                               KDL::RotationalInertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)));
}

}  // namespace

KDL::Tree make_kdl_tree(const RobotModel& model) {
  KDL::Tree tree(model.links.front().name);
  for (const Joint& joint : model.joints) {
    const Link& parent = model.links[static_cast<std::size_t>(joint.parent_link)];
    const Link& child = model.links[static_cast<std::size_t>(joint.child_link)];
    const KDL::Frame origin = frame_of(joint.origin);
    const KDL::Joint kdl_joint(joint.name, origin.p, origin.M * vector_of(joint.axis), KDL::Joint::RotAxis);
    tree.addSegment(KDL::Segment(child.name, kdl_joint, origin, inertia_of(child)), parent.name);
  }
  return tree;
}

}  // namespace gaitway::urdf
