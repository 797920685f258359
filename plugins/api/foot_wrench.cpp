// FootForces -> geometry_msgs/WrenchStamped.
#include "gaitway/api/frame_names.hpp"
#include "gaitway/api/ros_time.hpp"
#include "gaitway/api/sensor_messages.hpp"

namespace gaitway::api {

ros::WrenchStamped make_foot_wrench(urdf::Side side) {
  ros::WrenchStamped message;
  message.header.frame_id = kSoleFrames[static_cast<std::size_t>(side)];
  return message;
}

void fill(ros::WrenchStamped& message, const FootForces& forces, const urdf::RobotModel& model,
          urdf::Side side) noexcept {
  const auto foot = static_cast<std::size_t>(side);
  message.header.stamp = ros_time(forces.stamp_ns);
  message.wrench = {};
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const double force_N = forces.force[foot][cell];
    const Eigen::Vector2d& place_m = model.feet[foot].cell_m[cell];
    message.wrench.force.z += force_N;
    message.wrench.torque.x += place_m.y() * force_N;
    message.wrench.torque.y -= place_m.x() * force_N;
  }
}

}  // namespace gaitway::api
