// From the memory block's topics to ROS messages.
#pragma once

#include <cstdint>
#include <memory>

#include "gaitway/api/publication_sink.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

// Passive: looks what is new whenever it is told to. What nobody wants is not computed.
//
//   /joint_states, /imu/data, /foot/*/wrench   with each new value, stamped with its arrival at the message
//   controller /odom, /tf, /com, /zmp                     with each new estimate; /tf without odom when none
//   comes /clock                                     when the robot's clock passes a multiple of 10 ms
//   /zmp/reference, /footsteps                 with each new planned state
//   /diagnostics                               each second, of the robot's clock or of the caller's
//   /motion_state                              as it changes, and with each batch while a motion plays
//   /walk_to/state                             as it changes, and with each batch while there is a way
//   /command/state                             as it changes
//   /behaviour/state                           as it changes, and each second
//   /behaviour/nodes                           when all of another tree has come
//   /robot_state                               as it changes
//   /bus_slot                                  with each new value
//   /events, /rosout                           as they come;   /robot_description   in the first poll
//
// A topic keeps only its newest values: who polls less often than each 10 ms misses some. When the robot's
// clock runs backwards (it was started anew), all that was remembered is dropped, and publishing goes on with
// the new clock.
class Feed {
 public:
  // Set-up: opens the topics and reads the robot's URDF. `client` outlives the feed. Throws
  // msgclient::TopicError, or urdf::RobotError when the file cannot be read.
  Feed(msgclient::Client& client, const urdf::RobotModel& model);
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;
  ~Feed();

  // `wall_ns`: any monotonic clock of the caller's.
  void poll(std::int64_t wall_ns, PublicationSink& sink);

  // An event of the caller's own, among the robot's: one that says the same as another is counted with it.
  void tell(const ros::Log& event, PublicationSink& sink);

  // The robot's clock, as the last poll saw it; 0 while the robot has not been heard of.
  [[nodiscard]] std::int64_t robot_ns() const noexcept;
  // How long, at the last poll, the robot's clock had not moved.
  [[nodiscard]] std::int64_t heartbeat_age_ns() const noexcept;

 private:
  struct Topics;
  struct Messages;
  struct State;

  void follow_clock(std::int64_t wall_ns);
  void forget();
  void read_network();
  void publish_once(PublicationSink& sink);
  void publish_joints(PublicationSink& sink);
  void publish_imu(PublicationSink& sink);
  void publish_wrenches(PublicationSink& sink);
  void publish_frames(PublicationSink& sink);
  void publish_transforms(PublicationSink& sink, bool with_base);
  void publish_at_slot_edge(PublicationSink& sink);
  [[nodiscard]] const PlannedState* planned() const noexcept;
  void publish_planned(PublicationSink& sink);
  void publish_diagnostics(std::int64_t wall_ns, PublicationSink& sink);
  void publish_bus_slot(PublicationSink& sink);
  void publish_motion(PublicationSink& sink);
  void publish_way(PublicationSink& sink);
  void publish_robot_state(PublicationSink& sink);
  void publish_event(const ros::Log& event, PublicationSink& sink);
  void publish_events(PublicationSink& sink);

  std::unique_ptr<Topics> topics_;
  std::unique_ptr<Messages> messages_;
  std::unique_ptr<State> state_;
};

}  // namespace gaitway::api
