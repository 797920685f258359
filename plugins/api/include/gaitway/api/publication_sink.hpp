// Who takes what the feed publishes: the hub of the sessions, the recorder, a test.
#pragma once

#include <cstdint>
#include <utility>

#include "gaitway/api/publication.hpp"

namespace gaitway::api {

// One overload for each message type of kTopics. `robot_ns`: the robot's clock when the message was made; the
// header's stamp is the measurement's. The message is the feed's own and holds during the call only.
// Called from within Feed::poll(); must not throw.
class PublicationSink {
 public:
  virtual ~PublicationSink() = default;
  // Whether publish() would make use of a message of this topic; asked before anything is computed for it. A
  // sink that keeps the last message of latched topics wants these always.
  [[nodiscard]] virtual bool wants(Topic topic) const = 0;

  virtual void publish(Topic topic, const ros::JointState& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::Imu& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::WrenchStamped& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::PointStamped& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::Odometry& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::TFMessage& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::PoseArray& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::MotionState& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::String& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::Clock& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::DiagnosticArray& message, std::int64_t robot_ns) = 0;
  virtual void publish(Topic topic, const ros::Log& message, std::int64_t robot_ns) = 0;
};

// A sink that does the same with messages of every type: calls take(topic, message, robot_ns), and asks
// wanted(topic).
template <class Wanted, class Take>
class GenericSink final : public PublicationSink {
 public:
  GenericSink(Wanted wanted, Take take) : wanted_(std::move(wanted)), take_(std::move(take)) {}

  [[nodiscard]] bool wants(Topic topic) const override { return wanted_(topic); }

  void publish(Topic topic, const ros::JointState& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::Imu& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::WrenchStamped& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::PointStamped& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::Odometry& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::TFMessage& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::PoseArray& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::MotionState& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::String& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::Clock& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::DiagnosticArray& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }
  void publish(Topic topic, const ros::Log& message, std::int64_t robot_ns) override {
    take_(topic, message, robot_ns);
  }

 private:
  Wanted wanted_;
  Take take_;
};

}  // namespace gaitway::api
