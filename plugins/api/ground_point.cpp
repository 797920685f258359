// A point of the estimate or the plan -> geometry_msgs/PointStamped.
#include "gaitway/api/frame_messages.hpp"
#include "gaitway/api/frame_names.hpp"
#include "gaitway/api/ros_time.hpp"

namespace gaitway::api {

ros::PointStamped make_ground_point() {
  ros::PointStamped message;
  message.header.frame_id = kOdomFrame;
  return message;
}

void fill(ros::PointStamped& message, const Eigen::Isometry3d& odom_from_frame,
          const Eigen::Vector3d& point_m, std::int64_t stamp_ns) noexcept {
  const Eigen::Vector3d place = odom_from_frame * point_m;
  message.header.stamp = ros_time(stamp_ns);
  message.point = {place.x(), place.y(), place.z()};
}

}  // namespace gaitway::api
