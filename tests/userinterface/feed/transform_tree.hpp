// Looks poses up in a /tf message, as a client does.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <stdexcept>
#include <string>

#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api::test {

inline Eigen::Isometry3d isometry(const ros::Transform& transform) {
  const ros::Quaternion& q = transform.rotation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  result.translation() =
      Eigen::Vector3d(transform.translation.x, transform.translation.y, transform.translation.z);
  return result;
}

class TransformTree {
 public:
  explicit TransformTree(const ros::TFMessage& message) {
    for (const ros::TransformStamped& transform : message.transforms) {
      if (!parents_
               .emplace(transform.child_frame_id,
                        Parent{transform.header.frame_id, isometry(transform.transform)})
               .second) {
        throw std::runtime_error("two parents: " + transform.child_frame_id);
      }
    }
  }
  // Whether the frame has a parent.
  [[nodiscard]] bool knows(const std::string& child) const { return parents_.contains(child); }
  // Of `child` in `ancestor`; throws when that is not above it.
  [[nodiscard]] Eigen::Isometry3d pose(const std::string& ancestor, const std::string& child) const {
    if (child == ancestor) return Eigen::Isometry3d::Identity();
    const auto found = parents_.find(child);
    if (found == parents_.end()) throw std::runtime_error(child + " is not connected to " + ancestor);
    return pose(ancestor, found->second.name) * found->second.pose;
  }

 private:
  struct Parent {
    std::string name;
    Eigen::Isometry3d pose;
  };
  std::map<std::string, Parent> parents_;
};

}  // namespace gaitway::api::test
