// A sink that keeps all that it is given.
#pragma once

#include <bitset>
#include <cstdint>
#include <initializer_list>
#include <tuple>
#include <vector>

#include "gaitway/api/publication_sink.hpp"

namespace gaitway::api::test {

template <class Message>
struct Kept {
  Topic topic;
  Message message;
  std::int64_t robot_ns;
};

class Collector {
 public:
  Collector() { wanted_.set(); }
  explicit Collector(std::initializer_list<Topic> wanted) { want(wanted); }

  void want(std::initializer_list<Topic> wanted) {
    wanted_.reset();
    for (const Topic topic : wanted) wanted_.set(static_cast<std::size_t>(topic));
  }
  [[nodiscard]] bool wanted(Topic topic) const { return wanted_.test(static_cast<std::size_t>(topic)); }
  template <class Message>
  void take(Topic topic, const Message& message, std::int64_t robot_ns) {
    std::get<std::vector<Kept<Message>>>(kept_).push_back({topic, message, robot_ns});
    ++counts_[static_cast<std::size_t>(topic)];
  }

  template <class Message>
  [[nodiscard]] std::vector<Message> of(Topic topic) const {
    std::vector<Message> result;
    for (const Kept<Message>& kept : std::get<std::vector<Kept<Message>>>(kept_)) {
      if (kept.topic == topic) result.push_back(kept.message);
    }
    return result;
  }
  [[nodiscard]] std::size_t count(Topic topic) const { return counts_[static_cast<std::size_t>(topic)]; }
  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    for (const std::size_t count : counts_) sum += count;
    return sum;
  }
  void clear() {
    kept_ = {};
    counts_ = {};
  }

 private:
  template <class... Message>
  using Lists = std::tuple<std::vector<Kept<Message>>...>;

  std::bitset<kTopicCount> wanted_;
  std::array<std::size_t, kTopicCount> counts_{};
  Lists<ros::JointState, ros::Imu, ros::WrenchStamped, ros::PointStamped, ros::Odometry, ros::TFMessage,
        ros::PoseArray, ros::MotionState, ros::WayState, ros::RobotState, ros::String, ros::Clock,
        ros::DiagnosticArray, ros::BusSlot, ros::LinkState, ros::SimulationState, ros::TwinState,
        ros::TwistStamped, ros::Log, ros::CommandState, ros::BehaviourState, ros::BehaviourNodes>
      kept_;
};

// The same as a sink; refers to the collector.
inline auto sink_of(Collector& collector) {
  return GenericSink([&collector](Topic topic) { return collector.wanted(topic); },
                     [&collector](Topic topic, const auto& message, std::int64_t robot_ns) {
                       collector.take(topic, message, robot_ns);
                     });
}

}  // namespace gaitway::api::test
