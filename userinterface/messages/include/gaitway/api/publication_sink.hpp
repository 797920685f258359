// Who takes what the feed publishes: the hub of the sessions, the recorder, a test.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include "gaitway/api/publication.hpp"

namespace gaitway::api {

// A message of one of kTopics.
using AnyMessage =
    std::variant<const ros::JointState*, const ros::Imu*, const ros::WrenchStamped*, const ros::PointStamped*,
                 const ros::Odometry*, const ros::TFMessage*, const ros::PoseArray*, const ros::MotionState*,
                 const ros::WayState*, const ros::BusSlot*, const ros::RobotState*, const ros::LinkState*,
                 const ros::String*, const ros::Clock*, const ros::DiagnosticArray*, const ros::Log*,
                 const ros::SimulationState*, const ros::TwinState*, const ros::TwistStamped*,
                 const ros::CommandState*, const ros::BehaviourState*, const ros::BehaviourNodes*>;

// Called from within Feed::poll(); must not throw.
class PublicationSink {
 public:
  virtual ~PublicationSink() = default;
  // Whether publish() would make use of a message of this topic; asked before anything is computed for it. A
  // sink that keeps the last message of latched topics wants these always.
  [[nodiscard]] virtual bool wants(Topic topic) const = 0;
  // `robot_ns`: the robot's clock when the message was made; the header's stamp is the measurement's. The
  // message is the feed's own and holds during the call only.
  virtual void take(Topic topic, AnyMessage message, std::int64_t robot_ns) = 0;

  template <class M>
  void publish(Topic topic, const M& message, std::int64_t robot_ns) {
    take(topic, &message, robot_ns);
  }
};

// A sink that does the same with messages of every type: calls take(topic, message, robot_ns), and asks
// wanted(topic).
template <class Wanted, class Take>
class GenericSink final : public PublicationSink {
 public:
  GenericSink(Wanted wanted, Take take) : wanted_(std::move(wanted)), take_(std::move(take)) {}

  [[nodiscard]] bool wants(Topic topic) const override { return wanted_(topic); }

  void take(Topic topic, AnyMessage message, std::int64_t robot_ns) override {
    std::visit([&](const auto* known) { take_(topic, *known, robot_ns); }, message);
  }

 private:
  Wanted wanted_;
  Take take_;
};

}  // namespace gaitway::api
