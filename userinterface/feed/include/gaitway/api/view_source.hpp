// What the view shows, out of what the feed publishes and the memory block holds.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "gaitway/api/publication.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/page/view_layout.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

class ViewSource {
 public:
  // Throws msgclient::TopicError. `client` outlives it.
  ViewSource(msgclient::Client& client, const urdf::RobotModel& robot);

  // Topics of the feed that it is made of.
  [[nodiscard]] static bool wants(Topic topic) noexcept;
  template <class M>
  void take(Topic topic, const M& message, std::int64_t wall_ns) {
    if (wants(topic)) {
      note(topic, message, wall_ns);
    }
  }

  // What is known now. `beat_age_ns`: since the robot's clock has moved. `commander` must outlive the state.
  [[nodiscard]] page::ViewState state(std::int64_t robot_ns, std::int64_t beat_age_ns,
                                      std::string_view commander, std::int64_t wall_ns);

 private:
  static constexpr std::int64_t kNever = INT64_MIN;

  void note(Topic topic, const ros::JointState& message, std::int64_t wall_ns);
  void note(Topic topic, const ros::Odometry& message, std::int64_t wall_ns);
  void note(Topic topic, const ros::PointStamped& message, std::int64_t wall_ns);
  void note(Topic topic, const ros::PoseArray& message, std::int64_t wall_ns);
  template <class M>
  void note(Topic, const M&, std::int64_t) {}

  void add_controller(page::ViewState& state, std::int64_t wall_ns);
  void add_estimate(page::ViewState& state);
  void add_places(page::ViewState& state) const;

  std::size_t joint_count_;
  msgclient::Reader<NetworkState> network_;
  msgclient::Reader<NetworkHealth> health_;
  msgclient::Reader<Estimate> estimate_;
  msgclient::Reader<MotionState> motion_;
  std::array<double, page::kViewJoints> joints_rad_{};
  ros::Odometry odometry_;
  ros::Point com_, zmp_, planned_zmp_;
  std::vector<ros::Pose> footsteps_;
  std::uint64_t network_sequence_ = 0;
  std::int64_t joints_ns_ = kNever, pose_ns_ = kNever, plan_ns_ = kNever, network_ns_ = kNever,
               com_ns_ = kNever;
};

}  // namespace gaitway::api
